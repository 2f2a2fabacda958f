#include "simulation/batch_kernels.h"
#include "simulation/reduced_lane_stepper.h"

namespace hexapod::reduced {

Stepper* makeAvx512Stepper(const ReducedModel& model) {
  return makeStepper<Lanes<kAvx512Lanes>>(model);
}

}  // namespace hexapod::reduced
