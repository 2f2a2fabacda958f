#include "simulation/batch_kernels.h"
#include "simulation/reduced_lane_stepper.h"

namespace hexapod::reduced {

Stepper* makeAvx2Stepper(const ReducedModel& model) {
  return makeStepper<Lanes<kAvx2Lanes>>(model);
}

}  // namespace hexapod::reduced
