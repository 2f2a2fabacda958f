#pragma once

#include <string>
#include <vector>

#include "common/options.h"

namespace hexapod {

/// The help of a program for a terminal of 80 columns. First the introduction, in which lines that
/// are indented or tell the usage stay as they are, and the others are one paragraph until an empty
/// one; then each option: "--name", value now and range with unit on a line, the meaning below.
std::string helpOn(const std::string& introduction, const std::vector<Option>& options);

}  // namespace hexapod
