#include "simulation/reduced/batch_kernels.h"
#include "simulation/reduced/lane_stepper.h"

namespace hexapod::reduced {

Stepper* makeBaselineStepper(const ReducedModel& model) {
  return makeStepper<Lanes<kBaselineLanes>>(model);
}

}  // namespace hexapod::reduced
