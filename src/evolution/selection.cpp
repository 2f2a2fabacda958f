#include "evolution/selection.h"

#include <algorithm>

namespace hexapod {
namespace {

std::vector<Genome> genotypesOf(const std::vector<Individual>& pool) {
  std::vector<Genome> genotypes;
  genotypes.reserve(pool.size());
  for (const Individual& individual : pool) genotypes.push_back(individual.genotype);
  return genotypes;
}

bool comesFirst(const Individual& a, const Individual& b) {
  return isBetter(a.standing, b.standing) || (!isBetter(b.standing, a.standing) && a.id < b.id);
}

}  // namespace

std::vector<Individual> survivors(const std::vector<Individual>& pool,
                                  const std::vector<Objectives>& objectives, std::size_t count,
                                  const std::string& diversity) {
  const std::vector<Genome> genotypes = genotypesOf(pool);
  const std::vector<Front> fronts = nonDominatedFronts(objectives);
  std::vector<Individual> survivors;
  for (std::size_t rank = 0; rank < fronts.size() && survivors.size() < count; ++rank) {
    const std::vector<double> diversities = diversity == "crowding"
                                                ? crowdingDistances(objectives, fronts[rank])
                                                : genotypicDiversities(genotypes, fronts[rank]);
    std::vector<Individual> front;
    for (std::size_t k = 0; k < fronts[rank].size(); ++k) {
      front.push_back(pool[fronts[rank][k]]);
      front.back().standing = {rank, diversities[k]};
    }
    // Only the front that no longer fits is cut; sorting the others changes nothing but their
    // order.
    std::sort(front.begin(), front.end(), comesFirst);
    front.resize(std::min(front.size(), count - survivors.size()));
    survivors.insert(survivors.end(), front.begin(), front.end());
  }
  return survivors;
}

}  // namespace hexapod
