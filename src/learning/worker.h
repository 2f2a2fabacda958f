#pragma once

#include <atomic>
#include <string>

#include "learning/channel.h"
#include "learning/learn_options.h"
#include "robot/robot_description.h"

namespace hexapod {

/// Tells the LearningSession at the other end of the channel why this process cannot work for it,
/// and waits for its end.
void declineWork(Channel& session, const std::string& problem);

/// Simulates for the LearningSession at the other end of the channel until that ends. Robot and
/// options must be those of the session; repertoire_file is not touched. Throws
/// std::invalid_argument for options that do not fit. Once `cancelled` turns true, tasks are given
/// up within one simulated behaviour, and the session ends as if it had been asked to stop itself.
void workFor(Channel& session, const RobotDescription& robot, const LearnOptions& options,
             const std::atomic<bool>& cancelled);

}  // namespace hexapod
