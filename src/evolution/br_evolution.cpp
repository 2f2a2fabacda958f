#include "evolution/br_evolution.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "evolution/neighbourhood.h"

namespace hexapod_repertoire {
namespace {

/// The outcome, or kDiverged when a number of it is unusable.
Outcome checked(const Outcome& outcome) {
  if (!outcome.walked()) return outcome;
  const bool usable = isFinite(outcome.end_pose) && std::isfinite(outcome.orientation_error_rad) &&
                      outcome.orientation_error_rad >= 0.0;
  return usable ? outcome : Outcome{};
}

Entry entryOf(const Individual& individual) {
  Entry entry;
  entry.id = individual.id;
  entry.genome = individual.genome;
  entry.end_pose = individual.outcome.end_pose;
  entry.orientation_error_rad = individual.outcome.orientation_error_rad;
  entry.evaluation = individual.evaluation;
  return entry;
}

Individual individualOf(const Entry& entry) {
  Individual individual;
  individual.id = entry.id;
  individual.evaluation = entry.evaluation;
  individual.genome = entry.genome;
  individual.outcome = {Verdict::kWalked, entry.end_pose, entry.orientation_error_rad};
  return individual;
}

void count(const Outcome& outcome, EvolutionCounters& counters) {
  ++counters.evaluations;
  if (outcome.verdict == Verdict::kFell) ++counters.fell;
  if (outcome.verdict == Verdict::kSelfCollided) ++counters.self_collided;
  if (outcome.verdict == Verdict::kDiverged) ++counters.diverged;
}

void requireGeneCount(const Genome& genome, std::size_t gene_count, const std::string& owner) {
  if (genome.size() == gene_count) return;
  throw std::invalid_argument(owner + " has " + std::to_string(genome.size()) +
                              " genes: this evolution's genomes have " +
                              std::to_string(gene_count) + ".");
}

}  // namespace

BrEvolution::BrEvolution(const EvolutionOptions& options, std::size_t gene_count,
                         Evaluator& evaluator, const Random& random)
    : options_(options), gene_count_(gene_count), evaluator_(&evaluator), random_(random) {
  requireValid(options);
  if (gene_count == 0) throw std::invalid_argument("An evolution needs genomes of 1 gene or more.");
}

BrEvolution::BrEvolution(const EvolutionOptions& options, std::size_t gene_count,
                         Evaluator& evaluator, const EvolutionState& state)
    : BrEvolution(options, gene_count, evaluator, state.random) {
  next_id_ = state.next_id;
  counters_ = state.counters;
  population_ = state.population;
  archive_ = Archive(state.archive);
  for (const Individual& individual : population_) {
    requireGeneCount(individual.genome, gene_count, "Individual " + std::to_string(individual.id));
  }
  for (const Entry& entry : state.archive) {
    requireGeneCount(entry.genome, gene_count, "Entry " + std::to_string(entry.id));
  }
}

void BrEvolution::step(std::int64_t most_candidates) {
  if (most_candidates < 1) {
    throw std::invalid_argument("A generation needs 1 candidate or more, not " +
                                std::to_string(most_candidates) + ".");
  }
  const auto count = static_cast<std::size_t>(std::min(options_.population_size, most_candidates));
  Random random = random_;
  const std::vector<Genome> genomes = nextGenomes(count, random);
  const std::vector<Outcome> outcomes = evaluator_->evaluate(genomes);
  if (outcomes.size() != genomes.size()) {
    throw std::logic_error("The evaluator gave " + std::to_string(outcomes.size()) +
                           " outcomes for " + std::to_string(genomes.size()) + " genomes.");
  }
  random_ = random;
  std::vector<Individual> pool = population_;
  const std::vector<Individual> children = born(genomes, outcomes);
  pool.insert(pool.end(), children.begin(), children.end());
  const std::vector<Objectives> objectives = offerToArchive(pool);
  population_ = selected(pool, objectives);
  ++counters_.generations;
}

EvolutionState BrEvolution::state() const {
  return {random_, next_id_, counters_, population_, archive_.entries()};
}

Genome BrEvolution::randomGenome(Random& random) const {
  Genome genome(gene_count_);
  for (auto& level : genome) level = static_cast<std::uint8_t>(random.below(kGeneLevels));
  return canonical(genome);
}

Genome BrEvolution::mutated(const Genome& parent, Random& random) const {
  Genome child = parent;
  for (auto& level : child) {
    if (!random.chance(options_.mutation_rate)) continue;
    level = static_cast<std::uint8_t>(random.below(kGeneLevels));
  }
  return canonical(child);
}

std::vector<Genome> BrEvolution::nextGenomes(std::size_t count, Random& random) const {
  std::vector<Standing> standings;
  standings.reserve(population_.size());
  for (const Individual& individual : population_) standings.push_back(individual.standing);
  std::vector<Genome> genomes;
  genomes.reserve(count);
  while (genomes.size() < count) {
    genomes.push_back(population_.empty()
                          ? randomGenome(random)
                          : mutated(population_[tournament(standings, random)].genome, random));
  }
  return genomes;
}

std::vector<Individual> BrEvolution::born(const std::vector<Genome>& genomes,
                                          const std::vector<Outcome>& outcomes) {
  std::vector<Individual> children;
  children.reserve(genomes.size());
  for (std::size_t i = 0; i < genomes.size(); ++i) {
    const Outcome outcome = checked(outcomes[i]);
    count(outcome, counters_);
    children.push_back({next_id_++, counters_.evaluations, genomes[i], outcome, {}});
  }
  return children;
}

std::vector<Objectives> BrEvolution::offerToArchive(std::vector<Individual>& pool) {
  Neighbourhood neighbourhood(archive_, pool, static_cast<std::size_t>(options_.neighbours));
  std::vector<Objectives> objectives;
  objectives.reserve(pool.size());
  for (Individual& individual : pool) {
    objectives.push_back(neighbourhood.objectives(individual));
    if (!individual.outcome.walked()) continue;
    const OfferResult result =
        archive_.offer(entryOf(individual), objectives.back()[0], options_.novelty_threshold_m);
    if (result.status == AddStatus::kRejected) continue;
    neighbourhood.moveToArchive(individual);
    if (result.status == AddStatus::kAdded) {
      ++counters_.added;
      continue;
    }
    ++counters_.swapped;
    individual = individualOf(*result.displaced);
    neighbourhood.moveToPool(individual);
    objectives.back() = neighbourhood.objectives(individual);
  }
  return objectives;
}

std::vector<Individual> BrEvolution::selected(const std::vector<Individual>& pool,
                                              const std::vector<Objectives>& objectives) const {
  const bool crowding = options_.diversity == "crowding";
  const auto size = static_cast<std::size_t>(options_.population_size);
  std::vector<Genome> genomes;
  for (const Individual& individual : pool) genomes.push_back(individual.genome);
  const std::vector<Front> fronts = nonDominatedFronts(objectives);
  std::vector<Individual> survivors;
  for (std::size_t rank = 0; rank < fronts.size() && survivors.size() < size; ++rank) {
    const std::vector<double> diversities = crowding ? crowdingDistances(objectives, fronts[rank])
                                                     : genotypicDiversities(genomes, fronts[rank]);
    std::vector<Individual> front;
    for (std::size_t k = 0; k < fronts[rank].size(); ++k) {
      front.push_back(pool[fronts[rank][k]]);
      front.back().standing = {rank, diversities[k]};
    }
    // Only the front that no longer fits is cut; sorting the others changes nothing but their
    // order.
    std::sort(front.begin(), front.end(), [](const Individual& a, const Individual& b) {
      return isBetter(a.standing, b.standing) || (!isBetter(b.standing, a.standing) && a.id < b.id);
    });
    front.resize(std::min(front.size(), size - survivors.size()));
    survivors.insert(survivors.end(), front.begin(), front.end());
  }
  return survivors;
}

}  // namespace hexapod_repertoire
