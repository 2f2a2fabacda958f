#include "study/target_evolution.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <tuple>

#include "evolution/breeder.h"
#include "evolution/selection.h"

namespace hexapod {
namespace {

EvolutionOptions nsga2Options(EvolutionOptions options) {
  options.archive_parents = 0.0;
  options.diversity = "crowding";
  return options;
}

}  // namespace

TargetEvolution::TargetEvolution(const EvolutionOptions& options, const GenomeSpace& space,
                                 Evaluator& evaluator, const Random& random, const Target& target)
    : options_(nsga2Options(options)),
      space_(space),
      evaluator_(&evaluator),
      random_(random),
      target_(target) {
  requireValid(options_);
  requireValid(space_);
}

void TargetEvolution::step(std::int64_t most_candidates) {
  const auto size = static_cast<std::size_t>(std::min(options_.population_size, most_candidates));
  const Archive none;
  const Breeder breeder(options_, space_, population_, none);
  std::vector<Individual> pool = population_;
  std::vector<Genome> genomes;
  for (std::size_t i = 0; i < size; ++i) {
    Individual candidate;
    candidate.id = candidate.evaluation = evaluations_ + static_cast<std::int64_t>(i) + 1;
    candidate.genotype = breeder.next(random_);
    candidate.genome = space_.canonical(candidate.genotype);
    genomes.push_back(candidate.genome);
    pool.push_back(std::move(candidate));
  }
  const std::vector<Outcome> outcomes = evaluator_->evaluate(genomes);
  for (std::size_t i = 0; i < size; ++i) pool[population_.size() + i].outcome = outcomes.at(i);
  evaluations_ += static_cast<std::int64_t>(size);
  std::vector<Objectives> values;
  for (const Individual& individual : pool) values.push_back(objectives(individual));
  population_ = survivors(pool, values, static_cast<std::size_t>(options_.population_size),
                          options_.diversity);
}

std::optional<Individual> TargetEvolution::nearest() const {
  const Individual* best = nullptr;
  const auto key = [this](const Individual& individual) {
    return std::make_tuple(distance(individual), individual.outcome.cost, individual.id);
  };
  for (const Individual& individual : population_) {
    if (!individual.outcome.walked() || individual.standing.rank > 0) continue;
    if (best == nullptr || key(individual) < key(*best)) best = &individual;
  }
  return best == nullptr ? std::nullopt : std::optional<Individual>(*best);
}

std::optional<Individual> TargetEvolution::bestAligned(double radius_m) const {
  const Individual* best = nullptr;
  const auto key = [this](const Individual& individual) {
    return std::make_tuple(individual.outcome.cost, distance(individual), individual.id);
  };
  for (const Individual& individual : population_) {
    if (!individual.outcome.walked() || distance(individual) > radius_m) continue;
    if (best == nullptr || key(individual) < key(*best)) best = &individual;
  }
  return best == nullptr ? std::nullopt : std::optional<Individual>(*best);
}

double TargetEvolution::distance(const Individual& individual) const {
  const Pose2& end = individual.outcome.end_pose;
  return std::hypot(end.x_m - target_.x_m, end.y_m - target_.y_m);
}

Objectives TargetEvolution::objectives(const Individual& individual) const {
  constexpr double kWorst = -std::numeric_limits<double>::infinity();
  if (!individual.outcome.walked()) return {kWorst, kWorst};
  return {-distance(individual), -individual.outcome.cost};
}

}  // namespace hexapod
