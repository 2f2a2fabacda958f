#include "repertoire/entry_choice.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "geometry/arc.h"

namespace hexapod {

std::optional<std::size_t> entryNear(const std::vector<Entry>& entries, double x_m, double y_m,
                                     double within_m) {
  std::optional<std::size_t> nearest;
  double least_m = within_m;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Pose2& end = entries[i].expectedPose();
    const double apart_m = std::hypot(end.x_m - x_m, end.y_m - y_m);
    if (apart_m > least_m || (nearest && apart_m >= least_m)) continue;
    nearest = i;
    least_m = apart_m;
  }
  return nearest;
}

std::vector<Entry> neighboursOf(const std::vector<Entry>& entries, const Entry& entry,
                                std::size_t count) {
  std::vector<Entry> others;
  std::copy_if(entries.begin(), entries.end(), std::back_inserter(others),
               [&](const Entry& other) { return other.id != entry.id; });
  std::stable_sort(others.begin(), others.end(), [&](const Entry& a, const Entry& b) {
    return distance(entry.expectedPose(), a.expectedPose()) <
           distance(entry.expectedPose(), b.expectedPose());
  });
  others.resize(std::min(count, others.size()));
  return others;
}

std::optional<std::size_t> bestEntry(const std::vector<Entry>& entries) {
  std::vector<std::size_t> usable;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (entries[i].usable()) usable.push_back(i);
  }
  if (usable.empty()) return std::nullopt;
  const auto error_rad = [&](std::size_t i) { return orientationError(entries[i].expectedPose()); };
  std::stable_sort(usable.begin(), usable.end(),
                   [&](std::size_t a, std::size_t b) { return error_rad(a) < error_rad(b); });
  usable.resize((usable.size() + 1) / 2);
  return *std::max_element(usable.begin(), usable.end(), [&](std::size_t a, std::size_t b) {
    return entries[a].expectedPose().x_m < entries[b].expectedPose().x_m;
  });
}

}  // namespace hexapod
