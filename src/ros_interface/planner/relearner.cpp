#include "ros_interface/planner/relearner.h"

#include <exception>
#include <utility>

#include "learning/relearning.h"
#include "planning/move.h"
#include "ros_interface/common/realtime.h"

namespace hexapod {
namespace {

std::size_t usable(const AdaptivePlanner& planner) { return planner.planner()->usableEntries(); }

std::string count(std::size_t number) { return std::to_string(number); }

}  // namespace

Relearner::Relearner(const PlannerNodeOptions& options, std::optional<RobotDescription> robot,
                     RepertoireInUse& repertoire, Publish publish)
    : options_(options),
      robot_(std::move(robot)),
      repertoire_(repertoire),
      publish_(std::move(publish)) {}

Relearner::~Relearner() { join(); }

void Relearner::join() {
  cancelled_ = true;
  if (thread_.joinable()) thread_.join();
  cancelled_ = false;
  learning_ = learned_ = false;
}

std::string Relearner::bodyText() const { return describeLegs(*robot_, legs_); }

std::string Relearner::look(const std::optional<Physics>& body) {
  const auto published = repertoire_.published();
  if (!published || options_.relearn_below == 0.0) return "";
  const Repertoire& repertoire = published->repertoire();
  const bool same = repertoire.run_id == run_id_ && (!body || body->legs == legs_);
  if (!legs_.empty() && !same) return giveBack();
  if (learning_) return learned_ ? take() : "";
  // One try for a body: what it led to is in use, or was no better.
  if (!body || !legs_.empty() || !robot_ || robot_->digest != repertoire.robot_id) return "";
  const std::size_t planned = usableMoves(repertoire, options_.planner, {}).size();
  const double enough = options_.relearn_below * static_cast<double>(planned);
  if (static_cast<double>(usable(*published)) >= enough) return "";
  return begin(*published, *body);
}

std::string Relearner::begin(const AdaptivePlanner& published, const Physics& body) {
  const Repertoire& repertoire = published.repertoire();
  run_id_ = repertoire.run_id;
  legs_ = body.legs;
  learning_ = true;
  thread_ = std::thread(&Relearner::learn, this, repertoire, body);
  return "With " + bodyText() + ", " + count(usable(published)) + " of " +
         count(usableMoves(repertoire, options_.planner, {}).size()) +
         " entries are left; more are learned for this body.";
}

void Relearner::learn(const Repertoire& repertoire, const Physics& body) {
  beLessUrgent(Niceness::kBackground);
  try {
    RelearnOptions options;
    options.evaluations = options_.relearn_evaluations;
    options.threads = 1;
    relearned_ = relearn(*robot_, repertoire, body, options, cancelled_);
  } catch (const std::exception& error) {
    problem_ = error.what();
  }
  learned_ = true;
}

std::string Relearner::take() {
  join();
  const auto published = repertoire_.published();
  const std::optional<Repertoire> relearned = std::exchange(relearned_, std::nullopt);
  if (!relearned) {
    return "Nothing could be learned for " + bodyText() + ": " + std::exchange(problem_, "");
  }
  const std::size_t left = usable(*published);
  const std::size_t walks = repertoire_.standIn(*relearned, left);
  if (walks <= left) {
    return "Of what was learned for " + bodyText() + " " + count(walks) +
           " entries walk, no more than the " + count(left) +
           " left of the published repertoire, which stays in use.";
  }
  publish_(*relearned);
  return "Planning with " + count(walks) + " entries that were learned for " + bodyText() +
         ", instead of the " + count(left) + " left of run " + run_id_ + ".";
}

std::string Relearner::giveBack() {
  join();
  relearned_.reset();
  const std::string body = bodyText();
  legs_.clear();
  run_id_.clear();
  if (!repertoire_.endStandIn()) return "";
  publish_(Repertoire());
  return "Planning with the published repertoire again, no longer with what was learned for " +
         body + ".";
}

}  // namespace hexapod
