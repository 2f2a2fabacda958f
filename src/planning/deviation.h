#pragma once

#include <memory>
#include <mutex>

#include "geometry/pose2.h"
#include "planning/foresight.h"

namespace hexapod {

/// How a robot's behaviours differ, all alike, from what the repertoire says of them: another
/// floor, load or battery. Displacements are scaled and turned, headings scaled and shifted.
struct Deviation {
  double scale = 1.0;          ///< of the distance covered
  double direction_rad = 0.0;  ///< added to the direction of the displacement
  double turn_scale = 1.0;     ///< of the heading change
  double turn_rad = 0.0;       ///< added to the heading change of every behaviour

  /// Where a behaviour leads whose repertoire entry says `start_from_end`.
  Pose2 apply(const Pose2& start_from_end) const;

  bool operator==(const Deviation& other) const;
  bool operator!=(const Deviation& other) const { return !(*this == other); }
};

/// Learns the deviation from the behaviours walked so far.
///
/// Regularised least squares towards "as the repertoire says", so that the noise of a few
/// behaviours changes little; each behaviour counts 0.9 times as much as the next one, so that it
/// follows changes. Without it a robot that always walks a third too far still arrives, after many
/// corrections. Not thread-safe.
class DeviationEstimator {
 public:
  /// One behaviour: what the entry's expectedPose() says and what was measured, both
  /// start_from_end. Ignored when it is an accident (blocked, carried away) rather than a
  /// deviation: not finite, less than 0.4 or more than 2.5 times as far with at least 0.1 m in
  /// between, or turned by 45 degrees too much.
  void observe(const Pose2& expected, const Pose2& measured);

  /// The estimate, within 0.5 .. 2 times and 30 degrees, in steps of 4 % and 1.5 degrees: a planner
  /// need only be built anew when it changes. Exactly no deviation while the estimate is below what
  /// noise explains (5 %, 2 degrees), so that a robot that does as the repertoire says gets the
  /// same plans as ever.
  Deviation deviation() const;

 private:
  double expected_squared_ = 0.0;  ///< displacement . displacement
  double along_ = 0.0;             ///< expected . measured
  double across_ = 0.0;            ///< expected x measured
  double count_ = 0.0;
  double turn_sum_ = 0.0;      ///< expected heading changes
  double turn_squared_ = 0.0;  ///< their squares
  double error_sum_ = 0.0;     ///< heading errors
  double error_turn_ = 0.0;    ///< heading errors times expected changes
};

/// Expects every entry to deviate as those walked so far.
class DeviationForesight : public Foresight {
 public:
  void observe(const WalkedStep& step) override;
  std::shared_ptr<const Repertoire> expected(
      const std::shared_ptr<const Repertoire>& repertoire) override;

 private:
  std::mutex mutex_;
  DeviationEstimator estimator_;
  Deviation deviation_;                           // of deviating_
  std::shared_ptr<const Repertoire> undeviated_;  // that deviating_ was made from
  std::shared_ptr<const Repertoire> deviating_;
};

}  // namespace hexapod
