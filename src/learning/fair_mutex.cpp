#include "learning/fair_mutex.h"

namespace hexapod {

void FairMutex::lock() {
  std::unique_lock<std::mutex> lock(mutex_);
  const std::uint64_t own = next_++;
  turn_ended_.wait(lock, [&] { return serving_ == own; });
}

void FairMutex::unlock() {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++serving_;
  turn_ended_.notify_all();
}

}  // namespace hexapod
