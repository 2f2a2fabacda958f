#pragma once

#include <cstdint>
#include <optional>

#include "gait/genome.h"
#include "gait/outcome.h"
#include "geometry/arc.h"
#include "geometry/pose2.h"

namespace hexapod {

/// What an entry did when it was executed after random predecessors (validation).
struct Execution {
  Pose2 mean;  ///< mean end pose over the trials that did not fall (circular mean of yaw)
  double spread_m = 0.0;    ///< root mean square distance of the end positions from the mean
  double spread_rad = 0.0;  ///< root mean square difference of the headings from the mean
  int trials = 0;
  int falls = 0;  ///< trials that ended in anything but kWalked
};

/// One controller of the repertoire: a genome and where it leads.
struct Entry {
  std::int64_t id =
      0;  ///< unique in its repertoire, stable over swaps' lifetime: a swap gets a new id
  Genome genome;
  Pose2 end_pose;                      ///< as learned, in the start base_footprint
  double cost = 0.0;                   ///< what it won its place with, see Outcome
  std::int64_t evaluation = 0;         ///< number of the candidate that gave this entry, from 1
  std::optional<Execution> execution;  ///< empty until validated
  double disparity = 0.0;  ///< while learning only: what is known of a robot, see Transferability

  /// What it competes with: lower is better.
  double price() const { return cost + disparity; }
  /// Of the end pose as learned, 0 .. pi [rad].
  double orientationErrorRad() const { return orientationError(end_pose); }
  /// The pose a planner should expect: executed mean if validated, else as learned.
  const Pose2& expectedPose() const { return execution ? execution->mean : end_pose; }
  /// False when validation saw it fail.
  bool usable() const { return !execution || (execution->falls == 0 && execution->trials > 0); }
};

}  // namespace hexapod
