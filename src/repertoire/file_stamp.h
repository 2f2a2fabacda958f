#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace hexapod {

/// What the file system says of a file: two stamps of one path are alike as long as nobody replaced
/// or wrote the file.
struct FileStamp {
  std::uint64_t device = 0;
  std::uint64_t inode = 0;
  std::int64_t bytes = 0;
  std::int64_t modified_ns = 0;

  bool operator==(const FileStamp& other) const;
};

/// Nothing where there is no file. Links are not followed.
std::optional<FileStamp> stampOf(const std::string& file);

}  // namespace hexapod
