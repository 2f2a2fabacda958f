#pragma once

#include <string>

#include "repertoire/entry.h"

namespace hexapod {

/// The entry in words, a line each: id, where it ends, how well aligned, how steady.
std::string describe(const Entry& entry);

}  // namespace hexapod
