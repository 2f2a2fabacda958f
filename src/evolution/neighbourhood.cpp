#include "evolution/neighbourhood.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <unordered_set>

#include "gait/genome_hash.h"

namespace hexapod {

Neighbourhood::Neighbourhood(const Archive& archive, const std::vector<Individual>& pool,
                             std::size_t neighbours)
    : archive_(&archive), neighbours_(neighbours) {
  std::vector<Individual> walked;
  for (const Individual& individual : pool) {
    if (individual.outcome.walked()) walked.push_back(individual);
  }
  // Of equal genomes the oldest stands for all.
  std::sort(walked.begin(), walked.end(),
            [](const Individual& a, const Individual& b) { return a.id < b.id; });
  std::unordered_set<Genome, GenomeHash> seen;
  for (const Individual& individual : walked) {
    if (archive.contains(individual.genome)) continue;
    if (seen.insert(individual.genome).second) crowd_.push_back(individual);
  }
}

Objectives Neighbourhood::objectives(const Individual& individual) const {
  if (!individual.outcome.walked()) return kFailed;
  const std::vector<Rival> nearest = rivals(individual);
  if (nearest.empty()) return {std::numeric_limits<double>::infinity(), 0.0};
  double sum_m = 0.0;
  double outperformed = 0.0;
  for (const Rival& rival : nearest) {
    sum_m += std::sqrt(rival.squared_distance_m2);
    if (rival.cost > individual.outcome.cost) outperformed += 1.0;
  }
  return {sum_m / static_cast<double>(nearest.size()), outperformed};
}

bool Neighbourhood::isNovel(const Individual& individual, double threshold_m) const {
  // The crowd can but bring some nearer than the entries are.
  const std::vector<Rival> entries = entriesAround(individual);
  if (entries.size() >= neighbours_) {
    double sum_m = 0.0;
    for (std::size_t i = 0; i < neighbours_; ++i) {
      sum_m += std::sqrt(entries[i].squared_distance_m2);
    }
    if (sum_m / static_cast<double>(neighbours_) <= threshold_m) return false;
  }
  return objectives(individual)[0] > threshold_m;
}

void Neighbourhood::moveToArchive(const Individual& individual) {
  const auto found = std::find_if(crowd_.begin(), crowd_.end(), [&](const Individual& other) {
    return other.genome == individual.genome;
  });
  if (found != crowd_.end()) crowd_.erase(found);
}

void Neighbourhood::moveToPool(const Individual& individual) { crowd_.push_back(individual); }

std::vector<Neighbourhood::Rival> Neighbourhood::entriesAround(const Individual& individual) const {
  const Pose2& end = individual.outcome.end_pose;
  std::vector<Rival> rivals;
  // One more than needed, as its own copy may be among them.
  for (const Neighbour& neighbour : archive_->nearest(end.x_m, end.y_m, neighbours_ + 1)) {
    const Entry& entry = archive_->entries()[neighbour.slot];
    if (entry.genome == individual.genome) continue;
    rivals.push_back({neighbour.squared_distance_m2, neighbour.id, entry.cost});
  }
  return rivals;
}

std::vector<Neighbourhood::Rival> Neighbourhood::rivals(const Individual& individual) const {
  const Pose2& end = individual.outcome.end_pose;
  std::vector<Rival> rivals = entriesAround(individual);
  const double enough_m2 = rivals.size() < neighbours_ ? std::numeric_limits<double>::infinity()
                                                       : rivals.back().squared_distance_m2;
  for (const Individual& other : crowd_) {
    const double dx = other.outcome.end_pose.x_m - end.x_m;
    const double dy = other.outcome.end_pose.y_m - end.y_m;
    const double squared_m2 = dx * dx + dy * dy;
    if (squared_m2 > enough_m2 || other.genome == individual.genome) continue;
    rivals.push_back({squared_m2, other.id, other.outcome.cost});
  }
  const auto closer = [](const Rival& a, const Rival& b) {
    return std::tie(a.squared_distance_m2, a.id) < std::tie(b.squared_distance_m2, b.id);
  };
  const std::size_t count = std::min(neighbours_, rivals.size());
  std::partial_sort(rivals.begin(), rivals.begin() + static_cast<std::ptrdiff_t>(count),
                    rivals.end(), closer);
  rivals.resize(count);
  return rivals;
}

}  // namespace hexapod
