#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "common/random.h"
#include "evolution/algorithm.h"
#include "evolution/target.h"
#include "evolution/task.h"
#include "study/study_options.h"

namespace hexapod {

/// An algorithm that a study compares, and what it has found so far, by name: an algorithm may have
/// several ways to choose.
struct Method {
  std::unique_ptr<Algorithm> algorithm;
  std::function<std::map<std::string, std::vector<Entry>>()> repertoires;
};

/// The targets of the control experiments, spread over the region of interest (figure 2C).
std::vector<Target> controlTargets(const StudyOptions& options);

/// The algorithms of the study: algorithmNames(), and "targets" (the control experiments "nearest"
/// and "orientation" of the paper, targets in its region of interest).
std::vector<std::string> methodNames();

/// A new run. Throws std::invalid_argument for a name that is not among methodNames(), naming
/// those, and for options that are out of range.
Method makeMethod(const std::string& name, const Task& task, const StudyOptions& options,
                  const Random& random);

}  // namespace hexapod
