#pragma once

#include <string>

#include "planning/plan.h"

namespace hexapod {

/// Why a request cannot be answered, as a sentence; empty when it can.
std::string whyInvalid(const PlanRequest& request, const PlannerOptions& options);

/// Why none of so many entries can be planned with.
std::string noRepertoire(std::size_t entries);

/// Why none of so many entries, some of which could be planned with before, is expected to walk.
std::string nothingWalks(std::size_t entries);

/// What a plan is, or why there is none and what the user may do. Not for kInvalidGoal and
/// kNoRepertoire.
std::string describe(const PlanResult& result, const PlanRequest& request,
                     const PlannerOptions& options);

}  // namespace hexapod
