#pragma once

#include <cstdint>
#include <functional>
#include <unordered_set>
#include <vector>

#include "planning/plan_cost.h"
#include "planning/planning_tables.h"

namespace hexapod {

/// What a search found. Chains are indices into PlanningTables::moves, first move first.
struct SearchResult {
  bool found = false;
  bool exhausted = true;           ///< false: cut short by the limit on work or by `stop`
  std::vector<std::size_t> chain;  ///< the best; when none was found: the one that ends nearest
};

/// One search for the chain of least cost that leads to a goal.
///
/// The state is the goal as seen from the robot. Level by level (number of moves) states are
/// finished from tables: with one move, found by the pose that remains, and with two moves, from
/// the table of pairs. Chains of one and two moves are thus all seen, those of three nearly all;
/// beyond, a beam of the most promising states (cost so far + StepsToGo) is extended by
/// representative moves, at most one state per cell of position and heading. The search ends at the
/// level after which no longer chain can cost less. Deterministic; one object per search, used by
/// one thread.
class BeamSearch {
 public:
  struct Problem {
    Pose2 start_from_goal;
    GoalTolerance tolerance;
    std::function<bool()> stop;                                  ///< may be empty
    std::function<bool(const Pose2& start_from_robot)> is_free;  ///< may be empty
  };

  /// Keeps references to all three.
  BeamSearch(const PlanningTables& tables, const PlannerOptions& options, const Problem& problem);

  /// To be called once.
  SearchResult run();

 private:
  using Index = std::uint32_t;

  struct Node {
    Pose2 remaining;  ///< robot_from_goal
    Index parent = 0;
    Index move = 0;  ///< that led here from the parent
    int steps = 0;
    double cost = 0.0;
    Uncertainty uncertainty;
  };

  /// A node followed by `moves` (0 .. 2) more moves.
  struct Finish {
    double price;
    Index node = 0;
    int moves = 0;
    Index first = 0;
    Index second = 0;
  };

  /// A child that may enter the next beam.
  struct Candidate {
    double priority;
    Index parent;
    Index move;
    Pose2 remaining;
  };

  void searchShortChains();
  void searchLongChains();
  bool settled(int steps) const;
  bool stopped();

  void finishWithOne(Index node, double widest_m, double widest_rad);
  void finishWithTwo(Index node);
  void consider(Finish finish, const PoseTable::Chain& chain);
  void considerNearest(const Finish& finish, double distance_m, double heading_rad);

  std::vector<Index> nextBeam(const std::vector<Index>& beam);
  std::vector<Candidate> children(const std::vector<Index>& beam);
  Index addNode(Index parent, Index move, const Pose2& remaining);
  bool enterCell(const Pose2& remaining);

  bool isFree(const Finish& finish) const;
  bool isFreeStep(const Pose2& remaining, const Move& move) const;
  std::vector<std::size_t> chainOf(const Finish& finish) const;

  const PlanningTables& tables_;
  const PlannerOptions& options_;
  const Problem& problem_;
  EndCost end_cost_;
  double cell_m_;
  double cell_rad_;
  std::int64_t work_left_;
  bool cut_short_ = false;
  std::vector<Node> nodes_;
  std::unordered_set<std::uint64_t> cells_;  ///< already in a beam
  Finish best_;
  Finish nearest_;
};

}  // namespace hexapod
