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

// In steps.
struct CommandTiming {
  std::size_t period;
  std::size_t latency;
};

// Hands the runs to the lanes as they come free.
class Conveyor {
 public:
  Conveyor(const reduced::ReducedModel& model, reduced::Stepper& stepper, const WorldState& settled,
           const std::vector<BatchRun>& runs, const CommandTiming& timing, const HeldJoints& held)
      : model_(model),
        stepper_(stepper),
        settled_(settled),
        runs_(runs),
        timing_(timing),
        held_(held),
        lanes_(stepper.lanes()),
        results_(runs.size()) {}

  std::vector<BatchResult> run(double step_s) {
    while (fillLanes()) {
      stepper_.advance(step_s);
      for (std::size_t lane = 0; lane < lanes_.size(); ++lane) endStep(lane);
    }
    return std::move(results_);
  }

 private:
  struct Lane {
    const BatchRun* run = nullptr;  // nullptr: idle
    std::size_t step = 0;
    Pose2 world_from_start;
  };

  // False when nothing is left to do.
  bool fillLanes() {
    bool busy = false;
    for (std::size_t lane = 0; lane < lanes_.size(); ++lane) {
      while (lanes_[lane].run == nullptr && next_ < runs_.size()) begin(lane);
      if (lanes_[lane].run == nullptr) continue;
      busy = true;
      if (lanes_[lane].step < timing_.latency) continue;
      const std::size_t step = lanes_[lane].step - timing_.latency;
      if (step % timing_.period != 0) continue;
      send(lane, lanes_[lane].run->behavior->command(step / timing_.period));
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

  void begin(std::size_t lane) {
    const BatchRun& run = runs_[next_++];
    const WorldState& start = run.start != nullptr ? *run.start : settled_;
    stepper_.load(static_cast<int>(lane), start.values.data());
    const Eigen::Isometry3d world_from_base = worldFromBase(model_, start.values.data());
    lanes_[lane] = {&run, 0, footprint(world_from_base)};
    if (run.behavior->commandCount() == 0) finish(lane, Verdict::kWalked);
  }

  void endStep(std::size_t lane) {
    if (lanes_[lane].run == nullptr) return;
    const Verdict verdict = reduced::verdictOf(stepper_.findings(static_cast<int>(lane)));
    const std::size_t steps = lanes_[lane].run->behavior->commandCount() * timing_.period;
    if (verdict != Verdict::kWalked || ++lanes_[lane].step == steps) finish(lane, verdict);
  }

  void finish(std::size_t lane, Verdict verdict) {
    BatchResult& result = results_[lanes_[lane].run - runs_.data()];
    result.end.values.resize(settled_.values.size());
    stepper_.store(static_cast<int>(lane), result.end.values.data());
    if (verdict == Verdict::kWalked) {
      const Pose2 world_from_end = footprint(worldFromBase(model_, result.end.values.data()));
      result.outcome = walkedTo(inverse(lanes_[lane].world_from_start) * world_from_end);
    } else {
      result.outcome.verdict = verdict;
      // Whatever it does from here on, it shall stay finite.
      stepper_.load(static_cast<int>(lane), settled_.values.data());
    }
    lanes_[lane].run = nullptr;
  }

  const reduced::ReducedModel& model_;
  reduced::Stepper& stepper_;
  const WorldState& settled_;
  const std::vector<BatchRun>& runs_;
  CommandTiming timing_;
  const HeldJoints& held_;
  std::vector<double> targets_rad_;
  std::size_t next_ = 0;
  std::vector<Lane> lanes_;
  std::vector<BatchResult> results_;
};

}  // namespace

BatchRollout::BatchRollout(const RobotDescription& robot, const Physics& physics,
                           reduced::InstructionSet instructions)
    : BatchRollout(robot, physics, ReducedWorld(robot, physics).state(), instructions) {}

BatchRollout::BatchRollout(const RobotDescription& robot, const Physics& physics,
                           const WorldState& settled, reduced::InstructionSet instructions)
    : physics_(physics),
      held_(robot, physics),
      model_(std::make_unique<reduced::ReducedModel>(reduced::makeModel(robot, physics))),
      stepper_(reduced::makeBatchStepper(*model_, instructions)),
      settled_(settled) {
  for (int lane = 0; lane < lanes(); ++lane) stepper_->load(lane, settled_.values.data());
}

BatchRollout::~BatchRollout() = default;

int BatchRollout::lanes() const { return stepper_->lanes(); }

std::vector<BatchResult> BatchRollout::play(const std::vector<BatchRun>& runs,
                                            double command_period_s) {
  checkRuns(runs, settled_.values.size());
  const CommandTiming timing{stepsPerCommand(command_period_s, physics_.step_s),
                             latencySteps(physics_)};
  return Conveyor(*model_, *stepper_, settled_, runs, timing, held_).run(physics_.step_s);
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
