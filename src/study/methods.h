#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/random.h"
#include "evolution/evaluator.h"
#include "evolution/genome_space.h"
#include "gait/symmetry.h"
#include "study/method.h"
#include "study/study_options.h"
#include "study/target_evolution.h"

namespace hexapod {

/// What a method works on.
struct Task {
  GenomeSpace space;
  Evaluator* evaluator;              ///< must outlive the method
  std::vector<Symmetry> symmetries;  ///< of the task; none if there are none
};

/// The targets of the control experiments, spread over the region of interest (figure 2C).
std::vector<Target> controlTargets(const StudyOptions& options);

/// The algorithms of the study: "br_evolution" (the archive), "targets" (the control experiments
/// "nearest" and "orientation" of the paper, targets in its region of interest), "map_elites".
std::vector<std::string> methodNames();

/// A new run. Throws std::invalid_argument for a name that is not among methodNames(), naming
/// those, and for options that are out of range.
std::unique_ptr<Method> makeMethod(const std::string& name, const Task& task,
                                   const StudyOptions& options, const Random& random);

}  // namespace hexapod
