#include "evolution/target_evolution.h"

#include <algorithm>
#include <cmath>
#include <limits>
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
                                 const Random& random, const Target& target)
    : Generational(options.population_size, space, false, random),
      options_(nsga2Options(options)),
      target_(target) {
  requireValid(options_);
}

std::vector<Genome> TargetEvolution::breed(std::size_t count, Random& random) const {
  const Archive none;
  const Breeder breeder(options_, space(), population_, none);
  std::vector<Genome> genotypes;
  for (std::size_t i = 0; i < count; ++i) genotypes.push_back(breeder.next(random));
  return genotypes;
}

std::vector<std::size_t> TargetEvolution::promising(const std::vector<Individual>& /*pool*/,
                                                    int /*looks*/) const {
  return {};
}

void TargetEvolution::finish(Pool pool) {
  std::vector<Objectives> values;
  for (const Individual& individual : pool.individuals) values.push_back(objectives(individual));
  population_ = survivors(pool.individuals, values,
                          static_cast<std::size_t>(options_.population_size), options_.diversity);
  front_.clear();
  for (const Individual& individual : population_) {
    if (individual.outcome.walked() && individual.standing.rank == 0) {
      front_.push_back(entryOf(individual));
    }
  }
}

void TargetEvolution::judgeEntries() {
  for (Entry& entry : front_) entry.disparity = disparityOf(entry);
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
  if (!individual.outcome.walked()) return {kWorst, kWorst, kWorst};
  return {-distance(individual), -individual.outcome.cost, -individual.disparity};
}

}  // namespace hexapod
