#include "repertoire/archive.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace hexapod {
namespace {

IndexedPoint pointOf(const Entry& entry, std::size_t slot) {
  return {entry.end_pose, entry.id, slot};
}

}  // namespace

Archive::Archive(const std::vector<Entry>& entries, const PoseMetric& metric) : index_(metric) {
  for (const Entry& entry : entries) {
    requireValid(entry);
    if (contains(entry.genome)) {
      throw std::invalid_argument("Entry " + std::to_string(entry.id) + " has the genome " +
                                  toString(entry.genome) +
                                  " of another entry: every genome may occur once in an archive.");
    }
    add(entry);
  }
}

OfferResult Archive::offer(const Entry& candidate, double novelty_m, double novelty_threshold_m) {
  if (contains(candidate.genome)) return {AddStatus::kRejected, std::nullopt};
  requireValid(candidate);
  if (novelty_m > novelty_threshold_m) {
    add(candidate);
    return {AddStatus::kAdded, std::nullopt};
  }
  const auto nearest = index_.nearest(candidate.end_pose, 1);
  if (nearest.empty()) return {AddStatus::kRejected, std::nullopt};
  const std::size_t slot = nearest.front().slot;
  if (candidate.price() >= entries_[slot].price()) {
    return {AddStatus::kRejected, std::nullopt};
  }
  return {AddStatus::kSwapped, replace(slot, candidate)};
}

void Archive::setDisparities(const std::function<double(const Entry&)>& disparity) {
  for (Entry& entry : entries_) entry.disparity = disparity(entry);
}

void Archive::requireValid(const Entry& entry) const {
  const std::string name = "Entry " + std::to_string(entry.id);
  if (!isFinite(entry.end_pose)) {
    throw std::invalid_argument(name + " has an end pose that is not finite.");
  }
  if (!std::isfinite(entry.cost) || entry.cost < 0.0) {
    throw std::invalid_argument(name + " has a cost of " + std::to_string(entry.cost) +
                                ": expected a finite number of 0 or more.");
  }
  if (ids_.count(entry.id) > 0) {
    throw std::invalid_argument(name + " occurs twice: ids must be unique in an archive.");
  }
}

void Archive::add(const Entry& entry) {
  index_.insert(pointOf(entry, entries_.size()));
  entries_.push_back(entry);
  ids_.insert(entry.id);
  genomes_.insert(entry.genome);
}

Entry Archive::replace(std::size_t slot, const Entry& entry) {
  const Entry displaced = entries_[slot];
  index_.erase(pointOf(displaced, slot));
  ids_.erase(displaced.id);
  genomes_.erase(displaced.genome);
  index_.insert(pointOf(entry, slot));
  ids_.insert(entry.id);
  genomes_.insert(entry.genome);
  entries_[slot] = entry;
  return displaced;
}

}  // namespace hexapod
