#include "planning/adaptive_planner.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "planning/deviation.h"
#include "planning/move.h"
#include "planning/plan_messages.h"

namespace hexapod {
namespace {

// Below this a drift is not worth a second search [m].
constexpr double kNoDrift_m = 0.001;
// With a drift so many behaviours fewer and more than on a level floor are tried.
constexpr std::size_t kFewerTried = 2;
constexpr std::size_t kMoreTried = 2;
// Searches until a chain leads where it promised.
constexpr int kMostSearches = 4;
// A chain that misses its target by so much of the tolerance will do.
constexpr double kSurelyThere = 0.7;

Pose2 shifted(const Pose2& pose, const Eigen::Vector2d& by_m) {
  return {pose.x_m + by_m.x(), pose.y_m + by_m.y(), pose.yaw_rad};
}

// Coordinate by coordinate.
Pose2 sum(const Pose2& a, const Pose2& b) {
  return {a.x_m + b.x_m, a.y_m + b.y_m, wrapAngle(a.yaw_rad + b.yaw_rad)};
}

Pose2 difference(const Pose2& a, const Pose2& b) {
  return {a.x_m - b.x_m, a.y_m - b.y_m, wrapAngle(a.yaw_rad - b.yaw_rad)};
}

// The behaviours of a plan, and how surely they are all: one that misses needs at least another.
double priceOf(const PlanResult& plan, double missed) {
  const double more = missed <= 1.0 ? missed * missed : 1.0 + std::min(1.0, missed - 1.0);
  return static_cast<double>(plan.steps.size()) + more;
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

double AdaptivePlanner::reach_m() const {
  double reach_m = 0.0;
  for (const Entry& entry : repertoire_->entries) {
    const Pose2 end = entry.expectedPose();
    const double way_m = std::hypot(end.x_m, end.y_m);
    if (std::isfinite(way_m)) reach_m = std::max(reach_m, way_m);
  }
  return reach_m;
}

void AdaptivePlanner::prepare(const std::function<bool()>& stop) {
  if (foresight_) foresight_->prepare(repertoire_, stop);
}

std::shared_ptr<const Planner> AdaptivePlanner::planner() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return planner_;
}

PlanResult AdaptivePlanner::planDrifting(const Planner& planner, const PlanRequest& request) const {
  PlanResult result = planner.plan(request);
  if (result.code == PlanCode::kNoRepertoire && !usableMoves(*repertoire_, options_).empty()) {
    result.message = nothingWalks(repertoire_->entries.size());
  }
  const Eigen::Vector2d drift_m =
      foresight_ ? foresight_->drift_m() : Eigen::Vector2d(Eigen::Vector2d::Zero());
  if (drift_m.norm() < kNoDrift_m) return result;
  if (result.code != PlanCode::kFound) return result;
  // The fewest behaviours that lead to the goal less as many drifts: not only the first number that
  // agrees, for between its behaviours a chain that is never finished drifts on for ever.
  const std::size_t level = result.steps.size();
  const std::size_t first = level > kFewerTried ? level - kFewerTried : 1;
  for (std::size_t behaviors = first; behaviors <= level + kMoreTried; ++behaviors) {
    PlanRequest drifting = request;
    drifting.world_from_goal =
        shifted(request.world_from_goal, -static_cast<double>(behaviors) * drift_m);
    PlanResult found = planner.plan(drifting);
    found.effort += result.effort;
    result.effort = found.effort;
    // The goal less its drift is where the robot stands: the chain found before is the better one.
    if (found.code != PlanCode::kFound) continue;
    result = std::move(found);
    if (result.steps.size() <= behaviors) break;
  }
  addDrift(drift_m, result);
  return result;
}

/// Puts the poses that its chain leads to into a plan; false when they are not known.
bool AdaptivePlanner::follow(const PlanRequest& request, PlanResult& result) const {
  if (!foresight_ || result.code != PlanCode::kFound) return false;
  std::vector<Entry> chain;
  for (const PlannedStep& step : result.steps) chain.push_back(repertoire_->entries[step.entry]);
  const std::vector<Pose2> poses = foresight_->follow(request.world_from_start, chain);
  if (poses.size() != chain.size()) return false;
  for (std::size_t i = 0; i < poses.size(); ++i) result.steps[i].world_from_end = poses[i];
  result.world_from_end = poses.back();
  return true;
}

PlanResult AdaptivePlanner::plan(const PlanRequest& request) const {
  const std::shared_ptr<const Planner> planner = this->planner();
  PlanRequest corrected = request;
  if (foresight_) corrected.first_prices = foresight_->caution(repertoire_);
  PlanResult best;
  double least = std::numeric_limits<double>::infinity(), effort = 0.0;
  std::size_t proved = 0;
  for (int search = 0; search < kMostSearches; ++search) {
    PlanResult found = planDrifting(*planner, corrected);
    effort += found.effort;
    const Pose2 promised = found.world_from_end;
    if (!follow(request, found)) {
      if (search == 0) return found;
      break;
    }
    if (search == 0) proved = found.at_least_steps;  // those after it are to other goals
    // What was planned to is where the corrected goal is from the goal.
    found.world_from_target = sum(found.world_from_target,
                                  difference(request.world_from_goal, corrected.world_from_goal));
    found.distance_m = distance(found.world_from_end, found.world_from_target);
    found.heading_rad = headingDistance(found.world_from_end, found.world_from_target);
    corrected.world_from_goal =
        difference(request.world_from_goal, difference(found.world_from_end, promised));
    const double missed = found.shareMissed(request.tolerance);
    const double price = priceOf(found, missed);
    if (price < least) {
      least = price;
      best = std::move(found);
    }
    if (missed <= kSurelyThere) break;
  }
  best.effort = effort;
  best.at_least_steps = std::min(proved, best.steps.size());
  best.message = describe(best, request, options_);  // with the poses followed
  return best;
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
  auto planner = std::make_shared<const Planner>(*expected_, options_, paths_);
  const std::lock_guard<std::mutex> lock(mutex_);
  planner_ = std::move(planner);
}

}  // namespace hexapod
