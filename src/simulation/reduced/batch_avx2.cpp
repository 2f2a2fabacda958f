#include "simulation/reduced/batch_kernels.h"
#include "simulation/reduced/lane_stepper.h"

namespace hexapod::reduced {

Stepper* makeAvx2Stepper(const ReducedModel& model) {
  return makeStepper<Lanes<kAvx2Lanes>>(model);
}

}  // namespace hexapod::reduced
