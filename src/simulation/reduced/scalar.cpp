#include "simulation/reduced/lane_stepper.h"

namespace hexapod::reduced {

Stepper::~Stepper() = default;

Stepper* makeScalarStepper(const ReducedModel& model) { return makeStepper<double>(model); }

}  // namespace hexapod::reduced
