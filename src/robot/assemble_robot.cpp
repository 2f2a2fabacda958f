#include "robot/assemble_robot.h"

#include <cmath>
#include <set>
#include <vector>

#include "common/options.h"
#include "robot/urdf_bodies.h"

namespace hexapod {
namespace {

std::string typeName(int type) {
  switch (type) {
    case urdf::Joint::CONTINUOUS:
      return "continuous";
    case urdf::Joint::PRISMATIC:
      return "prismatic";
    case urdf::Joint::FLOATING:
      return "floating";
    case urdf::Joint::PLANAR:
      return "planar";
    case urdf::Joint::FIXED:
      return "fixed";
    default:
      return "unknown";
  }
}

class Assembly {
 public:
  Assembly(const RobotSources& sources, Problems& problems)
      : model_(sources.model),
        config_(sources.config),
        urdf_name_(sources.urdf_name),
        yaml_name_(sources.yaml_name),
        problems_(problems) {}

  RobotDescription assemble() {
    RobotDescription robot;
    robot.name = config_.name;
    robot.base_link = config_.base_link;
    robot.servo = config_.servo;
    robot.contact = config_.contact;
    robot.failure = config_.failure;
    const urdf::Link& root = *model_.getRoot();
    if (root.name != config_.base_link) {
      problems_.add(yaml_name_, "base_link is " + config_.base_link +
                                    ", but the root link of the URDF is " + root.name +
                                    "; expected the same link.");
    }
    const LumpedBody base = lumpFixedLinks(root, urdf_name_, problems_);
    robot.base = base.body;
    if (base.body.shapes.empty()) {
      problems_.add(urdf_name_, "link " + root.name +
                                    " and what is fixed to it have no collision shape; expected at "
                                    "least one, so that a fall is seen.");
    }
    for (const LegConfig& leg : config_.legs) robot.legs.push_back(assembleLeg(leg, base));
    findUnusedJoints();
    return robot;
  }

 private:
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
      const LumpedBody child =
          lumpFixedLinks(*model_.getLink(joint->child_link_name), urdf_name_, problems_);
      leg.segments.push_back({assembleJoint(*joint, joint_config, parent), child.body});
      has_shape = has_shape || !child.body.shapes.empty();
      parent = child;
    }
    if (!has_shape) {
      problems_.add(urdf_name_, "leg " + leg.name +
                                    " has no collision shape in any of its links; expected at "
                                    "least one to stand on.");
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
      addJointProblem(from.name, "hangs on link " + from.parent_link_name +
                                     ", which is not part of " + parent.body.name +
                                     "; list a leg's joints in the YAML from the base outwards, "
                                     "each on the link the one before moves.");
    } else {
      joint.parent_from_joint = place->second * toIsometry(from.parent_to_joint_origin_transform);
    }
    readHinge(from, joint);
    return joint;
  }

  void readHinge(const urdf::Joint& from, Joint& joint) {
    if (from.type != urdf::Joint::REVOLUTE) {
      addJointProblem(from.name, "is " + typeName(from.type) +
                                     "; expected a revolute joint with limits, as a servo has.");
      return;
    }
    if (from.mimic) {
      addJointProblem(from.name, "mimics another joint; expected a servo of its own.");
    }
    const Eigen::Vector3d axis(from.axis.x, from.axis.y, from.axis.z);
    if (axis.norm() > 1e-9) {
      joint.axis = axis.normalized();
    } else {
      addJointProblem(from.name, "has a zero axis; expected a direction such as 0 0 1.");
    }
    if (!from.limits) {
      addJointProblem(from.name, "has no <limit>; expected lower, upper, effort and velocity.");
      return;
    }
    joint.lower_rad = from.limits->lower;
    joint.upper_rad = from.limits->upper;
    joint.max_torque_nm = from.limits->effort;
    joint.max_velocity_rad_per_s = from.limits->velocity;
    checkLimits(joint);
  }

  void checkLimits(const Joint& joint) {
    const std::string range =
        numberText(joint.lower_rad) + " .. " + numberText(joint.upper_rad) + " rad";
    if (!(joint.lower_rad < joint.upper_rad && joint.lower_rad >= -M_PI &&
          joint.upper_rad <= M_PI)) {
      addJointProblem(joint.name,
                      "has the limits " + range + "; expected lower below upper, in -pi .. pi.");
      return;
    }
    if (!(joint.max_torque_nm > 0.0)) {
      addJointProblem(joint.name, "has the effort " + numberText(joint.max_torque_nm) +
                                      " N m; expected more than 0.");
    }
    if (!(joint.max_velocity_rad_per_s > 0.0)) {
      addJointProblem(joint.name, "has the velocity " + numberText(joint.max_velocity_rad_per_s) +
                                      " rad/s; expected more than 0.");
    }
    const double reach = std::abs(joint.amplitude_rad);
    if (joint.neutral_rad - reach < joint.lower_rad ||
        joint.neutral_rad + reach > joint.upper_rad) {
      problems_.add(yaml_name_, "joint " + joint.name + " moves between " +
                                    numberText(joint.neutral_rad - reach) + " and " +
                                    numberText(joint.neutral_rad + reach) +
                                    " rad (neutral_rad -+ amplitude_rad), outside its limits " +
                                    range + "; expected a gait within them.");
    }
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
      addJointProblem(
          name, "moves but is in no leg of " + yaml_name_ + "; list it in a leg or make it fixed.");
    }
  }

  void addJointProblem(const std::string& joint, const std::string& sentence) {
    problems_.add(urdf_name_, "joint " + joint + " " + sentence);
  }

  const urdf::ModelInterface& model_;
  const RobotConfig& config_;
  const std::string& urdf_name_;
  const std::string& yaml_name_;
  Problems& problems_;
  std::set<std::string> used_joints_;
};

}  // namespace

RobotDescription assembleRobot(const RobotSources& sources, Problems& problems) {
  return Assembly(sources, problems).assemble();
}

}  // namespace hexapod
