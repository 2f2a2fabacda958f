#include "planning/beam_search.h"

#include <algorithm>
#include <cmath>

namespace hexapod {
namespace {

constexpr std::int64_t kWorkOfChild = 3;
constexpr std::int64_t kWorkOfChildOnWay = 6;
constexpr std::int64_t kWorkOfTest = 10;

// The first beam is so much narrower than the full one.
constexpr std::size_t kNarrower = 10;
// What may be spent on better plans in any case: about 2 ms.
constexpr std::int64_t kLeastImprovement = 40000;
// An earlier chain is kept while it costs at most so much more than expected, in behaviours.
constexpr double kAsExpected = 0.3;
// A new one may have so many moves more than what is left of the earlier one; but where few are
// left a better one is soon found.
constexpr int kLonger = 1;
constexpr std::size_t kShort = 4;

double largestTurn(const std::vector<Move>& moves) {
  double turn_rad = 0.0;
  for (const Move& move : moves) turn_rad = std::max(turn_rad, std::abs(move.end.yaw_rad));
  return turn_rad;
}

}  // namespace

// Cells are finer than a move, so that a repertoire of small moves still gets from cell to cell.
BeamSearch::BeamSearch(const PlanningTables& tables, const PlannerOptions& options,
                       const SearchProblem& problem, int at_least)
    : tables_(tables),
      options_(options),
      problem_(problem),
      budget_(problem.effort * options.planning_time_s, problem.stop),
      tree_(tables, problem),
      finish_(tables, options, problem, tree_, budget_),
      cell_m_(std::clamp(tables.steps_to_go.reach_m() / 12.0, 0.002, 0.05)),
      cell_rad_(std::clamp(largestTurn(tables.moves) / 6.0, 0.01, 0.175)),
      at_least_(at_least) {}

SearchResult BeamSearch::run() {
  finish_.withNone(0);
  if (!keepsEarlier()) {
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
  result.price = finish_.best().price;
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
  const auto keeps = [&] {
    return finish_.found() && tree_.steps(finish_.best()) <= static_cast<int>(steps) &&
           finish_.best().price <= problem_.earlier_price + kAsExpected;
  };
  if (nodes.size() > steps) finish_.withNone(nodes[steps]);
  if (nodes.size() > steps - 1) {
    finish_.withOne(nodes[steps - 1], GoalFinish::kWidestOne_m, GoalFinish::kWidestOne_rad);
  }
  if (steps >= 2 && nodes.size() > steps - 2) finish_.withTwo(nodes[steps - 2]);
  if (keeps()) return true;
  if (steps >= 4 && nodes.size() > steps - 3) exchangeEnd(nodes[steps - 3]);
  if (keeps()) return true;
  // From shortly before where it touches, or its last three; then from farther back.
  const std::size_t whole = std::min(nodes.size() - 1, steps - std::min<std::size_t>(steps, 3));
  for (const std::size_t begin : {whole - std::min<std::size_t>(whole, 2), whole / 2}) {
    if (begin == 0 || steps < begin + 4) continue;
    searchLongChains(nodes[begin], firstWidth(), static_cast<int>(steps) + kLonger);
    if (keeps()) return true;
  }
  return steps > kShort && isAsGoodAsEarlier();
}

/// Good enough to leave it at that in the middle of a walk.
bool BeamSearch::isAsGoodAsEarlier() const {
  return finish_.found() && !problem_.earlier.empty() &&
         tree_.steps(finish_.best()) <= static_cast<int>(problem_.earlier.size()) + kLonger;
}

/// Ends a chain with any move and two more.
void BeamSearch::exchangeEnd(Index node) {
  for (Index move = 0; move < tables_.moves.size() && !budget_.isOver(); ++move) {
    if (isTooFar(tables_.moves[move].remaining(tree_[node].remaining), 2)) continue;
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
    if (!isTooFar(tree_[node].remaining, 2)) finish_.withTwo(node);
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
  cells_.clear();
  enterCell(tree_[from].remaining);
  std::vector<Index> beam = {from};
  for (int steps = begun + 1; steps <= most_steps && !budget_.isOver(); ++steps) {
    if (settled(steps + 1)) return;
    beam = nextBeam(beam, width, movesLeft(most_steps, steps));
    if (beam.empty()) return;
    if (steps == 1) continue;  // with two more these were all seen
    for (const Index node : beam) {
      if (budget_.isOver()) return;
      if (!isTooFar(tree_[node].remaining, 2)) finish_.withTwo(node);
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
    if (isTooFar(tree_[first].remaining, 3)) continue;
    for (Index move = 0; move < tables_.moves.size(); ++move) {
      const Pose2 remaining = tables_.moves[move].remaining(tree_[first].remaining);
      if (isTooFar(remaining, 2)) continue;
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

/// The best children, at most one per cell and none in a cell of an earlier beam.
std::vector<BeamSearch::Index> BeamSearch::nextBeam(const std::vector<Index>& beam,
                                                    std::size_t width, int moves_left) {
  std::vector<Candidate> candidates = children(beam, moves_left);
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    if (a.priority != b.priority) return a.priority < b.priority;
    return a.parent != b.parent ? a.parent < b.parent : a.move < b.move;
  });
  std::vector<Index> next;
  for (const Candidate& candidate : candidates) {
    if (next.size() >= width) break;
    if (problem_.obstacles) budget_.spend(kWorkOfTest);
    if (!tree_.isFreeMove(candidate.parent, candidate.move)) continue;
    if (!enterCell(candidate.remaining)) continue;
    next.push_back(tree_.add(candidate.parent, candidate.move));
    if (!finish_.found()) finish_.withNone(next.back());
  }
  return next;
}

std::vector<BeamSearch::Candidate> BeamSearch::children(const std::vector<Index>& beam,
                                                        int moves_left) {
  std::vector<Candidate> result;
  result.reserve(beam.size() * tables_.representatives.size());
  for (const Index parent : beam) {
    addChildren(parent, moves_left, result);
    const auto count = static_cast<std::int64_t>(tables_.representatives.size());
    budget_.spend((problem_.ways ? kWorkOfChildOnWay : kWorkOfChild) * count);
    if (budget_.isOver()) break;
  }
  return result;
}

/// Those from which that many moves may still lead to the goal.
void BeamSearch::addChildren(Index parent, int moves_left, std::vector<Candidate>& candidates) {
  const ChainTree::Node& node = tree_[parent];
  const double cosine = std::cos(node.world_from_robot.yaw_rad);
  const double sine = std::sin(node.world_from_robot.yaw_rad);
  for (const std::size_t index : tables_.representatives) {
    const Move& move = tables_.moves[index];
    const Pose2 remaining = move.remaining(node.remaining);
    if (isTooFar(remaining, moves_left)) continue;
    const Pose2 world{node.world_from_robot.x_m + cosine * move.end.x_m - sine * move.end.y_m,
                      node.world_from_robot.y_m + sine * move.end.x_m + cosine * move.end.y_m,
                      wrapOnce(node.world_from_robot.yaw_rad + move.end.yaw_rad)};
    const double to_go = estimate(remaining, world);
    if (to_go == GoalFinish::kInfinity) continue;
    candidates.push_back(
        {node.cost + move.cost + to_go, parent, static_cast<Index>(index), remaining});
  }
}

/// Infinite where no way leads from.
double BeamSearch::estimate(const Pose2& remaining, const Pose2& world_from_robot) const {
  const bool any_heading = problem_.tolerance.anyHeading();
  if (!problem_.ways) return tables_.steps_to_go(remaining, any_heading);
  const auto way = problem_.ways->wayFrom(world_from_robot.x_m, world_from_robot.y_m);
  if (!way) return GoalFinish::kInfinity;
  return tables_.steps_to_go(
      {way->length_m, wrapAngle(way->direction_rad - world_from_robot.yaw_rad),
       wrapAngle(way->arrival_rad - way->direction_rad), remaining.yaw_rad},
      any_heading);
}

/// Whether the goal is farther than that many moves lead.
bool BeamSearch::isTooFar(const Pose2& remaining, int moves) const {
  const double reach_m = moves * tables_.steps_bound.longest_m() + problem_.tolerance.xy_m + 1e-9;
  return remaining.x_m * remaining.x_m + remaining.y_m * remaining.y_m > reach_m * reach_m ||
         moves < 0;
}

/// False when the cell was entered before. Headings count even where the goal has none: what is
/// one behaviour away in one heading may be three away in another.
bool BeamSearch::enterCell(const Pose2& remaining) {
  const auto cell = [](double value, double size) {
    return static_cast<std::uint64_t>(std::llround(value / size)) & 0x1fffff;
  };
  return cells_
      .insert((cell(remaining.x_m, cell_m_) << 42) | (cell(remaining.y_m, cell_m_) << 21) |
              cell(remaining.yaw_rad, cell_rad_))
      .second;
}

}  // namespace hexapod
