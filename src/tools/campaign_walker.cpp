#include "tools/campaign_walker.h"

#include <algorithm>
#include <cmath>

#include "simulation/rollout.h"
#include "tools/machine.h"

namespace hexapod {
namespace {

bool isIntact(const std::vector<LegState>& legs) {
  return std::all_of(legs.begin(), legs.end(),
                     [](const LegState& leg) { return leg.condition == LegCondition::kIntact; });
}

// The same ones are out of order, in whatever way.
bool sameLegs(const std::vector<LegState>& a, const std::vector<LegState>& b) {
  if (isIntact(a) || isIntact(b)) return isIntact(a) && isIntact(b);
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const LegState& one, const LegState& other) {
                      return (one.condition == LegCondition::kIntact) ==
                             (other.condition == LegCondition::kIntact);
                    });
}

GoalWalk ended(GoalWalk walk, GoalWalk::End end) {
  walk.end = end;
  return walk;
}

}  // namespace

CampaignWalker::CampaignWalker(World& world, const Repertoire& repertoire,
                               const LearnedWorld& learned, const CampaignOptions& options,
                               std::uint64_t number)
    : world_(world),
      repertoire_(repertoire),
      learned_(learned),
      options_(options),
      random_(0x77616c6bu + 7919u * static_cast<std::uint64_t>(options.seed) + number) {}

GoalWalk CampaignWalker::walkTo(const Pose2& goal, AdaptivePlanner& planner,
                                const SelfModel* self_model) {
  GoalWalk walk;
  PlanRequest request;
  request.world_from_goal = goal;
  request.tolerance = {options_.xy_tolerance_m, options_.yaw_tolerance_rad};
  request.world_from_start = measuredPose();
  for (;;) {
    if (arrived(goal)) return ended(walk, GoalWalk::End::kArrived);
    if (walk.behaviors == options_.max_behaviors) return walk;
    const PlanResult plan = planner.plan(request);
    if (plan.steps.empty()) return ended(walk, GoalWalk::End::kNoPlan);
    const PlannedStep& step = plan.steps.front();
    const Outcome outcome = playEntry(step.entry);
    ++walk.behaviors;
    if (outcome.verdict == Verdict::kSelfCollided) return ended(walk, GoalWalk::End::kLegsTouched);
    if (!outcome.walked()) return ended(walk, GoalWalk::End::kFell);
    const Pose2 before = request.world_from_start;
    request.world_from_start = measuredPose();
    request.memory = plan.memory;
    walk.off_m.push_back(distance(step.world_from_end, request.world_from_start));
    walk.off_rad.push_back(headingDistance(step.world_from_end, request.world_from_start));
    const double begin_s = threadCpu_s();
    planner.observe(step.entry, before, request.world_from_start);
    walk.thought_s.push_back(threadCpu_s() - begin_s);
    if (self_model != nullptr) noteBelief(*self_model, walk);
  }
}

// Of the true pose: a noisy measurement must not decide it.
bool CampaignWalker::arrived(const Pose2& goal) const {
  return distance(pose(), goal) <= options_.xy_tolerance_m &&
         headingDistance(pose(), goal) <= options_.yaw_tolerance_rad;
}

Pose2 CampaignWalker::measuredPose() {
  Pose2 measured = pose();
  measured.x_m += options_.measurement_noise_m * random_.normal();
  measured.y_m += options_.measurement_noise_m * random_.normal();
  measured.yaw_rad =
      wrapAngle(measured.yaw_rad + options_.measurement_noise_rad * random_.normal());
  return measured;
}

Outcome CampaignWalker::playEntry(std::size_t entry) {
  const Behavior behavior(world_.robot(), repertoire_.entries[entry].genome, learned_.behavior);
  return play(world_, behavior, learned_.behavior.command_period_s);
}

void CampaignWalker::noteBelief(const SelfModel& self_model, GoalWalk& walk) const {
  const BodyBelief belief = self_model.belief();
  const std::vector<LegState>& believed = belief.bodies().front().legs;
  const bool right = sameLegs(believed, world_.physics().legs);
  if (walk.behaviors == 1) walk.right_after_first = right;
  if (isIntact(world_.physics().legs) && !isIntact(believed)) walk.false_alarm = true;
}

}  // namespace hexapod
