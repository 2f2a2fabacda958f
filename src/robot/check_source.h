#pragma once

#include <string>

#include "common/problems.h"

namespace hexapod {

/// The content of a regular file. Anything else, or more than a description ever needs (4 MiB), is
/// a problem and gives an empty text.
std::string readSource(const std::string& file, Problems& problems);

/// True when the text is fit for a recursive parser: not empty, no binary data, at most
/// 64 levels deep. Adds the problem otherwise; `kind` is "URDF" or "YAML".
bool isReadable(const std::string& text, const std::string& source, const std::string& kind,
                Problems& problems);

}  // namespace hexapod
