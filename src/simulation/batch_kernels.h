#pragma once

#include "simulation/reduced_stepper.h"

namespace hexapod::reduced {

// One per source file compiled for a kind of processor; call only on such a processor. The caller
// owns the result.
Stepper* makeBaselineStepper(const ReducedModel& model);
Stepper* makeAvx2Stepper(const ReducedModel& model);
Stepper* makeAvx512Stepper(const ReducedModel& model);

}  // namespace hexapod::reduced
