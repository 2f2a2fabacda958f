#include "planning/beam_search.h"

#include <algorithm>
#include <limits>

#include "planning/path.h"

namespace hexapod {
namespace {

// Work per second of planning time, measured: 0.1 s of it takes 80 to 120 ms of one core at 250 to
// 5,000 entries, near and far goals, with or without heading.
constexpr double kPosesPerSecond = 20e6;
constexpr std::int64_t kWorkOfLookup = 10;
constexpr std::int64_t kWorkOfChild = 3;

// How far around the goal tables are searched, whatever the tolerance: wider costs time and finds
// nothing better, narrower would not see the nearest of what misses.
constexpr double kWidestOne_m = 0.15;
constexpr double kWidestOne_rad = 0.35;
constexpr double kWidestTwo_m = 0.05;
constexpr double kWidestTwo_rad = 0.175;
constexpr double kNarrowest_m = 0.01;
constexpr double kNarrowest_rad = 0.03;

constexpr double kCollisionSpacing_m = 0.02;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double largestTurn(const std::vector<Move>& moves) {
  double turn_rad = 0.0;
  for (const Move& move : moves) turn_rad = std::max(turn_rad, std::abs(move.end.yaw_rad));
  return turn_rad;
}

}  // namespace

// Cells are finer than a move, so that a repertoire of small moves still gets from cell to cell.
BeamSearch::BeamSearch(const PlanningTables& tables, const PlannerOptions& options,
                       const Problem& problem)
    : tables_(tables),
      options_(options),
      problem_(problem),
      end_cost_(problem.tolerance, options),
      cell_m_(std::clamp(tables.steps_to_go.reach_m() / 12.0, 0.002, 0.05)),
      cell_rad_(std::clamp(largestTurn(tables.moves) / 6.0, 0.01, 0.175)),
      work_left_(static_cast<std::int64_t>(options.planning_time_s * kPosesPerSecond)),
      best_{kInfinity},
      nearest_{kInfinity} {}

SearchResult BeamSearch::run() {
  nodes_.push_back({problem_.start_from_goal, 0, 0, 0, 0.0, {}});
  considerNearest({0.0}, std::hypot(nodes_[0].remaining.x_m, nodes_[0].remaining.y_m),
                  std::abs(nodes_[0].remaining.yaw_rad));
  searchShortChains();
  if (!settled(3)) searchLongChains();
  const bool found = best_.price < kInfinity;
  return {found, !cut_short_, chainOf(found ? best_ : nearest_)};
}

void BeamSearch::searchShortChains() {
  finishWithOne(0, kInfinity, kInfinity);
  if (settled(1)) return;
  for (Index move = 0; move < tables_.moves.size(); ++move) {
    if (!isFreeStep(nodes_[0].remaining, tables_.moves[move])) continue;
    addNode(0, move, tables_.moves[move].remaining(nodes_[0].remaining));
  }
  const auto count = static_cast<Index>(nodes_.size());
  for (Index node = 1; node < count && !stopped(); ++node) {
    finishWithOne(node, kWidestOne_m, kWidestOne_rad);
  }
  if (settled(2)) return;
  for (Index node = 1; node < count && !stopped(); ++node) finishWithTwo(node);
}

void BeamSearch::searchLongChains() {
  enterCell(nodes_[0].remaining);
  std::vector<Index> beam = {0};
  for (int steps = 1; steps <= options_.max_steps; ++steps) {
    beam = nextBeam(beam);
    if (beam.empty() || stopped()) return;
    if (steps == 1) continue;
    for (std::size_t i = 0; i < beam.size() && !stopped(); ++i) finishWithTwo(beam[i]);
    if (settled(steps + 2)) return;
  }
}

/// True when no chain of more than `steps` moves can cost less than the best, or when stopped.
bool BeamSearch::settled(int steps) const { return cut_short_ || best_.price <= steps + 1.0; }

bool BeamSearch::stopped() {
  cut_short_ = cut_short_ || work_left_ < 0 || (problem_.stop && problem_.stop());
  return cut_short_;
}

void BeamSearch::finishWithOne(Index node, double widest_m, double widest_rad) {
  if (nodes_[node].steps + 1 > options_.max_steps) return;
  const GoalTolerance& tolerance = problem_.tolerance;
  const double radius_m =
      std::clamp(tolerance.xy_m, kNarrowest_m, std::max(widest_m, kNarrowest_m));
  const double half_width_rad =
      tolerance.anyHeading() ? M_PI : std::clamp(tolerance.yaw_rad, kNarrowest_rad, widest_rad);
  work_left_ -= kWorkOfLookup;
  tables_.singles.visitNear(nodes_[node].remaining, radius_m, half_width_rad,
                            [&](const PoseTable::Chain& chain) {
                              consider({0.0, node, 1, chain.first, 0}, chain);
                            });
}

void BeamSearch::finishWithTwo(Index node) {
  if (nodes_[node].steps + 2 > options_.max_steps) return;
  const GoalTolerance& tolerance = problem_.tolerance;
  const double radius_m = std::clamp(tolerance.xy_m, kNarrowest_m, kWidestTwo_m);
  const double half_width_rad =
      tolerance.anyHeading() ? M_PI : std::clamp(tolerance.yaw_rad, kNarrowest_rad, kWidestTwo_rad);
  work_left_ -= kWorkOfLookup;
  tables_.pairs.visitNear(nodes_[node].remaining, radius_m, half_width_rad,
                          [&](const PoseTable::Chain& chain) {
                            consider({0.0, node, 2, chain.first, chain.second}, chain);
                          });
}

/// Keeps the finish when it is the best within tolerance, or, before there is one, the nearest.
void BeamSearch::consider(Finish finish, const PoseTable::Chain& chain) {
  --work_left_;
  const Node& node = nodes_[finish.node];
  const double distance_m =
      std::hypot(chain.end.x_m - node.remaining.x_m, chain.end.y_m - node.remaining.y_m);
  const double heading_rad = std::abs(wrapOnce(chain.end.yaw_rad - node.remaining.yaw_rad));
  const GoalTolerance& tolerance = problem_.tolerance;
  if (distance_m > tolerance.xy_m || (!tolerance.anyHeading() && heading_rad > tolerance.yaw_rad)) {
    if (best_.price == kInfinity) considerNearest(finish, distance_m, heading_rad);
    return;
  }
  const Move& first = tables_.moves[finish.first];
  finish.price = node.cost + first.cost;
  if (finish.moves == 2) finish.price += tables_.moves[finish.second].cost;
  if (finish.price + end_cost_.margin(distance_m, heading_rad) >= best_.price) return;
  Uncertainty uncertainty = node.uncertainty.after(first, kKeptWhenReplanned);
  if (finish.moves == 2) {
    uncertainty = uncertainty.after(tables_.moves[finish.second], kKeptWhenReplanned);
  }
  finish.price += end_cost_(distance_m, heading_rad, uncertainty);
  if (finish.price < best_.price && isFree(finish)) best_ = finish;
}

void BeamSearch::considerNearest(const Finish& finish, double distance_m, double heading_rad) {
  const GoalTolerance& tolerance = problem_.tolerance;
  double price = distance_m / tolerance.xy_m;
  if (!tolerance.anyHeading()) price += heading_rad / tolerance.yaw_rad;
  if (price >= nearest_.price || !isFree(finish)) return;
  nearest_ = finish;
  nearest_.price = price;
}

/// The best children, at most one per cell and none in a cell of an earlier beam.
std::vector<BeamSearch::Index> BeamSearch::nextBeam(const std::vector<Index>& beam) {
  std::vector<Candidate> candidates = children(beam);
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    if (a.priority != b.priority) return a.priority < b.priority;
    return a.parent != b.parent ? a.parent < b.parent : a.move < b.move;
  });
  std::vector<Index> next;
  for (const Candidate& candidate : candidates) {
    if (next.size() >= static_cast<std::size_t>(options_.beam_width)) break;
    const Move& move = tables_.moves[candidate.move];
    if (!isFreeStep(nodes_[candidate.parent].remaining, move)) continue;
    if (!enterCell(candidate.remaining)) continue;
    next.push_back(addNode(candidate.parent, candidate.move, candidate.remaining));
  }
  return next;
}

