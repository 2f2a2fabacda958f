#include "evolution/nsga2.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace hexapod {
namespace {

// Of a gene; a genome keeps them in bytes.
constexpr std::size_t kMostLevels = 256;

/// Indices 0 .. count - 1 sorted by `less`, equals by index.
template <typename Less>
std::vector<std::size_t> sortedIndices(std::size_t count, Less less) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), less);
  return order;
}

}  // namespace

bool dominates(const Objectives& a, const Objectives& b) {
  for (std::size_t axis = 0; axis < a.size(); ++axis) {
    if (a[axis] < b[axis]) return false;
  }
  return a != b;
}

std::vector<Front> nonDominatedFronts(const std::vector<Objectives>& objectives) {
  // In this order nothing is dominated by what comes later, and who is dominated by a member of a
  // front is by one of every front before it. The latest members are the likeliest to dominate.
  const auto order = sortedIndices(objectives.size(), [&](std::size_t a, std::size_t b) {
    return objectives[a] > objectives[b];
  });
  std::vector<Front> fronts;
  std::size_t home = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const Objectives& newcomer = objectives[order[k]];
    // Equals come one after another, and many they are where many have failed.
    if (k == 0 || objectives[order[k - 1]] != newcomer) {
      const auto first =
          std::partition_point(fronts.begin(), fronts.end(), [&](const Front& front) {
            return std::any_of(front.rbegin(), front.rend(), [&](std::size_t member) {
              return dominates(objectives[member], newcomer);
            });
          });
      home = static_cast<std::size_t>(first - fronts.begin());
    }
    if (home == fronts.size()) fronts.emplace_back();
    fronts[home].push_back(order[k]);
  }
  for (Front& front : fronts) std::sort(front.begin(), front.end());
  return fronts;
}

std::vector<double> crowdingDistances(const std::vector<Objectives>& objectives,
                                      const Front& front) {
  std::vector<double> distances(front.size(), 0.0);
  for (std::size_t axis = 0; axis < std::tuple_size<Objectives>::value; ++axis) {
    const auto value = [&](std::size_t member) { return objectives[front[member]][axis]; };
    const auto order = sortedIndices(
        front.size(), [&](std::size_t a, std::size_t b) { return value(a) < value(b); });
    if (order.empty()) continue;
    const double range = value(order.back()) - value(order.front());
    if (!(range > 0.0)) continue;
    distances[order.front()] = std::numeric_limits<double>::infinity();
    distances[order.back()] = std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k + 1 < order.size(); ++k) {
      const double gap = (value(order[k + 1]) - value(order[k - 1])) / range;
      if (std::isfinite(gap)) distances[order[k]] += gap;
    }
  }
  return distances;
}

std::vector<double> genotypicDiversities(const std::vector<Genome>& genomes, const Front& front) {
  if (front.size() < 2) return std::vector<double>(front.size(), 0.0);
  // A member differs in a gene from all members but those with its level: counting levels once
  // replaces comparing all pairs.
  std::vector<std::array<std::size_t, kMostLevels>> counts(genomes[front.front()].size());
  for (auto& count : counts) count.fill(0);
  for (const std::size_t i : front) {
    for (std::size_t gene = 0; gene < counts.size(); ++gene) ++counts[gene][genomes[i][gene]];
  }
  std::vector<double> diversities;
  diversities.reserve(front.size());
  for (const std::size_t i : front) {
    std::size_t differences = 0;
    for (std::size_t gene = 0; gene < counts.size(); ++gene) {
      differences += front.size() - counts[gene][genomes[i][gene]];
    }
    diversities.push_back(static_cast<double>(differences) / static_cast<double>(front.size() - 1));
  }
  return diversities;
}

bool isBetter(const Standing& a, const Standing& b) {
  if (a.rank != b.rank) return a.rank < b.rank;
  return a.diversity > b.diversity;
}

std::size_t tournament(const std::vector<Standing>& standings, Random& random) {
  const auto first = static_cast<std::size_t>(random.below(standings.size()));
  const auto second = static_cast<std::size_t>(random.below(standings.size()));
  return isBetter(standings[second], standings[first]) ? second : first;
}

}  // namespace hexapod
