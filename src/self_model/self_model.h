#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "planning/deviation.h"
#include "planning/foresight.h"
#include "planning/planner_options.h"
#include "self_model/body_belief.h"
#include "self_model/imagined_repertoire.h"
#include "self_model/learned_world.h"

namespace hexapod {

/// How a robot simulates itself.
struct SelfModelOptions {
  BeliefOptions belief;
  PlannerOptions planner;  ///< what is planned with is imagined, and nothing else
  std::string engine = "reduced";
  int threads = 0;  ///< 0: as many as the machine has cores
};

/// The Foresight of a robot that simulates itself: after every behaviour it believes what body
/// explains what was measured (BodyBelief), and expects of its repertoire what that body makes of
/// it.
///
/// The repertoire is played in the most likely bodies when they are first believed in, each from
/// the state in which the last behaviour is thought to have left it; where chains of it lead from
/// the state of now, follow() imagines exactly. What fails in a body that is not unlikely is left
/// out, and so is what the planner would not use. Spreads come from how far bodies disagree, and
/// from how far the expected end poses were off so far. What no body explains, all behaviours
/// alike, is learned as a Deviation of what the most likely body does.
class SelfModel : public Foresight {
 public:
  /// With `told`, the robot has that body for sure; nothing is believed, the repertoire is played
  /// in it.
  SelfModel(const RobotDescription& robot, const LearnedWorld& learned,
            const SelfModelOptions& options, const std::optional<Physics>& told = std::nullopt);

  /// A robot of its own that knows as much.
  SelfModel(const SelfModel& other);

  void observe(const WalkedStep& step) override;
  std::shared_ptr<const Repertoire> expected(
      const std::shared_ptr<const Repertoire>& repertoire) override;
  std::vector<Pose2> follow(const Pose2& world_from_start,
                            const std::vector<Entry>& chain) const override;
  Eigen::Vector2d drift_m() const override;
  /// Of a repertoire that was prepared for, before the first behaviour.
  std::shared_ptr<const std::vector<double>> caution(
      const std::shared_ptr<const Repertoire>& repertoire) const override;
  void prepare(const std::shared_ptr<const Repertoire>& repertoire,
               const std::function<bool()>& stop) override;

  /// A copy of what is believed now.
  BodyBelief belief() const;

  /// Behaviours observed.
  int behaviors() const;

  /// Believes what it believed at first, whatever was observed since.
  void forget();

 private:
  struct Expected {
    std::shared_ptr<const Repertoire> of;
    std::shared_ptr<const Repertoire> repertoire;
    int revision = 0;
  };
  struct Caution {
    std::shared_ptr<const Repertoire> of;
    std::shared_ptr<const std::vector<double>> prices;
  };

  void learnErrors(const WalkedStep& step);
  void learnResidual(const SeenBehavior& seen);
  std::shared_ptr<const Repertoire> imagine(const Repertoire& repertoire);

  SelfModel(const SelfModel& other, const std::lock_guard<std::mutex>& lock_of_other);

  const std::shared_ptr<const Imagination> imagination_;
  const PlannerOptions planner_;
  mutable std::mutex mutex_;
  ImaginedRepertoire imagined_;
  BodyBelief belief_;
  const BodyBelief first_belief_;
  double heading_rad_ = 0.0;  // in which the robot stands
  int behaviors_ = 0;         // observed
  int revision_ = 0;          // of the belief
  Expected expected_;
  Caution caution_;
  Eigen::Vector2d drift_m_ = Eigen::Vector2d::Zero();
  DeviationEstimator residual_;  // of what a body with residual_legs_ does
  std::vector<LegState> residual_legs_;
  // Squares of how far expected end poses were off, and their number, fading.
  double square_m2_, square_rad2_, count_;
};

}  // namespace hexapod
