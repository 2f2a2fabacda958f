#include "tools/package_files.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <vector>

namespace hexapod {
namespace {

namespace fs = std::filesystem;

bool isFile(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

/// The names of the files config/learn*.yaml.
std::vector<std::string> presetNames(const fs::path& config) {
  std::vector<std::string> names;
  std::error_code error;
  for (const fs::directory_entry& file : fs::directory_iterator(config, error)) {
    const std::string name = file.path().stem().string();
    if (file.path().extension() == ".yaml" && name.rfind("learn", 0) == 0) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

std::string packageFolder() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path installed =
      program.parent_path().parent_path().parent_path() / "share" / "hexapod_repertoire";
  const fs::path sources = PACKAGE_SOURCE_FOLDER;
  for (const fs::path& folder : {installed, sources}) {
    if (isFile(folder / "config" / "learn.yaml")) return folder.string();
  }
  throw std::runtime_error("The folder config with learn.yaml is neither in " + installed.string() +
                           " nor in " + sources.string() +
                           ": give --config, --urdf and --robot_config, and --preset none.");
}

std::string presetFile(const std::string& folder, const std::string& name) {
  const fs::path config = fs::path(folder) / "config";
  const bool is_plain = !name.empty() && fs::path(name).filename() == name;
  for (const std::string& stem : {name, "learn_" + name}) {
    const fs::path file = config / (stem + ".yaml");
    if (is_plain && isFile(file)) return file.string();
  }
  std::string known;
  for (const std::string& preset : presetNames(config)) {
    known += (known.empty() ? "" : ", ") + preset;
  }
  throw std::invalid_argument("There is no preset '" + name + "' in " + config.string() +
                              "; there are " + known + ". Other files: --config FILE.");
}

}  // namespace hexapod
