#include "gait/genome.h"

#include <cassert>
#include <stdexcept>

namespace hexapod {

std::string toString(const Genome& genome) {
  std::string digits;
  digits.reserve(genome.size());
  for (std::uint8_t level : genome) {
    assert(level < kGeneLevels);
    digits += static_cast<char>('0' + level);
  }
  return digits;
}

Genome genomeFromString(const std::string& digits, std::size_t gene_count) {
  if (digits.size() != gene_count) {
    throw std::invalid_argument("A genome has " + std::to_string(digits.size()) +
                                " characters; expected " + std::to_string(gene_count) +
                                " digits 0 .. 4.");
  }
  Genome genome;
  genome.reserve(gene_count);
  for (std::size_t i = 0; i < digits.size(); ++i) {
    const int level = static_cast<unsigned char>(digits[i]) - '0';
    if (level < 0 || level >= kGeneLevels) {
      throw std::invalid_argument("Gene " + std::to_string(i) + " of a genome has character code " +
                                  std::to_string(level + '0') + "; expected a digit 0 .. 4.");
    }
    genome.push_back(static_cast<std::uint8_t>(level));
  }
  return genome;
}

Genome canonical(const Genome& genome) {
  Genome result = genome;
  for (std::size_t i = 0; i + 1 < result.size(); i += 2) {
    const bool silent = result[i] == 0;
    if (silent || result[i + 1] == kGeneLevels - 1) result[i + 1] = 0;
  }
  return result;
}

}  // namespace hexapod
