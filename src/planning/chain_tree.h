#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "planning/obstacles.h"
#include "planning/plan_cost.h"
#include "planning/planning_tables.h"
#include "planning/way_field.h"

namespace hexapod {

/// What one search is about. Chains are indices into PlanningTables::moves, first move first.
struct SearchProblem {
  Pose2 world_from_start;
  Pose2 world_from_goal;
  GoalTolerance tolerance;
  const Obstacles* obstacles = nullptr;  ///< none: everything is free
  const WayField* ways = nullptr;        ///< to the goal, where there are obstacles
  double least_clearance_m = 0.0;        ///< of the first move; negative: it leaves the margin
  std::vector<std::size_t> earlier;      ///< chain to keep when it still does
  double earlier_price = 0.0;            ///< that it was expected to have from here
  std::vector<double> first_prices;      ///< of moves as the first one, beside; empty: none
  double effort = 1.0;                   ///< share of planning_time_s that may be spent
  std::function<bool()> stop;            ///< may be empty
  std::function<void(std::size_t steps)> improved;  ///< may be empty; called at each better plan
};

/// The chains that a search has begun, as a tree that shares their beginnings.
class ChainTree {
 public:
  using Index = std::uint32_t;

  struct Node {
    Pose2 remaining;  ///< robot_from_goal
    Pose2 world_from_robot;
    Index parent = 0;
    Index move = 0;  ///< that led here from the parent
    int steps = 0;
    double cost = 0.0;
    Uncertainty uncertainty;
    enum class Reach : std::uint8_t { kUntested, kFree, kTouches } reach = Reach::kUntested;
  };

  /// A node followed by `moves` (0 .. 2) more moves.
  struct Ending {
    double price = 0.0;
    Index node = 0;
    int moves = 0;
    Index first = 0;
    Index second = 0;
  };

  /// Keeps references to both.
  ChainTree(const PlanningTables& tables, const SearchProblem& problem);

  const Node& operator[](Index node) const { return nodes_[node]; }
  Index size() const { return static_cast<Index>(nodes_.size()); }

  /// The node after one more move; its way is tested when first asked for.
  Index add(Index parent, Index move);

  /// What a move costs after a node, in behaviours.
  double costOf(Index node, Index move) const;

  /// Whether the robot gets there without touching anything.
  bool isFree(Index node);
  bool isFree(const Ending& ending);
  bool isFreeMove(Index node, Index move) const;

  /// Whether the goal, seen so, is farther than that many moves lead.
  bool isTooFar(const Pose2& remaining, int moves) const;

  int steps(const Ending& ending) const { return nodes_[ending.node].steps + ending.moves; }
  std::vector<std::size_t> chainOf(const Ending& ending) const;

  /// How many moves were tested against the obstacles.
  std::int64_t tested() const { return tested_; }

 private:
  bool isFreeMove(const Pose2& world_from_robot, Index move, bool first) const;

  const PlanningTables& tables_;
  const SearchProblem& problem_;
  std::vector<Node> nodes_;
  mutable std::int64_t tested_ = 0;
};

}  // namespace hexapod
