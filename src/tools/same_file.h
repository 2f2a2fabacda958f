#pragma once

#include <string>

namespace hexapod {

/// True when both paths name one file, there already or not, however they are spelt: relative, by
/// links of either kind, through other folders.
bool isSameFile(const std::string& a, const std::string& b);

}  // namespace hexapod