std::vector<BeamSearch::Candidate> BeamSearch::children(const std::vector<Index>& beam) {
  std::vector<Candidate> result;
  result.reserve(beam.size() * tables_.representatives.size());
  for (const Index parent : beam) {
    const Node& node = nodes_[parent];
    for (const std::size_t index : tables_.representatives) {
      const Move& move = tables_.moves[index];
      const Pose2 remaining = move.remaining(node.remaining);
      const double estimate = tables_.steps_to_go(remaining, problem_.tolerance.anyHeading());
      result.push_back(
          {node.cost + move.cost + estimate, parent, static_cast<Index>(index), remaining});
    }
    work_left_ -= kWorkOfChild * static_cast<std::int64_t>(tables_.representatives.size());
    if (stopped()) break;
  }
  return result;
}

BeamSearch::Index BeamSearch::addNode(Index parent, Index move, const Pose2& remaining) {
  const Node& from = nodes_[parent];
  const Move& step = tables_.moves[move];
  const auto index = static_cast<Index>(nodes_.size());
  nodes_.push_back({remaining, parent, move, from.steps + 1, from.cost + step.cost,
                    from.uncertainty.after(step, kKeptWhenReplanned)});
  if (best_.price == kInfinity) {
    considerNearest({0.0, index}, std::hypot(remaining.x_m, remaining.y_m),
                    std::abs(remaining.yaw_rad));
  }
  return index;
}

