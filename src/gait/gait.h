#pragma once

#include <cstdint>
#include <vector>

#include "gait/genome.h"
#include "robot/robot_description.h"

namespace hexapod {

/// gamma(t) = amplitude * tanh(4 sin(2 pi (t + phase))): eq. 3 of the paper, period 1 s.
double gaitSignal(double time_s, double amplitude, double phase);

/// gamma at full amplitude at one time, for each phase level: what all gaits have in common then.
using GaitSignals = std::vector<double>;
GaitSignals gaitSignals(double time_s, std::size_t gene_levels);

/// The periodic joint targets of one genome: pure function of time.
///
/// Joint j of leg i has target = neutral + amplitude_rad * gamma(t, alpha, phi), with alpha and phi
/// of the joint's signal on that leg (appendix B, with as many levels and signals as wanted; in the
/// paper the second and third joint share one signal with opposite signs, which keeps the tibia
/// vertical). Zero amplitudes give the neutral pose.
/// The description must outlive the gait. Const functions may be called from any thread.
class Gait {
 public:
  /// Throws std::invalid_argument when the number of genes or a level does not fit the robot.
  Gait(const RobotDescription& robot, const Genome& genome, std::size_t gene_levels = kGeneLevels);

  /// Writes the targets [rad] at time_s [s] in joint order; resizes `angles_rad` to the joint
  /// count.
  void angles(double time_s, std::vector<double>& angles_rad) const;
  /// The same at the time of the signals.
  void angles(const GaitSignals& signals, std::vector<double>& angles_rad) const;

  const RobotDescription& robot() const { return *robot_; }

 private:
  template <typename SignalOfLevel>
  void write(const SignalOfLevel& signal, std::vector<double>& angles_rad) const;

  const RobotDescription* robot_;
  std::size_t gene_levels_;
  std::vector<const Joint*> joints_;
  std::vector<double> amplitudes_;  // of gamma, per joint
  std::vector<std::uint8_t> phase_levels_;
};

}  // namespace hexapod
