#include "self_model/learned_world.h"

#include "common/options.h"
#include "simulation/body_text.h"

namespace hexapod {

LearnedWorld learnedWorldOf(const RobotDescription& robot, const Repertoire& repertoire) {
  LearnedWorld learned;
  std::vector<Option> wanted = declareOptions(learned.behavior);
  wanted.push_back(
      option("step_s", learned.physics.step_s, "s", "Step of the simulation.", 1e-4, 0.05));
  std::map<std::string, OptionValue> values;
  for (const Option& one : wanted) {
    const auto found = repertoire.options.find(one.name);
    if (found != repertoire.options.end()) values[one.name] = optionValueFromText(found->second);
  }
  applyOptions(wanted, values, "repertoire");
  learned.physics = bodyFromText(robot, repertoire.body(), learned.physics);
  return learned;
}

}  // namespace hexapod
