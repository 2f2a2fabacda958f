#pragma once

#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "common/options.h"

namespace hexapod {

/// Sets the options from the parameters in the private namespace of a node.
///
/// Strict where roscpp is not: a key that is no option, a value of the wrong type or outside its
/// range throws std::invalid_argument with a sentence for every problem. `also_known` names private
/// parameters that are read elsewhere. Nested parameters (maps, lists) are problems unless known.
void loadParams(const ros::NodeHandle& private_node, const std::vector<Option>& options,
                const std::vector<std::string>& also_known = {});

/// Replaces a leading "~/" by the home directory, as a shell would. Other paths are returned as
/// they are.
std::string expandHome(const std::string& path);

}  // namespace hexapod
