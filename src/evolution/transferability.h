#pragma once

#include "gait/genome.h"
#include "gait/outcome.h"

namespace hexapod {

/// What is known of how far simulation is from a robot: the transferability of Koos, Mouret &
/// Doncieux (2013), which evolution looks at beside novelty and local competition.
class Transferability {
 public:
  virtual ~Transferability() = default;

  /// How far the robot is expected to be from what simulation says of a controller that walked
  /// there, in units of its cost, >= 0 and finite.
  virtual double disparity(const Genome& genome, const Outcome& simulated) const = 0;
};

}  // namespace hexapod
