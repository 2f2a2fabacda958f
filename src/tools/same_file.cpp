#include "tools/same_file.h"

#include <filesystem>
#include <system_error>

namespace hexapod {
namespace {

namespace fs = std::filesystem;

/// The path without links, also where a link leads to what is not there yet.
fs::path resolved(const std::string& path) {
  std::error_code error;
  fs::path name = fs::absolute(path, error);
  // More links behind each other are a loop.
  for (int links = 0; links < 40 && fs::is_symlink(name, error); ++links) {
    name = name.parent_path() / fs::read_symlink(name, error);
  }
  return fs::weakly_canonical(name, error);
}

}  // namespace

bool isSameFile(const std::string& a, const std::string& b) {
  std::error_code error;
  return fs::equivalent(a, b, error) || resolved(a) == resolved(b);
}

}  // namespace hexapod
