#include "planning/goal_finish.h"

#include <algorithm>
#include <cmath>

namespace hexapod {
namespace {

constexpr double kNarrowest_m = 0.01;
constexpr double kNarrowest_rad = 0.03;

}  // namespace

GoalFinish::GoalFinish(const PlanningTables& tables, const PlannerOptions& options,
                       const SearchProblem& problem, ChainTree& tree, SearchBudget& budget)
    : tables_(tables),
      options_(options),
      problem_(problem),
      tree_(tree),
      budget_(budget),
      end_cost_(problem.tolerance, options) {
  best_.price = kInfinity;
  nearest_.price = kInfinity;
}

bool GoalFinish::seesAllPairs() const {
  const GoalTolerance& tolerance = problem_.tolerance;
  return tolerance.xy_m <= kWidestTwo_m &&
         (tolerance.anyHeading() || tolerance.yaw_rad <= kWidestTwo_rad);
}

void GoalFinish::withNone(Index node) {
  Ending ending;
  ending.node = node;
  consider(ending, {});
}

void GoalFinish::withOne(Index node, double widest_m, double widest_rad) {
  if (tree_[node].steps + 1 > options_.max_steps) return;
  const GoalTolerance& tolerance = problem_.tolerance;
  const double radius_m =
      std::clamp(tolerance.xy_m, kNarrowest_m, std::max(widest_m, kNarrowest_m));
  const double half_width_rad =
      tolerance.anyHeading() ? M_PI : std::clamp(tolerance.yaw_rad, kNarrowest_rad, widest_rad);
  budget_.spend(kWorkOfLookup);
  tables_.singles.visitNear(tree_[node].remaining, radius_m, half_width_rad,
                            [&](const PoseTable::Chain& chain) {
                              consider({0.0, node, 1, chain.first, 0}, chain.end);
                            });
}

void GoalFinish::withTwo(Index node) {
  if (tree_[node].steps + 2 > options_.max_steps) return;
  const GoalTolerance& tolerance = problem_.tolerance;
  const double radius_m = std::clamp(tolerance.xy_m, kNarrowest_m, kWidestTwo_m);
  const double half_width_rad =
      tolerance.anyHeading() ? M_PI : std::clamp(tolerance.yaw_rad, kNarrowest_rad, kWidestTwo_rad);
  budget_.spend(kWorkOfLookup);
  tables_.pairs.visitNear(tree_[node].remaining, radius_m, half_width_rad,
                          [&](const PoseTable::Chain& chain) {
                            consider({0.0, node, 2, chain.first, chain.second}, chain.end);
                          });
}

/// Keeps the ending when it is the best within tolerance, or, before there is one, the nearest.
void GoalFinish::consider(Ending ending, const Pose2& robot_from_end) {
  budget_.spend(1);
  const Pose2& remaining = tree_[ending.node].remaining;
  const double distance_m =
      std::hypot(robot_from_end.x_m - remaining.x_m, robot_from_end.y_m - remaining.y_m);
  const double heading_rad = std::abs(wrapOnce(robot_from_end.yaw_rad - remaining.yaw_rad));
  const GoalTolerance& tolerance = problem_.tolerance;
  if (distance_m > tolerance.xy_m || (!tolerance.anyHeading() && heading_rad > tolerance.yaw_rad)) {
    if (!found()) considerNearest(ending, distance_m, heading_rad);
    return;
  }
  const int steps = tree_.steps(ending);
  ending.price = priceOf(ending, distance_m, heading_rad);
  if (ending.price >= best_.price && steps >= fewest_) return;
  budget_.spend(problem_.obstacles ? kWorkOfTest : 0);
  if (!tree_.isFree(ending)) return;
  const bool fewer = steps < fewest_;
  fewest_ = std::min(fewest_, steps);
  if (ending.price < best_.price) best_ = ending;
  if (fewer && problem_.improved) problem_.improved(static_cast<std::size_t>(tree_.steps(best_)));
}

/// At least its price, and exactly that where it matters: below that of the best.
double GoalFinish::priceOf(const Ending& ending, double distance_m, double heading_rad) const {
  const ChainTree::Node& node = tree_[ending.node];
  double price = node.cost;
  if (ending.moves >= 1) price += tree_.costOf(ending.node, ending.first);
  if (ending.moves == 2) price += tables_.moves[ending.second].cost;
  const double least = price + end_cost_.margin(distance_m, heading_rad);
  if (least >= best_.price) return least;
  Uncertainty uncertainty = node.uncertainty;
  if (ending.moves >= 1) {
    uncertainty = uncertainty.after(tables_.moves[ending.first], kKeptWhenReplanned);
  }
  if (ending.moves == 2) {
    uncertainty = uncertainty.after(tables_.moves[ending.second], kKeptWhenReplanned);
  }
  return price + end_cost_(distance_m, heading_rad, uncertainty);
}

void GoalFinish::considerNearest(const Ending& ending, double distance_m, double heading_rad) {
  const GoalTolerance& tolerance = problem_.tolerance;
  double price = distance_m / tolerance.xy_m;
  if (!tolerance.anyHeading()) price += heading_rad / tolerance.yaw_rad;
  if (price >= nearest_.price) return;
  budget_.spend(problem_.obstacles ? kWorkOfTest : 0);
  if (!tree_.isFree(ending)) return;
  nearest_ = ending;
  nearest_.price = price;
}

}  // namespace hexapod
