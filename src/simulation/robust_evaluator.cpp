#include "simulation/robust_evaluator.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "common/random.h"
#include "simulation/validation.h"

namespace hexapod {
namespace {

// Other generators get the seed as it is.
constexpr std::uint64_t kPurpose = 0x7374617274;
// Behaviours before a start state, and how many are tried for one that walks.
constexpr int kPredecessors = 2;
constexpr int kMaxDraws = 100;

std::vector<Physics> allPhysics(const RobustnessOptions& options, const Physics& nominal,
                                double command_period_s, std::uint64_t seed) {
  std::vector<Physics> all = perturbedPhysics(options, nominal, command_period_s, seed);
  all.insert(all.begin(), nominal);
  return all;
}

Genome randomGenome(std::size_t gene_count, Random& random) {
  Genome genome(gene_count);
  for (auto& level : genome) level = static_cast<std::uint8_t>(random.below(kGeneLevels));
  return canonical(genome);
}

}  // namespace

RobustEvaluator::RobustEvaluator(Evaluator& nominal, std::shared_ptr<WorldPool> pool,
                                 const BehaviorOptions& behavior, const RobustnessOptions& options,
                                 std::uint64_t seed, const std::atomic<bool>* cancelled)
    : nominal_(&nominal),
      robot_(pool->robot()),
      behavior_(behavior),
      options_(options),
      seed_(seed),
      cancelled_(cancelled),
      worlds_(pool, allPhysics(options, pool->physics(), behavior.command_period_s, seed),
              behavior.command_period_s) {}

std::vector<Outcome> RobustEvaluator::evaluate(const std::vector<Genome>& genomes) {
  std::vector<Outcome> outcomes = nominal_->evaluate(genomes);
  if (!looksTwice()) return outcomes;
  for (Outcome& outcome : outcomes) {
    if (outcome.walked()) outcome.orientation_error_rad += options_.first_look_handicap_rad;
  }
  return outcomes;
}

std::vector<Outcome> RobustEvaluator::lookAgain(const std::vector<Genome>& genomes,
                                                const std::vector<Outcome>& first) {
  if (!looksTwice()) return first;
  prepareStartStates();
  std::vector<Behavior> behaviors;
  behaviors.reserve(genomes.size());
  for (const Genome& genome : genomes) behaviors.emplace_back(robot_, canonical(genome), behavior_);
  std::vector<RobustWorlds::Run> runs;
  for (const Behavior& behavior : behaviors) {
    for (std::size_t p = 1; p < worlds_.physics().size(); ++p)
      runs.push_back({p, &behavior, nullptr});
    for (const WorldState& state : start_states_) runs.push_back({0, &behavior, &state});
  }
  const std::vector<BatchResult> results = worlds_.play(runs, cancelled_);
  simulations_ += static_cast<std::int64_t>(runs.size());
  const std::size_t each = worlds_.physics().size() - 1 + start_states_.size();
  std::vector<Outcome> outcomes;
  for (std::size_t i = 0; i < genomes.size(); ++i) {
    std::vector<Outcome> all = {first[i]};
    all[0].orientation_error_rad -= options_.first_look_handicap_rad;
    for (std::size_t k = i * each; k < (i + 1) * each; ++k) all.push_back(results[k].outcome);
    outcomes.push_back(whole(all));
  }
  return outcomes;
}

Outcome RobustEvaluator::whole(const std::vector<Outcome>& outcomes) const {
  double error_rad = 0.0;
  for (const Outcome& outcome : outcomes) {
    if (!outcome.walked()) return outcome;
    error_rad += outcome.orientation_error_rad / static_cast<double>(outcomes.size());
  }
  const Execution execution = summarize(outcomes);
  Outcome result = walkedTo(execution.mean);
  error_rad += options_.spread_weight_rad_per_m * execution.spread_m;
  result.orientation_error_rad = std::round(error_rad * 1e5) / 1e5;
  return result;
}

void RobustEvaluator::prepareStartStates() {
  Random random(seed_ ^ kPurpose);
  while (start_states_.size() < static_cast<std::size_t>(options_.start_states)) {
    std::vector<WorldState> chain(1);
    for (int draw = 0; static_cast<int>(chain.size()) <= kPredecessors; ++draw) {
      if (draw == kMaxDraws) {
        throw std::runtime_error("None of " + std::to_string(kMaxDraws) +
                                 " random behaviours of robot " + robot_.name +
                                 " walks; set perturbed_start_states to 0.");
      }
      const Behavior behavior(robot_, randomGenome(robot_.geneCount(), random), behavior_);
      const WorldState* start = chain.size() == 1 ? nullptr : &chain.back();
      BatchResult result = worlds_.play({{0, &behavior, start}}, cancelled_)[0];
      if (result.outcome.walked()) chain.push_back(std::move(result.end));
    }
    start_states_.push_back(std::move(chain.back()));
  }
}

}  // namespace hexapod
