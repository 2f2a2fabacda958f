#pragma once

#include "simulation/reduced/step.h"
#include "simulation/reduced/stepper.h"

namespace hexapod::reduced {

/// Stepper of kLanesIn<Real> robots with `kSegments` joints per leg.
///
/// Included by source files that are compiled for one kind of processor each: it uses nothing but
/// templates over Real, which no other such file instantiates, so that no instruction of one
/// processor can end up in a function of another.
template <typename Real, int kSegments>
class LaneStepper final : public Stepper {
 public:
  LaneStepper(const ReducedModel& model, const Conditions<double>& conditions)
      : model_(model), state_() {
    for (int lane = 0; lane < lanes(); ++lane) LaneStepper::setConditions(lane, conditions);
    work_.clearance.forget();
    // A robot far from everything, so that unused lanes compute something finite.
    state_.base.rotation.w = splat<Real>(1.0);
    for (auto& leg : state_.segment) {
      for (BodyState<Real>& body : leg) body.rotation.w = splat<Real>(1.0);
    }
  }

  int lanes() const final { return kLanesIn<Real>; }

  void load(int lane, const double* values) override {
    forEachValue(model_, state_, [&](Real& value) { setLane(value, lane, *values++); });
    for (int leg = 0; leg < model_.legs; ++leg) pad(leg, lane);
    work_.clearance.forget(lane);
  }

  void store(int lane_index, double* values) const override {
    forEachValue(model_, state_, [&](const Real& value) { *values++ = lane(value, lane_index); });
  }

  void setTargets(int lane, const double* targets_rad) override {
    for (int leg = 0; leg < model_.legs; ++leg) {
      for (int s = 0; s < model_.of_leg[leg]; ++s)
        setLane(state_.target[leg][s], lane, *targets_rad++);
    }
  }

  void setConditions(int lane, const Conditions<double>& conditions) override {
    forEachPair(conditions_, conditions, [&](Real& value, double to) { setLane(value, lane, to); });
  }

  void advance() override { findings_ = reduced::advance(model_, conditions_, work_, state_); }

  LaneFindings findings(int lane) const override {
    return {inLane<Real>(findings_.fell, lane), inLane<Real>(findings_.collided, lane),
            inLane<Real>(findings_.diverged, lane)};
  }

 private:
  // Segments that the leg does not have are where its last one is.
  void pad(int leg, int lane_index) {
    for (int s = model_.of_leg[leg]; s < kSegments; ++s) {
      BodyState<Real> parent = s == 0 ? state_.base : state_.segment[leg][s - 1];
      Real values[kStateValues];
      Real* value = values;
      forEachValueOf(parent, [&](const Real& of_parent) { *value++ = of_parent; });
      value = values;
      forEachValueOf(state_.segment[leg][s],
                     [&](Real& own) { setLane(own, lane_index, lane(*value++, lane_index)); });
    }
  }

  static constexpr int kStateValues = 13;

  const ReducedModel& model_;
  Conditions<Real> conditions_;
  State<Real> state_;
  StepWorkspace<Real, kSegments> work_;
  StepFindings<Real> findings_;
};

template <typename Real>
inline Stepper* makeStepper(const ReducedModel& model, const Conditions<double>& conditions) {
  switch (model.segments) {
    case 2:
      return new LaneStepper<Real, 2>(model, conditions);
    case 3:
      return new LaneStepper<Real, 3>(model, conditions);
    default:
      return new LaneStepper<Real, 4>(model, conditions);
  }
}

}  // namespace hexapod::reduced
