#pragma once

#include <cstddef>
#include <string>

#include "learning/learning_session.h"

namespace hexapod {

/// A line for a person: "Learning: 2000 of 20000, trained: sparseness 4.21 cm, 2.31 deg, 120
/// entries, 35 s left". The same in every locale.
std::string describe(const LearningStatus& status);

/// The same without what a bar beside it shows: "trained: sparseness 4.21 cm, 2.31 deg, 120
/// entries, 4 s left" while it evolves.
std::string describeBriefly(const LearningStatus& status);

/// Of the phase under way, 0 .. 1: the part of the budget that is used up, or of the entries that
/// are checked.
double fractionDone(const LearningStatus& status);

/// Why there is no entry: what became of the candidates, in a sentence. `dropped`: entries that ODE
/// does not confirm.
std::string nothingLearned(const EvolutionCounters& counters, std::size_t dropped);

}  // namespace hexapod
