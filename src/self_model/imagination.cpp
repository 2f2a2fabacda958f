#include "self_model/imagination.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "simulation/physics.h"
#include "simulation/reduced/batch_rollout.h"
#include "simulation/rollout.h"
#include "simulation/standing_state.h"

namespace hexapod {
namespace {

// Registers that one thread takes at a time.
constexpr std::size_t kRegistersPerPart = 6;

void widen(std::vector<JointRange>& ranges, const std::vector<double>& angles_rad) {
  if (ranges.empty()) {
    for (const double angle_rad : angles_rad) ranges.push_back({angle_rad, angle_rad});
  }
  for (std::size_t j = 0; j < angles_rad.size(); ++j) {
    ranges[j].min_rad = std::min(ranges[j].min_rad, angles_rad[j]);
    ranges[j].max_rad = std::max(ranges[j].max_rad, angles_rad[j]);
  }
}

}  // namespace

class Imagination::Threads {
 public:
  explicit Threads(int count) : arena(count == 0 ? tbb::task_arena::automatic : count) {}
  tbb::task_arena arena;
};

// With one thread on the caller's own: an arena of one would let others wait.
template <typename Work>
void Imagination::forEach(std::size_t count, const Work& work) const {
  if (!threads_) {
    for (std::size_t i = 0; i < count; ++i) work(i);
    return;
  }
  threads_->arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, count, 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
          for (std::size_t i = range.begin(); i != range.end(); ++i) work(i);
        },
        tbb::simple_partitioner());
  });
}

Imagination::Imagination(const RobotDescription& robot, const BehaviorOptions& behavior,
                         Engine engine, int threads)
    : robot_(robot),
      behavior_(behavior),
      engine_(engine),
      threads_(threads == 1 ? nullptr : std::make_unique<Threads>(threads)) {}

Imagination::~Imagination() = default;

std::vector<std::optional<WorldState>> Imagination::stands(
    const std::vector<Physics>& bodies) const {
  std::vector<std::optional<WorldState>> stands(bodies.size());
  forEach(bodies.size(), [&](std::size_t i) {
    try {
      stands[i] = makeWorld(engine_, robot_, bodies[i])->state();
    } catch (const std::runtime_error&) {
      // It does not stand.
    }
  });
  return stands;
}

std::vector<Imagined> Imagination::play(const Genome& genome,
                                        const std::vector<Question>& questions) const {
  const Behavior behavior(robot_, canonical(genome), behavior_);
  std::vector<Imagined> answers(questions.size());
  forEach(questions.size(), [&](std::size_t i) { answers[i] = playOne(behavior, questions[i]); });
  return answers;
}

Imagined Imagination::playOne(const Behavior& behavior, const Question& question) const {
  const auto world = makeWorld(engine_, robot_, question.body, question.start);
  const std::size_t steps = stepsPerCommand(behavior_.command_period_s, question.body.step_s);
  const std::size_t latency = latencySteps(question.body);
  const Pose2 world_from_start = footprint(world->worldFromBase());
  Imagined imagined;
  imagined.verdict = Verdict::kWalked;
  std::vector<double> angles_rad;
  for (std::size_t i = 0; i < behavior.commandCount() * steps; ++i) {
    if (i >= latency && (i - latency) % steps == 0) {
      world->setTargets(behavior.command((i - latency) / steps));
      world->jointAngles(angles_rad);
      widen(imagined.joints, angles_rad);
    }
    const Verdict verdict = world->step();
    if (imagined.verdict == Verdict::kWalked) imagined.verdict = verdict;
    if (verdict == Verdict::kDiverged) {
      imagined.verdict = verdict;
      imagined.start_from_end.x_m = std::numeric_limits<double>::quiet_NaN();
      return imagined;
    }
  }
  imagined.start_from_end = inverse(world_from_start) * footprint(world->worldFromBase());
  imagined.end = world->state();
  return imagined;
}

WorldState Imagination::turned(const WorldState& state, double heading_rad) const {
  return footprintAtOrigin(baseOf(robot_, state), state, robot_.jointCount() + 1, heading_rad);
}

std::vector<Outcome> Imagination::playAll(const std::vector<Genome>& genomes,
                                          const Question& question) const {
  const std::size_t size = kRegistersPerPart * runsAtOnce(engine_);
  std::vector<Outcome> outcomes(genomes.size());
  forEach((genomes.size() + size - 1) / size, [&](std::size_t part) {
    const std::size_t begin = part * size, end = std::min(genomes.size(), begin + size);
    std::vector<Behavior> behaviors;
    for (std::size_t i = begin; i < end; ++i) {
      behaviors.emplace_back(robot_, canonical(genomes[i]), behavior_);
    }
    std::vector<BatchRun> runs;
    for (const Behavior& behavior : behaviors) runs.push_back({&behavior, question.start});
    const auto world = makeWorld(engine_, robot_, question.body, question.start);
    const std::vector<Outcome> played = playEach(*world, runs, behavior_.command_period_s);
    std::copy(played.begin(), played.end(), outcomes.begin() + begin);
  });
  return outcomes;
}

}  // namespace hexapod
