#include "repertoire/repertoire.h"

#include <limits>
#include <stdexcept>

#include "common/text.h"

namespace hexapod {

std::size_t Repertoire::geneLevels() const {
  const auto found = options.find("gene_levels");
  if (found == options.end()) return kGeneLevels;
  constexpr std::int64_t kMost = std::numeric_limits<Genome::value_type>::max() + 1;
  const auto levels = integerFromText(found->second);
  if (levels && *levels >= 1 && *levels <= kMost) return static_cast<std::size_t>(*levels);
  throw std::invalid_argument("expected 1 .. " + std::to_string(kMost) +
                              " as the option gene_levels, found '" + found->second + "'");
}

}  // namespace hexapod
