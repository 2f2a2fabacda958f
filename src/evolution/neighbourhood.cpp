#include "evolution/neighbourhood.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <unordered_set>

#include "gait/genome_hash.h"

namespace hexapod {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

Neighbourhood::Member::Member(const Individual& individual)
    : end(individual.outcome.end_pose),
      id(individual.id),
      price(individual.price()),
      genome(individual.genome) {}

Neighbourhood::Neighbourhood(const Archive& archive, const std::vector<Individual>& pool,
                             std::size_t neighbours)
    : archive_(&archive), neighbours_(neighbours) {
  std::vector<const Individual*> walked;
  for (const Individual& individual : pool) {
    if (individual.outcome.walked()) walked.push_back(&individual);
  }
  // Of equal genomes the oldest stands for all.
  std::sort(walked.begin(), walked.end(),
            [](const Individual* a, const Individual* b) { return a->id < b->id; });
  std::unordered_set<Genome, GenomeHash> seen;
  for (const Individual* individual : walked) {
    if (archive.contains(individual->genome)) continue;
    if (seen.insert(individual->genome).second) crowd_.emplace_back(*individual);
  }
}

Neighbourhood::View Neighbourhood::view(const Individual& individual) const {
  View view;
  view.changes = changes_.size();
  if (!individual.outcome.walked()) return view;
  const std::vector<Rival> nearest = rivals(individual, entriesAround(individual));
  view.objectives = {mean_m(nearest, nearest.size()), 0.0, -individual.disparity};
  for (const Rival& rival : nearest) {
    if (rival.price > individual.price()) view.objectives[1] += 1.0;
  }
  const bool sees_all = nearest.size() < neighbours_;
  view.reach_m2 = sees_all ? kInfinity : nearest.back().squared_distance_m2;
  return view;
}

void Neighbourhood::refresh(const Individual& individual, View& view) const {
  if (!individual.outcome.walked()) return;
  const auto first = changes_.begin() + static_cast<std::ptrdiff_t>(view.changes);
  const bool is_seen = std::any_of(first, changes_.end(), [&](const Pose2& end) {
    return archive_->metric().squaredDistance_m2(end, individual.outcome.end_pose) <= view.reach_m2;
  });
  if (is_seen) view = this->view(individual);
}

bool Neighbourhood::isWanted(const Individual& individual, double threshold_m) const {
  std::vector<Rival> entries = entriesAround(individual);
  if (!entries.empty() && individual.price() < entries.front().price) return true;
  // The crowd can but bring some nearer than the entries are.
  if (entries.size() >= neighbours_ && mean_m(entries, neighbours_) <= threshold_m) return false;
  const std::vector<Rival> nearest = rivals(individual, std::move(entries));
  return mean_m(nearest, nearest.size()) > threshold_m;
}

void Neighbourhood::moveToArchive(const Individual& individual,
                                  const std::optional<Entry>& displaced) {
  changes_.push_back(individual.outcome.end_pose);
  if (displaced) changes_.push_back(displaced->end_pose);
  const auto found = std::find_if(crowd_.begin(), crowd_.end(), [&](const Member& other) {
    return other.genome == individual.genome;
  });
  if (found != crowd_.end()) crowd_.erase(found);
}

void Neighbourhood::moveToPool(const Individual& individual) {
  changes_.push_back(individual.outcome.end_pose);
  crowd_.emplace_back(individual);
}

std::vector<Neighbourhood::Rival> Neighbourhood::entriesAround(const Individual& individual) const {
  std::vector<Rival> rivals;
  rivals.reserve(2 * neighbours_ + 1);
  // One more than needed, as its own copy may be among them.
  for (const Neighbour& neighbour :
       archive_->nearest(individual.outcome.end_pose, neighbours_ + 1)) {
    const Entry& entry = archive_->entries()[neighbour.slot];
    if (entry.genome == individual.genome) continue;
    rivals.push_back({neighbour.squared_distance_m2, neighbour.id, entry.price()});
  }
  return rivals;
}

std::vector<Neighbourhood::Rival> Neighbourhood::rivals(const Individual& individual,
                                                        std::vector<Rival> entries) const {
  const Pose2& end = individual.outcome.end_pose;
  const PoseMetric& metric = archive_->metric();
  std::vector<Rival> rivals = std::move(entries);
  const bool are_enough = rivals.size() >= neighbours_;
  const double enough_m2 = are_enough ? rivals[neighbours_ - 1].squared_distance_m2 : kInfinity;
  for (const Member& other : crowd_) {
    const double squared_m2 = metric.squaredDistance_m2(other.end, end);
    if (squared_m2 > enough_m2 || other.genome == individual.genome) continue;
    rivals.push_back({squared_m2, other.id, other.price});
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

double Neighbourhood::mean_m(const std::vector<Rival>& rivals, std::size_t count) {
  if (count == 0) return kInfinity;
  double sum_m = 0.0;
  for (std::size_t i = 0; i < count; ++i) sum_m += std::sqrt(rivals[i].squared_distance_m2);
  return sum_m / static_cast<double>(count);
}

}  // namespace hexapod
