#include "simulation/batch_kernels.h"
#include "simulation/reduced_lane_stepper.h"

namespace hexapod::reduced {

Stepper* makeBaselineStepper(const ReducedModel& model) {
  return makeStepper<Lanes<kBaselineLanes>>(model);
}

}  // namespace hexapod::reduced
