#include "self_model/body.h"

#include <cmath>

namespace hexapod {

const std::array<BodyParameterInfo, kBodyParameters>& bodyParameters() {
  static const std::array<BodyParameterInfo, kBodyParameters> infos = {{
      {"friction_scale", "", 0.25},
      {"servo_gain_scale", "", 0.2},
      {"torque_scale", "", 0.15},
      {"mass_scale", "", 0.08},
      {"slope_x_rad", "rad", 0.03},
      {"slope_y_rad", "rad", 0.03},
  }};
  return infos;
}

Physics physicsOf(const Physics& nominal, const std::vector<LegState>& legs,
                  const BodyVector& parameters) {
  Physics physics = nominal;
  physics.legs = legs;
  physics.friction_scale *= std::exp(parameters[kFriction]);
  physics.servo_gain_scale *= std::exp(parameters[kServoGain]);
  physics.torque_scale *= std::exp(parameters[kTorque]);
  physics.mass_scale *= std::exp(parameters[kMass]);
  physics.slope_x_rad += parameters[kSlopeX];
  physics.slope_y_rad += parameters[kSlopeY];
  return physics;
}

BodyVector parametersOf(const Physics& physics, const Physics& nominal) {
  BodyVector parameters;
  parameters[kFriction] = std::log(physics.friction_scale / nominal.friction_scale);
  parameters[kServoGain] = std::log(physics.servo_gain_scale / nominal.servo_gain_scale);
  parameters[kTorque] = std::log(physics.torque_scale / nominal.torque_scale);
  parameters[kMass] = std::log(physics.mass_scale / nominal.mass_scale);
  parameters[kSlopeX] = physics.slope_x_rad - nominal.slope_x_rad;
  parameters[kSlopeY] = physics.slope_y_rad - nominal.slope_y_rad;
  return parameters;
}

}  // namespace hexapod
