#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "execution/shared_executor.h"
#include "gait/random_genome.h"
#include "shipped_robot.h"

namespace {

std::atomic<long> allocations{0};

}  // namespace

// Replaced for this whole test program, to count.
void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace hexapod {
namespace {

TEST(SharedExecutor, ATickAllocatesNothing) {
  SharedExecutor executor(shippedRobot(), BehaviorOptions(), ExecutorOptions());
  Random random(11);
  const Behavior behavior(shippedRobot(), randomGenome(random), BehaviorOptions());
  ExecutorCore core(shippedRobot(), BehaviorOptions(), ExecutorOptions());
  const std::vector<double> measured = shippedRobot().neutralPose();
  WholeRobotDriver driver;
  const std::vector<char> nobody(measured.size(), 0);
  std::int64_t slot = 0;
  const long before = allocations;
  for (int i = 0; i < 300; ++i) {
    executor.feedback(driver.read(measured));
    executor.tick(slot, 0);
    core.feedback(driver.read(measured));
    if (i == 0) core.arm();
    if (i == 50) core.tolerate(nobody, true);
    if (i == 100) core.start(behavior, 1);
    if (i == 150) core.cancel(Reason::kCancelled);
    core.tick(slot++);
  }
  EXPECT_EQ(allocations - before, 0);
  EXPECT_EQ(core.status().serial, 1u);
}

}  // namespace
}  // namespace hexapod
