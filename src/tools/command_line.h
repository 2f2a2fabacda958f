#pragma once

#include <map>
#include <string>
#include <vector>

#include "common/options.h"

namespace hexapod {

/// What problems with a command line are told to be in.
extern const std::string kCommandLine;

/// The values that the words of a command line give to options: `--name value`, `--name=value` or,
/// as roslaunch has it, `name:=value`; `--name` alone for those that are true or false. Dashes in a
/// name count as underscores; `short_names` are other names of options. Names that no option has
/// are kept for applyOptions() to complain of.
///
/// Throws std::invalid_argument with a sentence for a word that is no option, an option without a
/// value, or one that stands there twice.
std::map<std::string, OptionValue> valuesFromCommandLine(
    const std::vector<std::string>& words, const std::vector<Option>& options,
    const std::map<std::string, std::string>& short_names = {});

}  // namespace hexapod
