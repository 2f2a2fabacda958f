#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "robot_import/judge_pose.h"
#include "robot_import/leg_model.h"

namespace hexapod {

/// Lowest that a leg's foot gets within the limits of its joints, in the base [m].
double lowestFoot_m(const LegModel& leg);

/// The best poses of all legs over a grid of their angles, by the height of the feet, so that a
/// height can be chosen that suits all legs.
class PoseGrid {
 public:
  /// Judges every pose of every leg, in every way to share. `legs` must outlive it.
  PoseGrid(const std::vector<LegModel>& legs, const StandingTask& task);

  /// The height at which the legs together stand best; nothing when there is none for all of them.
  std::optional<std::size_t> bestHeight() const;

  /// Sharing that suits a leg at a height, and all others of as many joints; those ahead of the
  /// robot and behind it share by themselves, as they step otherwise.
  SignalShares bestShares(std::size_t leg, std::size_t height) const;

  /// There must be one.
  const JudgedPose& best(std::size_t leg, const SignalShares& shares, std::size_t height) const;

 private:
  using ByHeight = std::vector<std::optional<JudgedPose>>;
  /// Legs that share alike: their number of joints, and whether they are on the axis.
  using Group = std::pair<std::size_t, bool>;

  std::size_t heightOf(double floor_m) const;
  /// With the sum of their scores.
  std::pair<SignalShares, double> bestOf(const Group& group, std::size_t height) const;

  const std::vector<LegModel>& legs_;
  double top_m_ = 0.0, bottom_m_ = 0.0;  // between which heights are compared
  std::vector<Group> groups_;            // per leg
  std::vector<std::map<SignalShares, ByHeight>> found_;
};

}  // namespace hexapod
