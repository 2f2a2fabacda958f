#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "common/options.h"

namespace hexapod {

/// Sets the options from Python's keyword arguments. Throws std::invalid_argument as applyOptions()
/// does, `source` being what was called.
void applyKeywords(const std::vector<Option>& options, const pybind11::kwargs& keywords,
                   const std::string& source);

}  // namespace hexapod
