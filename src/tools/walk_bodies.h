#pragma once

#include <string>
#include <vector>

#include "tools/walk_campaign.h"

namespace hexapod {

/// The words of a comma separated list, without the spaces around them.
std::vector<std::string> splitList(const std::string& text);

/// The bodies that a campaign walks with: intact, every leg lifted, one locked, missing and limp,
/// several legs, other physics, slopes.
std::vector<TrueBody> campaignBodies(const RobotDescription& robot);

/// Those of campaignBodies() that `text` names, comma separated; all for "all"; a text with colons
/// is one body, legs as in legStatesFromText(). Throws std::invalid_argument naming those there
/// are.
std::vector<TrueBody> bodiesFromText(const RobotDescription& robot, const std::string& text);

}  // namespace hexapod
