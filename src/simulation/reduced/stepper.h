#pragma once

#include "simulation/reduced/conditions.h"

namespace hexapod::reduced {

/// What the poses a step started from and the state it ended in say about one robot.
struct LaneFindings {
  bool fell = false;
  bool collided = false;
  bool diverged = false;
};

/// One or several robots of the same model stepped together, one per lane, each under conditions of
/// its own. Nothing passes between
/// lanes: a robot gets the same bits in every lane of every stepper. Not thread-safe.
class Stepper {
 public:
  virtual ~Stepper();

  virtual int lanes() const = 0;

  /// Values as OdeWorld::state(): 13 per body, then the targets.
  virtual void load(int lane, const double* values) = 0;
  virtual void store(int lane, double* values) const = 0;

  /// Targets [rad] in joint order.
  virtual void setTargets(int lane, const double* targets_rad) = 0;

  /// Under what a lane is stepped from now on.
  virtual void setConditions(int lane, const Conditions<double>& conditions) = 0;

  /// Advances all lanes, each by its own step.
  virtual void advance() = 0;

  /// Of the last advance().
  virtual LaneFindings findings(int lane) const = 0;
};

/// The stepper of a single robot. The model must outlive it; `conditions` are those of all lanes
/// until others are set. The caller owns the result.
Stepper* makeScalarStepper(const ReducedModel& model, const Conditions<double>& conditions);

}  // namespace hexapod::reduced
