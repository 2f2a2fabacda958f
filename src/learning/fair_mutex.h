#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace hexapod {

/// A mutex that goes to those who ask for it in the order in which they did, so that a thread that
/// takes it again and again keeps nobody else waiting for long.
class FairMutex {
 public:
  void lock();
  void unlock();

 private:
  std::mutex mutex_;
  std::condition_variable turn_ended_;
  std::uint64_t next_ = 0;     // of those who ask; guarded by mutex_
  std::uint64_t serving_ = 0;  // who has it, or will have it next; guarded by mutex_
};

}  // namespace hexapod
