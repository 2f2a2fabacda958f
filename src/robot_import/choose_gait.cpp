#include "robot_import/choose_gait.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "common/text.h"
#include "robot/assemble_robot.h"
#include "robot/dimensions.h"
#include "robot_import/judge_pose.h"
#include "robot_import/pose_grid.h"
#include "simulation/kinematics.h"

namespace hexapod {
namespace {

// Of the room that legs can make below the body at most, what a stand should have.
constexpr double kUsedClearance = 0.6;
// Of the reach; with less of it the body stays on the floor.
constexpr double kLeastClearance = 0.02;

// A quarter of degrees: what files round to anyway.
double rounded(double angle_rad) { return std::round(angle_rad * 1e4) / 1e4; }

class GaitChooser {
 public:
  GaitChooser(RobotDescription& robot, double scale, ImportReport& report)
      : robot_(robot), report_(report) {
    task_.scale = scale;
    task_.load_n = kGravity_m_per_s2 * totalMass_kg(robot) * 2.0 /
                   static_cast<double>(std::max<std::size_t>(robot.legs.size(), 4));
    task_.belly_m = 0.0;
    for (const Shape& shape : robot.base.shapes) {
      task_.belly_m = std::min(task_.belly_m, lowestPoint(shape, shape.body_from_shape));
    }
    for (const Leg& leg : robot.legs) {
      models_.emplace_back(leg);
      task_.middle_m += models_.back().hip_m().head<2>() / static_cast<double>(robot.legs.size());
    }
    lowest_m_ = -std::numeric_limits<double>::infinity();
    for (const LegModel& model : models_) lowest_m_ = std::max(lowest_m_, lowestFoot_m(model));
    task_.clearance_m = kUsedClearance * (task_.belly_m - lowest_m_);
  }

  void choose() {
    if (task_.clearance_m < kLeastClearance * legReach_m(robot_)) return complainOfShortLegs();
    // 1. Over the grid: legs of a kind share their joints alike; all stand at one height.
    const PoseGrid grid(models_, task_);
    const std::optional<std::size_t> height = grid.bestHeight();
    if (!height) return complainOfHeights();
    std::vector<JudgedPose> chosen;
    for (std::size_t leg = 0; leg < models_.size(); ++leg) {
      shares_.push_back(grid.bestShares(leg, *height));
      chosen.push_back(grid.best(leg, shares_.back(), *height));
    }
    // 2. From the grid to the best poses around, then to the very same height.
    for (std::size_t leg = 0; leg < models_.size(); ++leg) refine(leg, chosen[leg]);
    copyToImages(chosen);
    double floor_m = 0.0;
    for (const JudgedPose& pose : chosen)
      floor_m += pose.floor_m / static_cast<double>(chosen.size());
    for (std::size_t leg = 0; leg < models_.size(); ++leg) level(leg, floor_m, chosen[leg]);
    copyToImages(chosen);
    for (std::size_t leg = 0; leg < models_.size(); ++leg) write(leg, chosen[leg]);
    complain(chosen);
  }

 private:
  // Uphill along each joint in turn, with steps that halve, staying near the height.
  void refine(std::size_t leg, JudgedPose& pose) const {
    const double floor_m = pose.floor_m;
    const auto worth = [&](const JudgedPose& judged) {
      const double off = (judged.floor_m - floor_m) / (0.03 * models_[leg].reach_m());
      return judged.score - 0.1 * off * off;
    };
    for (double step_rad = 0.16; step_rad > 0.002; step_rad *= 0.5) {
      for (int round = 0; round < 4; ++round) {
        for (std::size_t j = 0; j < pose.angles_rad.size(); ++j) {
          for (const double way : {step_rad, -step_rad}) {
            const JudgedPose moved = movedBy(leg, pose, j, way);
            if (worth(moved) > worth(pose) + 1e-9) pose = moved;
          }
        }
      }
    }
  }

  JudgedPose movedBy(std::size_t leg, const JudgedPose& pose, std::size_t j, double way_rad) const {
    const Joint& joint = models_[leg].leg().segments[j].joint;
    std::vector<double> angles = pose.angles_rad;
    angles[j] = std::clamp(angles[j] + way_rad, joint.lower_rad, joint.upper_rad);
    return judgePose(models_[leg], task_, shares_[leg], angles);
  }

  // Puts the foot on the common floor by the joints that lift it.
  void level(std::size_t leg, double floor_m, JudgedPose& pose) const {
    const LegModel& model = models_[leg];
    for (int round = 0; round < 20; ++round) {
      const Eigen::RowVectorXd up = model.at(pose.angles_rad).jacobian_m.row(2);
      const double missing_m = floor_m - pose.floor_m;
      if (std::abs(missing_m) < 1e-5 || up.squaredNorm() < 1e-12) break;
      std::vector<double> angles = pose.angles_rad;
      for (std::size_t j = 0; j < angles.size(); ++j) {
        const Joint& joint = model.leg().segments[j].joint;
        const double turn = missing_m * up[static_cast<Eigen::Index>(j)] / up.squaredNorm();
        angles[j] = std::clamp(angles[j] + turn, joint.lower_rad, joint.upper_rad);
      }
      pose = judgePose(model, task_, shares_[leg], angles);
    }
  }

  // A leg that is another's mirror image takes over its pose, where that is as good.
  void copyToImages(std::vector<JudgedPose>& chosen) const {
    // Left and right come last: they are images of each other whatever front and rear are.
    for (const Eigen::Vector3d& flip :
         {Eigen::Vector3d(-1, -1, 1), Eigen::Vector3d(-1, 1, 1), Eigen::Vector3d(1, -1, 1)}) {
      for (std::size_t from = 0; from < models_.size(); ++from) {
        for (std::size_t to = from + 1; to < models_.size(); ++to) {
          copyToImage(flip, from, to, chosen);
        }
      }
    }
  }

