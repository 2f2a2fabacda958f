#include "evolution/evolution_state.h"

#include <array>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include "common/text.h"

namespace hexapod {
namespace {

using Counter = std::pair<const char*, std::int64_t EvolutionCounters::*>;
constexpr std::array<Counter, 9> kCounters = {{
    {"generations", &EvolutionCounters::generations},
    {"evaluations", &EvolutionCounters::evaluations},
    {"fell", &EvolutionCounters::fell},
    {"self_collided", &EvolutionCounters::self_collided},
    {"diverged", &EvolutionCounters::diverged},
    {"added", &EvolutionCounters::added},
    {"swapped", &EvolutionCounters::swapped},
    {"looked_twice", &EvolutionCounters::looked_twice},
    {"failed_later", &EvolutionCounters::failed_later},
}};

[[noreturn]] void fail(const std::string& name, const std::string& expected,
                       const std::string& found) {
  throw std::invalid_argument("The learner state '" + name + "' cannot be used: expected " +
                              expected + ", found '" + found + "'.");
}

KeptIndividual kept(const Individual& individual) {
  return {individual.id,
          individual.evaluation,
          individual.genotype,
          individual.outcome,
          static_cast<std::int64_t>(individual.standing.rank),
          individual.standing.diversity,
          individual.looks};
}

Individual individualFrom(const KeptIndividual& kept) {
  Individual individual;
  individual.id = kept.id;
  individual.evaluation = kept.evaluation;
  individual.genotype = kept.genotype;
  individual.outcome = kept.outcome;
  individual.standing = {static_cast<std::size_t>(kept.rank), kept.diversity};
  individual.looks = static_cast<int>(kept.looks);
  return individual;
}

const std::string& textOf(const std::map<std::string, std::string>& texts,
                          const std::string& name) {
  const auto found = texts.find(name);
  if (found == texts.end()) fail(name, "a text", "nothing");
  return found->second;
}

std::int64_t countOf(const std::map<std::string, std::string>& texts, const std::string& name) {
  const std::string& text = textOf(texts, name);
  const auto number = integerFromText(text);
  if (!number || *number < 0) fail(name, "a count", text);
  return *number;
}

}  // namespace

LearnerState toLearnerState(const EvolutionState& state) {
  LearnerState learner;
  learner.values = {{"random", state.random.state()}, {"next_id", std::to_string(state.next_id)}};
  for (const auto& [name, member] : kCounters) {
    learner.values[name] = std::to_string(state.counters.*member);
  }
  for (const Individual& individual : state.population) {
    learner.population.push_back(kept(individual));
  }
  learner.archive = state.archive;
  return learner;
}

EvolutionState evolutionStateFrom(const LearnerState& kept) {
  EvolutionState state;
  state.random = Random::fromState(textOf(kept.values, "random"));
  state.next_id = countOf(kept.values, "next_id");
  for (const auto& [name, member] : kCounters) {
    state.counters.*member = countOf(kept.values, name);
  }
  for (const KeptIndividual& individual : kept.population) {
    state.population.push_back(individualFrom(individual));
  }
  state.archive = kept.archive;
  return state;
}

}  // namespace hexapod