/// False when the cell was entered before.
bool BeamSearch::enterCell(const Pose2& remaining) {
  const auto cell = [](double value, double size) {
    return static_cast<std::uint64_t>(std::llround(value / size)) & 0x1fffff;
  };
  const bool any_heading = problem_.tolerance.anyHeading();
  const std::uint64_t heading = any_heading ? 0 : cell(remaining.yaw_rad, cell_rad_);
  return cells_
      .insert((cell(remaining.x_m, cell_m_) << 42) | (cell(remaining.y_m, cell_m_) << 21) | heading)
      .second;
}

/// The node itself was checked when it was made.
bool BeamSearch::isFree(const Finish& finish) const {
  if (!problem_.is_free || finish.moves == 0) return true;
  const Pose2& remaining = nodes_[finish.node].remaining;
  const Move& first = tables_.moves[finish.first];
  if (!isFreeStep(remaining, first)) return false;
  return finish.moves == 1 || isFreeStep(first.remaining(remaining), tables_.moves[finish.second]);
}

bool BeamSearch::isFreeStep(const Pose2& remaining, const Move& move) const {
  if (!problem_.is_free) return true;
  const Pose2 start_from_robot = problem_.start_from_goal * inverse(remaining);
  const std::vector<Pose2> poses = sampleStep(start_from_robot, move.end, kCollisionSpacing_m);
  return std::all_of(poses.begin(), poses.end(), problem_.is_free);
}

std::vector<std::size_t> BeamSearch::chainOf(const Finish& finish) const {
  std::vector<std::size_t> chain;
  for (Index node = finish.node; node != 0; node = nodes_[node].parent) {
    chain.push_back(nodes_[node].move);
  }
  std::reverse(chain.begin(), chain.end());
  if (finish.moves >= 1) chain.push_back(finish.first);
  if (finish.moves == 2) chain.push_back(finish.second);
  return chain;
}

}  // namespace hexapod
