#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "gait/genome.h"
#include "gait/outcome.h"
#include "geometry/pose2.h"
#include "robot/robot_description.h"

namespace hexapod {

/// A way in which the robot is its own image, with what that does to gaits and to where they lead:
/// a robot that walks the image of a genome ends at the image of the genome's end pose.
///
/// As exact as the robot is; of one that is exact, Outcome's 1e-5 hide what rounding leaves. Every
/// symmetry is its own inverse. Immutable; const functions may be called from any thread.
class Symmetry {
 public:
  /// Where a leg's gait goes.
  struct LegImage {
    std::size_t leg = 0;  ///< the leg that moves in its place
    /// Of each signal, whether it has to be negated there: half a period later.
    std::vector<bool> half_period = {false, false};
  };

  /// `x_sign` -1: front and rear are exchanged; `y_sign` -1: left and right are; each 1 or -1.
  /// One leg image per leg, all of as many signals; genes of so many levels.
  Symmetry(double x_sign, double y_sign, std::vector<LegImage> legs,
           std::size_t gene_levels = kGeneLevels);

  /// "left-right", "fore-aft" or, both at once, "half turn".
  std::string name() const;

  const std::vector<LegImage>& legs() const { return legs_; }

  /// Canonical genome of the image gait.
  Genome image(const Genome& genome) const;
  /// Left-right: (x, -y, -yaw); fore-aft: (-x, y, -yaw); half turn: (-x, -y, yaw).
  Pose2 image(const Pose2& start_from_end) const;
  /// The same verdict and orientation error, the image of the end pose.
  Outcome image(const Outcome& outcome) const;

 private:
  double x_sign_;
  double y_sign_;
  std::vector<LegImage> legs_;
  std::size_t gene_levels_;
};

/// The symmetries of a robot, found in its description: left-right, fore-aft and half turn, those
/// that exist; for genes of so many levels. In the neutral pose, geometry, masses, collision
/// shapes, joint axes, limits, servos and the gait's signals and amplitudes must map onto each
/// other as well as files give them: to a thousandth of the leg reach and of a radian, a hundredth
/// of masses and torques. A joint whose mirrored axis or amplitude has the opposite sign moves half
/// a period later.
std::vector<Symmetry> symmetriesOf(const RobotDescription& robot,
                                   std::size_t gene_levels = kGeneLevels);

/// Empty when left and right are mirror images, otherwise what is not, and by how much.
std::string whyNotMirrored(const RobotDescription& robot);

}  // namespace hexapod
