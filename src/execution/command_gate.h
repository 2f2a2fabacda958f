#pragma once

#include <cstdint>
#include <vector>

#include "robot/robot_description.h"

namespace hexapod {

/// What the gate limits beside the position and velocity limits of the robot description.
struct GateOptions {
  double max_acceleration_rad_per_s2 = 0.0;  ///< of every joint's commands; 0: not limited
  double soft_limit_margin_rad = 0.0;        ///< kept free before the position limits; 0: none
};

/// The last gate before the wire; trusts nobody.
///
/// Whatever is requested, what passes is finite, within the joints' position limits (by option less
/// a margin) and within velocity limit * period of the command that passed before, however much
/// time went by in between. With an acceleration limit two steps in a row differ by at most that
/// limit * period^2, and no step is so long that the joint could not come to rest before its
/// position limit. A request that is already so passes bit for bit; another is followed as closely
/// as that, braking in time to arrive where it asks. A joint found within the margin stays where it
/// is or moves out of it. No function but the constructor allocates. Not thread-safe.
class CommandGate {
 public:
  enum class Passage {
    kUnchanged,
    kClamped,  ///< at least one joint was held back
    kRefused   ///< not finite or not one value per joint; last() is what it was
  };

  /// Throws std::invalid_argument naming the joint whose neutral angle the margin would forbid.
  CommandGate(const RobotDescription& robot, double period_s, const GateOptions& options = {});

  /// The pose [rad] the robot rests in, from which the next command must be near; clamped into the
  /// position limits. Must be finite and one value per joint.
  void reset(const std::vector<double>& pose_rad);

  /// Commands were left out: the robot rests at last().
  void rest();

  Passage pass(const std::vector<double>& requested_rad);

  /// What passed last [rad]; before the first pass, the pose of reset() or neutral.
  const std::vector<double>& last() const { return last_; }

  /// Requests that were held back since construction.
  std::uint64_t clampedCount() const { return clamped_count_; }

 private:
  struct Limits {
    double lower_rad, upper_rad;            // hard
    double soft_lower_rad, soft_upper_rad;  // less the margin
    double step_rad;                        // velocity limit * period
  };

  bool acceptable(const std::vector<double>& requested_rad) const;
  double nextAngle(std::size_t j, double requested_rad) const;
  bool staysWith(std::size_t j, double requested_rad) const;

  std::vector<Limits> limits_;
  double step_change_rad_;  // acceleration limit * period^2; 0: not limited
  std::vector<double> last_;
  std::vector<double> requested_;  // the request before
  std::vector<double> step_;       // that led to last_ [rad]
  std::uint64_t clamped_count_ = 0;
};

}  // namespace hexapod
