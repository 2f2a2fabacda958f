#include "gait/symmetry.h"

#include <cassert>
#include <utility>

#include "gait/mirror.h"

namespace hexapod {
namespace {

std::uint8_t halfPeriodLater(std::uint8_t phase_level) {
  return static_cast<std::uint8_t>((phase_level + 2) % 4);
}

}  // namespace

Symmetry::Symmetry(double x_sign, double y_sign, std::vector<LegImage> legs)
    : x_sign_(x_sign), y_sign_(y_sign), legs_(std::move(legs)) {}

std::string Symmetry::name() const {
  if (x_sign_ > 0.0) return "left-right";
  return y_sign_ > 0.0 ? "fore-aft" : "half turn";
}

Genome Symmetry::image(const Genome& genome) const {
  assert(genome.size() == kGenesPerLeg * legs_.size());
  Genome image(genome.size());
  for (std::size_t leg = 0; leg < legs_.size(); ++leg) {
    for (std::size_t signal = 0; signal < 2; ++signal) {
      const std::size_t from = kGenesPerLeg * leg + 2 * signal;
      const std::size_t to = kGenesPerLeg * legs_[leg].leg + 2 * signal;
      image[to] = genome[from];
      image[to + 1] =
          legs_[leg].half_period[signal] ? halfPeriodLater(genome[from + 1]) : genome[from + 1];
    }
  }
  return canonical(image);
}

Pose2 Symmetry::image(const Pose2& start_from_end) const {
  // Adding 0 makes -0 a 0.
  return {x_sign_ * start_from_end.x_m + 0.0, y_sign_ * start_from_end.y_m + 0.0,
          wrapAngle(x_sign_ * y_sign_ * start_from_end.yaw_rad) + 0.0};
}

Outcome Symmetry::image(const Outcome& outcome) const {
  Outcome result = outcome;
  if (outcome.walked()) result.end_pose = image(outcome.end_pose);
  return result;
}

std::vector<Symmetry> symmetriesOf(const RobotDescription& robot) {
  std::vector<Symmetry> found;
  for (const auto& [x_sign, y_sign] : {std::pair{1.0, -1.0}, {-1.0, 1.0}, {-1.0, -1.0}}) {
    const auto legs = Mirror(robot, x_sign, y_sign).legImages();
    if (legs) found.emplace_back(x_sign, y_sign, *legs);
  }
  return found;
}

std::string whyNotMirrored(const RobotDescription& robot) {
  Mirror left_right(robot, 1.0, -1.0);
  return left_right.legImages() ? "" : left_right.difference();
}

}  // namespace hexapod
