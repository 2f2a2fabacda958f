#include "planning/adaptive_planner.h"

#include <utility>

#include "planning/deviation.h"

namespace hexapod {
namespace {

// Below this a drift is not worth a second search [m].
constexpr double kNoDrift_m = 0.001;
// Searches until the number of behaviours agrees with the drift it was sought with.
constexpr int kMostSearches = 4;

Pose2 shifted(const Pose2& pose, const Eigen::Vector2d& by_m) {
  return {pose.x_m + by_m.x(), pose.y_m + by_m.y(), pose.yaw_rad};
}

// The chain as it will be walked: every behaviour adds its drift.
void addDrift(const Eigen::Vector2d& drift_m, PlanResult& result) {
  double behaviors = 0.0;
  for (PlannedStep& step : result.steps) {
    step.world_from_end = shifted(step.world_from_end, ++behaviors * drift_m);
  }
  result.world_from_end = shifted(result.world_from_end, behaviors * drift_m);
  result.world_from_target = shifted(result.world_from_target, behaviors * drift_m);
}

}  // namespace

AdaptivePlanner::AdaptivePlanner(const Repertoire& repertoire, const PlannerOptions& options,
                                 std::shared_ptr<Foresight> foresight, EntryPaths paths)
    : repertoire_(std::make_shared<const Repertoire>(repertoire)),
      options_(options),
      foresight_(std::move(foresight)),
      expected_(foresight_ ? foresight_->expected(repertoire_) : repertoire_),
      paths_(std::move(paths)) {
  rebuild();
}

AdaptivePlanner::AdaptivePlanner(const Repertoire& repertoire, const PlannerOptions& options)
    : AdaptivePlanner(repertoire, options, std::make_shared<DeviationForesight>()) {}

AdaptivePlanner::AdaptivePlanner(const Repertoire& repertoire, const AdaptivePlanner& earlier,
                                 EntryPaths paths)
    : AdaptivePlanner(repertoire, earlier.options_, earlier.foresight_, std::move(paths)) {}

AdaptivePlanner::AdaptivePlanner(const AdaptivePlanner& like, std::shared_ptr<Foresight> foresight)
    : repertoire_(like.repertoire_),
      options_(like.options_),
      foresight_(std::move(foresight)),
      expected_(foresight_ ? foresight_->expected(repertoire_) : repertoire_),
      paths_(like.paths_),
      planner_(expected_ == like.expected_ ? like.planner() : nullptr) {
  if (!planner_) rebuild();
}

std::shared_ptr<const Planner> AdaptivePlanner::planner() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return planner_;
}

PlanResult AdaptivePlanner::plan(const PlanRequest& request) const {
  const std::shared_ptr<const Planner> planner = this->planner();
  PlanResult result = planner->plan(request);
  const Eigen::Vector2d drift_m =
      foresight_ ? foresight_->drift_m() : Eigen::Vector2d(Eigen::Vector2d::Zero());
  if (drift_m.norm() < kNoDrift_m) return result;
  for (int search = 0; search < kMostSearches && result.code == PlanCode::kFound; ++search) {
    const std::size_t behaviors = result.steps.size();
    PlanRequest drifting = request;
    drifting.world_from_goal =
        shifted(request.world_from_goal, -static_cast<double>(behaviors) * drift_m);
    PlanResult found = planner->plan(drifting);
    found.effort += result.effort;
    // The goal less its drift is where the robot stands: the chain found before is the better one.
    if (found.code == PlanCode::kAlreadyThere) break;
    result = std::move(found);
    if (result.steps.size() == behaviors) break;
  }
  addDrift(drift_m, result);
  return result;
}

void AdaptivePlanner::observe(std::size_t entry, const Pose2& world_from_before,
                              const Pose2& world_from_after,
                              const std::vector<JointRange>& joints) {
  if (!foresight_) return;
  foresight_->observe(
      {repertoire_->entries.at(entry), world_from_before, world_from_after, joints});
  std::shared_ptr<const Repertoire> expected = foresight_->expected(repertoire_);
  const std::lock_guard<std::mutex> lock(build_mutex_);
  if (expected == expected_) return;
  expected_ = std::move(expected);
  rebuild();
}

void AdaptivePlanner::setPaths(EntryPaths paths) {
  const std::lock_guard<std::mutex> lock(build_mutex_);
  paths_ = std::move(paths);
  rebuild();
}

/// With build_mutex_, or before anybody else knows of it.
void AdaptivePlanner::rebuild() {
  auto planner = std::make_shared<const Planner>(*expected_, options_, Deviation{}, paths_);
  const std::lock_guard<std::mutex> lock(mutex_);
  planner_ = std::move(planner);
}

}  // namespace hexapod
