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

// Numbers of questions in parts of at most `most`, of the same legs each and with a start.
std::vector<std::vector<std::size_t>> alike(const std::vector<Imagination::Question>& questions,
                                            std::size_t most) {
  std::vector<std::vector<std::size_t>> parts;
  for (std::size_t i = 0; i < questions.size(); ++i) {
    const auto takes = [&](const std::vector<std::size_t>& part) {
      const Imagination::Question& first = questions[part.front()];
      return part.size() < most && first.start != nullptr && questions[i].start != nullptr &&
             first.body.legs == questions[i].body.legs;
    };
    const auto found = std::find_if(parts.begin(), parts.end(), takes);
    if (found == parts.end()) {
      parts.push_back({i});
    } else {
      found->push_back(i);
    }
  }
  return parts;
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
      maker_(robot_, behavior),
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
                                        const std::vector<Question>& questions,
                                        Joints joints) const {
  const Behavior behavior = maker_.make(genome);
  std::vector<Imagined> answers(questions.size());
  const std::size_t abreast = joints == Joints::kIgnored ? runsAtOnce(engine_) : 1;
  const std::vector<std::vector<std::size_t>> parts = alike(questions, abreast);
  forEach(parts.size(), [&](std::size_t k) {
    if (parts[k].size() > 1) playAbreast(behavior, questions, parts[k], answers);
    for (const std::size_t i : parts[k]) {
      // Alone, one that fails goes on to the end.
      if (answers[i].verdict != Verdict::kWalked) answers[i] = playOne(behavior, questions[i]);
    }
  });
  return answers;
}

void Imagination::playAbreast(const Behavior& behavior, const std::vector<Question>& questions,
                              const std::vector<std::size_t>& some,
                              std::vector<Imagined>& answers) const {
  std::vector<BatchPhysics> bodies;
  std::vector<BatchRun> runs;
  for (const std::size_t i : some) {
    runs.push_back({&behavior, questions[i].start, bodies.size()});
    bodies.push_back({questions[i].body, *questions[i].start});
  }
  std::vector<BatchResult> results =
      BatchRollout(robot_, std::move(bodies)).play(runs, behavior_.command_period_s);
  for (std::size_t k = 0; k < some.size(); ++k) {
    Imagined& answer = answers[some[k]];
    answer.verdict = results[k].outcome.verdict;
    answer.end = std::move(results[k].end);
    answer.start_from_end = way(*questions[some[k]].start, answer.end);
  }
}

Imagined Imagination::playOne(const Behavior& behavior, const Question& question) const {
  const auto world = makeWorld(engine_, robot_, question.body, question.start);
  const std::size_t steps = stepsPerCommand(behavior_.command_period_s, question.body.step_s);
  const std::size_t latency = latencySteps(question.body);
  const WorldState start = world->state();
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
  imagined.end = world->state();
  imagined.start_from_end = way(start, imagined.end);
  return imagined;
}

Pose2 Imagination::way(const WorldState& start, const WorldState& end) const {
  return inverse(footprint(baseOf(robot_, start))) * footprint(baseOf(robot_, end));
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
    for (std::size_t i = begin; i < end; ++i) behaviors.push_back(maker_.make(genomes[i]));
    std::vector<BatchRun> runs;
    for (const Behavior& behavior : behaviors) runs.push_back({&behavior, question.start});
    const auto world = makeWorld(engine_, robot_, question.body, question.start);
    const std::vector<Outcome> played = playEach(*world, runs, behavior_.command_period_s);
    std::copy(played.begin(), played.end(), outcomes.begin() + static_cast<std::ptrdiff_t>(begin));
  });
  return outcomes;
}

}  // namespace hexapod
