#include "gait/genome.h"

#include <algorithm>
#include <stdexcept>

namespace hexapod {
namespace {

constexpr char kDigits[] = "0123456789abcdef";
constexpr char kHexadecimal = 'x';
constexpr int kOneDigit = 9;  // the highest level that is one

[[noreturn]] void failAt(std::size_t position, const std::string& text, const char* expected) {
  const int code =
      position < text.size() ? static_cast<int>(static_cast<unsigned char>(text[position])) : -1;
  throw std::invalid_argument(
      "A genome has at position " + std::to_string(position) +
      (code < 0 ? " its end" : " the character code " + std::to_string(code)) + "; expected " +
      expected + ".");
}

// The digit at a position; its base is 10 or 16.
int digitAt(std::size_t position, const std::string& text, int base) {
  const char* const end = kDigits + base;
  const char* const digit = position < text.size() ? std::find(kDigits, end, text[position]) : end;
  if (digit == end) failAt(position, text, base == 10 ? "a digit" : "a hexadecimal digit");
  return static_cast<int>(digit - kDigits);
}

}  // namespace

void requireGeneLevels(std::int64_t levels) {
  constexpr auto kLeast = static_cast<std::int64_t>(kGeneLevels);
  constexpr auto kMost = static_cast<std::int64_t>(kMostGeneLevels);
  if (levels >= kLeast && levels <= kMost && levels % (kLeast - 1) == 1) return;
  throw std::invalid_argument(
      "Option gene_levels is " + std::to_string(levels) + "; expected " + std::to_string(kLeast) +
      ", or one more than another multiple of 4, up to " + std::to_string(kMost) + ".");
}

std::string toString(const Genome& genome) {
  const bool is_decimal = std::all_of(genome.begin(), genome.end(),
                                      [](std::uint8_t level) { return level <= kOneDigit; });
  std::string text;
  if (!is_decimal) text += kHexadecimal;
  for (const std::uint8_t level : genome) {
    if (!is_decimal) text += kDigits[level / 16];
    text += kDigits[level % 16];
  }
  return text;
}

Genome genomeFromString(const std::string& text) {
  Genome genome;
  if (text.empty() || text[0] != kHexadecimal) {
    for (std::size_t i = 0; i < text.size(); ++i) {
      genome.push_back(static_cast<std::uint8_t>(digitAt(i, text, 10)));
    }
    return genome;
  }
  for (std::size_t i = 1; i < text.size(); i += 2) {
    const int level = 16 * digitAt(i, text, 16) + digitAt(i + 1, text, 16);
    genome.push_back(static_cast<std::uint8_t>(level));
  }
  return genome;
}

Genome canonical(const Genome& genome, std::size_t levels) {
  Genome result = genome;
  for (std::size_t i = 0; i + 1 < result.size(); i += 2) {
    const bool silent = result[i] == 0;
    if (silent || result[i + 1] + std::size_t{1} == levels) result[i + 1] = 0;
  }
  return result;
}

Genome withLevels(const Genome& genome, std::size_t old_levels, std::size_t new_levels) {
  const std::size_t times = (new_levels - 1) / (old_levels - 1);
  if (times * (old_levels - 1) != new_levels - 1) {
    throw std::invalid_argument("Genes of " + std::to_string(old_levels) +
                                " levels cannot be told in " + std::to_string(new_levels) +
                                ": not all of their values are among them.");
  }
  Genome result;
  for (const std::uint8_t level : genome) {
    result.push_back(static_cast<std::uint8_t>(times * level));
  }
  return result;
}

}  // namespace hexapod
