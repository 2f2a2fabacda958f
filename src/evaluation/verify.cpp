#include "evaluation/verify.h"

#include <algorithm>
#include <mutex>

#include "gait/behavior.h"
#include "simulation/rollout.h"

namespace hexapod {

bool agree(const End& a, const End& b) {
  if (a.verdict != b.verdict) return false;
  return a.verdict != Verdict::kWalked || (distance(a.pose, b.pose) <= kVerifiedWithin_m &&
                                           headingDistance(a.pose, b.pose) <= kVerifiedWithin_rad);
}

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
