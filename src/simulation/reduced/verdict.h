#pragma once

#include "gait/outcome.h"
#include "simulation/reduced/stepper.h"

namespace hexapod::reduced {

/// The verdict of a step, in the order in which OdeWorld looks.
inline Verdict verdictOf(const LaneFindings& findings) {
  if (findings.diverged) return Verdict::kDiverged;
  if (findings.fell) return Verdict::kFell;
  return findings.collided ? Verdict::kSelfCollided : Verdict::kWalked;
}

}  // namespace hexapod::reduced
