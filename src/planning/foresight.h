#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <vector>

#include "geometry/pose2.h"
#include "repertoire/repertoire.h"

namespace hexapod {

/// How far a joint moved during a behaviour: what feedback tells of a servo without a common clock.
struct JointRange {
  double min_rad = 0.0;
  double max_rad = 0.0;
};

/// One behaviour that was walked.
struct WalkedStep {
  Entry entry;
  Pose2 world_from_before, world_from_after;  ///< measured, at rest
  /// Measured, in joint order; not finite: this joint was not read; empty: there is no feedback.
  std::vector<JointRange> joints;
};

/// What the robot as it is makes of a repertoire, learned while it walks. Planning asks here what
/// to expect and knows nothing of how it is known. May be called from any thread.
class Foresight {
 public:
  virtual ~Foresight() = default;

  virtual void observe(const WalkedStep& step) = 0;

  /// The same entries in the same order, each one's execution as it is expected now; what is
  /// expected to fail has falls. Another object whenever the expectation has changed, never one
  /// that changes.
  virtual std::shared_ptr<const Repertoire> expected(
      const std::shared_ptr<const Repertoire>& repertoire) = 0;

  /// The poses after each of these behaviours, played one after another from where the robot
  /// stands, which is `world_from_start`; empty when nothing better is known than expected() tells.
  /// What one of them leads to depends on those before it, and on the heading on a slope: this
  /// knows, a repertoire does not.
  virtual std::vector<Pose2> follow(const Pose2& /*world_from_start*/,
                                    const std::vector<Entry>& /*chain*/) const {
    return {};
  }

  /// What each entry of a repertoire costs beside as the next behaviour, in behaviours: what it may
  /// do to a robot of which nothing was measured yet. Null: nothing.
  virtual std::shared_ptr<const std::vector<double>> caution(
      const std::shared_ptr<const Repertoire>& /*repertoire*/) const {
    return nullptr;
  }

  /// Thinks of what takes seconds and may wait, as caution() is; returns soon after `stop` is true.
  virtual void prepare(const std::shared_ptr<const Repertoire>& /*repertoire*/,
                       const std::function<bool()>& /*stop*/) {}

  /// What every behaviour moves the robot beyond that, in the world and wherever it heads: the
  /// downhill drift on a slope [m].
  virtual Eigen::Vector2d drift_m() const { return Eigen::Vector2d::Zero(); }
};

}  // namespace hexapod
