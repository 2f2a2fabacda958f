#include "robot_import/judge_pose.h"

#include <algorithm>
#include <cmath>

namespace hexapod {
namespace {

// Stroke and lift either way per reach: of the paper's hexapod 0.055 and 0.06 m of 0.29 m.
constexpr double kStroke = 0.19;
constexpr double kLift = 0.20;
constexpr double kMostAmplitude_rad = M_PI / 4.0;
// The return to the neutral pose takes 0.6 s by default.
constexpr double kReturn_s = 0.55;
// A stroke to the side instead of ahead is for legs that can do nothing else.
constexpr double kSideways = 0.04;
// Levers below this share of the reach count less and less.
constexpr double kLever = 0.12;

/// How one signal moves the foot.
struct SignalMotion {
  Eigen::VectorXd amplitudes_rad;  // per joint; 0 for those of the other signal
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  // per unit asked for
  double room = 0.0;  // share of the way asked for that limits and servos allow
};

// The combination of the joints of `signal` that moves the foot along `wanted` and no other way.
SignalMotion motionFor(const LegModel& leg, const LegPose& pose, const SignalShares& shares,
                       int signal, const Eigen::Vector3d& wanted, double way_m,
                       const std::vector<double>& angles_rad) {
  const auto n = static_cast<Eigen::Index>(shares.size());
  Eigen::MatrixXd own = Eigen::MatrixXd::Zero(3, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    if (shares[static_cast<std::size_t>(j)] == signal) own.col(j) = pose.jacobian_m.col(j);
  }
  const double lever_m = kLever * leg.reach_m();
  const Eigen::MatrixXd square =
      own.transpose() * own + lever_m * lever_m * Eigen::MatrixXd::Identity(n, n);
  SignalMotion motion;
  motion.amplitudes_rad = square.ldlt().solve(own.transpose() * wanted);
  motion.direction = own * motion.amplitudes_rad;
  const double speed = std::max(1e-9, std::abs(motion.direction.dot(wanted)));
  motion.amplitudes_rad *= way_m / speed;
  double room = 1.0;
  for (Eigen::Index j = 0; j < n; ++j) {
    const double amplitude = std::abs(motion.amplitudes_rad[j]);
    if (amplitude < 1e-9) continue;
    const Joint& joint = leg.leg().segments[static_cast<std::size_t>(j)].joint;
    const double angle = angles_rad[static_cast<std::size_t>(j)];
    const double allowed = std::min({kMostAmplitude_rad, kReturn_s * joint.max_velocity_rad_per_s,
                                     angle - joint.lower_rad, joint.upper_rad - angle});
    room = std::min(room, std::max(0.0, allowed) / amplitude);
  }
  motion.amplitudes_rad *= room;
  motion.room = room;
  return motion;
}

double strokeQuality(const SignalMotion& motion, bool ahead) {
  const Eigen::Vector3d& v = motion.direction;
  const double along = ahead ? v.x() : kSideways * v.y();
  return std::max(0.0, along - 0.7 * std::abs(v.z()) - 0.1 * std::abs(ahead ? v.y() : v.x())) *
         std::sqrt(motion.room);
}

double liftQuality(const SignalMotion& motion) {
  const Eigen::Vector3d& v = motion.direction;
  if (v.z() <= 0.0) return 0.0;
  // A foot that also goes aside lifts less well, but lifts.
  return v.z() * v.z() / (v.z() + 0.5 * v.head<2>().norm()) * std::sqrt(motion.room);
}

}  // namespace

bool isOnAxis(const LegModel& leg, const StandingTask& task) {
  const Eigen::Vector2d hip_m = leg.hip_m().head<2>() - task.middle_m;
  return std::abs(hip_m.y()) < 0.05 * hip_m.norm();
}

JudgedPose judgePose(const LegModel& leg, const StandingTask& task, const SignalShares& shares,
                     const std::vector<double>& angles_rad) {
  const LegPose pose = leg.at(angles_rad);
  const double reach_m = leg.reach_m();
  JudgedPose judged;
  judged.angles_rad = angles_rad;
  judged.floor_m = pose.floor_m;

  // 1. What the signals do.
  const double stroke_m = kStroke * reach_m * task.scale, lift_m = kLift * reach_m * task.scale;
  SignalMotion stroke =
      motionFor(leg, pose, shares, 1, Eigen::Vector3d::UnitX(), stroke_m, angles_rad);
  double stroke_quality = strokeQuality(stroke, true);
  const SignalMotion sideways =
      motionFor(leg, pose, shares, 1, Eigen::Vector3d::UnitY(), stroke_m, angles_rad);
  if (strokeQuality(sideways, false) > stroke_quality) {
    stroke = sideways;
    stroke_quality = strokeQuality(sideways, false);
  }
  const SignalMotion lift =
      motionFor(leg, pose, shares, 2, Eigen::Vector3d::UnitZ(), lift_m, angles_rad);
  const Eigen::VectorXd amplitudes_rad = stroke.amplitudes_rad + lift.amplitudes_rad;
  judged.amplitudes_rad.assign(amplitudes_rad.data(),
                               amplitudes_rad.data() + amplitudes_rad.size());
  double score = 1.2 * std::sqrt(stroke_quality * liftQuality(lift));

  // 2. What it takes to stand.
  double from_zero = 0.0;
  for (std::size_t j = 0; j < shares.size(); ++j) {
    const Joint& joint = leg.leg().segments[j].joint;
    const double torque_nm =
        std::abs(pose.jacobian_m(2, static_cast<Eigen::Index>(j))) * task.load_n;
    judged.torque_share = std::max(judged.torque_share, torque_nm / joint.max_torque_nm);
    const double nearest_rad = std::clamp(0.0, joint.lower_rad, joint.upper_rad);
    from_zero += std::abs(angles_rad[j] - nearest_rad) / static_cast<double>(shares.size());
  }
  score -= 0.4 * std::max(0.0, judged.torque_share - 0.25);
  score -= 5.0 * std::max(0.0, judged.torque_share - 0.8);
  score -= 0.1 * from_zero / M_PI;

  // 3. Where everything is: tibia upright, foot outside of the hip, belly and knees free.
  const Eigen::Vector3d tibia = pose.foot_m - pose.joint_m.back();
  score += 0.3 * -tibia.z() / std::max(1e-9, tibia.norm());
  const Eigen::Vector2d hip_m = leg.hip_m().head<2>() - task.middle_m;
  const Eigen::Vector2d foot_m = pose.foot_m.head<2>() - task.middle_m;
  const double outside = (foot_m.norm() - hip_m.norm()) / reach_m;
  score += 0.5 * std::clamp(outside, -0.5, 0.45);
  const Eigen::Vector2d out_m = foot_m - hip_m;
  // A leg in the middle, ahead or behind, stays there.
  const bool is_on_axis = isOnAxis(leg, task);
  if (is_on_axis) score -= 3.0 * std::abs(out_m.y()) / reach_m;
  // Others do not reach under the body, where they meet.
  const double inwards_m = std::abs(hip_m.y()) - std::copysign(1.0, hip_m.y()) * foot_m.y();
  if (!is_on_axis) score -= 2.0 * std::max(0.0, inwards_m) / reach_m;
  if (hip_m.norm() > 1e-6 && out_m.norm() > 1e-6) {
    const double cosine = out_m.dot(hip_m) / out_m.norm() / hip_m.norm();
    score += 0.15 * cosine * std::min(1.0, out_m.norm() / (0.3 * reach_m));
  }
  const double clearance_m = std::min(task.clearance_m, 0.35 * reach_m);
  score -= 3.0 * std::max(0.0, clearance_m - (task.belly_m - judged.floor_m)) / reach_m;
  score -= 3.0 * std::max(0.0, 0.15 - (pose.lowest_of_others_m - judged.floor_m) / reach_m);
  judged.score = score;
  return judged;
}

}  // namespace hexapod
