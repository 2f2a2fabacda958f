#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace hexapod {

/// Levels of the genes. Those of a gait: for each leg and each of its signals an amplitude and a
/// phase, index = RobotDescription::genesPerLeg() * leg + 2 * (signal - 1) + {amplitude, phase}.
using Genome = std::vector<std::uint8_t>;

/// The levels of a gene are 0 .. levels - 1, for the values 0 .. 1 in equal steps; the paper's five
/// are 0, 0.25, 0.5, 0.75, 1 (Cully & Mouret 2013, appendix B).
constexpr std::size_t kGeneLevels = 5;
/// As good as continuous: steps of 4 ms, and of a tenth of a degree at an amplitude of 25 degrees,
/// a third of what a hobby servo resolves.
constexpr std::size_t kMostGeneLevels = 253;

/// Throws std::invalid_argument unless so many levels make a gait: one more than a multiple of 4,
/// so that half a period is a level, and the paper's five are among them, 5 .. kMostGeneLevels.
void requireGeneLevels(std::int64_t levels);

/// Value of a level: 0 .. 1.
constexpr double geneValue(std::uint8_t level, std::size_t levels = kGeneLevels) {
  return level / static_cast<double>(levels - 1);
}

/// The form of files and logs: "012340...", one digit per gene, or, where a level is above 9,
/// "x00fc07...", two hexadecimal digits per gene.
std::string toString(const Genome& genome);

/// Reads toString()'s form, of any levels. Throws std::invalid_argument naming the position, what
/// was found and what was expected when a character is none of it.
Genome genomeFromString(const std::string& text);

/// The genome that all genomes of the same gait share: the last phase level is level 0 (a whole
/// period), and the phase of a zero amplitude is level 0. A Behavior plays it in place of all of
/// them: the equal gaits differ in the last bits of sin().
Genome canonical(const Genome& genome, std::size_t levels = kGeneLevels);

/// The same gait with genes of more levels. Throws std::invalid_argument where some value of the
/// old levels is none of the new ones.
Genome withLevels(const Genome& genome, std::size_t old_levels, std::size_t new_levels);

}  // namespace hexapod
