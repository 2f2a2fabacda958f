#pragma once

#include <string>

#include "robot/robot_description.h"
#include "simulation/reduced/conditions.h"
#include "simulation/reduced/model.h"
#include "simulation/world.h"

namespace hexapod::reduced {

/// Empty when the engine covers this description; otherwise the sentence that says why not.
std::string whyNotCovered(const RobotDescription& robot);

/// The robot with its legs in the states of `physics`. Throws std::invalid_argument with that
/// sentence, or when a value of `physics` is out of range.
ReducedModel makeModel(const RobotDescription& robot, const Physics& physics);

/// The rest of what `physics` say, for a step of `step_s`, whatever their own is.
Conditions<double> conditionsOf(const RobotDescription& robot, const Physics& physics,
                                double step_s);

/// Pose of the base's link from the first values of a state.
Eigen::Isometry3d worldFromBase(const ReducedModel& model, const double* state_values);

}  // namespace hexapod::reduced
