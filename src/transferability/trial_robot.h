#pragma once

#include <optional>
#include <string>

#include "gait/genome.h"
#include "geometry/pose2.h"

namespace hexapod {

/// A robot on which controllers are tried while a repertoire is learned.
class TrialRobot {
 public:
  /// What became of a trial.
  struct Result {
    bool was_played = false;              ///< to its end, or to a fall
    std::optional<Pose2> start_from_end;  ///< measured at rest; none when it was not, or fell
    std::string problem;                  ///< a sentence, when it was not played
  };

  virtual ~TrialRobot() = default;

  /// Has the behaviour of a genome played, and waits for its end.
  virtual Result play(const Genome& genome) = 0;
};

}  // namespace hexapod
