#pragma once

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
/// std::invalid_argument for options that do not fit.
void workFor(Channel& session, const RobotDescription& robot, const LearnOptions& options);

}  // namespace hexapod
