#pragma once

#include <memory>
#include <string>
#include <vector>

#include "simulation/reduced/stepper.h"

namespace hexapod::reduced {

/// The instruction sets the batched step is built for. All give the same bits.
enum class InstructionSet { kBaseline, kAvx2, kAvx512 };

/// "baseline", "AVX2", "AVX-512".
std::string toString(InstructionSet instructions);

/// Robots per register: 2, 4, 8.
int lanes(InstructionSet instructions);

/// Those that were built in and that this machine's processor has; kBaseline is always one.
std::vector<InstructionSet> availableInstructionSets();

/// The widest of them.
InstructionSet bestInstructionSet();

/// A stepper of as many robots as a register of the instruction set holds: 2, 4 or 8. The model
/// must outlive it; `conditions` as those of makeScalarStepper(). Throws std::invalid_argument when
/// the instruction set is not available.
std::unique_ptr<Stepper> makeBatchStepper(const ReducedModel& model,
                                          const Conditions<double>& conditions,
                                          InstructionSet instructions);

}  // namespace hexapod::reduced
