#pragma once

#include "simulation/reduced/stepper.h"

namespace hexapod::reduced {

constexpr int kBaselineLanes = 2;
constexpr int kAvx2Lanes = 4;
constexpr int kAvx512Lanes = 8;

// One per source file compiled for a kind of processor; call only on such a processor. The caller
// owns the result.
Stepper* makeBaselineStepper(const ReducedModel& model, const Conditions<double>& conditions);
Stepper* makeAvx2Stepper(const ReducedModel& model, const Conditions<double>& conditions);
Stepper* makeAvx512Stepper(const ReducedModel& model, const Conditions<double>& conditions);

}  // namespace hexapod::reduced
