#include "repertoire/steadiness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hexapod {
namespace {

/// 1 at the nearer of both limits.
double unsteadiness(const Entry& entry, const SteadinessOptions& options) {
  if (!entry.execution) return 0.0;
  const double ratio = std::max(entry.execution->spread_m / options.max_spread_m,
                                entry.execution->spread_rad / options.max_spread_rad);
  const bool is_number =
      std::isfinite(entry.execution->spread_m) && std::isfinite(entry.execution->spread_rad);
  return is_number ? ratio : std::numeric_limits<double>::infinity();
}

}  // namespace

std::vector<Option> declareOptions(SteadinessOptions& options) {
  return {
      option("max_spread_m", options.max_spread_m, "m",
             "entries whose validated end positions spread more are left out", 1e-6, 10.0),
      option("max_spread_rad", options.max_spread_rad, "rad",
             "entries whose validated headings spread more are left out", 1e-6, 10.0),
      option("least_entries", options.least_entries,
             "of the entries beyond these limits the steadiest are kept to have so many in all", 0,
             10000000),
  };
}

std::vector<std::size_t> steadyEntries(const std::vector<Entry>& entries,
                                       const SteadinessOptions& options) {
  std::vector<std::pair<double, std::size_t>> ranked;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (entries[i].usable()) ranked.emplace_back(unsteadiness(entries[i], options), i);
  }
  std::sort(ranked.begin(), ranked.end());
  std::vector<std::size_t> steady;
  for (const auto& [ratio, index] : ranked) {
    if (ratio > 1.0 && steady.size() >= static_cast<std::size_t>(options.least_entries)) break;
    steady.push_back(index);
  }
  std::sort(steady.begin(), steady.end());
  return steady;
}

std::vector<Entry> onlySteady(const std::vector<Entry>& entries, const SteadinessOptions& options) {
  std::vector<Entry> steady;
  for (const std::size_t i : steadyEntries(entries, options)) steady.push_back(entries[i]);
  return steady;
}

}  // namespace hexapod
