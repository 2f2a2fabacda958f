#include "robot_import/build_bodies.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "common/text.h"
#include "geometry/pose2.h"
#include "robot/urdf_hinge.h"

namespace hexapod {
namespace {

constexpr double kAssumedVelocity_rad_per_s = 2.0 * M_PI;
// Slower than any servo: in some other unit, or a place holder.
constexpr double kSlowest_rad_per_s = 0.1;
// Limits beyond two turns are degrees, unless they are beyond a turn of those.
constexpr double kTwoTurns_rad = 4.0 * M_PI;
constexpr double kTurn_deg = 360.0;

class Builder {
 public:
  Builder(const urdf::ModelInterface& model, const MeshFiles& files, ImportReport& report)
      : model_(model), files_(files), report_(report) {}

  ImportedRobot build(const urdf::LinkSharedPtr& base, const std::vector<JointChain>& legs) {
    ImportedRobot imported;
    imported.robot.name = model_.getName();
    imported.robot.base_link = base->name;
    const LumpedBody base_body = lump(*base, imported);
    imported.robot.base = base_body.body;
    for (const JointChain& chain : legs) {
      Leg leg;
      LumpedBody parent = base_body;
      for (const urdf::JointSharedPtr& joint : chain) {
        const LumpedBody child = lump(*model_.getLink(joint->child_link_name), imported);
        leg.segments.push_back({hinge(*joint, parent), child.body});
        parent = child;
      }
      imported.robot.legs.push_back(leg);
    }
    return imported;
  }

 private:
  LumpedBody lump(const urdf::Link& link, ImportedRobot& imported) {
    BodyExtras extras;
    Problems shapes;
    const Findings findings{report_.source, shapes, report_.remarks};
    const LumpedBody lumped = lumpFixedLinks(
        link, findings, [&](const urdf::Mesh& mesh, const Eigen::Isometry3d& body_from_mesh) {
          const Mesh read = meshOf(mesh, link.name, extras);
          for (const Eigen::Vector3d& vertex : read.vertices) {
            extras.collision_points.push_back(body_from_mesh * vertex);
          }
          ++extras.meshes;
          return std::string();
        });
    for (const auto& [name, body_from_link] : lumped.body_from_link) {
      if (name != link.name) extras.frames.push_back({name, body_from_link});
      for (const auto& visual : model_.getLink(name)->visual_array) {
        if (!visual->geometry) continue;
        Look look{visual->geometry, body_from_link * toIsometry(visual->origin), {}};
        if (const auto* mesh = dynamic_cast<const urdf::Mesh*>(visual->geometry.get())) {
          look.mesh = meshOf(*mesh, name, extras);
        }
        extras.looks.push_back(look);
      }
    }
    imported.extras.push_back(extras);
    return lumped;
  }

  // Empty, with a remark, when there is none.
  Mesh meshOf(const urdf::Mesh& mesh, const std::string& link, BodyExtras& extras) {
    const std::string file = files_.find(mesh.filename);
    if (file.empty()) {
      ++extras.lost_meshes;
      report_.remarks.add("meshes", {"link", link},
                          "has a mesh that is not found; --mesh_path names the folder of the "
                          "meshes or of their package.");
      return {};
    }
    try {
      return readMesh(file, Eigen::Vector3d(mesh.scale.x, mesh.scale.y, mesh.scale.z));
    } catch (const std::runtime_error& error) {
      ++extras.lost_meshes;
      report_.remarks.add("meshes", {"link", link}, std::string("is left out: ") + error.what());
      return {};
    }
  }

  Joint hinge(const urdf::Joint& given, const LumpedBody& parent) {
    const urdf::Joint from = repaired(given);
    Joint joint;
    joint.name = from.name;
    joint.parent_from_joint = parent.body_from_link.at(from.parent_link_name) *
                              toIsometry(from.parent_to_joint_origin_transform);
    Problems missing;  // an effort that is missing is made up for when the weight is known
    readHinge(from, {report_.source, missing, report_.remarks}, joint);
    if (Eigen::Vector3d(from.axis.x, from.axis.y, from.axis.z).norm() < 1e-9) {
      report_.problems.add(report_.source, {"joint", from.name},
                           "has a zero axis; expected a direction such as 0 0 1.");
    }
    return joint;
  }

  // With limits and a velocity that a servo can have.
  urdf::Joint repaired(urdf::Joint joint) {
    urdf::JointLimits limits;
    if (joint.limits) limits = *joint.limits;
    if (joint.type != urdf::Joint::CONTINUOUS) repairRange(joint, limits);
    if (!(limits.velocity > 0.0)) {
      addRemark(joint, "has no velocity: taken as 6.28 rad/s; check it.");
      limits.velocity = kAssumedVelocity_rad_per_s;
    } else if (limits.velocity < kSlowest_rad_per_s) {
      addRemark(joint, "has the velocity " + numberText(limits.velocity) +
                           " rad/s, slower than any servo: taken as 6.28 rad/s; check it.");
      limits.velocity = kAssumedVelocity_rad_per_s;
    }
    joint.limits = std::make_shared<urdf::JointLimits>(limits);
    return joint;
  }

  void repairRange(const urdf::Joint& joint, urdf::JointLimits& limits) {
    const double widest = std::max(std::abs(limits.lower), std::abs(limits.upper));
    if (!(std::max(limits.lower, -M_PI) < std::min(limits.upper, M_PI))) {
      addRemark(joint, "has no usable limits: taken as -pi/2 .. pi/2; check them.");
      limits.lower = -0.5 * M_PI;
      limits.upper = 0.5 * M_PI;
    } else if (widest > kTwoTurns_rad && widest <= kTurn_deg) {
      addRemark(joint, "has the limits " + numberText(limits.lower) + " .. " +
                           numberText(limits.upper) + ", taken as degrees; check them.");
      limits.lower *= kDegree;
      limits.upper *= kDegree;
    }
  }

  void addRemark(const urdf::Joint& joint, const std::string& sentence) {
    report_.remarks.add("limits", {"joint", joint.name}, sentence);
  }

  const urdf::ModelInterface& model_;
  const MeshFiles& files_;
  ImportReport& report_;
};

}  // namespace

ImportedRobot buildBodies(const urdf::ModelInterface& model, const urdf::LinkSharedPtr& base,
                          const std::vector<JointChain>& legs, const MeshFiles& files,
                          ImportReport& report) {
  return Builder(model, files, report).build(base, legs);
}

}  // namespace hexapod
