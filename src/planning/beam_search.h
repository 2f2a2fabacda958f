#pragma once

#include <cstdint>
#include <vector>

#include "planning/beam.h"
#include "planning/chain_tree.h"
#include "planning/goal_finish.h"
#include "planning/search_budget.h"

namespace hexapod {

/// What a search found.
struct SearchResult {
  bool found = false;
  bool exhausted = true;           ///< false: cut short by the budget
  int at_least = 1;                ///< proved: no chain of fewer moves leads there
  double price = 0.0;              ///< that a found chain promises
  double spent_s = 0.0;            ///< of planning_time_s
  std::vector<std::size_t> chain;  ///< the best; when none was found: the one that ends nearest
};

/// One search for the chain of least cost that leads to a goal.
///
/// The state is the goal as seen from the robot. Chains are finished from tables: with one move,
/// found by the pose that remains, and with two moves, from the table of pairs. Chains of up to
/// three moves are thus all seen when the table holds all pairs (else nearly all); for longer ones
/// a Beam is extended move by move: first a narrow one, which gives a plan early, then the full one
/// while a plan of fewer moves is not ruled out and less was spent on better plans than on the
/// first. What is ruled out adds up to a lower bound: by StepsBound, by the ways, by what was seen
/// exhaustively; chains of four moves, if need be, by all pairs of pairs.
///
/// An earlier chain is kept as far as it still leads along free ways; its last moves are exchanged,
/// or only its beginning is kept, while the result is as good as expected. Deterministic; one
/// object per search, used by one thread.
class BeamSearch {
 public:
  /// Keeps references to all three.
  BeamSearch(const PlanningTables& tables, const PlannerOptions& options,
             const SearchProblem& problem, int at_least);

  /// To be called once.
  SearchResult run();

 private:
  using Index = ChainTree::Index;

  bool keepsEarlier();
  bool isAsExpected() const;
  double mostExpected() const;
  bool isAsGoodAsEarlier() const;
  bool findsOneMoreMove();
  bool addedOneMove() const;
  void exchangeEnd(Index node, double enough);
  void searchShortChains();
  void searchLongChains(Index from, std::size_t width, int most_steps);
  void searchPairsOfPairs();
  void addFirstMoves();
  void ruleOut(int steps, bool exact);
  int movesLeft(int most_steps, int steps) const;
  bool settled(int steps) const;
  bool mayImprove() const;
  std::size_t firstWidth() const;

  const PlanningTables& tables_;
  const PlannerOptions& options_;
  const SearchProblem& problem_;
  SearchBudget budget_;
  ChainTree tree_;
  GoalFinish finish_;
  Beam beam_;
  int at_least_;
  Index first_moves_ = 0;  ///< nodes 1 .. first_moves_ are those after one move
};

}  // namespace hexapod
