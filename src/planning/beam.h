#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <vector>

#include "planning/chain_tree.h"
#include "planning/search_budget.h"

namespace hexapod {

/// The most promising chains of one length, by cost so far and StepsToGo along the ways around
/// obstacles: at most one per cell of position and heading, and none in a cell of a shorter one.
/// Deterministic.
class Beam {
 public:
  using Index = ChainTree::Index;

  /// Keeps references to all of them.
  Beam(const PlanningTables& tables, const SearchProblem& problem, ChainTree& tree,
       SearchBudget& budget);

  /// Begins anew with one chain.
  void begin(Index from);

  /// Goes on to the best chains of one more representative move, at most `width`, from which
  /// `moves_left` more may still lead to the goal. Ends early when the budget is over.
  void extend(std::size_t width, int moves_left);

  const std::vector<Index>& chains() const { return chains_; }

 private:
  /// A chain that may be among them.
  struct Candidate {
    double priority;
    Index parent;
    Index move;
    Pose2 remaining;
  };

  std::vector<Candidate> children(int moves_left);
  void addChildren(Index parent, int moves_left, std::vector<Candidate>& candidates) const;
  double stepsToGo(const Pose2& remaining, const Pose2& world_from_robot) const;
  bool enterCell(const Pose2& remaining);

  const PlanningTables& tables_;
  const SearchProblem& problem_;
  ChainTree& tree_;
  SearchBudget& budget_;
  double cell_m_;
  double cell_rad_;
  std::vector<Index> chains_;
  std::unordered_set<std::uint64_t> cells_;  ///< entered since begin()
};

}  // namespace hexapod
