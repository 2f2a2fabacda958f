#include "simulation/reduced/batch_kernels.h"
#include "simulation/reduced/lane_stepper.h"

namespace hexapod::reduced {

Stepper* makeBaselineStepper(const ReducedModel& model, const Conditions<double>& conditions) {
  return makeStepper<Lanes<kBaselineLanes>>(model, conditions);
}

}  // namespace hexapod::reduced
