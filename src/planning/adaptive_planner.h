#pragma once

#include <memory>
#include <mutex>

#include "planning/deviation.h"
#include "planning/planner.h"
#include "repertoire/repertoire.h"

namespace hexapod {

/// A planner that follows how the robot deviates from its repertoire: built anew whenever the
/// estimate of the Deviation changes. planner() may be called from any thread, observe() from one.
class AdaptivePlanner {
 public:
  AdaptivePlanner(const Repertoire& repertoire, const PlannerOptions& options);

  const Repertoire& repertoire() const { return repertoire_; }

  /// The planner as of the last observation; it stays as it is for whoever holds it.
  std::shared_ptr<const Planner> planner() const;

  /// One behaviour that was walked: its entry (index) and the measured pose at rest before and
  /// after it. Takes some 50 ms when the estimate changes.
  void observe(std::size_t entry, const Pose2& world_from_before, const Pose2& world_from_after);

 private:
  const Repertoire repertoire_;
  const PlannerOptions options_;
  DeviationEstimator estimator_;
  Deviation deviation_;
  mutable std::mutex mutex_;
  std::shared_ptr<const Planner> planner_;  // guarded by mutex_
};

}  // namespace hexapod
