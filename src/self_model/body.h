#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "robot/robot_description.h"
#include "simulation/world.h"

namespace hexapod {

/// What may be otherwise about a body by degrees: the logarithms of scales, and the slope of the
/// floor along x and y of the world [rad].
constexpr int kBodyParameters = 6;
enum BodyParameter { kFriction, kServoGain, kTorque, kMass, kSlopeX, kSlopeY };
using BodyVector = Eigen::Matrix<double, kBodyParameters, 1>;
using BodyMatrix = Eigen::Matrix<double, kBodyParameters, kBodyParameters>;

/// Name, unit and standard deviation that is thought possible beforehand, of each.
struct BodyParameterInfo {
  const char* name;
  const char* unit;
  double prior_deviation;
};
const std::array<BodyParameterInfo, kBodyParameters>& bodyParameters();

/// The physics of a body on its floor.
Physics physicsOf(const Physics& nominal, const std::vector<LegState>& legs,
                  const BodyVector& parameters);

/// The parameters of a physics: the inverse of physicsOf().
BodyVector parametersOf(const Physics& physics, const Physics& nominal);

}  // namespace hexapod
