#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace hexapod {

/// Levels of the genes, each 0 .. 4 for the values 0, 0.25, 0.5, 0.75, 1 (Cully & Mouret 2013,
/// appendix B). Index = 4 * leg + {amplitude 1, phase 1, amplitude 2, phase 2}.
using Genome = std::vector<std::uint8_t>;

constexpr int kGeneLevels = 5;
constexpr std::size_t kGenesPerLeg = 4;

/// Value of a level: 0, 0.25, .., 1.
constexpr double geneValue(std::uint8_t level) { return 0.25 * level; }

/// "012340..." one digit per gene; the form of files, messages and logs.
std::string toString(const Genome& genome);

/// Reads toString()'s form. Throws std::invalid_argument naming the position, what was found and
/// what was expected when a character is no level or the count is not `gene_count`.
Genome genomeFromString(const std::string& digits, std::size_t gene_count);

/// The genome that all genomes of the same gait share: phase level 4 is level 0 (a whole period),
/// and the phase of a zero amplitude is level 0. Simulate only canonical genomes: the equal gaits
/// differ in the last bits of sin().
Genome canonical(const Genome& genome);

}  // namespace hexapod
