#include "robot/urdf_hinge.h"

#include <algorithm>
#include <cmath>

#include "common/text.h"

namespace hexapod {
namespace {

std::string typeName(int type) {
  switch (type) {
    case urdf::Joint::PRISMATIC:
      return "prismatic";
    case urdf::Joint::FLOATING:
      return "floating";
    case urdf::Joint::PLANAR:
      return "planar";
    case urdf::Joint::FIXED:
      return "fixed";
    default:
      return "of an unknown type";
  }
}

class HingeReader {
 public:
  HingeReader(const urdf::Joint& from, const Findings& findings, Joint& joint)
      : from_(from), findings_(findings), joint_(joint) {}

  void read() {
    if (from_.type != urdf::Joint::REVOLUTE && from_.type != urdf::Joint::CONTINUOUS) {
      addProblem("is " + typeName(from_.type) +
                 "; expected a revolute joint with limits, as a servo has.");
      return;
    }
    if (from_.mimic) addProblem("mimics another joint; expected a servo of its own.");
    const Eigen::Vector3d axis(from_.axis.x, from_.axis.y, from_.axis.z);
    if (axis.norm() > 1e-9) {
      joint_.axis = axis.normalized();
    } else {
      addProblem("has a zero axis; expected a direction such as 0 0 1.");
    }
    if (!from_.limits) {
      addProblem("has no <limit>; expected lower, upper, effort and velocity.");
      return;
    }
    readLimits();
    joint_.max_torque_nm = from_.limits->effort;
    joint_.max_velocity_rad_per_s = from_.limits->velocity;
    if (!(joint_.max_torque_nm > 0.0)) {
      addProblem("has the effort " + numberText(joint_.max_torque_nm) +
                 " N m; expected more than 0.");
    }
    if (!(joint_.max_velocity_rad_per_s > 0.0)) {
      addProblem("has the velocity " + numberText(joint_.max_velocity_rad_per_s) +
                 " rad/s; expected more than 0.");
    }
  }

 private:
  void readLimits() {
    const double lower_rad = from_.limits->lower;
    const double upper_rad = from_.limits->upper;
    joint_.lower_rad = std::max(lower_rad, -M_PI);
    joint_.upper_rad = std::min(upper_rad, M_PI);
    if (from_.type == urdf::Joint::CONTINUOUS) {
      joint_.lower_rad = -M_PI;
      joint_.upper_rad = M_PI;
      addRemark("is continuous: its limits are taken as -pi .. pi.");
    } else if (lower_rad == 0.0 && upper_rad == 0.0) {
      addProblem(
          "has no lower and upper in its <limit>, or both are 0; expected the range of the "
          "servo.");
    } else if (!(joint_.lower_rad < joint_.upper_rad)) {
      addProblem("has the limits " + numberText(lower_rad) + " .. " + numberText(upper_rad) +
                 " rad; expected lower below upper, with a part in -pi .. pi.");
    } else if (lower_rad < -M_PI - kRounding_rad || upper_rad > M_PI + kRounding_rad) {
      addRemark("has the limits " + numberText(lower_rad) + " .. " + numberText(upper_rad) +
                " rad: taken as " + numberText(joint_.lower_rad) + " .. " +
                numberText(joint_.upper_rad) + " rad.");
    }
  }

  void addProblem(const std::string& sentence) {
    findings_.problems.add(findings_.source, {"joint", from_.name}, sentence);
  }
  void addRemark(const std::string& sentence) {
    findings_.remarks.add(findings_.source, {"joint", from_.name}, sentence);
  }

  // 3.1416 is meant to be pi.
  static constexpr double kRounding_rad = 1e-3;

  const urdf::Joint& from_;
  const Findings& findings_;
  Joint& joint_;
};

}  // namespace

void readHinge(const urdf::Joint& from, const Findings& findings, Joint& joint) {
  HingeReader(from, findings, joint).read();
}

}  // namespace hexapod
