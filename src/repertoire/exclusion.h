#pragma once

#include <cstdint>
#include <set>

#include "repertoire/repertoire.h"

namespace hexapod {

/// Entries that a person does not want to be used: the repertoire keeps them, as its fact
/// `do_not_use`, ids with commas between them.

/// Their ids; without those that are not ids, which nobody of this package writes.
std::set<std::int64_t> excludedIds(const Repertoire& repertoire);

/// Leaves an entry out from now on, or takes it in again. Throws std::invalid_argument when there
/// is no entry of that id.
void setExcluded(Repertoire& repertoire, std::int64_t entry_id, bool exclude);

/// The repertoire as it is to be used.
Repertoire withoutExcluded(Repertoire repertoire);

}  // namespace hexapod
