#pragma once

#include <string>

namespace hexapod {

/// The folder that holds config/ and urdf/: beside the program where the package is installed
/// (<prefix>/share/hexapod_repertoire), else the sources that the program was built from. Throws
/// std::runtime_error naming both places when neither is there.
std::string packageFolder();

/// The file of a preset: config/<name>.yaml or config/learn_<name>.yaml below `folder`. Throws
/// std::invalid_argument naming the presets there are when there is no such file.
std::string presetFile(const std::string& folder, const std::string& name);

}  // namespace hexapod
