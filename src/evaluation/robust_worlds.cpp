#include "evaluation/robust_worlds.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "evolution/evaluator.h"
#include "simulation/physics.h"
#include "simulation/rollout.h"

namespace hexapod {

// One thread's robot under one physics.
class RobustWorlds::Simulator {
 public:
  Simulator(Engine engine, const RobotDescription& robot, const Physics& physics) {
    if (engine == Engine::kReduced) {
      batch_ = std::make_unique<BatchRollout>(robot, physics);
    } else {
      world_ = makeWorld(engine, robot, physics);
    }
  }

  std::vector<BatchResult> play(const std::vector<BatchRun>& runs, double command_period_s) {
    if (batch_) return batch_->play(runs, command_period_s);
    std::vector<BatchResult> results;
    for (const BatchRun& run : runs) {
      if (run.start != nullptr) {
        world_->restore(*run.start);
      } else {
        world_->restart();
      }
      const Outcome outcome = hexapod::play(*world_, *run.behavior, command_period_s);
      results.push_back({outcome, world_->state()});
    }
    return results;
  }

 private:
  std::unique_ptr<BatchRollout> batch_;
  std::unique_ptr<World> world_;
};

RobustWorlds::RobustWorlds(std::shared_ptr<WorldPool> pool, std::vector<Physics> physics,
                           double command_period_s)
    : pool_(std::move(pool)), physics_(std::move(physics)), command_period_s_(command_period_s) {
  for (const Physics& one : physics_) {
    checkPhysics(one);
    stepsPerCommand(command_period_s, one.step_s);
  }
}

RobustWorlds::~RobustWorlds() = default;

std::vector<BatchResult> RobustWorlds::play(const std::vector<Run>& runs,
                                            const std::atomic<bool>* cancelled) {
  // Runs of equal physics side by side, the costliest first, cut into full registers.
  std::vector<std::size_t> order(runs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const auto key = [&](std::size_t i) {
      return std::pair(physics_[runs[i].physics].step_s, runs[i].physics);
    };
    return key(a) < key(b);
  });
  const auto size = pool_->engine() == Engine::kReduced
                        ? static_cast<std::size_t>(reduced::lanes(reduced::bestInstructionSet()))
                        : std::size_t{1};
  std::vector<std::size_t> cuts = {0};
  for (std::size_t k = 1; k <= order.size(); ++k) {
    if (k == order.size() || k - cuts.back() == size ||
        runs[order[k]].physics != runs[order[k - 1]].physics) {
      cuts.push_back(k);
    }
  }
  std::vector<BatchResult> results(runs.size());
  pool_->forEach(cuts.size() - 1, [&](World& world, std::size_t part) {
    if (cancelled != nullptr && *cancelled) throw EvaluationCancelled();
    std::vector<BatchRun> batch;
    for (std::size_t k = cuts[part]; k < cuts[part + 1]; ++k) {
      batch.push_back({runs[order[k]].behavior, runs[order[k]].start});
    }
    Simulator& simulator = simulatorOf(world, runs[order[cuts[part]]].physics);
    std::vector<BatchResult> played = simulator.play(batch, command_period_s_);
    for (std::size_t k = cuts[part]; k < cuts[part + 1]; ++k) {
      results[order[k]] = std::move(played[k - cuts[part]]);
    }
  });
  return results;
}

RobustWorlds::Simulator& RobustWorlds::simulatorOf(const World& world, std::size_t physics) {
  std::unique_ptr<Simulator>* simulator = nullptr;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    simulator = &simulators_[{&world, physics}];
  }
  // Settling takes a while; nobody else asks for this one.
  if (!*simulator) {
    *simulator = std::make_unique<Simulator>(pool_->engine(), robot(), physics_[physics]);
  }
  return **simulator;
}

}  // namespace hexapod
