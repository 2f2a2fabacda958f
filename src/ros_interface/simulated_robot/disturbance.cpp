#include "ros_interface/simulated_robot/disturbance.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "simulation/physics.h"

namespace hexapod {
namespace {

using Request = hexapod_repertoire::Disturb::Request;

double checked(const char* name, double value, double max) {
  if (value >= 0.0 && value <= max) return value;
  std::ostringstream sentence;
  sentence.imbue(std::locale::classic());
  sentence << name << " is " << value << "; expected 0 .. " << max << ".";
  throw std::invalid_argument(sentence.str());
}

double scaleOf(double asked) { return asked == 0.0 ? 1.0 : asked; }

std::size_t legNamed(const RobotDescription& robot, const std::string& name) {
  std::string names;
  for (std::size_t leg = 0; leg < robot.legs.size(); ++leg) {
    if (robot.legs[leg].name == name) return leg;
    names += (leg == 0 ? "" : ", ") + robot.legs[leg].name;
  }
  throw std::invalid_argument("There is no leg '" + name + "'; expected one of " + names + ".");
}

std::vector<double> anglesOfLeg(const RobotDescription& robot, std::size_t index,
                                const std::vector<double>& angles_rad) {
  std::size_t first = 0;
  for (std::size_t leg = 0; leg < index; ++leg) first += robot.legs[leg].segments.size();
  const auto begin = angles_rad.begin() + static_cast<std::ptrdiff_t>(first);
  return {begin, begin + static_cast<std::ptrdiff_t>(robot.legs[index].segments.size())};
}

std::vector<LegState> legsFrom(const Request& request, const RobotDescription& robot,
                               const std::vector<double>& angles_rad) {
  if (request.legs.size() != request.states.size()) {
    throw std::invalid_argument("There are " + std::to_string(request.legs.size()) + " legs and " +
                                std::to_string(request.states.size()) +
                                " states; expected a state for each leg.");
  }
  std::vector<LegState> legs;
  for (std::size_t i = 0; i < request.legs.size(); ++i) {
    if (request.states[i] >= legConditionNames().size()) {
      throw std::invalid_argument("The state of leg '" + request.legs[i] + "' is " +
                                  std::to_string(request.states[i]) +
                                  "; expected 0 (intact), 1 (locked), 2 (lifted), 3 (limp) or 4 "
                                  "(missing).");
    }
    legs.resize(robot.legs.size());
    LegState& leg = legs[legNamed(robot, request.legs[i])];
    leg.condition = static_cast<LegCondition>(request.states[i]);
    if (leg.condition == LegCondition::kLocked) {
      leg.locked_rad = anglesOfLeg(robot, legNamed(robot, request.legs[i]), angles_rad);
    }
  }
  return legs;
}

}  // namespace

Disturbance disturbanceFrom(const Request& request, const Disturbance& started_with,
                            const RobotDescription& robot, const std::vector<double>& angles_rad) {
  Disturbance disturbance = started_with;
  Physics& physics = disturbance.physics;
  if (!request.legs.empty()) physics.legs = legsFrom(request, robot, angles_rad);
  physics.friction_scale *= scaleOf(request.friction_scale);
  physics.mass_scale *= scaleOf(request.mass_scale);
  physics.servo_gain_scale *= scaleOf(request.servo_gain_scale);
  physics.torque_scale *= scaleOf(request.torque_scale);
  physics.slope_x_rad += request.slope_x_rad;
  physics.slope_y_rad += request.slope_y_rad;
  checkPhysics(physics);
  disturbance.latency_s += checked("latency_s", request.latency_s, 1.0);
  disturbance.dropped_share += checked("dropped_share", request.dropped_share, 1.0);
  disturbance.feedback_noise_rad += checked("feedback_noise_rad", request.feedback_noise_rad, 1.0);
  disturbance.dead_band_rad += checked("dead_band_rad", request.dead_band_rad, 1.0);
  return disturbance;
}

std::string describe(const Disturbance& disturbance, const RobotDescription& robot) {
  const Physics& physics = disturbance.physics;
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "Legs: " << describeLegs(robot, physics.legs) << "; friction x " << physics.friction_scale
       << ", mass x " << physics.mass_scale << ", servo gain x " << physics.servo_gain_scale
       << ", torque x " << physics.torque_scale << ", slope " << physics.slope_x_rad << ", "
       << physics.slope_y_rad << " rad; commands " << disturbance.latency_s << " s late, "
       << 100.0 * disturbance.dropped_share << " % lost; feedback noise "
       << disturbance.feedback_noise_rad << " rad, dead band " << disturbance.dead_band_rad
       << " rad.";
  return text.str();
}

}  // namespace hexapod
