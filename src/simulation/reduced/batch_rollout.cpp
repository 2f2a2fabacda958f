#include "simulation/reduced/batch_rollout.h"

#include <stdexcept>
#include <string>
#include <utility>

#include "geometry/pose2.h"
#include "simulation/reduced/make_model.h"
#include "simulation/reduced/reduced_world.h"
#include "simulation/reduced/verdict.h"
#include "simulation/rollout.h"

namespace hexapod {
namespace {

void checkRuns(const std::vector<BatchRun>& runs, std::size_t values) {
  for (const BatchRun& run : runs) {
    if (run.start == nullptr || run.start->values.size() == values) continue;
    throw std::invalid_argument("A start state must have " + std::to_string(values) +
                                " values, found " + std::to_string(run.start->values.size()) +
                                "; use states of the same robot.");
  }
}

const std::vector<BatchPhysics>& checked(const std::vector<BatchPhysics>& physics) {
  if (physics.empty()) throw std::invalid_argument("A batch needs one physics at least.");
  for (const BatchPhysics& one : physics) {
    if (one.physics.legs == physics.front().physics.legs) continue;
    throw std::invalid_argument(
        "Legs must be in the same states in all physics that are played side by side.");
  }
  return physics;
}

// Of one physics.
struct Rules {
  const reduced::Conditions<double>& conditions;
  const WorldState& settled;
  std::size_t period;   // of commands, in steps
  std::size_t latency;  // in steps
};

// Hands the runs of a queue to the lanes as they come free.
class Conveyor {
 public:
  Conveyor(const reduced::ReducedModel& model, const HeldJoints& held, std::vector<Rules> rules,
           reduced::Stepper& stepper, RunQueue& queue)
      : model_(model),
        held_(held),
        rules_(std::move(rules)),
        stepper_(stepper),
        queue_(queue),
        lanes_(stepper.lanes()) {}

  void run(LaneUse& use) {
    while (const std::int64_t busy = fillLanes()) {
      stepper_.advance();
      ++use.register_steps;
      use.lane_steps += busy;
      for (std::size_t lane = 0; lane < lanes_.size(); ++lane) endStep(lane);
    }
  }

 private:
  struct Lane {
    const BatchRun* run = nullptr;  // nullptr: idle
    std::size_t number = 0;         // of the run
    std::size_t step = 0;
    Pose2 world_from_start;
  };

  const Rules& rulesOf(const Lane& lane) const { return rules_[lane.run->physics]; }

  // How many have something to do.
  std::int64_t fillLanes() {
    std::int64_t busy = 0;
    for (std::size_t lane = 0; lane < lanes_.size(); ++lane) {
      while (lanes_[lane].run == nullptr && begin(lane)) {
      }
      if (lanes_[lane].run == nullptr) continue;
      ++busy;
      const Rules& rules = rulesOf(lanes_[lane]);
      if (lanes_[lane].step < rules.latency) continue;
      const std::size_t step = lanes_[lane].step - rules.latency;
      if (step % rules.period != 0) continue;
      send(lane, lanes_[lane].run->behavior->command(step / rules.period));
    }
    return busy;
  }

  void send(std::size_t lane, const std::vector<double>& targets_rad) {
    const std::vector<double>* sent = &targets_rad;
    if (held_.any()) {
      targets_rad_ = targets_rad;
      held_.apply(targets_rad_);
      sent = &targets_rad_;
    }
    stepper_.setTargets(static_cast<int>(lane), sent->data());
  }

  // False when there is nothing left to begin.
  bool begin(std::size_t lane) {
    const std::optional<std::size_t> number = queue_.take();
    if (!number) return false;
    const BatchRun& run = queue_.runs()[*number];
    const Rules& rules = rules_[run.physics];
    const WorldState& start = run.start != nullptr ? *run.start : rules.settled;
    stepper_.setConditions(static_cast<int>(lane), rules.conditions);
    stepper_.load(static_cast<int>(lane), start.values.data());
    const Eigen::Isometry3d world_from_base = worldFromBase(model_, start.values.data());
    lanes_[lane] = {&run, *number, 0, footprint(world_from_base)};
    if (run.behavior->commandCount() == 0) finish(lane, Verdict::kWalked);
    return true;
  }

