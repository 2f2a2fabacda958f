#pragma once

#include <map>
#include <string>

#include "repertoire/metrics.h"
#include "robot/robot_description.h"
#include "study/run_plan.h"
#include "study/study_options.h"

namespace hexapod {

/// What came of a run.
struct RunResult {
  double wall_s = 0.0;
  std::map<std::string, RepertoireMetrics> repertoires;  ///< by name
};

/// Does one run of a study and writes its files into a folder that exists: history.csv, entries.csv
/// (RunRecorder), run.csv (what was run, where, how long) and, for the control experiments,
/// targets.csv. Robot, options, algorithm and seed alone determine the entries; one thread.
/// `machine` is told in run.csv. Throws std::invalid_argument for options that do not fit,
/// std::runtime_error for files that cannot be written.
RunResult performRun(const RobotDescription& robot, const StudyOptions& options,
                     const RunPlan& plan, const std::string& machine, const std::string& folder);

}  // namespace hexapod
