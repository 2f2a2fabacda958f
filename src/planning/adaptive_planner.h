#pragma once

#include <functional>
#include <memory>
#include <mutex>

#include "planning/foresight.h"
#include "planning/planner.h"
#include "repertoire/repertoire.h"

namespace hexapod {

/// A planner that follows what is learned of the robot: built anew whenever its Foresight expects
/// something else of the repertoire, or more of its paths is known. From any thread; observe() from
/// one at a time.
class AdaptivePlanner {
 public:
  /// Without a foresight the repertoire is taken at its word. `paths` as far as they are known.
  AdaptivePlanner(const Repertoire& repertoire, const PlannerOptions& options,
                  std::shared_ptr<Foresight> foresight, EntryPaths paths = {});
  /// Learns how the robot deviates from its repertoire, all behaviours alike.
  AdaptivePlanner(const Repertoire& repertoire, const PlannerOptions& options);

  /// For a newer state of the same repertoire: knows what `earlier` has learned, and what it learns
  /// from now on in a walk that still goes on with it.
  AdaptivePlanner(const Repertoire& repertoire, const AdaptivePlanner& earlier,
                  EntryPaths paths = {});

  /// For another robot that walks with the same repertoire and options.
  AdaptivePlanner(const AdaptivePlanner& like, std::shared_ptr<Foresight> foresight);

  const Repertoire& repertoire() const { return *repertoire_; }

  /// How far the farthest entry leads by the repertoire's own word [m].
  double reach_m() const;

  /// Plans along these paths from now on. Takes some 50 ms.
  void setPaths(EntryPaths paths);

  /// Foresight::prepare() of the repertoire.
  void prepare(const std::function<bool()>& stop);

  /// The planner as of the last observation; it stays as it is for whoever holds it.
  std::shared_ptr<const Planner> planner() const;

  /// As Planner::plan(), a drift in the world included: a chain of k behaviours is sought to the
  /// goal less k drifts, and predicted to end that much farther. Where the foresight follows chains
  /// (Foresight::follow()) and the one found leads elsewhere, others are sought to the goal less
  /// what that one misses it by; the poses of the plan are those followed.
  PlanResult plan(const PlanRequest& request) const;

  /// One behaviour that was walked: its entry (index) and the measured pose at rest before and
  /// after it, and feedback of the joints if there is any. Takes some 50 ms when the expectation
  /// changes, beside what the foresight takes.
  void observe(std::size_t entry, const Pose2& world_from_before, const Pose2& world_from_after,
               const std::vector<JointRange>& joints = {});

 private:
  void rebuild();
  PlanResult planDrifting(const Planner& planner, const PlanRequest& request) const;
  bool follow(const PlanRequest& request, PlanResult& result) const;

  const std::shared_ptr<const Repertoire> repertoire_;
  const PlannerOptions options_;
  const std::shared_ptr<Foresight> foresight_;
  std::mutex build_mutex_;                      // one builds at a time
  std::shared_ptr<const Repertoire> expected_;  // of planner_; guarded by build_mutex_
  EntryPaths paths_;                            // likewise
  mutable std::mutex mutex_;
  std::shared_ptr<const Planner> planner_;  // guarded by mutex_
};

}  // namespace hexapod
