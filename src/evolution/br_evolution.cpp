#include "evolution/br_evolution.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "evolution/breeder.h"
#include "evolution/selection.h"

namespace hexapod {
namespace {

// Fewer entries per candidate than this: the archive has filled, as far as its threshold lets it.
constexpr double kEnoughAdded = 0.02;

/// The outcome, or kDiverged when a number of it is unusable.
Outcome checked(const Outcome& outcome) {
  if (!outcome.walked()) return outcome;
  const bool usable =
      isFinite(outcome.end_pose) && std::isfinite(outcome.cost) && outcome.cost >= 0.0;
  return usable ? outcome : Outcome{};
}

void requireOneEach(const std::vector<Outcome>& outcomes, const std::vector<Genome>& genomes) {
  if (outcomes.size() == genomes.size()) return;
  throw std::logic_error("The evaluator gave " + std::to_string(outcomes.size()) +
                         " outcomes for " + std::to_string(genomes.size()) + " genomes.");
}

void requireGeneCount(const Genome& genome, std::size_t gene_count, const std::string& owner) {
  if (genome.size() == gene_count) return;
  throw std::invalid_argument(owner + " has " + std::to_string(genome.size()) +
                              " genes: this evolution's genomes have " +
                              std::to_string(gene_count) + ".");
}

}  // namespace

BrEvolution::BrEvolution(const EvolutionOptions& options, const GenomeSpace& space,
                         Evaluator& evaluator, const Random& random,
                         std::vector<Symmetry> symmetries)
    : options_(options),
      space_(space),
      evaluator_(&evaluator),
      random_(random),
      novelty_threshold_m_(options.novelty_threshold_m) {
  requireValid(options);
  if (options.offer_twins) symmetries_ = std::move(symmetries);
  requireValid(space);
}

BrEvolution::BrEvolution(const EvolutionOptions& options, const GenomeSpace& space,
                         Evaluator& evaluator, const EvolutionState& state,
                         std::vector<Symmetry> symmetries)
    : BrEvolution(options, space, evaluator, state.random, std::move(symmetries)) {
  next_id_ = state.next_id;
  novelty_threshold_m_ = state.novelty_threshold_m;
  counters_ = state.counters;
  population_ = state.population;
  archive_ = Archive(state.archive);
  for (const Individual& individual : population_) {
    requireGeneCount(individual.genotype, space.gene_count,
                     "Individual " + std::to_string(individual.id));
  }
  for (const Entry& entry : state.archive) {
    requireGeneCount(entry.genome, space.gene_count, "Entry " + std::to_string(entry.id));
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
  std::vector<Individual> pool = population_;
  pool.insert(pool.end(), candidates.begin(), candidates.end());
  std::vector<bool> is_news(pool.size(), false);
  std::fill(is_news.begin() + static_cast<std::ptrdiff_t>(population_.size()), is_news.end(), true);
  std::int64_t looked_twice = 0;
  for (int look = 2; look <= evaluator_->looks(); ++look) {
    const std::vector<std::size_t> looked_at = lookAgain(look, pool);
    for (const std::size_t i : looked_at) is_news[i] = true;
    if (look == 2) looked_twice = static_cast<std::int64_t>(looked_at.size());
  }
  // Nothing below can fail.
  random_ = random;
  next_id_ += static_cast<std::int64_t>(size * (1 + symmetries_.size()));
  counters_.evaluations += static_cast<std::int64_t>(size);
  counters_.looked_twice += looked_twice;
  countFailures(pool, is_news);
  const std::int64_t added_before = counters_.added;
  const std::vector<Objectives> objectives = offerToArchive(pool, is_news);
  refineNovelty(counters_.added - added_before, size);
  population_ = survivors(pool, objectives, static_cast<std::size_t>(options_.population_size),
                          options_.diversity);
  ++counters_.generations;
}

EvolutionState BrEvolution::state() const {
  return {random_, next_id_, counters_, novelty_threshold_m_, population_, archive_.entries()};
}

std::vector<Individual> BrEvolution::nextCandidates(std::size_t count, Random& random) const {
  const Breeder breeder(options_, space_, population_, archive_);
  std::vector<Individual> candidates(count);
  for (std::size_t i = 0; i < count; ++i) {
    Individual& candidate = candidates[i];
    // The ids in between are for its twins.
    candidate.id = next_id_ + static_cast<std::int64_t>(i * (1 + symmetries_.size()));
    candidate.evaluation = counters_.evaluations + static_cast<std::int64_t>(i) + 1;
    candidate.genotype = breeder.next(random);
    candidate.genome = space_.canonical(candidate.genotype);
  }
  return candidates;
}

void BrEvolution::evaluate(std::vector<Individual>& candidates) const {
  std::vector<Genome> genomes;
  genomes.reserve(candidates.size());
  for (const Individual& candidate : candidates) genomes.push_back(candidate.genome);
  const std::vector<Outcome> outcomes = evaluator_->evaluate(genomes);
  requireOneEach(outcomes, genomes);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    candidates[i].outcome = checked(outcomes[i]);
    candidates[i].looks = 1;
  }
}

std::vector<std::size_t> BrEvolution::lookAgain(int look, std::vector<Individual>& pool) const {
  const Neighbourhood neighbourhood(archive_, pool, static_cast<std::size_t>(options_.neighbours));
  std::vector<std::size_t> promising;
  std::vector<Genome> genomes;
  std::vector<Outcome> previous;
  for (std::size_t i = 0; i < pool.size(); ++i) {
    if (pool[i].looks != look - 1 || !isPromising(pool[i], neighbourhood)) continue;
    promising.push_back(i);
    genomes.push_back(pool[i].genome);
    previous.push_back(pool[i].outcome);
  }
  if (promising.empty()) return promising;
  const std::vector<Outcome> outcomes = evaluator_->lookAgain(look, genomes, previous);
  requireOneEach(outcomes, genomes);
  for (std::size_t k = 0; k < promising.size(); ++k) {
    pool[promising[k]].outcome = checked(outcomes[k]);
    pool[promising[k]].looks = look;
  }
  return promising;
}

bool BrEvolution::isPromising(const Individual& individual,
                              const Neighbourhood& neighbourhood) const {
  if (!individual.outcome.walked()) return false;
  std::vector<Individual> images = twins(individual);
  images.push_back(individual);
  return std::any_of(images.begin(), images.end(), [&](const Individual& image) {
    if (archive_.contains(image.genome)) return false;
    if (neighbourhood.objectives(image)[0] > novelty_threshold_m_) return true;
    const Pose2& end = image.outcome.end_pose;
    const auto nearest = archive_.nearest(end.x_m, end.y_m, 1);
    return !nearest.empty() && image.outcome.cost < archive_.entries()[nearest[0].slot].cost;
  });
}

std::vector<Individual> BrEvolution::twins(const Individual& individual) const {
  std::vector<Individual> twins;
  for (const Symmetry& symmetry : symmetries_) {
    Individual twin = individual;
    twin.id = individual.id + 1 + static_cast<std::int64_t>(twins.size());
    twin.genotype = twin.genome = symmetry.image(individual.genome);
    twin.outcome = symmetry.image(individual.outcome);
    twins.push_back(std::move(twin));
  }
  return twins;
}

void BrEvolution::countFailures(const std::vector<Individual>& pool,
                                const std::vector<bool>& is_news) {
  for (std::size_t i = 0; i < pool.size(); ++i) {
    if (!is_news[i]) continue;
    const Verdict verdict = pool[i].outcome.verdict;
    if (verdict == Verdict::kFell) ++counters_.fell;
    if (verdict == Verdict::kSelfCollided) ++counters_.self_collided;
    if (verdict == Verdict::kDiverged) ++counters_.diverged;
  }
}

std::vector<Objectives> BrEvolution::offerToArchive(std::vector<Individual>& pool,
                                                    const std::vector<bool>& is_news) {
  Neighbourhood neighbourhood(archive_, pool, static_cast<std::size_t>(options_.neighbours));
  std::vector<Objectives> objectives;
  objectives.reserve(pool.size());
  for (std::size_t i = 0; i < pool.size(); ++i) {
    Individual& individual = pool[i];
    objectives.push_back(neighbourhood.objectives(individual));
    if (!individual.outcome.walked() || individual.looks < evaluator_->looks()) continue;
    const std::vector<Individual> images =
        is_news[i] ? twins(individual) : std::vector<Individual>();
    const OfferResult result = offer(individual, objectives.back()[0]);
    if (result.status != AddStatus::kRejected) neighbourhood.moveToArchive(individual);
    if (result.status == AddStatus::kSwapped && options_.swap == "exchange") {
      individual = individualOf(*result.displaced, evaluator_->looks());
      neighbourhood.moveToPool(individual);
      objectives.back() = neighbourhood.objectives(individual);
    }
    for (const Individual& twin : images) {
      const OfferResult twin_result = offer(twin, neighbourhood.objectives(twin)[0]);
      if (twin_result.status != AddStatus::kRejected) neighbourhood.moveToArchive(twin);
    }
  }
  return objectives;
}

OfferResult BrEvolution::offer(const Individual& individual, double novelty_m) {
  const OfferResult result = archive_.offer(entryOf(individual), novelty_m, novelty_threshold_m_);
  if (result.status == AddStatus::kAdded) ++counters_.added;
  if (result.status == AddStatus::kSwapped) ++counters_.swapped;
  return result;
}

void BrEvolution::refineNovelty(std::int64_t added, std::size_t candidates) {
  const double enough = kEnoughAdded * static_cast<double>(candidates);
  const double least_m = options_.novelty_threshold_min_m;
  if (novelty_threshold_m_ <= least_m || static_cast<double>(added) >= enough) return;
  novelty_threshold_m_ =
      std::max(least_m, novelty_threshold_m_ * (1.0 - options_.novelty_refinement));
}

}  // namespace hexapod
