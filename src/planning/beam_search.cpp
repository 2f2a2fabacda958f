#include "planning/beam_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hexapod {
namespace {

// The first beam is so much narrower than the full one, and one that mends an earlier chain, of
// which the number of moves is known, so much narrower again.
constexpr std::size_t kNarrower = 10;
constexpr std::size_t kNarrowest = 3;
// What may be spent on better plans in any case: about 2 ms.
constexpr std::int64_t kLeastImprovement = 40000;
// An earlier chain is kept while it costs at most so much more than expected, in behaviours. How
// well it ends is settled when few are left.
constexpr double kAsExpected = 0.3;
constexpr double kAsExpectedFar = 1.0;
// Where only so many moves are left and miss, a chain of one more is taken at once if it costs at
// most so much more: it then ends better than was expected.
constexpr std::size_t kLastMoves = 2;
constexpr double kOneMore = 0.85;
// A new one may have so many moves more than what is left of the earlier one; but where few are
// left a better one is soon found.
constexpr int kLonger = 1;
constexpr std::size_t kShort = 4;

}  // namespace

BeamSearch::BeamSearch(const PlanningTables& tables, const PlannerOptions& options,
                       const SearchProblem& problem, int at_least)
    : tables_(tables),
      options_(options),
      problem_(problem),
      budget_(problem.effort * options.planning_time_s, problem.stop),
      tree_(tables, problem),
      finish_(tables, options, problem, tree_, budget_),
      beam_(tables, problem, tree_, budget_),
      at_least_(at_least) {}

SearchResult BeamSearch::run() {
  finish_.withNone(0);
  const bool keeps = keepsEarlier();
  if (!keeps) {
    if (at_least_ <= 3 || at_least_ > options_.max_steps) searchShortChains();
    const auto widest = static_cast<std::size_t>(options_.beam_width);
    const auto most_steps = static_cast<int>(options_.max_steps);
    searchLongChains(0, firstWidth(), most_steps);
    budget_.limitTo(finish_.found() ? std::max(budget_.spent(), kLeastImprovement)
                                    : std::numeric_limits<std::int64_t>::max());
    if (mayImprove() && !isAsGoodAsEarlier()) {
      searchLongChains(0, widest, finish_.found() ? tree_.steps(finish_.best()) - 1 : most_steps);
    }
    if (mayImprove() && finish_.found()) searchPairsOfPairs();
  }
  SearchResult result;
  result.found = finish_.found();
  result.exhausted = !budget_.isOver();
  result.at_least = at_least_;
  // Of a chain that is kept again and again the promise stays that of the first.
  result.price = finish_.best().price;
  if (keeps && !addedOneMove()) result.price = std::min(result.price, problem_.earlier_price);
  result.spent_s = static_cast<double>(budget_.spent()) / SearchBudget::kPosesPerSecond;
  result.chain = tree_.chainOf(result.found ? finish_.best() : finish_.nearest());
  return result;
}

/// Whether the earlier chain, with another end or at least its beginning, leads there as expected.
bool BeamSearch::keepsEarlier() {
  const std::size_t steps = problem_.earlier.size();
  if (steps == 0) return false;
  std::vector<Index> nodes = {0};
  for (const std::size_t move : problem_.earlier) {
    const Index next = tree_.add(nodes.back(), static_cast<Index>(move));
    if (!tree_.isFree(next)) break;
    nodes.push_back(next);
  }
  if (nodes.size() > steps) finish_.withNone(nodes[steps]);
  if (nodes.size() > steps - 1) {
    finish_.withOne(nodes[steps - 1], GoalFinish::kWidestOne_m, GoalFinish::kWidestOne_rad);
  }
  if (steps >= 2 && nodes.size() > steps - 2) finish_.withTwo(nodes[steps - 2]);
  if (isAsExpected()) return true;
  if (steps <= kLastMoves && findsOneMoreMove()) return true;
  if (steps >= 4 && nodes.size() > steps - 3) {
    exchangeEnd(nodes[steps - 3], steps > kShort ? mostExpected() : -GoalFinish::kInfinity);
  }
  if (isAsExpected()) return true;
  // From shortly before where it touches, or its last three; then from farther back.
  const std::size_t whole = std::min(nodes.size() - 1, steps - std::min<std::size_t>(steps, 3));
  const std::pair<std::size_t, std::size_t> attempts[] = {
      {whole - std::min<std::size_t>(whole, 2), firstWidth() / kNarrowest + 1},
      {whole / 2, firstWidth()}};
  for (const auto& [begin, width] : attempts) {
    if (begin == 0 || steps < begin + 4) continue;
    searchLongChains(nodes[begin], width, static_cast<int>(steps) + kLonger);
    if (isAsExpected()) return true;
  }
  return steps > kShort && isAsGoodAsEarlier();
}

/// What the earlier chain promised.
bool BeamSearch::isAsExpected() const {
  const std::size_t steps = problem_.earlier.size();
  return finish_.found() && tree_.steps(finish_.best()) <= static_cast<int>(steps) &&
         finish_.best().price <= mostExpected();
}

double BeamSearch::mostExpected() const {
  return problem_.earlier_price + (problem_.earlier.size() > kShort ? kAsExpectedFar : kAsExpected);
}

/// Of a chain of which little was left.
bool BeamSearch::addedOneMove() const {
  const std::size_t steps = problem_.earlier.size();
  return steps <= kLastMoves && tree_.steps(finish_.best()) > static_cast<int>(steps);
}

