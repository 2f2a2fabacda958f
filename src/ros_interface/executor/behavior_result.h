#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "execution/executor_status.h"
#include "hexapod_repertoire/ExecuteBehaviorResult.h"

namespace hexapod {

/// What a client is told of a behaviour of `command_count` commands that ended; without its stamp.
/// SUCCEEDED is only a behaviour of which every command was sent.
hexapod_repertoire::ExecuteBehaviorResult behaviorResult(
    const BehaviorEnd& end, std::size_t command_count, const std::vector<std::string>& joint_names);

}  // namespace hexapod
