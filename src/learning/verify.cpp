#include "learning/verify.h"

#include <algorithm>
#include <mutex>

#include "gait/behavior.h"
#include "simulation/rollout.h"

namespace hexapod {

std::vector<End> playFromTheStand(WorldPool& worlds, const BehaviorOptions& behavior,
                                  const std::vector<Genome>& genomes,
                                  const VerificationHooks& hooks) {
  std::vector<End> ends(genomes.size());
  std::mutex mutex;
  std::size_t done = 0;
  worlds.forEach(genomes.size(), [&](World& world, std::size_t i) {
    if (hooks.cancelled != nullptr && *hooks.cancelled) return;
    world.restart();
    const Behavior played(world.robot(), canonical(genomes[i]), behavior);
    ends[i].verdict = play(world, played, behavior.command_period_s).verdict;
    ends[i].pose = footprint(world.worldFromBase());
    const std::lock_guard<std::mutex> lock(mutex);
    ++done;
    if (hooks.progress) hooks.progress(done, genomes.size());
  });
  return ends;
}

Verification verifyInOde(WorldPool& worlds, const BehaviorOptions& behavior,
                         const std::vector<Genome>& genomes, const VerificationHooks& hooks) {
  VerificationHooks silent;
  silent.cancelled = hooks.cancelled;
  const std::vector<End> found = playFromTheStand(worlds, behavior, genomes, silent);
  WorldPool ode(Engine::kOde, worlds.robot(), worlds.physics(), worlds.threads());
  const std::vector<End> expected = playFromTheStand(ode, behavior, genomes, hooks);
  Verification verification;
  for (std::size_t i = 0; i < genomes.size(); ++i) {
    const bool walks = expected[i].verdict == Verdict::kWalked;
    const double apart_m = walks ? distance(found[i].pose, expected[i].pose) : 0.0;
    const double apart_rad = walks ? headingDistance(found[i].pose, expected[i].pose) : 0.0;
    const bool holds = found[i].verdict == expected[i].verdict && apart_m <= kVerifiedWithin_m &&
                       apart_rad <= kVerifiedWithin_rad;
    verification.holds.push_back(holds);
    if (!holds) continue;
    verification.largest_difference_m = std::max(verification.largest_difference_m, apart_m);
    verification.largest_difference_rad = std::max(verification.largest_difference_rad, apart_rad);
  }
  return verification;
}

}  // namespace hexapod
