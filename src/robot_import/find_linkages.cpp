#include "robot_import/find_linkages.h"

#include "robot/dimensions.h"

namespace hexapod {
namespace {

constexpr double kOnOneLine = 0.02;   // of the reach
constexpr double kSideBySide = 0.35;  // of the reach

// Whether two first hinges, close to each other, have one axis.
bool shareAxis(const Joint& a, const Joint& b, double reach_m) {
  const Eigen::Vector3d between_m =
      b.parent_from_joint.translation() - a.parent_from_joint.translation();
  const Eigen::Vector3d axis = a.parent_from_joint.linear() * a.axis;
  const Eigen::Vector3d other = b.parent_from_joint.linear() * b.axis;
  return between_m.norm() < kSideBySide * reach_m && axis.cross(other).norm() < kOnOneLine &&
         axis.cross(between_m).norm() < kOnOneLine * reach_m;
}

}  // namespace

void remarkLinkages(const ImportedRobot& imported, ImportReport& report) {
  const std::vector<Leg>& legs = imported.robot.legs;
  const double reach_m = legReach_m(imported.robot);
  for (std::size_t i = 0; i < legs.size(); ++i) {
    for (std::size_t j = i + 1; j < legs.size(); ++j) {
      if (!shareAxis(legs[i].segments[0].joint, legs[j].segments[0].joint, reach_m)) continue;
      report.remarks.add("legs", {"pair", legs[i].name + " with " + legs[j].name},
                         "turns about one axis side by side: if the ends meet in one foot of a "
                         "linkage, this is not that robot, as each is simulated as a leg.");
    }
  }
}

}  // namespace hexapod
