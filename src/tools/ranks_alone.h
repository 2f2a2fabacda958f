#pragma once

#include <algorithm>
#include <thread>

#include "tools/ranks.h"

namespace hexapod {

/// A process that was not started by mpirun.
class RankAlone : public Ranks {
 public:
  int rank() const override { return 0; }
  int count() const override { return 1; }
  int coresPerProcess() const override {
    return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  }
  DistributedEvaluator::Workers workers() const override { return {}; }
  std::shared_ptr<Channel> master() const override { return nullptr; }
  std::string loss() const override { return ""; }
  [[noreturn]] void abort(int exit_code) override;
};

}  // namespace hexapod
