#include "evolution/targets.h"

#include <optional>
#include <stdexcept>

namespace hexapod {

Targets::Targets(const EvolutionOptions& options, const GenomeSpace& space, Random random,
                 const std::vector<Target>& targets, double radius_m)
    : radius_m_(radius_m) {
  if (targets.empty()) throw std::invalid_argument("The control experiments need a target.");
  for (const Target& target : targets) {
    evolutions_.emplace_back(options, space, Random(random.bits()), target);
  }
}

void Targets::tell(const std::vector<Outcome>& outcomes) {
  TargetEvolution& evolution = evolutions_[turn_];
  const EvolutionCounters before = evolution.counters();
  evolution.tell(outcomes);
  const EvolutionCounters& now = evolution.counters();
  ++counters_.generations;
  counters_.evaluations += now.evaluations - before.evaluations;
  counters_.fell += now.fell - before.fell;
  counters_.self_collided += now.self_collided - before.self_collided;
  counters_.diverged += now.diverged - before.diverged;
  turn_ = (turn_ + 1) % evolutions_.size();
  choose();
}

void Targets::choose() {
  nearest_.clear();
  best_aligned_.clear();
  for (std::size_t i = 0; i < evolutions_.size(); ++i) {
    const auto keep = [&](std::vector<Entry>& kept, const std::optional<Individual>& individual) {
      if (!individual) return;
      kept.push_back(entryOf(*individual));
      kept.back().id = static_cast<std::int64_t>(i + 1);
    };
    keep(nearest_, evolutions_[i].nearest());
    keep(best_aligned_, evolutions_[i].bestAligned(radius_m_));
  }
}

}  // namespace hexapod
