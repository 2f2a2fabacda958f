#include "robot_import/build_bodies.h"

#include <cmath>
#include <stdexcept>

#include "robot/urdf_hinge.h"

namespace hexapod {
namespace {

constexpr double kAssumedVelocity_rad_per_s = 2.0 * M_PI;

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
          const Mesh read = meshOf(mesh, link.name);
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
          look.mesh = meshOf(*mesh, name);
        }
        extras.looks.push_back(look);
      }
    }
    imported.extras.push_back(extras);
    return lumped;
  }

  // Empty, with a remark, when there is none.
  Mesh meshOf(const urdf::Mesh& mesh, const std::string& link) {
    const std::string file = files_.find(mesh.filename);
    if (file.empty()) {
      report_.remarks.add("meshes", {"link", link},
                          "has a mesh that is not found; --mesh_path names the folder of the "
                          "meshes or of their package.");
      return {};
    }
    try {
      return readMesh(file, Eigen::Vector3d(mesh.scale.x, mesh.scale.y, mesh.scale.z));
    } catch (const std::runtime_error& error) {
      report_.remarks.add("meshes", {"link", link}, std::string("is left out: ") + error.what());
      return {};
    }
  }

  Joint hinge(const urdf::Joint& from, const LumpedBody& parent) {
    Joint joint;
    joint.name = from.name;
    joint.parent_from_joint = parent.body_from_link.at(from.parent_link_name) *
                              toIsometry(from.parent_to_joint_origin_transform);
    Problems missing;  // what is missing is made up for below
    readHinge(from, {report_.source, missing, report_.remarks}, joint);
    if (Eigen::Vector3d(from.axis.x, from.axis.y, from.axis.z).norm() < 1e-9) {
      report_.problems.add(report_.source, {"joint", from.name},
                           "has a zero axis; expected a direction such as 0 0 1.");
    }
    if (!(joint.lower_rad < joint.upper_rad)) {
      joint.lower_rad = -0.5 * M_PI;
      joint.upper_rad = 0.5 * M_PI;
      addRemark(from, "has no usable limits: taken as -pi/2 .. pi/2; check them.");
    }
    if (!(joint.max_velocity_rad_per_s > 0.0)) {
      joint.max_velocity_rad_per_s = kAssumedVelocity_rad_per_s;
      addRemark(from, "has no velocity: taken as 6.28 rad/s; check it.");
    }
    return joint;
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
