#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "gait/genome.h"
#include "robot/robot_description.h"

namespace hexapod {

/// gamma(t) = amplitude * tanh(4 sin(2 pi (t + phase))): eq. 3 of the paper, period 1 s.
double gaitSignal(double time_s, double amplitude, double phase);

/// gamma at full amplitude at one time, for each phase level: what all gaits have in common then.
using GaitSignals = std::array<double, kGeneLevels>;
GaitSignals gaitSignals(double time_s);

/// The periodic joint targets of one genome: pure function of time.
///
/// Joint j of leg i has target = neutral + amplitude_rad * gamma(t, alpha, phi), with alpha and phi
/// of the joint's signal on that leg (appendix B; the second and third joint share one signal with
/// opposite signs, which keeps the tibia vertical). Zero amplitudes give the neutral pose.
/// The description must outlive the gait. Const functions may be called from any thread.
class Gait {
 public:
  /// Throws std::invalid_argument when the number of genes or a level does not fit the robot.
  Gait(const RobotDescription& robot, const Genome& genome);

  /// Writes the targets [rad] at time_s [s] in joint order; resizes `angles_rad` to the joint
  /// count.
  void angles(double time_s, std::vector<double>& angles_rad) const {
    angles(gaitSignals(time_s), angles_rad);
  }
  void angles(const GaitSignals& signals, std::vector<double>& angles_rad) const;

  const RobotDescription& robot() const { return *robot_; }

 private:
  const RobotDescription* robot_;
  std::vector<const Joint*> joints_;
  std::vector<double> amplitudes_;  // of gamma, per joint
  std::vector<std::uint8_t> phase_levels_;
};

}  // namespace hexapod
