#include "repertoire/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace hexapod {
namespace {

std::string ownerNoted(int descriptor) {
  std::array<char, 256> text{};
  const ssize_t length = ::pread(descriptor, text.data(), text.size(), 0);
  if (length <= 0) return "another process";
  const std::string note(text.data(), static_cast<std::size_t>(length));
  return note.substr(0, note.find('\n'));
}

}  // namespace

FileLock::FileLock(const std::string& file) : lock_file_(file + ".lock") {
  while (true) {
    descriptor_ = ::open(lock_file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0644);
    if (descriptor_ < 0) {
      throw std::runtime_error("The lock file " + lock_file_ + " cannot be opened: " +
                               std::strerror(errno) + ". Its folder must be writable.");
    }
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
      const std::string owner = errno == EWOULDBLOCK ? ownerNoted(descriptor_) : "";
      const std::string reason = std::strerror(errno);
      ::close(descriptor_);
      if (owner.empty()) {
        throw std::runtime_error("The lock file " + lock_file_ + " cannot be locked: " + reason +
                                 ".");
      }
      throw FileTaken("The file " + file + " is being written by " + owner +
                      ": stop it first, or choose another file.");
    }
    // Between open and lock the previous owner may have removed the lock file: then it locks
    // nobody.
    if (isCurrent()) break;
    ::close(descriptor_);
  }
  writeNote();
}

FileLock::~FileLock() {
  if (isCurrent()) ::unlink(lock_file_.c_str());
  ::close(descriptor_);
}

bool FileLock::isCurrent() const {
  struct stat opened = {};
  struct stat named = {};
  return ::fstat(descriptor_, &opened) == 0 && ::lstat(lock_file_.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

void FileLock::writeNote() const {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  const std::string note = "process " + std::to_string(::getpid()) + " on " + host.data() + "\n";
  // The note only serves messages: without it the lock holds all the same.
  if (::ftruncate(descriptor_, 0) != 0) return;
  if (::pwrite(descriptor_, note.data(), note.size(), 0) < 0) return;
}

}  // namespace hexapod
