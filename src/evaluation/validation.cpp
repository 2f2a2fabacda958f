#include "evaluation/validation.h"

#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "common/random.h"
#include "simulation/rollout.h"

namespace hexapod {
namespace {

// Predecessors drawn for one place in a chain until one walks; then the place stays empty.
constexpr int kMaxRedraws = 20;

// Generators of the start states and of the genomes must not repeat each other.
enum class Purpose : std::uint64_t { kStartState = 1, kEntry = 2 };

Random generator(std::uint64_t seed, Purpose purpose, std::size_t index) {
  Random mixer(seed);
  const std::uint64_t base = mixer.bits();
  return Random(base + 0x9e3779b97f4a7c15u * (2 * index + static_cast<std::uint64_t>(purpose)));
}

void check(const ValidationOptions& options) {
  if (options.trials < 1 || options.start_states < options.trials || options.start_states > 10000) {
    throw std::invalid_argument(
        "Validation needs 1 <= trials <= start_states <= 10000, found trials " +
        std::to_string(options.trials) + " and start_states " +
        std::to_string(options.start_states) + ".");
  }
}

class Validation {
 public:
  Validation(const std::shared_ptr<WorldPool>& worlds, const BehaviorOptions& behavior,
             const std::vector<Genome>& genomes, const ValidationOptions& options)
      : worlds_(worlds), behavior_(behavior), genomes_(genomes), options_(options) {}

  std::vector<Execution> run(const PlayHooks& hooks) {
    std::vector<WorldState> start_states(options_.start_states);
    worlds_->forEach(start_states.size(), [&](World& world, std::size_t s) {
      if (!isCancelled(hooks)) start_states[s] = afterPredecessors(world, s);
    });
    std::vector<RobustWorlds::Run> runs;
    for (std::size_t i = 0; i < genomes_.size(); ++i) {
      for (const std::size_t s : chooseStartStates(i)) runs.push_back({i, 0, &start_states[s]});
    }
    const std::vector<BatchResult> results =
        RobustWorlds(worlds_, {worlds_->physics()}, behavior_).play(genomes_, runs, hooks);
    std::vector<Execution> executions;
    for (auto result = results.begin(); result != results.end();) {
      std::vector<Outcome> outcomes;
      for (int k = 0; k < options_.trials; ++k) outcomes.push_back((result++)->outcome);
      executions.push_back(summarize(outcomes));
    }
    return executions;
  }

 private:
  static bool isCancelled(const PlayHooks& hooks) {
    return hooks.cancelled != nullptr && hooks.cancelled->load();
  }

  WorldState afterPredecessors(World& world, std::size_t s) const {
    Random random = generator(options_.seed, Purpose::kStartState, s);
    world.restart();
    const std::uint64_t places = 2 + random.below(2);
    for (std::uint64_t place = 0; place < places; ++place) playPredecessor(world, random);
    return world.state();
  }

  void playPredecessor(World& world, Random& random) const {
    const WorldState before = world.state();
    for (int draw = 0; draw < kMaxRedraws; ++draw) {
      const Genome& genome = genomes_[random.below(genomes_.size())];
      if (playGenome(world, genome).walked() && goesOnStanding(world)) return;
      world.restore(before);
    }
  }

  // From a robot that is about to fall over every entry would fail. Leaves the world as it is.
  bool goesOnStanding(World& world) const {
    const WorldState now = world.state();
    const bool stands = playGenome(world, Genome(world.robot().geneCount(), 0)).walked();
    world.restore(now);
    return stands;
  }

  Outcome playGenome(World& world, const Genome& genome) const {
    const Behavior behavior(world.robot(), genome, behavior_);
    return play(world, behavior, behavior_.command_period_s);
  }

  // The first `trials` of a random permutation.
  std::vector<std::size_t> chooseStartStates(std::size_t i) const {
    Random random = generator(options_.seed, Purpose::kEntry, i);
    std::vector<std::size_t> states(options_.start_states);
    std::iota(states.begin(), states.end(), std::size_t{0});
    const std::size_t trials = static_cast<std::size_t>(options_.trials);
    for (std::size_t k = 0; k < trials; ++k) {
      std::swap(states[k], states[k + random.below(states.size() - k)]);
    }
    states.resize(trials);
    return states;
  }

  const std::shared_ptr<WorldPool>& worlds_;
  const BehaviorOptions& behavior_;
  const std::vector<Genome>& genomes_;
  const ValidationOptions& options_;
};

}  // namespace

std::vector<Execution> validate(const std::shared_ptr<WorldPool>& worlds,
                                const BehaviorOptions& behavior, const std::vector<Genome>& genomes,
                                const ValidationOptions& options, const PlayHooks& hooks) {
  check(options);
  if (genomes.empty()) return {};
  return Validation(worlds, behavior, genomes, options).run(hooks);
}

Execution summarize(const std::vector<Outcome>& outcomes) {
  std::vector<Pose2> ends;
  for (const Outcome& outcome : outcomes) {
    if (outcome.walked()) ends.push_back(outcome.end_pose);
  }
  Execution execution;
  execution.trials = static_cast<int>(outcomes.size());
  execution.falls = static_cast<int>(outcomes.size() - ends.size());
  if (ends.empty()) return execution;

  const double count = static_cast<double>(ends.size());
  double cosines = 0.0;
  double sines = 0.0;
  for (const Pose2& end : ends) {
    execution.mean.x_m += end.x_m / count;
    execution.mean.y_m += end.y_m / count;
    cosines += std::cos(end.yaw_rad);
    sines += std::sin(end.yaw_rad);
  }
  execution.mean.yaw_rad = std::atan2(sines, cosines);
  double square_distances = 0.0;
  double square_angles = 0.0;
  for (const Pose2& end : ends) {
    square_distances += std::pow(distance(end, execution.mean), 2);
    square_angles += std::pow(headingDistance(end, execution.mean), 2);
  }
  execution.spread_m = std::sqrt(square_distances / count);
  execution.spread_rad = std::sqrt(square_angles / count);
  return execution;
}

}  // namespace hexapod
