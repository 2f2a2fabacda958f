#pragma once

#include <limits>

#include "planning/chain_tree.h"
#include "planning/search_budget.h"

namespace hexapod {

/// Ends chains at the goal with one or two moves from the tables, and keeps the best.
class GoalFinish {
 public:
  using Index = ChainTree::Index;
  using Ending = ChainTree::Ending;

  /// How far around the goal tables are searched, whatever the tolerance: wider costs time and
  /// finds nothing better, narrower would not see the nearest of what misses.
  static constexpr double kWidestOne_m = 0.15;
  static constexpr double kWidestOne_rad = 0.35;
  static constexpr double kWidestTwo_m = 0.05;
  static constexpr double kWidestTwo_rad = 0.175;

  /// Keeps references to all of them.
  GoalFinish(const PlanningTables& tables, const PlannerOptions& options,
             const SearchProblem& problem, ChainTree& tree, SearchBudget& budget);

  /// Looks at the node itself, and at all chains that go on from it with one or two moves and end
  /// within the tolerance, or, of a wide one, within the given widths.
  void withNone(Index node);
  void withOne(Index node, double widest_m, double widest_rad);
  void withTwo(Index node);

  /// Whether withTwo() overlooks nothing.
  bool seesAllPairs() const;

  bool found() const { return best_.price < kInfinity; }
  /// The one of least price within tolerance; a price of infinity: none was found.
  const Ending& best() const { return best_; }
  /// Of the fewest moves seen within tolerance; many more than any plan has before there is one.
  int fewest() const { return fewest_; }
  /// Nearest end of all, looked for as long as none is within tolerance.
  const Ending& nearest() const { return nearest_; }

  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

 private:
  void consider(Ending ending, const Pose2& robot_from_end);
  double priceOf(const Ending& ending, double distance_m, double heading_rad) const;
  void considerNearest(const Ending& ending, double distance_m, double heading_rad);

  const PlanningTables& tables_;
  const PlannerOptions& options_;
  const SearchProblem& problem_;
  ChainTree& tree_;
  SearchBudget& budget_;
  EndCost end_cost_;
  Ending best_;
  Ending nearest_;
  int fewest_ = std::numeric_limits<int>::max();
};

}  // namespace hexapod
