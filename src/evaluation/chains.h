#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "evaluation/robust_worlds.h"
#include "repertoire/entry.h"

namespace hexapod {

/// How many behaviours are played one after another: `behaviors` in each of `chains` simulations,
/// which all begin at the stand.
struct ChainOptions {
  std::int64_t chains = 8;
  std::int64_t behaviors = 1250;
  std::uint64_t seed = 1;
};

/// By how much the behaviours of one or several chains missed where they were expected to end.
/// Values of those that walked only.
struct ChainResult {
  std::int64_t failed = 0;  ///< after a failure a chain goes on from the stand
  std::vector<double> misses_m;
  std::vector<double> misses_rad;

  std::int64_t behaviors() const { return failed + static_cast<std::int64_t>(misses_m.size()); }
  /// Adds another result's behaviours to these.
  void add(const ChainResult& other);
};

/// Plays random entries one after another under each physics and gives one result per physics. The
/// same entries in all of them; same seed, same result, whatever the number of threads. `entries`
/// must not be empty. Throws as RobustWorlds does.
std::vector<ChainResult> chainAtRandom(const std::shared_ptr<WorldPool>& pool,
                                       const BehaviorOptions& behavior,
                                       const std::vector<Entry>& entries,
                                       const std::vector<Physics>& physics,
                                       const ChainOptions& options);

/// The value that `share` of all do not exceed; 0 without values.
double quantile(std::vector<double> values, double share);

}  // namespace hexapod
