#include "robot/assemble_robot.h"

#include <cmath>
#include <set>
#include <vector>

#include "common/options.h"
#include "common/text.h"
#include "robot/dimensions.h"
#include "robot/urdf_hinge.h"

namespace hexapod {
namespace {

// Gaits may be beyond the limits by what files round away; what is sent is within them.
constexpr double kRounding_rad = 1e-5;

double forwardYaw_rad(const std::string& axis) {
  if (axis == "y") return 0.5 * M_PI;
  if (axis == "-x") return M_PI;
  return axis == "-y" ? -0.5 * M_PI : 0.0;
}

class Assembly {
 public:
  Assembly(const RobotSources& sources, Problems& problems)
      : model_(sources.model),
        config_(sources.config),
        urdf_name_(sources.urdf_name),
        yaml_name_(sources.yaml_name),
        problems_(problems),
        findings_{urdf_name_, problems_, remarks_} {}

  RobotDescription assemble() {
    RobotDescription robot;
    robot.name = config_.name;
    robot.base_link = config_.base_link;
    robot.servo = config_.servo;
    const urdf::LinkConstSharedPtr link = findBase();
    if (!link) return robot;
    const LumpedBody base = lumpFixedLinks(*link, findings_);
    robot.base = base.body;
    if (base.body.shapes.empty() && problems_.none()) {
      problems_.add(urdf_name_, {"link", link->name},
                    "and what is fixed to it have no collision shape; expected at least one, so "
                    "that a fall is seen.");
    }
    for (const LegConfig& leg : config_.legs) robot.legs.push_back(assembleLeg(leg, base));
    findUnusedJoints();
    turnForward(config_.forward, robot);
    deriveConstants(robot);
    robot.remarks = remarks_.sentences();
    return robot;
  }

 private:
  // The base link; above it there may be the world and frames, but nothing with a body.
  urdf::LinkConstSharedPtr findBase() {
    const urdf::LinkConstSharedPtr base = model_.getLink(config_.base_link);
    if (!base) {
      std::vector<std::string> names;
      for (const auto& [name, link] : model_.links_) names.push_back(name);
      const std::string nearest = nearestName(config_.base_link, names);
      problems_.add(yaml_name_, "base_link is " + config_.base_link + ", which " + urdf_name_ +
                                    " does not have; " +
                                    (nearest.empty() ? "its root link is " + model_.getRoot()->name
                                                     : "did you mean " + nearest) +
                                    (nearest.empty() ? "." : "?"));
      return nullptr;
    }
    for (auto above = base; above->getParent(); above = above->getParent()) {
      const urdf::Joint& joint = *above->parent_joint;
      const urdf::Link& link = *above->getParent();
      const bool is_frame = !link.inertial && link.collision_array.empty();
      const bool is_free = joint.type == urdf::Joint::FIXED ||
                           joint.type == urdf::Joint::FLOATING || joint.type == urdf::Joint::PLANAR;
      used_joints_.insert(joint.name);
      if (is_frame && is_free) continue;
      problems_.add(yaml_name_, "base_link is " + config_.base_link + ", but it hangs on link " +
                                    link.name + " by joint " + joint.name +
                                    "; expected the link that carries the legs, below nothing but "
                                    "frames (the root link of the URDF is " +
                                    model_.getRoot()->name + ").");
      return nullptr;
    }
    return base;
  }

  Leg assembleLeg(const LegConfig& config, const LumpedBody& base) {
    Leg leg;
    leg.name = config.name;
    LumpedBody parent = base;
    bool has_shape = false;
    for (const JointConfig& joint_config : config.joints) {
      const auto joint = model_.getJoint(joint_config.name);
      if (!joint) {
        addMissingJoint(leg.name, joint_config.name);
        return leg;
      }
      used_joints_.insert(joint->name);
      const LumpedBody child = lumpFixedLinks(*model_.getLink(joint->child_link_name), findings_);
      leg.segments.push_back({assembleJoint(*joint, joint_config, parent), child.body});
      has_shape = has_shape || !child.body.shapes.empty();
      parent = child;
    }
    if (!has_shape && problems_.none()) {
      problems_.add(urdf_name_, {"leg", leg.name},
                    "has no collision shape in any of its links; expected at least one to stand "
                    "on.");
    }
    return leg;
  }

