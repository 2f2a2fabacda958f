#pragma once

#include <actionlib/client/simple_action_client.h>
#include <ros/node_handle.h>

#include <cstdint>
#include <functional>
#include <string>

#include "hexapod_repertoire/ExecuteBehaviorAction.h"
#include "repertoire/entry.h"

namespace hexapod {

/// Has the executor play one behaviour and waits for its end.
class BehaviorClient {
 public:
  enum class End { kPlayed, kCancelled, kNotReady, kFault };
  struct Result {
    End end = End::kFault;
    std::string message;
    ros::Time finished;  ///< stamp of the last command
  };

  explicit BehaviorClient(ros::NodeHandle& node);

  /// Plays an entry. `cancelled` is asked while it plays: when true, the executor is told to break
  /// off. An executor that is not ready is asked again for some seconds (then kNotReady). Gives up
  /// with kFault when the executor is not there, refuses, or takes longer than `longest_s`. Called
  /// from one thread.
  Result play(const Entry& entry, const std::string& run_id, double longest_s,
              const std::function<bool()>& cancelled);

 private:
  Result playOnce(const hexapod_repertoire::ExecuteBehaviorGoal& goal, double longest_s,
                  const std::function<bool()>& cancelled);

  actionlib::SimpleActionClient<hexapod_repertoire::ExecuteBehaviorAction> client_;
};

}  // namespace hexapod
