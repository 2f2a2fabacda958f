#include "study/targets_method.h"

#include <optional>
#include <stdexcept>

namespace hexapod {

TargetsMethod::TargetsMethod(const EvolutionOptions& options, const GenomeSpace& space,
                             Evaluator& evaluator, Random random,
                             const std::vector<Target>& targets, double radius_m)
    : radius_m_(radius_m) {
  if (targets.empty()) throw std::invalid_argument("The control experiments need a target.");
  for (const Target& target : targets) {
    evolutions_.emplace_back(options, space, evaluator, Random(random.bits()), target);
  }
}

void TargetsMethod::step(std::int64_t most_candidates) {
  TargetEvolution& evolution = evolutions_[turn_];
  const std::int64_t before = evolution.evaluations();
  evolution.step(most_candidates);
  evaluations_ += evolution.evaluations() - before;
  turn_ = (turn_ + 1) % evolutions_.size();
}

std::map<std::string, std::vector<Entry>> TargetsMethod::repertoires() const {
  std::map<std::string, std::vector<Entry>> found = {{"nearest", {}}, {"orientation", {}}};
  for (std::size_t i = 0; i < evolutions_.size(); ++i) {
    const auto keep = [&](const std::string& name, const std::optional<Individual>& individual) {
      if (!individual) return;
      Entry entry = entryOf(*individual);
      entry.id = static_cast<std::int64_t>(i + 1);
      found[name].push_back(entry);
    };
    keep("nearest", evolutions_[i].nearest());
    keep("orientation", evolutions_[i].bestAligned(radius_m_));
  }
  return found;
}

}  // namespace hexapod
