#include "evaluation/robust_evaluator.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "common/random.h"
#include "evaluation/validation.h"

namespace hexapod {
namespace {

// Other generators get the seed as it is.
constexpr std::uint64_t kPurposeOfStarts = 0x7374617274;
// Behaviours before a start state, and how many are tried for one that walks.
constexpr int kPredecessors = 2;
constexpr int kMaxDraws = 100;

std::vector<Physics> allPhysics(const RobustnessOptions& options, const Physics& nominal,
                                double command_period_s, std::uint64_t seed) {
  std::vector<Physics> all = perturbedPhysics(options, nominal, command_period_s, seed);
  all.insert(all.begin(), nominal);
  return all;
}

}  // namespace

RobustEvaluator::RobustEvaluator(Evaluator& nominal, const std::shared_ptr<WorldPool>& pool,
                                 const BehaviorOptions& behavior, const RobustnessOptions& options,
                                 std::uint64_t seed, const std::atomic<bool>* cancelled)
    : nominal_(&nominal),
      options_(options),
      seed_(seed),
      hooks_{nullptr, cancelled},
      worlds_(pool, allPhysics(options, pool->physics(), behavior.command_period_s, seed),
              behavior),
      gaits_(gaitsOf(pool->robot(), behavior)) {
  if (!options_.steadinessAlone() || options_.isOn()) return;
  throw std::invalid_argument(
      "'quality' is steadiness, which only runs under other conditions show: set perturbed_physics "
      "or perturbed_start_states above 0.");
}

std::vector<Outcome> RobustEvaluator::evaluate(const std::vector<Genome>& genomes) {
  std::vector<Outcome> outcomes = nominal_->evaluate(genomes);
  if (!options_.isOn()) return outcomes;
  for (Outcome& outcome : outcomes) outcome = atFirst(outcome);
  return outcomes;
}

Outcome RobustEvaluator::atFirst(const Outcome& nominal) const {
  Outcome outcome = nominal;
  if (!outcome.walked()) return outcome;
  if (options_.steadinessAlone()) outcome.cost = 0.0;
  outcome.cost += options_.first_look_handicap_rad;
  return outcome;
}

int RobustEvaluator::looks() const {
  if (!options_.isOn()) return 1;
  const bool screens = options_.screening_runs > 0 && options_.screening_runs < options_.runs();
  return screens ? 3 : 2;
}

std::vector<Outcome> RobustEvaluator::lookAgain(int look, const std::vector<Genome>& genomes,
                                                const std::vector<Outcome>& previous) {
  if (!options_.isOn()) return previous;
  prepareStartStates();
  std::vector<std::vector<Outcome>> seen;
  std::vector<RobustWorlds::Run> runs;
  for (std::size_t i = 0; i < genomes.size(); ++i) {
    seen.push_back(seenBefore(look, genomes[i], previous[i]));
    for (std::size_t number = seen[i].size() - 1; number < runsUntil(look); ++number) {
      runs.push_back(run(number, i));
    }
  }
  const std::vector<BatchResult> results = worlds_.play(genomes, runs, hooks_);
  simulations_ += static_cast<std::int64_t>(runs.size());
  if (look < looks()) screened_.clear();
  std::vector<Outcome> outcomes;
  auto result = results.begin();
  for (std::size_t i = 0; i < genomes.size(); ++i) {
    while (seen[i].size() - 1 < runsUntil(look)) seen[i].push_back((result++)->outcome);
    outcomes.push_back(whole(seen[i]));
    if (look < looks()) screened_[genomes[i]] = std::move(seen[i]);
  }
  return outcomes;
}

std::size_t RobustEvaluator::runsUntil(int look) const {
  return static_cast<std::size_t>(look < looks() ? options_.screening_runs : options_.runs());
}

std::vector<Outcome> RobustEvaluator::seenBefore(int look, const Genome& genome,
                                                 const Outcome& previous) const {
  // To the last bit what the first run gave before the handicap was added.
  if (look == 2) return {walkedTo(previous.end_pose)};
  const auto known = screened_.find(genome);
  return known != screened_.end() ? known->second : nominal_->evaluate({genome});
}

RobustWorlds::Run RobustEvaluator::run(std::size_t number, std::size_t genome) const {
  const std::size_t physics = worlds_.physics().size() - 1;
  const std::size_t pairs = std::min(physics, start_states_.size());
  const bool is_paired = number < 2 * pairs;
  const std::size_t index = is_paired ? number / 2 : number - pairs;
  const bool is_physics = is_paired ? number % 2 == 0 : physics > pairs;
  if (is_physics) return {genome, index + 1, nullptr};
  return {genome, 0, &start_states_[index]};
}

Outcome RobustEvaluator::whole(const std::vector<Outcome>& outcomes) const {
  double error_rad = 0.0;
  for (const Outcome& outcome : outcomes) {
    if (!outcome.walked()) return outcome;
    error_rad += outcome.cost / static_cast<double>(outcomes.size());
  }
  const Execution execution = summarize(outcomes);
  if (options_.steadinessAlone()) error_rad = execution.spread_rad;
  Outcome result = walkedTo(execution.mean);
  error_rad += options_.spread_weight_rad_per_m * execution.spread_m;
  result.cost = std::round(error_rad * 1e5) / 1e5;
  return result;
}

// A robot that is about to fall over would make every candidate fail.
bool RobustEvaluator::goesOnStanding(const WorldState& state) {
  const Genome standing(worlds_.robot().geneCount(), 0);
  return worlds_.play({standing}, {{0, 0, &state}}, hooks_)[0].outcome.walked();
}

void RobustEvaluator::prepareStartStates() {
  Random random(seed_ ^ kPurposeOfStarts);
  while (start_states_.size() < static_cast<std::size_t>(options_.start_states)) {
    std::vector<WorldState> chain(1);
    for (int draw = 0; static_cast<int>(chain.size()) <= kPredecessors; ++draw) {
      if (draw == kMaxDraws) {
        throw std::runtime_error("Of " + std::to_string(kMaxDraws) +
                                 " random behaviours of robot " + worlds_.robot().name +
                                 " none walks and stands still afterwards; give it a lower stand "
                                 "or smaller amplitudes (import_robot tries them), or set "
                                 "perturbed_start_states to 0.");
      }
      const Genome genome = gaits_.drawn(random);
      const WorldState* start = chain.size() == 1 ? nullptr : &chain.back();
      BatchResult result = worlds_.play({genome}, {{0, 0, start}}, hooks_)[0];
      if (result.outcome.walked() && goesOnStanding(result.end)) {
        chain.push_back(std::move(result.end));
      }
    }
    start_states_.push_back(std::move(chain.back()));
  }
}

}  // namespace hexapod
