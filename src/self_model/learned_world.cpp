#include "self_model/learned_world.h"

#include "common/options.h"
#include "simulation/body_text.h"

namespace hexapod {

LearnedWorld learnedWorldOf(const RobotDescription& robot, const Repertoire& repertoire) {
  LearnedWorld learned;
  learned.behavior = behaviorOptionsOf(repertoire.options, learned.behavior);
  applyKept({option("step_s", learned.physics.step_s, "s", "Step of the simulation.", 1e-4, 0.05)},
            repertoire.options, "repertoire");
  learned.physics = bodyFromText(robot, repertoire.body(), learned.physics);
  return learned;
}

}  // namespace hexapod
