#include "evolution/evolution_state.h"

#include <array>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "common/text.h"

namespace hexapod {
namespace {

constexpr std::array<Verdict, 4> kVerdicts = {Verdict::kWalked, Verdict::kFell,
                                              Verdict::kSelfCollided, Verdict::kDiverged};

using Counter = std::pair<const char*, std::int64_t EvolutionCounters::*>;
constexpr std::array<Counter, 8> kCounters = {{
    {"generations", &EvolutionCounters::generations},
    {"evaluations", &EvolutionCounters::evaluations},
    {"fell", &EvolutionCounters::fell},
    {"self_collided", &EvolutionCounters::self_collided},
    {"diverged", &EvolutionCounters::diverged},
    {"added", &EvolutionCounters::added},
    {"swapped", &EvolutionCounters::swapped},
    {"looked_twice", &EvolutionCounters::looked_twice},
}};
// States from before it was counted have none.
constexpr Counter kFailedLater = {"failed_later", &EvolutionCounters::failed_later};

[[noreturn]] void fail(const std::string& name, const std::string& expected,
                       const std::string& found) {
  throw std::invalid_argument("The learner state '" + name + "' cannot be used: expected " +
                              expected + ", found '" + found + "'.");
}

std::string lineOf(const Individual& individual) {
  const Outcome& outcome = individual.outcome;
  std::string line = std::to_string(individual.id) + " " + std::to_string(individual.evaluation) +
                     " " + toString(individual.genotype) + " " + toString(outcome.verdict);
  for (const double number : {outcome.end_pose.x_m, outcome.end_pose.y_m, outcome.end_pose.yaw_rad,
                              outcome.cost, individual.standing.diversity}) {
    line += " " + exactText(number);
  }
  return line + " " + std::to_string(individual.standing.rank) + " " +
         std::to_string(individual.looks) + "\n";
}

/// The words of one individual's line, converted one after another.
class Words {
 public:
  explicit Words(const std::string& line) : line_(line), words_(line) {}

  std::string text() {
    std::string word;
    if (!(words_ >> word)) fail("population", "eleven words a line", line_);
    return word;
  }
  std::int64_t integer() {
    const auto number = integerFromText(text());
    if (!number || *number < 0) fail("population", "a count", line_);
    return *number;
  }
  double real() {
    const auto number = doubleFromText(text());
    if (!number) fail("population", "a number", line_);
    return *number;
  }
  Verdict verdict() {
    const std::string word = text();
    for (const Verdict verdict : kVerdicts) {
      if (word == toString(verdict)) return verdict;
    }
    fail("population", "a verdict", line_);
  }

 private:
  std::string line_;
  std::istringstream words_;
};

Individual individualFrom(const std::string& line) {
  Words words(line);
  Individual individual;
  individual.id = words.integer();
  individual.evaluation = words.integer();
  individual.genotype = genomeFromString(words.text());
  individual.outcome.verdict = words.verdict();
  individual.outcome.end_pose.x_m = words.real();
  individual.outcome.end_pose.y_m = words.real();
  individual.outcome.end_pose.yaw_rad = words.real();
  individual.outcome.cost = words.real();
  individual.standing.diversity = words.real();
  individual.standing.rank = static_cast<std::size_t>(words.integer());
  individual.looks = static_cast<int>(words.integer());
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

std::map<std::string, std::string> toTexts(const EvolutionState& state) {
  std::map<std::string, std::string> texts{{"random", state.random.state()},
                                           {"next_id", std::to_string(state.next_id)}};
  for (const auto& [name, member] : kCounters) texts[name] = std::to_string(state.counters.*member);
  texts[kFailedLater.first] = std::to_string(state.counters.*kFailedLater.second);
  std::string& population = texts["population"];
  for (const Individual& individual : state.population) population += lineOf(individual);
  return texts;
}

EvolutionState stateFromTexts(const std::map<std::string, std::string>& texts,
                              const std::vector<Entry>& archive) {
  EvolutionState state;
  state.random = Random::fromState(textOf(texts, "random"));
  state.next_id = countOf(texts, "next_id");
  for (const auto& [name, member] : kCounters) state.counters.*member = countOf(texts, name);
  if (texts.count(kFailedLater.first) > 0) {
    state.counters.*kFailedLater.second = countOf(texts, kFailedLater.first);
  }
  std::istringstream lines(textOf(texts, "population"));
  for (std::string line; std::getline(lines, line);) {
    state.population.push_back(individualFrom(line));
  }
  state.archive = archive;
  return state;
}

}  // namespace hexapod
