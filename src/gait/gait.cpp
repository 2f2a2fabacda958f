#include "gait/gait.h"

#include <cmath>
#include <stdexcept>

namespace hexapod {

double gaitSignal(double time_s, double amplitude, double phase) {
  return amplitude * std::tanh(4.0 * std::sin(2.0 * M_PI * (time_s + phase)));
}

GaitSignals gaitSignals(double time_s) {
  GaitSignals signals;
  for (std::uint8_t level = 0; level < kGeneLevels; ++level) {
    signals[level] = gaitSignal(time_s, 1.0, geneValue(level));
  }
  return signals;
}

Gait::Gait(const RobotDescription& robot, const Genome& genome)
    : robot_(&robot), joints_(robot.joints()) {
  if (genome.size() != robot.geneCount()) {
    throw std::invalid_argument("A genome of " + std::to_string(genome.size()) +
                                " genes does not fit robot " + robot.name + "; expected " +
                                std::to_string(robot.geneCount()) + ", 4 per leg.");
  }
  for (std::size_t gene = 0; gene < genome.size(); ++gene) {
    if (genome[gene] < kGeneLevels) continue;
    throw std::invalid_argument("Gene " + std::to_string(gene) + " is " +
                                std::to_string(genome[gene]) + "; expected a level 0 .. 4.");
  }
  for (std::size_t leg = 0; leg < robot.legs.size(); ++leg) {
    for (const Segment& segment : robot.legs[leg].segments) {
      const std::size_t gene =
          kGenesPerLeg * leg + (segment.joint.signal == Signal::kFirst ? 0 : 2);
      amplitudes_.push_back(geneValue(genome[gene]));
      phase_levels_.push_back(genome[gene + 1]);
    }
  }
}

void Gait::angles(const GaitSignals& signals, std::vector<double>& angles_rad) const {
  angles_rad.resize(joints_.size());
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const double signal = amplitudes_[j] * signals[phase_levels_[j]];
    angles_rad[j] = joints_[j]->neutral_rad + joints_[j]->amplitude_rad * signal;
  }
}

}  // namespace hexapod
