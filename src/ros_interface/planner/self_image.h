#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "hexapod_repertoire/BodyBelief.h"
#include "planning/foresight.h"
#include "robot/robot_description.h"
#include "ros_interface/common/clock.h"
#include "self_model/self_model.h"

namespace hexapod {

/// What the robot believes of itself while it walks, told to whoever wants to know.
///
/// Gives each repertoire a Foresight: a SelfModel of this robot. Where the robot or how it is
/// played is not known, one deviation of all behaviours has to do, and nothing is told. From any
/// thread.
class SelfImage {
 public:
  using Tell = std::function<void(const hexapod_repertoire::BodyBelief&)>;

  /// `robot`: nothing when only its repertoires are known. `tell` is called after every behaviour,
  /// from the thread that walks, and by tellAgain().
  SelfImage(const Clock& clock, std::optional<RobotDescription> robot, Tell tell);

  std::shared_ptr<Foresight> foresightFor(const Repertoire& repertoire);

  /// Tells once more, with the time of now: who goes by it shall know that it is still believed.
  void tellAgain();

  /// What was told last; without a sentence when nothing was.
  hexapod_repertoire::BodyBelief told() const;

  /// The body that was believed for sure when it was last told, on a level floor; nothing when none
  /// was. Returns at once, whatever is being thought.
  std::optional<Physics> sureBody() const;

  /// Believes what it believed at first. A sentence for the user.
  std::string forget();

 private:
  class Told;

  void tell(const BodyBelief& belief, int behaviors);
  hexapod_repertoire::BodyBelief messageOf(const BodyBelief& belief, int behaviors) const;

  const Clock& clock_;
  const std::optional<RobotDescription> robot_;
  const Tell tell_;
  mutable std::mutex tell_mutex_;  // held while telling: nothing old is told after something new
  hexapod_repertoire::BodyBelief told_;  // guarded by tell_mutex_
  std::optional<Physics> sure_body_;     // likewise
  std::mutex mutex_;
  std::shared_ptr<Told> current_;  // of the repertoire in use; null: not simulated
};

}  // namespace hexapod
