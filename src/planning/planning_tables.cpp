#include "planning/planning_tables.h"

#include <algorithm>

namespace hexapod {
namespace {

constexpr std::size_t kEvenlySpread = 64;
constexpr std::size_t kSectors = 24;

std::vector<std::size_t> chooseRepresentatives(const std::vector<Move>& moves) {
  std::vector<std::size_t> chosen = spreadOut(moves, kEvenlySpread);
  const std::vector<std::size_t> farthest = farthestPerSector(moves, kSectors);
  chosen.insert(chosen.end(), farthest.begin(), farthest.end());
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  return chosen;
}

PoseTable tabulateSingles(const std::vector<Move>& moves) {
  std::vector<PoseTable::Chain> chains;
  chains.reserve(moves.size());
  for (const Move& move : moves) {
    const auto index = static_cast<std::uint32_t>(chains.size());
    chains.push_back({move.end, index, 0});
  }
  return PoseTable(std::move(chains));
}

PoseTable tabulatePairs(const std::vector<Move>& moves) {
  std::vector<PoseTable::Chain> chains;
  chains.reserve(moves.size() * moves.size());
  for (std::size_t first = 0; first < moves.size(); ++first) {
    for (std::size_t second = 0; second < moves.size(); ++second) {
      chains.push_back({moves[first].end * moves[second].end, static_cast<std::uint32_t>(first),
                        static_cast<std::uint32_t>(second)});
    }
  }
  return PoseTable(std::move(chains));
}

}  // namespace

PlanningTables::PlanningTables(const Repertoire& repertoire, const PlannerOptions& options,
                               const EntryPaths& paths)
    : moves(usableMoves(repertoire, options, paths)),
      representatives(chooseRepresentatives(moves)),
      singles(tabulateSingles(moves)),
      pairs(tabulatePairs(moves)),
      steps_to_go(moves),
      steps_bound(moves) {}

}  // namespace hexapod
