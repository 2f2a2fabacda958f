#pragma once

#include "evolution/individual.h"
#include "repertoire/learner_state.h"

namespace hexapod {

/// The state in the form in which a repertoire file keeps it. Exact, and the same in every locale.
LearnerState toLearnerState(const EvolutionState& state);

/// The way back; the genomes of individuals, which follow from their genotypes, are for the
/// algorithm that goes on from it. Throws std::invalid_argument naming the value, what was expected
/// and what was found.
EvolutionState evolutionStateFrom(const LearnerState& kept);

}  // namespace hexapod
