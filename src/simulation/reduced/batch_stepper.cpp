#include "simulation/reduced/batch_stepper.h"

#include <algorithm>
#include <stdexcept>

#include "simulation/reduced/batch_kernels.h"

namespace hexapod::reduced {

std::string toString(InstructionSet instructions) {
  switch (instructions) {
    case InstructionSet::kAvx2:
      return "AVX2";
    case InstructionSet::kAvx512:
      return "AVX-512";
    case InstructionSet::kBaseline:
      break;
  }
  return "baseline";
}

int lanes(InstructionSet instructions) {
  switch (instructions) {
    case InstructionSet::kAvx2:
      return kAvx2Lanes;
    case InstructionSet::kAvx512:
      return kAvx512Lanes;
    case InstructionSet::kBaseline:
      break;
  }
  return kBaselineLanes;
}

std::vector<InstructionSet> availableInstructionSets() {
  std::vector<InstructionSet> sets{InstructionSet::kBaseline};
#ifdef HEXAPOD_X86_KERNELS
  if (__builtin_cpu_supports("avx2")) sets.push_back(InstructionSet::kAvx2);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl")) {
    sets.push_back(InstructionSet::kAvx512);
  }
#endif
  return sets;
}

InstructionSet bestInstructionSet() { return availableInstructionSets().back(); }

std::unique_ptr<Stepper> makeBatchStepper(const ReducedModel& model,
                                          const Conditions<double>& conditions,
                                          InstructionSet instructions) {
  const std::vector<InstructionSet> available = availableInstructionSets();
  if (std::find(available.begin(), available.end(), instructions) == available.end()) {
    throw std::invalid_argument("This machine or build has no " + toString(instructions) +
                                " kernels; use bestInstructionSet().");
  }
#ifdef HEXAPOD_X86_KERNELS
  if (instructions == InstructionSet::kAvx512) {
    return std::unique_ptr<Stepper>(makeAvx512Stepper(model, conditions));
  }
  if (instructions == InstructionSet::kAvx2) {
    return std::unique_ptr<Stepper>(makeAvx2Stepper(model, conditions));
  }
#endif
  return std::unique_ptr<Stepper>(makeBaselineStepper(model, conditions));
}

}  // namespace hexapod::reduced
