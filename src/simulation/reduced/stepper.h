#pragma once

#include "simulation/reduced/model.h"

namespace hexapod::reduced {

/// What the poses a step started from and the state it ended in say about one robot.
struct LaneFindings {
  bool fell = false;
  bool collided = false;
  bool diverged = false;
};

/// One or several robots of the same model stepped together, one per lane. Nothing passes between
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

  /// Advances all lanes.
  virtual void advance(double step_s) = 0;

  /// Of the last advance().
  virtual LaneFindings findings(int lane) const = 0;
};

/// The stepper of a single robot. The model must outlive it. The caller owns the result.
Stepper* makeScalarStepper(const ReducedModel& model);

}  // namespace hexapod::reduced
