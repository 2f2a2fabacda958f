#include "evolution/br_evolution.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "evolution/neighbourhood.h"

namespace hexapod {
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
  individual.genotype = entry.genome;
  individual.genome = entry.genome;
  individual.outcome = {Verdict::kWalked, entry.end_pose, entry.orientation_error_rad};
  return individual;
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
    requireGeneCount(individual.genotype, gene_count,
                     "Individual " + std::to_string(individual.id));
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
  const auto size = static_cast<std::size_t>(std::min(options_.population_size, most_candidates));
  Random random = random_;
  std::vector<Individual> candidates = nextCandidates(size, random);
  evaluate(candidates);
  random_ = random;
  next_id_ += static_cast<std::int64_t>(size);
  count(candidates);
  std::vector<Individual> pool = population_;
  pool.insert(pool.end(), candidates.begin(), candidates.end());
  const std::vector<Objectives> objectives = offerToArchive(pool);
  population_ = selected(pool, objectives);
  ++counters_.generations;
}

EvolutionState BrEvolution::state() const {
  return {random_, next_id_, counters_, population_, archive_.entries()};
}

Genome BrEvolution::randomGenotype(Random& random) const {
  Genome genotype(gene_count_);
  for (auto& level : genotype) level = static_cast<std::uint8_t>(random.below(kGeneLevels));
  return genotype;
}

Genome BrEvolution::mutated(const Genome& parent, Random& random) const {
  Genome child = parent;
  for (auto& level : child) {
    if (!random.chance(options_.mutation_rate)) continue;
    level = static_cast<std::uint8_t>(random.below(kGeneLevels));
  }
  return child;
}

std::vector<Individual> BrEvolution::nextCandidates(std::size_t count, Random& random) const {
  std::vector<Standing> standings;
  standings.reserve(population_.size());
  for (const Individual& individual : population_) standings.push_back(individual.standing);
  std::vector<Individual> candidates(count);
  for (std::size_t i = 0; i < count; ++i) {
    Individual& candidate = candidates[i];
    candidate.id = next_id_ + static_cast<std::int64_t>(i);
    candidate.evaluation = counters_.evaluations + static_cast<std::int64_t>(i) + 1;
    candidate.genotype = population_.empty()
                             ? randomGenotype(random)
                             : mutated(population_[tournament(standings, random)].genotype, random);
    candidate.genome = canonical(candidate.genotype);
  }
  return candidates;
}

void BrEvolution::evaluate(std::vector<Individual>& candidates) const {
  std::vector<Genome> genomes;
  genomes.reserve(candidates.size());
  for (const Individual& candidate : candidates) genomes.push_back(candidate.genome);
  const std::vector<Outcome> outcomes = evaluator_->evaluate(genomes);
  if (outcomes.size() != genomes.size()) {
    throw std::logic_error("The evaluator gave " + std::to_string(outcomes.size()) +
                           " outcomes for " + std::to_string(genomes.size()) + " genomes.");
  }
  for (std::size_t i = 0; i < candidates.size(); ++i) candidates[i].outcome = checked(outcomes[i]);
}

void BrEvolution::count(const std::vector<Individual>& candidates) {
  for (const Individual& candidate : candidates) {
    const Verdict verdict = candidate.outcome.verdict;
    ++counters_.evaluations;
    if (verdict == Verdict::kFell) ++counters_.fell;
    if (verdict == Verdict::kSelfCollided) ++counters_.self_collided;
    if (verdict == Verdict::kDiverged) ++counters_.diverged;
  }
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
    if (options_.swap == "copy") continue;
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
  std::vector<Genome> genotypes;
  genotypes.reserve(pool.size());
  for (const Individual& individual : pool) genotypes.push_back(individual.genotype);
  const std::vector<Front> fronts = nonDominatedFronts(objectives);
  std::vector<Individual> survivors;
  for (std::size_t rank = 0; rank < fronts.size() && survivors.size() < size; ++rank) {
    const std::vector<double> diversities = crowding
                                                ? crowdingDistances(objectives, fronts[rank])
                                                : genotypicDiversities(genotypes, fronts[rank]);
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

}  // namespace hexapod
