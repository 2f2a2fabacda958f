#include "ros_interface/planner/repertoire_in_use.h"

#include <exception>
#include <utility>

#include "planning/deviation.h"
#include "repertoire/import_repertoire.h"
#include "ros_interface/common/conversions.h"

namespace hexapod {

namespace {

std::string learnedFor(const Repertoire& repertoire) {
  if (repertoire.body().empty()) return "";
  return " It was learned for this body: " + repertoire.body() + ".";
}

}  // namespace

RepertoireInUse::RepertoireInUse(const PlannerOptions& options, std::string robot_id,
                                 std::function<std::vector<std::string>()> publishers,
                                 ForesightFor foresight_for, PathsOf paths_of)
    : options_(options),
      robot_id_(std::move(robot_id)),
      publisher_(std::move(publishers)),
      foresight_for_(std::move(foresight_for)),
      paths_of_(std::move(paths_of)) {}

std::shared_ptr<Foresight> RepertoireInUse::deviationOf(const Repertoire&) {
  return std::make_shared<DeviationForesight>();
}

std::shared_ptr<AdaptivePlanner> RepertoireInUse::planner() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return stand_in_ ? stand_in_ : planner_;
}

std::shared_ptr<AdaptivePlanner> RepertoireInUse::published() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return planner_;
}

std::size_t RepertoireInUse::standIn(Repertoire relearned, std::size_t left) {
  relearned.run_id.clear();
  const auto fresh =
      std::make_shared<AdaptivePlanner>(relearned, *published(), paths_of_(relearned));
  const std::size_t walks = fresh->planner()->usableEntries();
  const std::lock_guard<std::mutex> lock(mutex_);
  if (walks > left) stand_in_ = fresh;
  return walks;
}

bool RepertoireInUse::endStandIn() {
  const auto before = published();
  if (planner() == before) return false;
  // What was learned of the robot meanwhile it has not heard of.
  const auto fresh = std::make_shared<AdaptivePlanner>(before->repertoire(), *before,
                                                       paths_of_(before->repertoire()));
  const std::lock_guard<std::mutex> lock(mutex_);
  stand_in_.reset();
  planner_ = fresh;
  return true;
}

std::string RepertoireInUse::whyRefused(const hexapod_repertoire::Repertoire& message,
                                        const std::string& publisher) const {
  if (!message.robot_id.empty() && message.robot_id != kImported && !robot_id_.empty() &&
      message.robot_id != robot_id_) {
    return "The repertoire of " + publisher + " was learned for the robot " + message.robot_id +
           ", this one is " + robot_id_ + "; learn one for this robot description.";
  }
  return publisher_.whyRefused(publisher);
}

RepertoireInUse::Taken RepertoireInUse::take(const hexapod_repertoire::Repertoire& message,
                                             const std::string& publisher) {
  const auto earlier = published();
  const std::string kept = earlier ? " The earlier repertoire stays in use." : "";
  std::string refused = whyRefused(message, publisher);
  if (!refused.empty()) return {false, refused + kept};
  std::shared_ptr<AdaptivePlanner> fresh;
  bool same_run = false;
  try {
    const Repertoire repertoire = fromMsg(message);
    same_run =
        earlier && !repertoire.run_id.empty() && earlier->repertoire().run_id == repertoire.run_id;
    fresh = same_run
                ? std::make_shared<AdaptivePlanner>(repertoire, *earlier, paths_of_(repertoire))
                : std::make_shared<AdaptivePlanner>(
                      repertoire, options_, foresight_for_(repertoire), paths_of_(repertoire));
  } catch (const std::exception& error) {
    return {false, error.what() + kept};
  }
  publisher_.use(publisher);
  const std::lock_guard<std::mutex> lock(mutex_);
  planner_ = fresh;
  if (!same_run) stand_in_.reset();
  return {true, "Planning with " + std::to_string(fresh->planner()->usableEntries()) + " of " +
                    std::to_string(fresh->repertoire().entries.size()) + " entries of run " +
                    fresh->repertoire().run_id + ", published by " + publisher + "." +
                    learnedFor(fresh->repertoire())};
}

}  // namespace hexapod
