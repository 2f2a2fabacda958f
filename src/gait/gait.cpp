#include "gait/gait.h"

#include <cmath>
#include <stdexcept>

namespace hexapod {

double gaitSignal(double time_s, double amplitude, double phase) {
  return amplitude * std::tanh(4.0 * std::sin(2.0 * M_PI * (time_s + phase)));
}

GaitSignals gaitSignals(double time_s, std::size_t gene_levels) {
  GaitSignals signals;
  for (std::size_t level = 0; level < gene_levels; ++level) {
    const auto phase = geneValue(static_cast<std::uint8_t>(level), gene_levels);
    signals.push_back(gaitSignal(time_s, 1.0, phase));
  }
  return signals;
}

Gait::Gait(const RobotDescription& robot, const Genome& genome, std::size_t gene_levels)
    : robot_(&robot), gene_levels_(gene_levels), joints_(robot.joints()) {
  if (genome.size() != robot.geneCount()) {
    throw std::invalid_argument("A genome of " + std::to_string(genome.size()) +
                                " genes does not fit robot " + robot.name + "; expected " +
                                std::to_string(robot.geneCount()) + ", " +
                                std::to_string(robot.genesPerLeg()) + " per leg.");
  }
  for (std::size_t gene = 0; gene < genome.size(); ++gene) {
    if (genome[gene] < gene_levels) continue;
    throw std::invalid_argument("Gene " + std::to_string(gene) + " is " +
                                std::to_string(genome[gene]) + "; expected a level 0 .. " +
                                std::to_string(gene_levels - 1) + ".");
  }
  for (std::size_t leg = 0; leg < robot.legs.size(); ++leg) {
    for (const Segment& segment : robot.legs[leg].segments) {
      const auto signal = static_cast<std::size_t>(segment.joint.signal) - 1;
      const std::size_t gene = robot.genesPerLeg() * leg + 2 * signal;
      amplitudes_.push_back(geneValue(genome[gene], gene_levels));
      phase_levels_.push_back(genome[gene + 1]);
    }
  }
}

void Gait::angles(double time_s, std::vector<double>& angles_rad) const {
  write([&](std::uint8_t level) { return gaitSignal(time_s, 1.0, geneValue(level, gene_levels_)); },
        angles_rad);
}

void Gait::angles(const GaitSignals& signals, std::vector<double>& angles_rad) const {
  write([&](std::uint8_t level) { return signals[level]; }, angles_rad);
}

template <typename SignalOfLevel>
void Gait::write(const SignalOfLevel& signal, std::vector<double>& angles_rad) const {
  angles_rad.resize(joints_.size());
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const double gamma = amplitudes_[j] * signal(phase_levels_[j]);
    angles_rad[j] = joints_[j]->neutral_rad + joints_[j]->amplitude_rad * gamma;
  }
}

}  // namespace hexapod
