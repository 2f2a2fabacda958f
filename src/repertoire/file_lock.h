#pragma once

#include <stdexcept>
#include <string>

namespace hexapod {

/// Thrown for a file that another process, or another part of this one, has claimed.
class FileTaken : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Exclusive claim on a file between processes (and within one), for as long as this lives.
///
/// Kept in `<file>.lock`, which holds a line that names the owner and goes with it; when the owner
/// is killed the system frees the claim and the left-over lock file is in nobody's way.
class FileLock {
 public:
  /// Throws FileTaken naming the owner when the file is taken, or std::runtime_error telling
  /// why there can be no lock.
  explicit FileLock(const std::string& file);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  /// False when the lock file was removed or replaced: then the claim keeps nobody out any more.
  bool isCurrent() const;

 private:
  void writeNote() const;

  std::string lock_file_;
  int descriptor_ = -1;
};

}  // namespace hexapod
