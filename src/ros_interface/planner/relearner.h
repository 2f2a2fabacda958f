#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "repertoire/repertoire.h"
#include "robot/robot_description.h"
#include "ros_interface/planner/planner_node_options.h"
#include "ros_interface/planner/repertoire_in_use.h"
#include "simulation/leg_state.h"
#include "simulation/world.h"

namespace hexapod {

/// Where the body that is believed leaves too little of the repertoire in use, evolution goes on
/// from what is left of it, for that body, in the background; what comes of it is planned with when
/// it has more entries that walk, as long as that body is believed. From one thread.
class Relearner {
 public:
  using Publish = std::function<void(const Repertoire&)>;

  /// `publish` is given what is planned with from now on: what was relearned, or no entries when
  /// the published one is again. All references must outlive it.
  Relearner(const PlannerNodeOptions& options, std::optional<RobotDescription> robot,
            RepertoireInUse& repertoire, Publish publish);
  /// Gives up what is being learned; waits for some behaviours at most.
  ~Relearner();
  Relearner(const Relearner&) = delete;
  Relearner& operator=(const Relearner&) = delete;

  /// To be called now and then. `body`: the one believed for sure, nothing while none is. Returns a
  /// sentence for the log, empty when nothing has changed. Takes some 50 ms when it has.
  std::string look(const std::optional<Physics>& body);

  bool isLearning() const { return learning_ && !learned_; }

 private:
  std::string begin(const AdaptivePlanner& published, const Physics& body);
  std::string take();
  std::string giveBack();
  void learn(const Repertoire& repertoire, const Physics& body);
  void join();
  std::string bodyText() const;

  const PlannerNodeOptions& options_;
  const std::optional<RobotDescription> robot_;
  RepertoireInUse& repertoire_;
  const Publish publish_;
  std::string run_id_;          // of the repertoire relearned from
  std::vector<LegState> legs_;  // of the body relearned for
  bool learning_ = false;       // the thread is there
  std::thread thread_;
  std::atomic<bool> cancelled_{false};
  std::atomic<bool> learned_{false};     // the thread has said all it will
  std::optional<Repertoire> relearned_;  // by the thread, before learned_
  std::string problem_;                  // likewise
};

}  // namespace hexapod