  void copyToImage(const Eigen::Vector3d& flip, std::size_t from, std::size_t to,
                   std::vector<JudgedPose>& chosen) const {
    const double tolerance_m = 5e-3 * models_[from].reach_m();
    const Eigen::Vector3d middle_m(task_.middle_m.x(), task_.middle_m.y(), 0.0);
    const auto image = [&](const Eigen::Vector3d& point) -> Eigen::Vector3d {
      return middle_m + flip.cwiseProduct(point - middle_m);
    };
    if (models_[from].jointCount() != models_[to].jointCount() ||
        (image(models_[from].hip_m()) - models_[to].hip_m()).norm() > tolerance_m) {
      return;
    }
    const LegPose pose = models_[from].at(chosen[from].angles_rad);
    const LegPose present = models_[to].at(chosen[to].angles_rad);
    std::vector<double> angles(models_[to].jointCount());
    // Outwards: each joint's sense follows from the axes once those before it are mirrored.
    for (std::size_t j = 0; j < angles.size(); ++j) {
      std::vector<double> so_far = angles;
      const Eigen::Vector3d axis = flip.prod() * flip.cwiseProduct(pose.axis[j]);
      const double sense = axis.dot(models_[to].at(so_far).axis[j]) > 0.0 ? 1.0 : -1.0;
      const Joint& joint = models_[to].leg().segments[j].joint;
      angles[j] = sense * chosen[from].angles_rad[j];
      if (angles[j] < joint.lower_rad || angles[j] > joint.upper_rad) return;
    }
    if ((models_[to].at(angles).foot_m - image(pose.foot_m)).norm() > tolerance_m) return;
    const JudgedPose judged = judgePose(models_[to], task_, shares_[to], angles);
    if (judged.score > chosen[to].score - 0.1) chosen[to] = judged;
  }

  void write(std::size_t leg, const JudgedPose& pose) {
    for (std::size_t j = 0; j < pose.angles_rad.size(); ++j) {
      Joint& joint = robot_.legs[leg].segments[j].joint;
      joint.neutral_rad = rounded(pose.angles_rad[j]);
      joint.amplitude_rad = 0.999 * pose.amplitudes_rad[j];
      joint.amplitude_rad = std::trunc(joint.amplitude_rad * 1e4) / 1e4;
      joint.signal = shares_[leg][j] == 2 ? Signal::kSecond : Signal::kFirst;
    }
  }

  void complainOfShortLegs() {
    report_.problems.add(
        report_.source,
        "cannot stand: within their limits its feet do not all reach below its body, whose lowest "
        "point is at z = " +
            numberText(task_.belly_m) +
            " m of the base link; the least that a foot gets down to is " +
            numberText(rounded(lowest_m_)) + " m. Check the limits, and that z is up.");
  }

  void complainOfHeights() {
    report_.problems.add(report_.source,
                         "cannot stand: there is no height that the feet of all legs reach within "
                         "their limits. Check the limits, and that z of the base link is up.");
  }

  void complain(const std::vector<JudgedPose>& chosen) {
    for (std::size_t leg = 0; leg < chosen.size(); ++leg) {
      const double needed = chosen[leg].torque_share;
      if (needed <= 1.0) continue;
      report_.problems.add(
          report_.source, {"leg", robot_.legs[leg].name},
          "cannot carry the robot: in its best pose standing on half of the legs takes " +
              numberText(std::round(10.0 * needed) / 10.0) +
              " times the torque of a joint. The "
              "robot has " +
              numberText(totalMass_kg(robot_)) + " kg; check masses and efforts.");
    }
  }

  RobotDescription& robot_;
  ImportReport& report_;
  StandingTask task_;
  std::vector<LegModel> models_;
  double lowest_m_;                   // that all feet reach
  std::vector<SignalShares> shares_;  // chosen, per leg
};

// As strong for its weight and reach as the paper's hexapod with its 1.5 N m.
void assumeTorques(RobotDescription& robot, ImportReport& report) {
  constexpr double kShare = 1.5 * 6.0 / (3.06 * kGravity_m_per_s2 * 0.29);
  const double weight_n = kGravity_m_per_s2 * totalMass_kg(robot);
  for (Leg& leg : robot.legs) {
    for (Segment& segment : leg.segments) {
      Joint& joint = segment.joint;
      if (joint.max_torque_nm > 0.0) continue;
      joint.max_torque_nm =
          kShare * weight_n * legReach_m(robot) / static_cast<double>(robot.legs.size());
      report.remarks.add("limits", {"joint", joint.name},
                         "has no effort: taken as " + numberText(joint.max_torque_nm) +
                             " N m, what a strong robot of its weight has; check it.");
    }
  }
}

}  // namespace

void chooseGait(ImportedRobot& imported, double scale, ImportReport& report) {
  assumeTorques(imported.robot, report);
  RobotDescription turned = imported.robot;
  turnForward(imported.forward, turned);
  GaitChooser(turned, scale, report).choose();
  for (std::size_t leg = 0; leg < turned.legs.size(); ++leg) {
    for (std::size_t s = 0; s < turned.legs[leg].segments.size(); ++s) {
      const Joint& chosen = turned.legs[leg].segments[s].joint;
      Joint& joint = imported.robot.legs[leg].segments[s].joint;
      joint.neutral_rad = chosen.neutral_rad;
      joint.amplitude_rad = chosen.amplitude_rad;
      joint.signal = chosen.signal;
    }
  }
}

}  // namespace hexapod
