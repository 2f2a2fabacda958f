#pragma once

#include <ostream>

#include "repertoire/repertoire.h"

namespace hexapod {

/// The entries as comma separated values with a header line, by id, in the columns of the file's
/// table; numbers with a decimal point in every locale and read back exactly; fields that are not
/// validated are empty.
void exportCsv(const Repertoire& repertoire, std::ostream& out);

}  // namespace hexapod
