#pragma once

#include <string>
#include <vector>

#include "tools/walk_campaign.h"

namespace hexapod {

/// The parts of a list without the spaces around them, none of them empty.
std::vector<std::string> splitList(const std::string& text, char separator = ',');

/// The bodies that a campaign walks with, as texts that bodyFromText() reads: intact, every leg
/// lifted, one locked, missing and limp, several legs, other physics, slopes.
std::vector<std::string> campaignBodies(const RobotDescription& robot);

/// The bodies that `text` describes as bodyFromText() reads them, semicolons between them;
/// campaignBodies() for "all". Throws std::invalid_argument as bodyFromText() does, and when there
/// is none.
std::vector<TrueBody> bodiesFromText(const RobotDescription& robot, const std::string& text);

}  // namespace hexapod
