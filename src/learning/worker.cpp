#include "learning/worker.h"

#include <atomic>
#include <memory>

#include "learning/candidate_evaluator.h"

namespace hexapod {

void declineWork(Channel& session, const std::string& problem) {
  const std::atomic<bool> never{false};
  session.send(toMessage(Introduction{"", 1, problem}));
  session.receive(never, 0.0);
}

void workFor(Channel& session, const RobotDescription& robot, const LearnOptions& options,
             const std::atomic<bool>& cancelled) {
  const auto worlds = std::make_shared<WorldPool>(chooseEngine(options.engine, robot).engine, robot,
                                                  nominalPhysics(robot, options),
                                                  static_cast<int>(options.threads));
  CandidateEvaluator(worlds, suitedTo(robot, withBudget(options)), cancelled).serveFor(session);
}

}  // namespace hexapod
