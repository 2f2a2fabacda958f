#include "repertoire/find_repertoire.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <vector>

namespace hexapod {
namespace {

namespace fs = std::filesystem;

constexpr char kPrefix[] = "hexapod_repertoire";
constexpr char kExtension[] = ".db";
constexpr std::size_t kMostNamed = 5;

struct File {
  fs::file_time_type written;
  fs::path path;
};

// The newest first. What cannot be read is not there.
std::vector<File> repertoiresIn(const std::string& folder) {
  std::vector<File> files;
  std::error_code problem;
  for (fs::directory_iterator entry(folder, problem), end; entry != end; entry.increment(problem)) {
    const fs::path& path = entry->path();
    const bool is_one =
        path.extension() == kExtension && path.filename().string().rfind(kPrefix, 0) == 0;
    if (!is_one || !entry->is_regular_file(problem)) continue;
    const fs::file_time_type written = entry->last_write_time(problem);
    if (!problem) files.push_back({written, fs::absolute(path).lexically_normal()});
  }
  std::sort(files.begin(), files.end(), [](const File& a, const File& b) {
    return a.written != b.written ? a.written > b.written : a.path < b.path;
  });
  return files;
}

std::string whatThereIs(const std::vector<File>& files) {
  if (files.empty()) return "Learn one first: ./run demo (a minute) or ./run learn.";
  std::string text = "There are, the newest first:";
  for (std::size_t i = 0; i < std::min(files.size(), kMostNamed); ++i) {
    text += (i == 0 ? " " : ", ") + files[i].path.string();
  }
  return text + ".";
}

}  // namespace

std::string findRepertoire(const std::string& named, const std::string& folder) {
  std::error_code problem;
  if (!named.empty() && fs::exists(named, problem))
    return fs::absolute(named).lexically_normal().string();
  const std::vector<File> files = repertoiresIn(folder);
  if (!named.empty()) {
    throw std::invalid_argument("There is no repertoire file " +
                                fs::absolute(named).lexically_normal().string() + ". " +
                                whatThereIs(files));
  }
  if (files.empty()) {
    throw std::invalid_argument("There is no repertoire in " + folder + " yet. " +
                                whatThereIs(files));
  }
  return files.front().path.string();
}

}  // namespace hexapod
