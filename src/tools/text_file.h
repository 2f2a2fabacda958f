#pragma once

#include <string>

namespace hexapod {

/// The whole text of a file. Throws std::runtime_error naming it when it cannot be read.
std::string textOfFile(const std::string& file);

/// Writes a file, in place of what was there. Throws std::runtime_error naming it.
void writeTextFile(const std::string& file, const std::string& text);

}  // namespace hexapod
