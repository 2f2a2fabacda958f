#include "simulation/reduced/reduced_world.h"

#include <cmath>
#include <stdexcept>

#include "simulation/physics.h"
#include "simulation/reduced/angle.h"
#include "simulation/reduced/batch_rollout.h"
#include "simulation/reduced/make_model.h"
#include "simulation/reduced/state.h"
#include "simulation/reduced/stepper.h"
#include "simulation/reduced/verdict.h"
#include "simulation/standing_state.h"

namespace hexapod {
namespace {

void checkCount(const char* what, const std::string& robot, std::size_t expected,
                std::size_t found) {
  if (expected == found) return;
  throw std::invalid_argument(std::string(what) + " of robot '" + robot + "' has " +
                              std::to_string(expected) + " values, found " + std::to_string(found) +
                              ".");
}

}  // namespace

ReducedWorld::ReducedWorld(const RobotDescription& robot, const Physics& physics,
                           const WorldState* settled)
    : description_(robot),
      physics_(physics),
      held_(robot, physics),
      model_(std::make_unique<reduced::ReducedModel>(reduced::makeModel(robot, physics))),
      stepper_(reduced::makeScalarStepper(*model_,
                                          reduced::conditionsOf(robot, physics, physics.step_s))) {
  if (settled != nullptr) {
    settled_ = *settled;
  } else {
    settle();
    settled_ = footprintAtOrigin(worldFromBase(), state(), description_.jointCount() + 1);
  }
  restart();
}

ReducedWorld::~ReducedWorld() = default;

void ReducedWorld::settle() {
  stepper_->setConditions(0, reduced::conditionsOf(description_, physics_, kSettlingStep_s));
  restore(standingState(description_));
  setTargets(description_.neutralPose());
  const int steps = static_cast<int>(std::lround(kSettlingTime_s / kSettlingStep_s));
  for (int i = 1; i <= steps; ++i) {
    const Verdict verdict = step();
    if (verdict != Verdict::kWalked) throwDoesNotStand(description_, verdict, i * kSettlingStep_s);
  }
  stepper_->setConditions(0, reduced::conditionsOf(description_, physics_, physics_.step_s));
}

WorldState ReducedWorld::state() const {
  WorldState state;
  state.values.resize(valueCount());
  stepper_->store(0, state.values.data());
  return state;
}

void ReducedWorld::restore(const WorldState& state) {
  checkCount("A state", description_.name, valueCount(), state.values.size());
  stepper_->load(0, state.values.data());
  diverged_ = false;
  for (std::size_t body = 0; body <= description_.jointCount(); ++body) {
    const double* values = &state.values[body * kStateValuesPerBody];
    diverged_ |= isAbsurd(Eigen::Vector3d(values), Eigen::Vector3d(values + 7),
                          Eigen::Vector3d(values + 10));
  }
}

void ReducedWorld::setTargets(const std::vector<double>& targets_rad) {
  checkCount("A set of joint targets", description_.name, description_.jointCount(),
             targets_rad.size());
  if (!held_.any()) return stepper_->setTargets(0, targets_rad.data());
  std::vector<double> held_rad = targets_rad;
  held_.apply(held_rad);
  stepper_->setTargets(0, held_rad.data());
}

Verdict ReducedWorld::step() {
  if (diverged_) return Verdict::kDiverged;
  stepper_->advance();
  const Verdict verdict = reduced::verdictOf(stepper_->findings(0));
  diverged_ = verdict == Verdict::kDiverged;
  return verdict;
}

Eigen::Isometry3d ReducedWorld::worldFromBase() const {
  return reduced::worldFromBase(*model_, state().values.data());
}

void ReducedWorld::jointAngles(std::vector<double>& angles_rad) const {
  const WorldState now = state();
  const double* values = now.values.data();
  reduced::State<double> bodies{};
  reduced::forEachValue(*model_, bodies, [&](double& value) { value = *values++; });
  angles_rad.clear();
  for (int leg = 0; leg < model_->legs; ++leg) {
    const reduced::BodyState<double>* parent = &bodies.base;
    for (int s = 0; s < model_->of_leg[leg]; ++s) {
      const reduced::JointModel& joint = model_->joints[leg][s];
      const reduced::BodyState<double>& child = bodies.segment[leg][s];
      angles_rad.push_back(reduced::hingeAngle(child.rotation, parent->rotation,
                                               joint.child_from_parent, joint.child_axis));
      parent = &child;
    }
  }
}

BatchRollout& ReducedWorld::batch() {
  if (!batch_)
    batch_ = std::make_unique<BatchRollout>(description_,
                                            std::vector<BatchPhysics>{{physics_, settled_}});
  return *batch_;
}

std::size_t ReducedWorld::valueCount() const {
  const std::size_t joints = description_.jointCount();
  return kStateValuesPerBody * (joints + 1) + joints;
}

bool coversRobot(const RobotDescription& robot, std::string& reason) {
  reason = reduced::whyNotCovered(robot);
  return reason.empty();
}

}  // namespace hexapod
