#include "simulation/world_pool.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "simulation/physics.h"

namespace hexapod {
namespace {

constexpr int kMaxThreads = 1024;

int cores() { return static_cast<int>(std::max(1u, std::thread::hardware_concurrency())); }

int checkedThreads(int threads) {
  if (threads < 0 || threads > kMaxThreads) {
    throw std::invalid_argument("The number of threads must be between 1 and " +
                                std::to_string(kMaxThreads) + ", or 0 for all cores; found " +
                                std::to_string(threads) + ".");
  }
  return threads == 0 ? cores() : threads;
}

}  // namespace

// A slot of the arena belongs to one thread at a time, so the worlds go by slots: never more worlds
// than slots, whichever of TBB's threads come and go.
class WorldPool::Threads {
 public:
  explicit Threads(int count) : count_(count), arena_(count), worlds_(count) {
    // TBB starts no more threads than there are cores unless it is told to.
    if (count > cores()) limit_.emplace(tbb::global_control::max_allowed_parallelism, count);
  }

  int count() const { return count_; }

  template <typename Function>
  void run(const Function& function) {
    arena_.execute(function);
  }

  std::unique_ptr<World>& worldOfThisSlot() {
    return worlds_[tbb::this_task_arena::current_thread_index()];
  }

 private:
  int count_;
  std::optional<tbb::global_control> limit_;
  tbb::task_arena arena_;
  std::vector<std::unique_ptr<World>> worlds_;
};

WorldPool::WorldPool(Engine engine, const RobotDescription& robot, const Physics& physics,
                     int threads)
    : engine_(engine),
      robot_(robot),
      physics_(physics),
      threads_(std::make_unique<Threads>(checkedThreads(threads))) {
  checkPhysics(physics);
}

WorldPool::~WorldPool() = default;

int WorldPool::threads() const { return threads_->count(); }

void WorldPool::forEach(std::size_t count, const std::function<void(World&, std::size_t)>& work) {
  const auto range_work = [&](const tbb::blocked_range<std::size_t>& range) {
    std::unique_ptr<World>& world = threads_->worldOfThisSlot();
    if (!world) world = makeWorld(engine_, robot_, physics_);
    for (std::size_t i = range.begin(); i != range.end(); ++i) work(*world, i);
  };
  threads_->run([&] {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1), range_work,
                      tbb::simple_partitioner());
  });
}

}  // namespace hexapod
