#include "gait/symmetry.h"

#include <cassert>
#include <utility>

#include "gait/mirror.h"

namespace hexapod {
namespace {

std::uint8_t halfPeriodLater(std::uint8_t phase_level, std::size_t levels) {
  const std::size_t period = levels - 1;
  return static_cast<std::uint8_t>((phase_level + period / 2) % period);
}

}  // namespace

Symmetry::Symmetry(double x_sign, double y_sign, std::vector<LegImage> legs,
                   std::size_t gene_levels)
    : x_sign_(x_sign), y_sign_(y_sign), legs_(std::move(legs)), gene_levels_(gene_levels) {}

std::string Symmetry::name() const {
  if (x_sign_ > 0.0) return "left-right";
  return y_sign_ > 0.0 ? "fore-aft" : "half turn";
}

Genome Symmetry::image(const Genome& genome) const {
  Genome image(genome.size());
  for (std::size_t leg = 0; leg < legs_.size(); ++leg) {
    const std::size_t signals = legs_[leg].half_period.size();
    assert(genome.size() == 2 * signals * legs_.size());
    for (std::size_t signal = 0; signal < signals; ++signal) {
      const std::size_t from = 2 * (signals * leg + signal);
      const std::size_t to = 2 * (signals * legs_[leg].leg + signal);
      const std::uint8_t phase = genome[from + 1];
      image[to] = genome[from];
      image[to + 1] = legs_[leg].half_period[signal] ? halfPeriodLater(phase, gene_levels_) : phase;
    }
  }
  return canonical(image, gene_levels_);
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

std::vector<Symmetry> symmetriesOf(const RobotDescription& robot, std::size_t gene_levels) {
  std::vector<Symmetry> found;
  for (const auto& [x_sign, y_sign] : {std::pair{1.0, -1.0}, {-1.0, 1.0}, {-1.0, -1.0}}) {
    const auto legs = Mirror(robot, x_sign, y_sign).legImages();
    if (legs) found.emplace_back(x_sign, y_sign, *legs, gene_levels);
  }
  return found;
}

std::string whyNotMirrored(const RobotDescription& robot) {
  Mirror left_right(robot, 1.0, -1.0);
  return left_right.legImages() ? "" : left_right.difference();
}

}  // namespace hexapod
