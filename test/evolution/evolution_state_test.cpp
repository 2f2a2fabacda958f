#include "evolution/evolution_state.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <string>

#include "analytic_evaluator.h"
#include "evolution/br_evolution.h"

namespace hexapod {
namespace {

std::map<std::int64_t, Genome> contentOf(const Archive& archive) {
  std::map<std::int64_t, Genome> content;
  for (const Entry& entry : archive.entries()) content[entry.id] = entry.genome;
  return content;
}

/// As a file keeps it, and back.
EvolutionState keptAndBack(const EvolutionState& state) {
  return evolutionStateFrom(toLearnerState(state));
}

std::string digestOf(const EvolutionState& state) { return digestOf(toLearnerState(state)); }

TEST(EvolutionState, ARunStoppedAtAnyGenerationEndsLikeTheUndisturbedOne) {
  for (const char* diversity : {"genotypic", "crowding"}) {
    EvolutionOptions options;
    options.diversity = diversity;
    AnalyticEvaluator evaluator;
    BrEvolution undisturbed(options, 24, Random(20));
    for (int generation = 0; generation < 25; ++generation) advance(undisturbed, evaluator);
    for (const int stop : {0, 1, 2, 13}) {
      BrEvolution first(options, 24, Random(20));
      for (int generation = 0; generation < stop; ++generation) advance(first, evaluator);
      BrEvolution second(options, 24, keptAndBack(first.state()));
      for (int generation = stop; generation < 25; ++generation) advance(second, evaluator);
      EXPECT_EQ(contentOf(second.archive()), contentOf(undisturbed.archive()));
      EXPECT_EQ(digestOf(second.state()), digestOf(undisturbed.state()));
    }
  }
}

TEST(EvolutionState, ARunStoppedAfterEveryGenerationEndsLikeTheUndisturbedOne) {
  AnalyticEvaluator evaluator;
  BrEvolution undisturbed({}, 24, Random(21));
  EvolutionState state = BrEvolution({}, 24, Random(21)).state();
  for (int generation = 0; generation < 25; ++generation) {
    advance(undisturbed, evaluator);
    BrEvolution resumed({}, 24, keptAndBack(state));
    advance(resumed, evaluator);
    state = resumed.state();
  }
  EXPECT_EQ(digestOf(state), digestOf(undisturbed.state()));
}

TEST(EvolutionState, SurvivesInfinityAndTheFallen) {
  EvolutionState state;
  Individual individual;
  individual.genotype = {0, 1, 2, 3};
  individual.outcome = {Verdict::kSelfCollided, {}, 0.0};
  individual.standing = {3, std::numeric_limits<double>::infinity()};
  state.population = {individual};
  const EvolutionState back = keptAndBack(state);
  ASSERT_EQ(back.population.size(), 1U);
  EXPECT_EQ(back.population[0].outcome.verdict, Verdict::kSelfCollided);
  EXPECT_EQ(back.population[0].genotype, (Genome{0, 1, 2, 3}));
  EXPECT_EQ(back.population[0].standing.rank, 3U);
  EXPECT_EQ(back.population[0].standing.diversity, std::numeric_limits<double>::infinity());
}

TEST(EvolutionState, OfAnotherTaskGoesOnWithItsOwnGenotypes) {
  // As gaits {0, 3} and {0, 7} were one; here they are two, of levels beyond a digit.
  const Task task(GenomeSpace(2, 101));
  AnalyticEvaluator evaluator(7, 2);
  EvolutionOptions options;
  options.population_size = 10;
  BrEvolution undisturbed(options, task, Random(24));
  for (int generation = 0; generation < 9; ++generation) advance(undisturbed, evaluator);
  BrEvolution first(options, task, Random(24));
  for (int generation = 0; generation < 4; ++generation) advance(first, evaluator);
  BrEvolution second(options, task, keptAndBack(first.state()));
  for (const Individual& individual : second.population()) {
    EXPECT_EQ(individual.genome, individual.genotype);
  }
  for (int generation = 4; generation < 9; ++generation) advance(second, evaluator);
  EXPECT_EQ(digestOf(second.state()), digestOf(undisturbed.state()));
}

TEST(EvolutionState, RefusesValuesThatAreDamaged) {
  AnalyticEvaluator evaluator;
  BrEvolution evolution({}, 24, Random(22));
  advance(evolution, evaluator);
  const LearnerState good = toLearnerState(evolution.state());
  for (const auto& [name, text] : good.values) {
    LearnerState missing = good;
    missing.values.erase(name);
    EXPECT_THROW(evolutionStateFrom(missing), std::invalid_argument) << name;
    LearnerState garbled = good;
    garbled.values[name] = "x" + text;
    EXPECT_THROW(evolutionStateFrom(garbled), std::invalid_argument) << name;
  }
}

TEST(EvolutionState, ThatDoesNotFitIsRefused) {
  AnalyticEvaluator evaluator;
  BrEvolution evolution({}, 24, Random(23));
  advance(evolution, evaluator);
  EXPECT_THROW(BrEvolution({}, 12, evolution.state()), std::invalid_argument);
}

}  // namespace
}  // namespace hexapod
