#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/pose2.h"
#include "repertoire/entry.h"

namespace hexapod {

/// The entries, as many as `count`, that end nearest to where another one does; nearest first.
std::vector<Entry> neighboursOf(const std::vector<Entry>& entries, const Entry& entry,
                                std::size_t count);

/// Index of the entry whose expected end is nearest to a point [m], in the frame of the start; none
/// when all are farther than `within_m`. Of equally near ones the first.
std::optional<std::size_t> entryNear(const std::vector<Entry>& entries, double x_m, double y_m,
                                     double within_m);

/// Index of the entry to show first: of the better aligned half of the usable ones that which
/// ends farthest in front; none when none is usable.
std::optional<std::size_t> bestEntry(const std::vector<Entry>& entries);

}  // namespace hexapod
