#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/options.h"
#include "repertoire/entry.h"

namespace hexapod {

/// How much the ends of an entry may have scattered in its validation to be planned with.
struct SteadinessOptions {
  double max_spread_m = 0.006;
  double max_spread_rad = 0.02;
  std::int64_t least_entries = 1000;  ///< rather take the steadiest beyond the limits than fewer
};

/// The options under their names, bound to `options`, which must outlive them.
std::vector<Option> declareOptions(SteadinessOptions& options);

/// Indices, ascending, of the entries that are usable() and spread within both limits; while those
/// are fewer than least_entries, of the steadiest others as well, by the larger of their two ratios
/// of spread to limit and then by index. Entries that have not been validated are within the
/// limits; a spread that is not a number is beyond any.
std::vector<std::size_t> steadyEntries(const std::vector<Entry>& entries,
                                       const SteadinessOptions& options);

/// Those entries themselves.
std::vector<Entry> onlySteady(const std::vector<Entry>& entries, const SteadinessOptions& options);

}  // namespace hexapod
