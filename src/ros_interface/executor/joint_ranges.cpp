#include "ros_interface/executor/joint_ranges.h"

#include <algorithm>
#include <cmath>

namespace hexapod {

JointRanges::JointRanges(std::size_t joint_count)
    : counts_(joint_count, 0), min_rad_(joint_count, NAN), max_rad_(joint_count, NAN) {}

void JointRanges::begin() {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::fill(min_rad_.begin(), min_rad_.end(), NAN);
  max_rad_ = min_rad_;
}

void JointRanges::add(const JointReadings& readings) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (std::size_t j = 0; j < counts_.size(); ++j) {
    if (readings.counts[j] == counts_[j]) continue;
    counts_[j] = readings.counts[j];
    min_rad_[j] = std::fmin(min_rad_[j], readings.angles_rad[j]);
    max_rad_[j] = std::fmax(max_rad_[j], readings.angles_rad[j]);
  }
}

std::vector<double> JointRanges::min_rad() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return min_rad_;
}

std::vector<double> JointRanges::max_rad() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return max_rad_;
}

}  // namespace hexapod
