#pragma once

#include <ros/time.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "planning/foresight.h"
#include "repertoire/entry.h"

namespace hexapod {

/// Who plays behaviours on the robot: the executor, or a stand-in in a test. From any thread, but
/// play() from one at a time.
class BehaviorPlayer {
 public:
  enum class End {
    kPlayed,
    kCancelled,  ///< broken off because it was to be
    kNotReady,   ///< did not begin: stopped, disarmed, faulty, absent
    kFault,      ///< began and failed, or the player fell silent
    kTimeStands  ///< simulated time stood still
  };
  struct Result {
    End end = End::kFault;
    std::string message;
    ros::Time finished;         ///< stamp of the last command, or since when it has been ready
    std::uint32_t skipped = 0;  ///< commands that were left out: not the entry's behaviour
    std::vector<JointRange> joints = {};  ///< as in WalkedStep
  };
  using Interrupted = std::function<bool()>;  ///< asked often; true: break off
  struct Order {
    const Entry& entry;
    std::string run_id;   ///< empty: of one that nobody publishes; the genome alone is sent
    std::uint64_t stops;  ///< stops() when the goal was given
    Interrupted interrupted;
  };

  virtual ~BehaviorPlayer() = default;

  /// Empty when it plays, or will soon (standing up, coming to rest). Else a sentence that says why
  /// not and what to do.
  virtual std::string whyNotReady() const = 0;

  /// How often it has come to a state in which it plays nothing until a person arms it. What was
  /// asked of it before a stop does not begin after it.
  virtual std::uint64_t stops() const = 0;

  /// Waits until nothing is under way any more: what was broken off before ends in the neutral
  /// pose. kPlayed when it would play now, else the reason why not. `stops` as in an Order.
  virtual Result awaitReady(std::uint64_t stops, const Interrupted& interrupted) = 0;

  /// Has an entry played and waits for its end. Every wait is bounded in steady time.
  virtual Result play(const Order& order) = 0;
};

}  // namespace hexapod
