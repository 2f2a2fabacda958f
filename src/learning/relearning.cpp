#include "learning/relearning.h"

#include <string>
#include <utility>

#include "evolution/evaluator.h"
#include "learning/checks.h"
#include "learning/learning_run.h"
#include "simulation/body_text.h"

namespace hexapod {
namespace {

// As the repertoire was learned, as far as it tells.
LearnOptions learnedWith(const Repertoire& repertoire) {
  LearnOptions options;
  applyKept(declareOptions(options), repertoire.options, "repertoire");
  return options;
}

LearnOptions optionsFor(const RobotDescription& robot, const Repertoire& repertoire,
                        const Physics& body, const RelearnOptions& relearn) {
  LearnOptions options = learnedWith(repertoire);
  Physics level;
  level.step_s = options.step_s;
  options.body = bodyText(robot, body, level);
  options.evaluations = relearn.evaluations;
  options.time_budget_s = 0.0;
  options.threads = relearn.threads;
  options.verify_with_ode = options.resimulate = options.transfer.transferability = false;
  return options;
}

}  // namespace

std::optional<Repertoire> relearn(const RobotDescription& robot, const Repertoire& repertoire,
                                  const Physics& body, const RelearnOptions& options,
                                  const std::atomic<bool>& cancelled) {
  RunStart start;
  start.warm = warmStart(robot, repertoire, "run " + repertoire.run_id, repertoire.geneLevels());
  LearningRun run(robot, optionsFor(robot, repertoire, body, options), start, cancelled, {});
  try {
    while (run.budgetIsLeft()) run.step();
    for (const Check& check : checks()) {
      if (check.is_wanted(run)) run.add(check.find(run, {nullptr, &cancelled}));
    }
  } catch (const EvaluationCancelled&) {
    return std::nullopt;
  }
  return run.repertoire();
}

}  // namespace hexapod
