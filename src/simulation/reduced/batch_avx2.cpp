#include "simulation/reduced/batch_kernels.h"
#include "simulation/reduced/lane_stepper.h"

namespace hexapod::reduced {

Stepper* makeAvx2Stepper(const ReducedModel& model, const Conditions<double>& conditions) {
  return makeStepper<Lanes<kAvx2Lanes>>(model, conditions);
}

}  // namespace hexapod::reduced
