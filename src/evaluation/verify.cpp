#include "evaluation/verify.h"

#include <algorithm>

#include "simulation/standing_state.h"

namespace hexapod {

bool agree(const End& a, const End& b) {
  if (a.verdict != b.verdict) return false;
  return a.verdict != Verdict::kWalked || (distance(a.pose, b.pose) <= kVerifiedWithin_m &&
                                           headingDistance(a.pose, b.pose) <= kVerifiedWithin_rad);
}

std::vector<End> playFromTheStand(const std::shared_ptr<WorldPool>& worlds,
                                  const BehaviorOptions& behavior,
                                  const std::vector<Genome>& genomes, const PlayHooks& hooks) {
  std::vector<RobustWorlds::Run> runs(genomes.size());
  for (std::size_t i = 0; i < runs.size(); ++i) runs[i].genome = i;
  std::vector<End> ends;
  const RobotDescription& robot = worlds->robot();
  for (const BatchResult& result :
       RobustWorlds(worlds, {worlds->physics()}, behavior).play(genomes, runs, hooks)) {
    ends.push_back({result.outcome.verdict, footprint(baseOf(robot, result.end))});
  }
  return ends;
}

Verification verifyInOde(const std::shared_ptr<WorldPool>& worlds, const BehaviorOptions& behavior,
                         const std::vector<Genome>& genomes, const PlayHooks& hooks) {
  const std::vector<End> found =
      playFromTheStand(worlds, behavior, genomes, {nullptr, hooks.cancelled});
  const auto ode = std::make_shared<WorldPool>(Engine::kOde, worlds->robot(), worlds->physics(),
                                               worlds->threads());
  const std::vector<End> expected = playFromTheStand(ode, behavior, genomes, hooks);
  Verification verification;
  for (std::size_t i = 0; i < genomes.size(); ++i) {
    const bool holds = agree(found[i], expected[i]);
    verification.holds.push_back(holds);
    if (!holds || expected[i].verdict != Verdict::kWalked) continue;
    verification.largest_difference_m =
        std::max(verification.largest_difference_m, distance(found[i].pose, expected[i].pose));
    verification.largest_difference_rad = std::max(
        verification.largest_difference_rad, headingDistance(found[i].pose, expected[i].pose));
  }
  return verification;
}

}  // namespace hexapod
