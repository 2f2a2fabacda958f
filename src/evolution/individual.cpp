#include "evolution/individual.h"

namespace hexapod {

Entry entryOf(const Individual& individual) {
  Entry entry;
  entry.id = individual.id;
  entry.genome = individual.genome;
  entry.end_pose = individual.outcome.end_pose;
  entry.cost = individual.outcome.cost;
  entry.evaluation = individual.evaluation;
  entry.disparity = individual.disparity;
  return entry;
}

Individual individualOf(const Entry& entry, int looks) {
  Individual individual;
  individual.id = entry.id;
  individual.evaluation = entry.evaluation;
  individual.genotype = entry.genome;
  individual.genome = entry.genome;
  individual.outcome = {Verdict::kWalked, entry.end_pose, entry.cost};
  individual.looks = looks;
  individual.disparity = entry.disparity;
  return individual;
}

}  // namespace hexapod
