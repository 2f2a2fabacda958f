#pragma once

#include <set>
#include <vector>

#include "evolution/transferability.h"
#include "repertoire/entry.h"
#include "repertoire/robot_trial.h"
#include "transferability/disparity_process.h"

namespace hexapod {

/// Where a robot is expected to end, seen from where simulation does.
struct Disparity {
  Pose2 shift;                 ///< of the end pose: x, y in the frame of the start, and heading
  double deviation_m = 0.0;    ///< root mean square of what is left of the position then
  double deviation_rad = 0.0;  ///< and of the heading
};

/// What trials tell of all other behaviours (Koos, Mouret & Doncieux 2013, with Gaussian processes
/// in place of inverse distances: they say how sure they are).
///
/// A behaviour that fell is taken for one that left the robot where it was. Immutable; const
/// functions may be called from any thread. Deterministic.
class DisparityModel : public Transferability {
 public:
  /// One trial or more. `weight_rad_per_m`: what a metre counts in cost.
  DisparityModel(const FeatureScales& scales, double weight_rad_per_m,
                 const std::vector<RobotTrial>& trials);

  Disparity expected(const Genome& genome, const Outcome& simulated) const;

  /// The root mean square distance between robot and simulation that is expected, by the weight.
  double disparity(const Genome& genome, const Outcome& simulated) const override;

  /// An entry's execution as it is expected on the robot: moved, and spread by what is not known.
  /// That of an entry that fell there has a fall. The entry must have one.
  Execution onRobot(const Entry& entry) const;

 private:
  FeatureScales scales_;
  double weight_rad_per_m_;
  std::set<Genome> fell_;
  std::vector<DisparityProcess> coordinates_;  // x, y, heading
};

}  // namespace hexapod
