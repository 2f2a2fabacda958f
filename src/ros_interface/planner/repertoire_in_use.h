#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "hexapod_repertoire/Repertoire.h"
#include "planning/adaptive_planner.h"
#include "ros_interface/common/first_publisher.h"

namespace hexapod {

/// The repertoire that is planned with: of one publisher, for this robot.
///
/// A second publisher is refused while the first is there. A newer message of the same run keeps
/// what was learned of the robot on its walks. What was relearned for a body that is believed may
/// stand in for it. From any thread; take(), standIn() and endStandIn() from one at a time.
class RepertoireInUse {
 public:
  struct Taken {
    bool in_use = false;
    std::string message;  ///< a sentence for the log
  };

  /// What is to be expected of a repertoire; null: what it says.
  using ForesightFor = std::function<std::shared_ptr<Foresight>(const Repertoire&)>;
  /// Its paths that are known.
  using PathsOf = std::function<EntryPaths(const Repertoire&)>;

  /// `robot_id`: digest of the robot description, or empty: any robot's will do. `publishers`: the
  /// nodes that publish repertoires now.
  RepertoireInUse(const PlannerOptions& options, std::string robot_id,
                  std::function<std::vector<std::string>()> publishers,
                  ForesightFor foresight_for = deviationOf, PathsOf paths_of = noPaths);

  /// A message of `publisher`. Refused, the one before stays in use. Takes some 50 ms.
  Taken take(const hexapod_repertoire::Repertoire& message, const std::string& publisher);

  /// Null while there is none.
  std::shared_ptr<AdaptivePlanner> planner() const;

  /// The one of the repertoire that is published, whatever stands in for it.
  std::shared_ptr<AdaptivePlanner> published() const;

  /// Plans with `relearned` instead, until another run is published, if more than `left` of its
  /// entries walk. It knows what the published one has learned of the robot; nobody else knows its
  /// run, so that its entries are sent as bare genomes. Returns how many walk. Takes some 50 ms.
  std::size_t standIn(Repertoire relearned, std::size_t left);

  /// Plans with the published one again. False when it did all the time.
  bool endStandIn();

 private:
  static std::shared_ptr<Foresight> deviationOf(const Repertoire& repertoire);
  static EntryPaths noPaths(const Repertoire&) { return {}; }
  std::string whyRefused(const hexapod_repertoire::Repertoire& message,
                         const std::string& publisher) const;

  PlannerOptions options_;
  std::string robot_id_;
  FirstPublisher publisher_;  // thread of take()
  ForesightFor foresight_for_;
  PathsOf paths_of_;
  mutable std::mutex mutex_;
  std::shared_ptr<AdaptivePlanner> planner_;   // guarded by mutex_
  std::shared_ptr<AdaptivePlanner> stand_in_;  // guarded by mutex_
};

}  // namespace hexapod
