#pragma once

#include <map>
#include <string>
#include <vector>

#include "evolution/individual.h"

namespace hexapod {

/// The state as texts by name, in the form in which a repertoire file keeps them; all but the
/// archive, which is the repertoire's entries. Exact, and the same in every locale.
std::map<std::string, std::string> toTexts(const EvolutionState& state);

/// Reads toTexts() and completes it with the archive; the genomes of individuals, which follow from
/// their genotypes, are for the algorithm that goes on from it. Throws std::invalid_argument naming
/// the text, what was expected and what was found.
EvolutionState stateFromTexts(const std::map<std::string, std::string>& texts,
                              const std::vector<Entry>& archive);

}  // namespace hexapod
