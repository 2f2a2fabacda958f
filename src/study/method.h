#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "repertoire/entry.h"

namespace hexapod {

/// An algorithm that a study compares: given candidates to spend, asked for what it has found.
///
/// Deterministic: same task, options and seed, same repertoires, however the candidates are dealt
/// out as long as no generation is cut short. Used by one thread.
class Method {
 public:
  virtual ~Method() = default;

  /// One generation, or the first `most_candidates` (>= 1) candidates of it.
  virtual void step(std::int64_t most_candidates) = 0;

  /// Candidates evaluated so far.
  virtual std::int64_t evaluations() const = 0;

  /// What it has found so far, by name: an algorithm may have several ways to choose. A controller
  /// may be in a repertoire more than once.
  virtual std::map<std::string, std::vector<Entry>> repertoires() const = 0;
};

}  // namespace hexapod
