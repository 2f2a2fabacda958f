#include "learning/fair_mutex.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <thread>

namespace hexapod {
namespace {

TEST(FairMutex, GoesToAnotherBeforeItComesBackToTheSameThread) {
  FairMutex mutex;
  std::atomic<bool> has_been_asked{false};
  std::atomic<bool> came{false};
  mutex.lock();
  std::thread other([&] {
    has_been_asked = true;
    const std::lock_guard<FairMutex> lock(mutex);
    came = true;
  });
  while (!has_been_asked) std::this_thread::yield();
  // The other thread asks any moment now: this one, taking it again and again, meets it soon.
  while (!came) {
    mutex.unlock();
    mutex.lock();
  }
  mutex.unlock();
  other.join();
}

TEST(FairMutex, IsHeldByOneAtATime) {
  FairMutex mutex;
  int count = 0;
  const auto work = [&] {
    for (int i = 0; i < 2000; ++i) {
      const std::lock_guard<FairMutex> lock(mutex);
      ++count;
    }
  };
  std::thread other(work);
  work();
  other.join();
  EXPECT_EQ(count, 4000);
}

}  // namespace
}  // namespace hexapod
