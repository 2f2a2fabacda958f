#include "planning/beam.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexapod {
namespace {

double largestTurn(const std::vector<Move>& moves) {
  double turn_rad = 0.0;
  for (const Move& move : moves) turn_rad = std::max(turn_rad, std::abs(move.end.yaw_rad));
  return turn_rad;
}

}  // namespace

// Cells are finer than a move, so that a repertoire of small moves still gets from cell to cell.
Beam::Beam(const PlanningTables& tables, const SearchProblem& problem, ChainTree& tree,
           SearchBudget& budget)
    : tables_(tables),
      problem_(problem),
      tree_(tree),
      budget_(budget),
      cell_m_(std::clamp(tables.steps_to_go.reach_m() / 12.0, 0.002, 0.05)),
      cell_rad_(std::clamp(largestTurn(tables.moves) / 6.0, 0.01, 0.175)) {}

void Beam::begin(Index from) {
  cells_.clear();
  enterCell(tree_[from].remaining);
  chains_ = {from};
}

void Beam::extend(std::size_t width, int moves_left) {
  std::vector<Candidate> candidates = children(moves_left);
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    if (a.priority != b.priority) return a.priority < b.priority;
    return a.parent != b.parent ? a.parent < b.parent : a.move < b.move;
  });
  chains_.clear();
  for (const Candidate& candidate : candidates) {
    if (chains_.size() >= width) break;
    if (problem_.obstacles) budget_.spend(kWorkOfTest);
    if (!tree_.isFreeMove(candidate.parent, candidate.move)) continue;
    if (enterCell(candidate.remaining))
      chains_.push_back(tree_.add(candidate.parent, candidate.move));
  }
}

std::vector<Beam::Candidate> Beam::children(int moves_left) {
  std::vector<Candidate> result;
  result.reserve(chains_.size() * tables_.representatives.size());
  for (const Index parent : chains_) {
    addChildren(parent, moves_left, result);
    const auto count = static_cast<std::int64_t>(tables_.representatives.size());
    budget_.spend((problem_.ways ? kWorkOfChildOnWay : kWorkOfChild) * count);
    if (budget_.isOver()) break;
  }
  return result;
}

/// Those from which that many moves may still lead to the goal.
void Beam::addChildren(Index parent, int moves_left, std::vector<Candidate>& candidates) const {
  const ChainTree::Node& node = tree_[parent];
  const double cosine = std::cos(node.world_from_robot.yaw_rad);
  const double sine = std::sin(node.world_from_robot.yaw_rad);
  for (const std::size_t index : tables_.representatives) {
    const Move& move = tables_.moves[index];
    const Pose2 remaining = move.remaining(node.remaining);
    if (tree_.isTooFar(remaining, moves_left)) continue;
    const Pose2 world{node.world_from_robot.x_m + cosine * move.end.x_m - sine * move.end.y_m,
                      node.world_from_robot.y_m + sine * move.end.x_m + cosine * move.end.y_m,
                      wrapOnce(node.world_from_robot.yaw_rad + move.end.yaw_rad)};
    const double to_go = stepsToGo(remaining, world);
    if (to_go == std::numeric_limits<double>::infinity()) continue;
    candidates.push_back(
        {node.cost + move.cost + to_go, parent, static_cast<Index>(index), remaining});
  }
}

/// Infinite where no way leads from.
double Beam::stepsToGo(const Pose2& remaining, const Pose2& world_from_robot) const {
  const bool any_heading = problem_.tolerance.anyHeading();
  if (!problem_.ways) return tables_.steps_to_go(remaining, any_heading);
  return tables_.steps_to_go(*problem_.ways, world_from_robot, remaining.yaw_rad, any_heading);
}

/// False when the cell was entered before. Headings count even where the goal has none: what is
/// one behaviour away in one heading may be three away in another.
bool Beam::enterCell(const Pose2& remaining) {
  const auto cell = [](double value, double size) {
    return static_cast<std::uint64_t>(std::llround(value / size)) & 0x1fffff;
  };
  return cells_
      .insert((cell(remaining.x_m, cell_m_) << 42) | (cell(remaining.y_m, cell_m_) << 21) |
              cell(remaining.yaw_rad, cell_rad_))
      .second;
}

}  // namespace hexapod
