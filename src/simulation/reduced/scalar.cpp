#include "simulation/reduced/lane_stepper.h"

namespace hexapod::reduced {

Stepper::~Stepper() = default;

Stepper* makeScalarStepper(const ReducedModel& model, const Conditions<double>& conditions) {
  return makeStepper<double>(model, conditions);
}

}  // namespace hexapod::reduced
