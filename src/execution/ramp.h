#pragma once

#include <cstdint>
#include <vector>

#include "robot/robot_description.h"

namespace hexapod {

/// A smooth way from one pose to another, command by command: a hold, then a cubic that starts and
/// ends at rest. No function but the constructor allocates.
class Ramp {
 public:
  explicit Ramp(const RobotDescription& robot);

  /// Takes at least `duration_s` after `hold_s` at `from`, and longer where a joint would exceed
  /// its velocity limit. Poses [rad] in joint order, one value per joint.
  void plan(const std::vector<double>& from, const std::vector<double>& to, double hold_s,
            double duration_s, double period_s);

  /// Pose of command `index` (0: `from`), into `pose_rad`, which has its size.
  void pose(std::int64_t index, std::vector<double>& pose_rad) const;

  /// From this index on, pose() is the goal exactly.
  std::int64_t length() const { return hold_ + moving_; }
  const std::vector<double>& goal() const { return to_; }

 private:
  std::vector<double> max_velocity_;
  std::vector<double> from_;
  std::vector<double> to_;
  std::int64_t hold_ = 0;
  std::int64_t moving_ = 1;
};

}  // namespace hexapod
