#include "ros_interface/common/realtime.h"

#include <gtest/gtest.h>
#include <pthread.h>
#include <sched.h>

#include <thread>

namespace hexapod {
namespace {

TEST(Realtime, AThreadHasThePriorityItIsToldItHas) {
  int refusal = -1;
  int policy = -1;
  std::thread thread([&] {
    refusal = askForRealtimePriority(RealtimePriority::kLoop);
    sched_param parameters{};
    pthread_getschedparam(pthread_self(), &policy, &parameters);
  });
  thread.join();
  EXPECT_GE(refusal, 0);
  EXPECT_EQ(policy, refusal == 0 ? SCHED_RR : SCHED_OTHER);
}

}  // namespace
}  // namespace hexapod
