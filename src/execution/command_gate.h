#pragma once

#include <cstdint>
#include <vector>

#include "robot/robot_description.h"

namespace hexapod {

/// The last gate before the wire; trusts nobody.
///
/// Whatever is requested, what passes is finite, within the joints' position limits and, with
/// limit_velocity, within velocity limit * period of the command that passed before, however much
/// time went by in between. A request that is already so passes bit for bit.
/// No function but the constructor allocates. Not thread-safe.
class CommandGate {
 public:
  enum class Passage {
    kUnchanged,
    kClamped,  ///< at least one joint was held back
    kRefused   ///< not finite or not one value per joint; last() is what it was
  };

  CommandGate(const RobotDescription& robot, double period_s, bool limit_velocity);

  /// The pose [rad] the robot is in, from which the next command must be near; clamped into the
  /// position limits. Must be finite and one value per joint.
  void reset(const std::vector<double>& pose_rad);

  Passage pass(const std::vector<double>& requested_rad);

  /// What passed last [rad]; before the first pass, the pose of reset() or neutral.
  const std::vector<double>& last() const { return last_; }

  /// Requests that were held back since construction.
  std::uint64_t clampedCount() const { return clamped_count_; }

 private:
  struct Limits {
    double lower_rad, upper_rad, step_rad;
  };

  bool acceptable(const std::vector<double>& requested_rad) const;

  std::vector<Limits> limits_;
  bool limit_velocity_;
  std::vector<double> last_;
  std::uint64_t clamped_count_ = 0;
};

}  // namespace hexapod
