#include "evolution/br_evolution.h"

#include <algorithm>

#include "evolution/breeder.h"
#include "evolution/selection.h"

namespace hexapod {

BrEvolution::BrEvolution(const EvolutionOptions& options, const Task& task, const Random& random)
    : Generational(options.candidatesPerGeneration(), task, options.offer_twins, random),
      options_(options),
      novelty_threshold_m_(options.novelty_threshold_m),
      archive_(metricOf(options)) {
  requireValid(options);
}

BrEvolution::BrEvolution(const EvolutionOptions& options, const Task& task,
                         const EvolutionState& state)
    : BrEvolution(options, task, state.random) {
  goOn(state);
  novelty_threshold_m_ = noveltyThresholdAfter(counters_.evaluations, options_);
  archive_ = Archive(state.archive, metricOf(options_));
}

std::vector<Genome> BrEvolution::breed(std::size_t count, Random& random) const {
  const Breeder breeder(options_, space(), population_, archive_);
  std::vector<Genome> genotypes;
  for (std::size_t i = 0; i < count; ++i) genotypes.push_back(breeder.next(random));
  return genotypes;
}

std::vector<std::size_t> BrEvolution::promising(const std::vector<Individual>& pool,
                                                int looks) const {
  const Neighbourhood neighbourhood(archive_, pool, static_cast<std::size_t>(options_.neighbours));
  // Not bool: its bits would be shared by threads.
  std::vector<char> is_promising(pool.size(), 0);
  forEach(pool.size(), [&](std::size_t i) {
    is_promising[i] = pool[i].looks == looks && isPromising(pool[i], neighbourhood);
  });
  std::vector<std::size_t> promising;
  for (std::size_t i = 0; i < pool.size(); ++i) {
    if (is_promising[i]) promising.push_back(i);
  }
  return promising;
}

void BrEvolution::finish(Pool pool) {
  const std::vector<Objectives> objectives = offerToArchive(pool);
  novelty_threshold_m_ = noveltyThresholdAfter(counters_.evaluations, options_);
  population_ = survivors(pool.individuals, objectives,
                          static_cast<std::size_t>(options_.population_size), options_.diversity);
}

void BrEvolution::judgeEntries() {
  archive_.setDisparities([this](const Entry& entry) { return disparityOf(entry); });
}

bool BrEvolution::isPromising(const Individual& individual,
                              const Neighbourhood& neighbourhood) const {
  if (!individual.outcome.walked()) return false;
  std::vector<Individual> images = twins(individual);
  images.push_back(individual);
  return std::any_of(images.begin(), images.end(), [&](const Individual& image) {
    return !archive_.contains(image.genome) && neighbourhood.isWanted(image, novelty_threshold_m_);
  });
}

std::vector<Objectives> BrEvolution::offerToArchive(Pool& pool) {
  std::vector<Individual>& individuals = pool.individuals;
  Neighbourhood neighbourhood(archive_, individuals, static_cast<std::size_t>(options_.neighbours));
  std::vector<Neighbourhood::View> views(individuals.size());
  forEach(views.size(), [&](std::size_t i) { views[i] = neighbourhood.view(individuals[i]); });
  std::vector<Objectives> objectives;
  objectives.reserve(individuals.size());
  for (std::size_t i = 0; i < individuals.size(); ++i) {
    Individual& individual = individuals[i];
    neighbourhood.refresh(individual, views[i]);
    objectives.push_back(views[i].objectives);
    if (!individual.outcome.walked() || individual.looks < looks()) continue;
    const std::vector<Individual> images =
        pool.is_news[i] ? twins(individual) : std::vector<Individual>();
    const OfferResult result = offer(individual, objectives.back()[0], neighbourhood);
    if (result.status == AddStatus::kSwapped && options_.swap == "exchange") {
      individual = individualOf(*result.displaced, looks());
      neighbourhood.moveToPool(individual);
      objectives.back() = neighbourhood.objectives(individual);
    }
    for (const Individual& twin : images) {
      offer(twin, neighbourhood.objectives(twin)[0], neighbourhood);
    }
  }
  return objectives;
}

OfferResult BrEvolution::offer(const Individual& individual, double novelty_m,
                               Neighbourhood& neighbourhood) {
  OfferResult result = archive_.offer(entryOf(individual), novelty_m, novelty_threshold_m_);
  if (result.status == AddStatus::kAdded) ++counters_.added;
  if (result.status == AddStatus::kSwapped) ++counters_.swapped;
  if (result.status != AddStatus::kRejected) {
    neighbourhood.moveToArchive(individual, result.displaced);
  }
  return result;
}

}  // namespace hexapod