  Joint assembleJoint(const urdf::Joint& from, const JointConfig& config,
                      const LumpedBody& parent) {
    Joint joint;
    joint.name = from.name;
    joint.signal = config.signal;
    joint.neutral_rad = config.neutral_rad;
    joint.amplitude_rad = config.amplitude_rad;
    const auto place = parent.body_from_link.find(from.parent_link_name);
    if (place == parent.body_from_link.end()) {
      problems_.add(urdf_name_, {"joint", from.name},
                    "hangs on link " + from.parent_link_name + ", which is not part of " +
                        parent.body.name +
                        "; list a leg's joints in the YAML from the base outwards, each on the "
                        "link the one before moves.");
    } else {
      joint.parent_from_joint = place->second * toIsometry(from.parent_to_joint_origin_transform);
    }
    readHinge(from, findings_, joint);
    if (joint.lower_rad < joint.upper_rad) checkGait(joint);
    return joint;
  }

  void checkGait(const Joint& joint) {
    const double reach = std::abs(joint.amplitude_rad);
    const double low_rad = joint.neutral_rad - reach;
    const double high_rad = joint.neutral_rad + reach;
    if (low_rad >= joint.lower_rad - kRounding_rad && high_rad <= joint.upper_rad + kRounding_rad) {
      return;
    }
    problems_.add(yaml_name_, {"joint", joint.name},
                  "moves between " + numberText(low_rad) + " and " + numberText(high_rad) +
                      " rad (neutral_rad -+ amplitude_rad), outside its limits " +
                      numberText(joint.lower_rad) + " .. " + numberText(joint.upper_rad) +
                      " rad; expected a gait within them.");
  }

  void addMissingJoint(const std::string& leg, const std::string& joint) {
    std::vector<std::string> names;
    for (const auto& [name, candidate] : model_.joints_) names.push_back(name);
    const std::string nearest = nearestName(joint, names);
    problems_.add(
        yaml_name_,
        "leg " + leg + " names joint " + joint + ", which " + urdf_name_ + " does not have; " +
            (nearest.empty() ? "expected one of its joints." : "did you mean " + nearest + "?"));
  }

  void findUnusedJoints() {
    for (const auto& [name, joint] : model_.joints_) {
      if (joint->type == urdf::Joint::FIXED || used_joints_.count(name) > 0) continue;
      problems_.add(
          urdf_name_, {"joint", name},
          "moves but is in no leg of " + yaml_name_ + "; list it in a leg or make it fixed.");
    }
  }

  void deriveConstants(RobotDescription& robot) {
    robot.contact = config_.contact;
    robot.failure = config_.failure;
    if (!problems_.none()) return;
    if (!config_.has_slip) robot.contact.slip_per_n_s = slipFor(robot);
    if (!config_.has_soft_cfm) robot.contact.soft_cfm = softCfmFor(robot);
    if (!config_.has_max_base_height) robot.failure.max_base_height_m = maxBaseHeightFor(robot);
  }

  const urdf::ModelInterface& model_;
  const RobotConfig& config_;
  const std::string& urdf_name_;
  const std::string& yaml_name_;
  Problems& problems_;
  Problems remarks_;
  Findings findings_;
  std::set<std::string> used_joints_;
};

}  // namespace

void turnForward(const std::string& axis, RobotDescription& robot) {
  const double link_from_base_yaw_rad = forwardYaw_rad(axis);
  robot.link_from_base_yaw_rad = link_from_base_yaw_rad;
  if (link_from_base_yaw_rad == 0.0) return;
  const Eigen::Isometry3d base_from_link(
      Eigen::AngleAxisd(-link_from_base_yaw_rad, Eigen::Vector3d::UnitZ()));
  Body& base = robot.base;
  base.center_of_mass_m = base_from_link * base.center_of_mass_m;
  base.inertia_kg_m2 =
      base_from_link.linear() * base.inertia_kg_m2 * base_from_link.linear().transpose();
  for (Shape& shape : base.shapes) shape.body_from_shape = base_from_link * shape.body_from_shape;
  for (Leg& leg : robot.legs) {
    if (leg.segments.empty()) continue;
    Joint& hip = leg.segments.front().joint;
    hip.parent_from_joint = base_from_link * hip.parent_from_joint;
  }
}

RobotDescription assembleRobot(const RobotSources& sources, Problems& problems) {
  return Assembly(sources, problems).assemble();
}

}  // namespace hexapod
