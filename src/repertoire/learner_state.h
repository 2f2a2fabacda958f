#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "gait/genome.h"
#include "gait/outcome.h"
#include "repertoire/entry.h"

namespace hexapod {

/// An individual of a learner's population, as a file keeps it.
struct KeptIndividual {
  std::int64_t id = 0;
  std::int64_t evaluation = 0;
  Genome genotype;
  Outcome outcome;
  std::int64_t rank = 0;   ///< of its front
  double diversity = 0.0;  ///< in that front
  std::int64_t looks = 0;
};

/// What a learner keeps beside the repertoire in order to go on.
struct LearnerState {
  std::map<std::string, std::string> values;  ///< numbers and the like as texts by name
  std::vector<KeptIndividual> population;
  std::vector<Entry> archive;      ///< in the learner's order, as learned, without executions
  std::set<std::int64_t> dropped;  ///< ids of those that the repertoire leaves out
};

/// 16 hexadecimal digits over all of it.
std::string digestOf(const LearnerState& state);

}  // namespace hexapod
