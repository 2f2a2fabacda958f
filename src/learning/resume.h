#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "learning/checkpoint.h"
#include "learning/learn_options.h"
#include "robot/robot_description.h"

namespace hexapod {

/// From where a session goes on.
struct Resumed {
  Checkpoint checkpoint;
  std::vector<HistoryRow> history;
  std::map<std::int64_t, Execution> executions;  ///< by id, of the entries that have one
  std::map<std::string, std::string> facts;
  std::vector<RobotTrial> trials;
  std::string from;            ///< what names the entries that it began with, or empty
  bool checks_differ = false;  ///< its entries were checked otherwise than is asked for now
};

/// Reads the run that repertoire_file holds. Throws std::invalid_argument when it is another run
/// than these options and this robot make, with a line for each difference, or cannot be gone on
/// with; std::runtime_error as loadStoredRepertoire() does.
///
/// Budgets and checks may differ: the same run may be given more evaluations, more time, more
/// trials. It must not have fewer evaluations than were done already. What it began with need not
/// be told again.
Resumed resume(const RobotDescription& robot, const LearnOptions& options);

}  // namespace hexapod
