#include "tools/learner_file.h"

namespace hexapod {

std::map<std::string, OptionValue> valuesFromLearnerFile(const std::string& file) {
  std::map<std::string, OptionValue> values = optionValuesFromYaml(file);
  for (const char* name : {"publish_period_s", "exit_when_done"}) values.erase(name);
  return values;
}

}  // namespace hexapod
