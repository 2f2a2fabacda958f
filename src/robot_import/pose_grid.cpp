#include "robot_import/pose_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace hexapod {
namespace {

constexpr int kHeights = 30;     // at which standing is compared
constexpr double kNoPose = 1e6;  // of a score

// Values per joint of the grid of poses, by the number of joints.
int gridSize(std::size_t joints) { return joints <= 2 ? 33 : joints == 3 ? 13 : 7; }

// Calls use(angles) for every pose of a leg's grid: cell by cell, and angle 0.
template <typename Use>
void forEachPose(const LegModel& model, const Use& use) {
  const std::size_t n = model.jointCount();
  const int size = gridSize(n);
  std::vector<std::vector<double>> values(n);
  for (std::size_t j = 0; j < n; ++j) {
    const Joint& joint = model.leg().segments[j].joint;
    for (int i = 0; i < size; ++i) {
      values[j].push_back(joint.lower_rad + (i + 0.5) / size * (joint.upper_rad - joint.lower_rad));
    }
    values[j].push_back(std::clamp(0.0, joint.lower_rad, joint.upper_rad));
  }
  std::vector<std::size_t> at(n, 0);
  std::vector<double> angles(n);
  for (bool more = true; more;) {
    for (std::size_t j = 0; j < n; ++j) angles[j] = values[j][at[j]];
    use(angles);
    more = false;
    for (std::size_t j = 0; j < n && !more; ++j) {
      at[j] = (at[j] + 1) % values[j].size();
      more = at[j] != 0;
    }
  }
}

/// All ways to share joints between two signals, each of which gets at least one; of a single joint
/// any.
std::vector<SignalShares> waysToShare(std::size_t joints) {
  std::vector<SignalShares> ways;
  SignalShares shares(joints, 0);
  for (bool more = true; more;) {
    const bool has_both = std::count(shares.begin(), shares.end(), 1) > 0 &&
                          std::count(shares.begin(), shares.end(), 2) > 0;
    if (has_both || joints == 1) ways.push_back(shares);
    more = false;
    for (int& share : shares) {
      share = (share + 1) % 3;
      more = share != 0;
      if (more) break;
    }
  }
  return ways;
}

}  // namespace

double lowestFoot_m(const LegModel& leg) {
  double lowest_m = std::numeric_limits<double>::infinity();
  forEachPose(leg, [&](const std::vector<double>& angles) {
    lowest_m = std::min(lowest_m, leg.at(angles).floor_m);
  });
  return lowest_m;
}

PoseGrid::PoseGrid(const std::vector<LegModel>& legs, const StandingTask& task) : legs_(legs) {
  for (const LegModel& leg : legs) {
    groups_.emplace_back(leg.jointCount(), isOnAxis(leg, task));
    top_m_ = std::max(top_m_, leg.hip_m().z());
    bottom_m_ = std::min(bottom_m_, leg.hip_m().z() - leg.reach_m());
  }
  for (const LegModel& leg : legs) {
    std::map<SignalShares, ByHeight> by_shares;
    for (const SignalShares& shares : waysToShare(leg.jointCount())) {
      by_shares[shares].resize(kHeights);
    }
    forEachPose(leg, [&](const std::vector<double>& angles) {
      for (auto& [shares, by_height] : by_shares) {
        JudgedPose judged = judgePose(leg, task, shares, angles);
        std::optional<JudgedPose>& best = by_height[heightOf(judged.floor_m)];
        if (!best || judged.score > best->score) best = std::move(judged);
      }
    });
    found_.push_back(std::move(by_shares));
  }
}

std::size_t PoseGrid::heightOf(double floor_m) const {
  const double share = (top_m_ - floor_m) / (top_m_ - bottom_m_);
  return static_cast<std::size_t>(std::clamp(share * kHeights, 0.0, kHeights - 1.0));
}

SignalShares PoseGrid::bestShares(std::size_t leg, std::size_t height) const {
  return bestOf(groups_[leg], height).first;
}

std::pair<SignalShares, double> PoseGrid::bestOf(const Group& group, std::size_t height) const {
  std::pair<SignalShares, double> best{{}, -1e12};
  for (const SignalShares& shares : waysToShare(group.first)) {
    double sum = 0.0;
    for (std::size_t leg = 0; leg < legs_.size(); ++leg) {
      if (groups_[leg] != group) continue;
      const auto& pose = found_[leg].at(shares)[height];
      sum += pose ? pose->score : -kNoPose;
    }
    if (sum > best.second) best = {shares, sum};
  }
  return best;
}

std::optional<std::size_t> PoseGrid::bestHeight() const {
  const std::set<Group> groups(groups_.begin(), groups_.end());
  std::optional<std::size_t> best;
  double best_sum = -0.5 * kNoPose;
  for (std::size_t height = 0; height < kHeights; ++height) {
    double sum = 0.0;
    for (const Group& group : groups) sum += bestOf(group, height).second;
    if (sum > best_sum) best = height, best_sum = sum;
  }
  return best;
}

const JudgedPose& PoseGrid::best(std::size_t leg, const SignalShares& shares,
                                 std::size_t height) const {
  return *found_[leg].at(shares)[height];
}

}  // namespace hexapod
