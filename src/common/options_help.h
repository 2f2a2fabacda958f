#pragma once

#include <string>
#include <vector>

#include "common/options.h"

namespace hexapod {

/// The options for a terminal of 80 columns: "--name", value now and range with unit on a line,
/// the meaning below.
std::string helpOn(const std::vector<Option>& options);

}  // namespace hexapod
