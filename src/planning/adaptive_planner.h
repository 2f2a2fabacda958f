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

  /// For a newer state of the same repertoire: begins with what `earlier` has learned.
  AdaptivePlanner(const Repertoire& repertoire, const AdaptivePlanner& earlier);

  const Repertoire& repertoire() const { return repertoire_; }

  /// The planner as of the last observation; it stays as it is for whoever holds it.
  std::shared_ptr<const Planner> planner() const;

  /// One behaviour that was walked: its entry (index) and the measured pose at rest before and
  /// after it. Takes some 50 ms when the estimate changes.
  void observe(std::size_t entry, const Pose2& world_from_before, const Pose2& world_from_after);

 private:
  AdaptivePlanner(const Repertoire& repertoire, const AdaptivePlanner& earlier,
                  const std::lock_guard<std::mutex>& lock_of_earlier);

  const Repertoire repertoire_;
  const PlannerOptions options_;
  mutable std::mutex mutex_;
  DeviationEstimator estimator_;            // guarded by mutex_
  Deviation deviation_;                     // guarded by mutex_
  std::shared_ptr<const Planner> planner_;  // guarded by mutex_
};

}  // namespace hexapod
