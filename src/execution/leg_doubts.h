#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "execution/executor_options.h"
#include "execution/executor_status.h"
#include "robot/robot_description.h"

namespace hexapod {

/// What somebody who watches the robot's body says of its joints.
struct JointTolerance {
  std::vector<std::size_t> dead;  ///< indices of joints that are believed dead
  bool watched = false;           ///< somebody does watch, and will say so when a leg is dead

  bool operator==(const JointTolerance& other) const {
    return dead == other.dead && watched == other.watched;
  }
};

/// Which legs need neither follow nor be read: those that are believed dead, and for a while those
/// that may be.
///
/// A leg that breaks is in trouble before anybody can know why. While somebody watches the body
/// (JointTolerance), a leg in trouble is doubted instead: until the first behaviour that begins
/// with it in trouble has ended whole, no command left out, and belief_patience_s more. By then it
/// is believed dead, or its trouble is a fault. No more than max_dead_legs are dead or doubted at
/// once, and a leg is doubted once between two armings. No function but the constructor allocates,
/// locks or waits. Not thread-safe.
class LegDoubts {
 public:
  LegDoubts(const RobotDescription& robot, double period_s, const ExecutorOptions& options);

  /// `dead`: one flag per joint.
  void tolerate(const std::vector<char>& dead, bool watched);

  /// The joint is believed dead.
  bool tolerates(std::size_t joint) const { return dead_[joint] != 0; }

  /// The joint is in trouble. True when that is no fault (yet).
  bool excuses(std::size_t joint);

  /// One command period goes by.
  void passTick(const ExecutorStatus& status);

  /// Legs may be doubted anew.
  void forgive();

  /// A bit for each leg in doubt.
  std::uint64_t doubted() const;

 private:
  enum class Trust { kTrusted, kDoubted, kSpent };
  struct Leg {
    Trust trust = Trust::kTrusted;
    bool is_dead = false;
    bool was_watched = false;         // a whole behaviour has ended since
    std::uint64_t serial = 0;         // of the last behaviour that began before the doubt
    std::int64_t patience_ticks = 0;  // left once it was watched
  };

  std::int64_t legsLost() const;

  std::int64_t max_dead_legs_;
  std::int64_t patience_ticks_;
  bool watched_ = false;
  std::uint64_t serial_ = 0;  // of the last behaviour that began
  std::vector<std::size_t> leg_of_joint_;
  std::vector<char> dead_;  // per joint
  std::vector<Leg> legs_;
};

}  // namespace hexapod