  void endStep(std::size_t lane) {
    if (lanes_[lane].run == nullptr) return;
    const Verdict verdict = reduced::verdictOf(stepper_.findings(static_cast<int>(lane)));
    const std::size_t steps =
        lanes_[lane].run->behavior->commandCount() * rulesOf(lanes_[lane]).period;
    if (verdict != Verdict::kWalked || ++lanes_[lane].step == steps) finish(lane, verdict);
  }

  void finish(std::size_t lane, Verdict verdict) {
    const WorldState& settled = rulesOf(lanes_[lane]).settled;
    BatchResult result;
    result.end.values.resize(settled.values.size());
    stepper_.store(static_cast<int>(lane), result.end.values.data());
    if (verdict == Verdict::kWalked) {
      const Pose2 world_from_end = footprint(worldFromBase(model_, result.end.values.data()));
      result.outcome = walkedTo(inverse(lanes_[lane].world_from_start) * world_from_end);
    } else {
      result.outcome.verdict = verdict;
      // Whatever it does from here on, it shall stay finite.
      stepper_.load(static_cast<int>(lane), settled.values.data());
    }
    queue_.finish(lanes_[lane].number, std::move(result));
    lanes_[lane].run = nullptr;
  }

  const reduced::ReducedModel& model_;
  const HeldJoints& held_;
  std::vector<Rules> rules_;
  reduced::Stepper& stepper_;
  RunQueue& queue_;
  std::vector<double> targets_rad_;
  std::vector<Lane> lanes_;
};

}  // namespace

BatchRollout::BatchRollout(const RobotDescription& robot, const Physics& physics,
                           reduced::InstructionSet instructions)
    : BatchRollout(robot, {{physics, ReducedWorld(robot, physics).state()}}, instructions) {}

BatchRollout::BatchRollout(const RobotDescription& robot, std::vector<BatchPhysics> physics,
                           reduced::InstructionSet instructions)
    : physics_(std::move(physics)),
      held_(robot, checked(physics_).front().physics),
      model_(std::make_unique<reduced::ReducedModel>(
          reduced::makeModel(robot, physics_.front().physics))) {
  for (const BatchPhysics& one : physics_) {
    checkPhysics(one.physics);
    conditions_.push_back(reduced::conditionsOf(robot, one.physics, one.physics.step_s));
  }
  stepper_ = reduced::makeBatchStepper(*model_, conditions_.front(), instructions);
  for (int lane = 0; lane < lanes(); ++lane) stepper_->load(lane, settled().values.data());
}

BatchRollout::~BatchRollout() = default;

int BatchRollout::lanes() const { return stepper_->lanes(); }

std::vector<BatchResult> BatchRollout::play(const std::vector<BatchRun>& runs,
                                            double command_period_s) {
  RunQueue queue(runs);
  play(queue, command_period_s);
  return std::move(queue.results());
}

void BatchRollout::play(RunQueue& queue, double command_period_s) {
  checkRuns(queue.runs(), settled().values.size());
  std::vector<Rules> rules;
  for (std::size_t i = 0; i < physics_.size(); ++i) {
    const Physics& physics = physics_[i].physics;
    rules.push_back({conditions_[i], physics_[i].settled,
                     stepsPerCommand(command_period_s, physics.step_s), latencySteps(physics)});
  }
  Conveyor(*model_, held_, std::move(rules), *stepper_, queue).run(use_);
}

std::vector<Outcome> playEach(World& world, const std::vector<BatchRun>& runs,
                              double command_period_s) {
  std::vector<Outcome> outcomes;
  outcomes.reserve(runs.size());
  if (auto* reduced = dynamic_cast<ReducedWorld*>(&world)) {
    for (const BatchResult& result : reduced->batch().play(runs, command_period_s)) {
      outcomes.push_back(result.outcome);
    }
    return outcomes;
  }
  for (const BatchRun& run : runs) {
    world.restart();
    if (run.start != nullptr) world.restore(*run.start);
    outcomes.push_back(play(world, *run.behavior, command_period_s));
  }
  return outcomes;
}

std::size_t runsAtOnce(Engine engine) {
  return engine == Engine::kReduced ? reduced::lanes(reduced::bestInstructionSet()) : 1;
}

}  // namespace hexapod
