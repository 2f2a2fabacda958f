#include "planning/chain_tree.h"

#include <algorithm>

namespace hexapod {

ChainTree::ChainTree(const PlanningTables& tables, const SearchProblem& problem)
    : tables_(tables), problem_(problem) {
  Node root;
  root.remaining = inverse(problem.world_from_start) * problem.world_from_goal;
  root.world_from_robot = problem.world_from_start;
  root.reach = Node::Reach::kFree;
  nodes_.push_back(root);
}

ChainTree::Index ChainTree::add(Index parent, Index move) {
  const Node& from = nodes_[parent];
  const Move& step = tables_.moves[move];
  Node node;
  node.remaining = step.remaining(from.remaining);
  if (problem_.obstacles) node.world_from_robot = from.world_from_robot * step.end;
  node.parent = parent;
  node.move = move;
  node.steps = from.steps + 1;
  node.cost = from.cost + costOf(parent, move);
  node.uncertainty = from.uncertainty.after(step, kKeptWhenReplanned);
  nodes_.push_back(node);
  return size() - 1;
}

double ChainTree::costOf(Index node, Index move) const {
  const double cost = tables_.moves[move].cost;
  return node > 0 || problem_.first_prices.empty() ? cost : cost + problem_.first_prices[move];
}

bool ChainTree::isFree(Index node) {
  if (!problem_.obstacles) return true;
  using Reach = Node::Reach;
  if (nodes_[node].reach == Reach::kUntested) {
    const bool free =
        isFree(nodes_[node].parent) && isFreeMove(nodes_[node].parent, nodes_[node].move);
    nodes_[node].reach = free ? Reach::kFree : Reach::kTouches;
  }
  return nodes_[node].reach == Reach::kFree;
}

bool ChainTree::isFree(const Ending& ending) {
  if (!problem_.obstacles) return true;
  if (!isFree(ending.node)) return false;
  if (ending.moves == 0) return true;
  if (!isFreeMove(ending.node, ending.first)) return false;
  if (ending.moves == 1) return true;
  return isFreeMove(nodes_[ending.node].world_from_robot * tables_.moves[ending.first].end,
                    ending.second, false);
}

bool ChainTree::isFreeMove(Index node, Index move) const {
  return isFreeMove(nodes_[node].world_from_robot, move, node == 0);
}

bool ChainTree::isFreeMove(const Pose2& world_from_robot, Index move, bool first) const {
  if (!problem_.obstacles) return true;
  ++tested_;
  return problem_.obstacles->isFree(world_from_robot, tables_.moves[move].path,
                                    first ? problem_.least_clearance_m : 0.0);
}

bool ChainTree::isTooFar(const Pose2& remaining, int moves) const {
  const double reach_m = moves * tables_.steps_bound.longest_m() + problem_.tolerance.xy_m + 1e-9;
  return remaining.x_m * remaining.x_m + remaining.y_m * remaining.y_m > reach_m * reach_m ||
         moves < 0;
}

std::vector<std::size_t> ChainTree::chainOf(const Ending& ending) const {
  std::vector<std::size_t> chain;
  for (Index node = ending.node; node != 0; node = nodes_[node].parent) {
    chain.push_back(nodes_[node].move);
  }
  std::reverse(chain.begin(), chain.end());
  if (ending.moves >= 1) chain.push_back(ending.first);
  if (ending.moves == 2) chain.push_back(ending.second);
  return chain;
}

}  // namespace hexapod
