#pragma once

#include <map>
#include <string>

#include "common/options.h"

namespace hexapod {

/// The values of a YAML file of the learner's options, like config/learn.yaml, without those that
/// only the node knows. Throws as optionValuesFromYaml().
std::map<std::string, OptionValue> valuesFromLearnerFile(const std::string& file);

}  // namespace hexapod