/// Good enough to leave it at that in the middle of a walk.
bool BeamSearch::isAsGoodAsEarlier() const {
  return finish_.found() && !problem_.earlier.empty() &&
         tree_.steps(finish_.best()) <= static_cast<int>(problem_.earlier.size()) + kLonger;
}

/// Whether a chain of a move more than are left, which miss, is good enough (kOneMore).
bool BeamSearch::findsOneMoreMove() {
  finish_.withOne(0, GoalFinish::kWidestOne_m, GoalFinish::kWidestOne_rad);
  ruleOut(1, finish_.seesAllPairs());
  finish_.withTwo(0);
  ruleOut(2, finish_.seesAllPairs());
  const double enough = problem_.earlier_price + kOneMore;
  if (problem_.earlier.size() == kLastMoves) exchangeEnd(0, enough);
  return finish_.best().price <= enough;
}

/// Ends a chain with any move and two more, until that costs no more than `enough`.
void BeamSearch::exchangeEnd(Index node, double enough) {
  for (Index move = 0; move < tables_.moves.size() && !budget_.isOver(); ++move) {
    if (finish_.best().price <= enough) return;
    if (tree_.isTooFar(tables_.moves[move].remaining(tree_[node].remaining), 2)) continue;
    finish_.withTwo(tree_.add(node, move));
  }
}

void BeamSearch::searchShortChains() {
  const GoalTolerance& tolerance = problem_.tolerance;
  finish_.withOne(0, GoalFinish::kInfinity, GoalFinish::kInfinity);
  ruleOut(1, true);
  if (settled(1)) return;
  addFirstMoves();
  for (Index node = 1; node <= first_moves_ && !budget_.isOver(); ++node) {
    finish_.withOne(node, GoalFinish::kWidestOne_m, GoalFinish::kWidestOne_rad);
  }
  ruleOut(2, tolerance.xy_m <= GoalFinish::kWidestOne_m &&
                 (tolerance.anyHeading() || tolerance.yaw_rad <= GoalFinish::kWidestOne_rad));
  if (settled(2)) return;
  for (Index node = 1; node <= first_moves_ && !budget_.isOver(); ++node) {
    if (!tree_.isTooFar(tree_[node].remaining, 2)) finish_.withTwo(node);
  }
  ruleOut(3, finish_.seesAllPairs());
}

void BeamSearch::addFirstMoves() {
  if (first_moves_ > 0) return;
  const Index before = tree_.size();
  for (Index move = 0; move < tables_.moves.size(); ++move) tree_.add(0, move);
  first_moves_ = tree_.size() - before;
}

/// All chains of that many moves were seen, if `exact`: none leads there, or one did.
void BeamSearch::ruleOut(int steps, bool exact) {
  if (exact && !budget_.isOver() && finish_.fewest() > steps && at_least_ == steps) ++at_least_;
}

/// True when no chain of more than `steps` moves can cost less than the best.
bool BeamSearch::settled(int steps) const { return finish_.best().price <= steps + 1.0; }

/// True while there is no plan, or one of fewer moves is not ruled out.
bool BeamSearch::mayImprove() const {
  return !finish_.found() || tree_.steps(finish_.best()) > at_least_;
}

std::size_t BeamSearch::firstWidth() const {
  return std::max<std::size_t>(1, static_cast<std::size_t>(options_.beam_width) / kNarrower);
}

/// Chains that begin with the one to a node, of four more up to `most_steps` moves.
void BeamSearch::searchLongChains(Index from, std::size_t width, int most_steps) {
  const int begun = tree_[from].steps;
  if (settled(begun + 3)) return;
  beam_.begin(from);
  for (int steps = begun + 1; steps <= most_steps && !budget_.isOver(); ++steps) {
    if (settled(steps + 1)) return;
    beam_.extend(width, movesLeft(most_steps, steps));
    if (beam_.chains().empty()) return;
    for (const Index node : beam_.chains()) {
      if (!finish_.found()) finish_.withNone(node);
    }
    if (steps == 1) continue;  // with two more these were all seen
    for (const Index node : beam_.chains()) {
      if (budget_.isOver()) return;
      if (!tree_.isTooFar(tree_[node].remaining, 2)) finish_.withTwo(node);
    }
  }
}

/// Moves that chains may still have; any number where there are only nearest ends to look for.
int BeamSearch::movesLeft(int most_steps, int steps) const {
  return at_least_ > options_.max_steps ? std::numeric_limits<int>::max() : most_steps - steps;
}

/// Sees every chain of four moves, to find one or to rule them out.
void BeamSearch::searchPairsOfPairs() {
  if (at_least_ != 4 || finish_.fewest() <= 4 || !finish_.seesAllPairs()) return;
  addFirstMoves();
  for (Index first = 1; first <= first_moves_; ++first) {
    if (tree_.isTooFar(tree_[first].remaining, 3)) continue;
    for (Index move = 0; move < tables_.moves.size(); ++move) {
      const Pose2 remaining = tables_.moves[move].remaining(tree_[first].remaining);
      if (tree_.isTooFar(remaining, 2)) continue;
      budget_.spend(kWorkOfChild);
      const GoalTolerance& tolerance = problem_.tolerance;
      const double half_width_rad = tolerance.anyHeading() ? M_PI : tolerance.yaw_rad;
      if (!tables_.pairs.mayEndNear(remaining, tolerance.xy_m, half_width_rad)) continue;
      finish_.withTwo(tree_.add(first, move));
    }
    if (budget_.isOver()) return;
  }
  ruleOut(4, true);
}

}  // namespace hexapod
