#pragma once

#include <cstdint>
#include <mutex>
#include <vector>

#include "execution/joint_readings.h"

namespace hexapod {

/// How far each joint was seen to move since begin(). From any thread.
class JointRanges {
 public:
  explicit JointRanges(std::size_t joint_count);

  void begin();
  void add(const JointReadings& readings);

  /// In joint order; nan for a joint that was not read.
  std::vector<double> min_rad() const;
  std::vector<double> max_rad() const;

 private:
  mutable std::mutex mutex_;
  std::vector<std::uint64_t> counts_;
  std::vector<double> min_rad_, max_rad_;
};

}  // namespace hexapod
