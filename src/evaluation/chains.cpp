#include "evaluation/chains.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "common/random.h"

namespace hexapod {
namespace {

/// Where a chain is: nothing: on the stand.
struct Link {
  bool on_stand = true;
  WorldState state;
};

}  // namespace

void ChainResult::add(const ChainResult& other) {
  failed += other.failed;
  misses_m.insert(misses_m.end(), other.misses_m.begin(), other.misses_m.end());
  misses_rad.insert(misses_rad.end(), other.misses_rad.begin(), other.misses_rad.end());
}

std::vector<ChainResult> chainAtRandom(const std::shared_ptr<WorldPool>& pool,
                                       const BehaviorOptions& behavior,
                                       const std::vector<Entry>& entries,
                                       const std::vector<Physics>& physics,
                                       const ChainOptions& options) {
  RobustWorlds worlds(pool, physics, behavior);
  const auto chains = static_cast<std::size_t>(options.chains);
  std::vector<Link> links(physics.size() * chains);  // physics by physics
  std::vector<ChainResult> results(physics.size());
  Random random(options.seed);
  for (std::int64_t place = 0; place < options.behaviors; ++place) {
    std::vector<std::size_t> drawn;  // of the entries, one per chain
    std::vector<Genome> genomes;
    for (std::size_t c = 0; c < chains; ++c) {
      drawn.push_back(random.below(entries.size()));
      genomes.push_back(entries[drawn.back()].genome);
    }
    std::vector<RobustWorlds::Run> runs;
    for (std::size_t i = 0; i < links.size(); ++i) {
      runs.push_back({i % chains, i / chains, links[i].on_stand ? nullptr : &links[i].state});
    }
    std::vector<BatchResult> played = worlds.play(genomes, runs);
    for (std::size_t i = 0; i < links.size(); ++i) {
      ChainResult& result = results[i / chains];
      const Outcome& outcome = played[i].outcome;
      links[i].on_stand = !outcome.walked();
      if (!outcome.walked()) {
        ++result.failed;
        continue;
      }
      links[i].state = std::move(played[i].end);
      const Pose2 expected = entries[drawn[i % chains]].expectedPose();
      result.misses_m.push_back(distance(outcome.end_pose, expected));
      result.misses_rad.push_back(headingDistance(outcome.end_pose, expected));
    }
  }
  return results;
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  const auto last = static_cast<double>(values.size() - 1);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::lround(share * last));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace hexapod
