#include "evolution/br_evolution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "analytic_evaluator.h"
#include "repertoire/metrics.h"

namespace hexapod {
namespace {

constexpr std::size_t kGenes = 24;

EvolutionOptions optionsOfSize(std::int64_t population_size) {
  EvolutionOptions options;
  options.population_size = population_size;
  return options;
}

void runTo(std::int64_t evaluations, Evaluator& evaluator, BrEvolution& evolution) {
  while (evolution.counters().evaluations < evaluations) {
    advance(evolution, evaluator, evaluations - evolution.counters().evaluations);
  }
}

/// Every genome has the same outcome.
class ConstantEvaluator : public Evaluator {
 public:
  explicit ConstantEvaluator(const Outcome& outcome) : outcome_(outcome) {}
  std::vector<Outcome> evaluate(const std::vector<Genome>& genomes) override {
    return std::vector<Outcome>(genomes.size(), outcome_);
  }

 private:
  Outcome outcome_;
};

/// Works until it is told to fail.
class FailingEvaluator : public AnalyticEvaluator {
 public:
  std::vector<Outcome> evaluate(const std::vector<Genome>& genomes) override {
    if (fails) throw std::runtime_error("the simulation was interrupted");
    auto outcomes = AnalyticEvaluator::evaluate(genomes);
    if (loses_one) outcomes.pop_back();
    return outcomes;
  }
  bool fails = false;
  bool loses_one = false;
};

TEST(BrEvolution, FillsTheRegionAndStraightensItsControllers) {
  AnalyticEvaluator evaluator;
  BrEvolution evolution({}, kGenes, Random(1));
  runTo(1000, evaluator, evolution);
  const auto early = measure(learnedEndings(evolution.archive().entries()));
  runTo(20000, evaluator, evolution);
  const auto late = measure(learnedEndings(evolution.archive().entries()));
  EXPECT_EQ(evaluator.candidates, 20000);
  EXPECT_LT(late.sparseness_m, 0.03);
  EXPECT_LT(late.sparseness_m, early.sparseness_m);
  EXPECT_LT(late.median_error_in_region_rad, 0.5 * early.median_error_in_region_rad);
  EXPECT_GT(late.max_reach_m, early.max_reach_m);
}

TEST(BrEvolution, CrowdingDiversityWorksToo) {
  AnalyticEvaluator evaluator;
  EvolutionOptions options;
  options.diversity = "crowding";
  BrEvolution evolution(options, kGenes, Random(1));
  runTo(5000, evaluator, evolution);
  EXPECT_LT(measure(learnedEndings(evolution.archive().entries())).sparseness_m, 0.04);
}

TEST(BrEvolution, WithCopiesTheBetterIndividualStaysInThePopulation) {
  AnalyticEvaluator evaluator;
  EvolutionOptions options;
  options.swap = "copy";
  BrEvolution evolution(options, kGenes, Random(1));
  for (int generation = 0; generation < 30; ++generation) {
    std::set<std::int64_t> known;
    for (const Individual& individual : evolution.population()) known.insert(individual.id);
    const std::int64_t oldest_child = evolution.counters().evaluations + 1;
    advance(evolution, evaluator);
    // Nobody comes back: all are parents or children.
    for (const Individual& individual : evolution.population()) {
      EXPECT_TRUE(known.count(individual.id) > 0 || individual.id >= oldest_child);
    }
  }
  EXPECT_GT(evolution.counters().swapped, 0);
}

TEST(BrEvolution, InheritsSilentGenesButSimulatesCanonicalGenomes) {
  AnalyticEvaluator evaluator;
  BrEvolution evolution(optionsOfSize(50), kGenes, Random(14));
  bool silent = false;
  for (int generation = 0; generation < 5; ++generation) advance(evolution, evaluator);
  for (const Individual& individual : evolution.population()) {
    EXPECT_EQ(individual.genome, canonical(individual.genotype));
    silent = silent || individual.genome != individual.genotype;
  }
  EXPECT_TRUE(silent);
}

TEST(BrEvolution, ArchiveNeverShrinksAndKeepsItsPromisesThroughARun) {
  AnalyticEvaluator evaluator;
  BrEvolution evolution({}, kGenes, Random(2));
  std::size_t size = 0;
  for (int generation = 0; generation < 40; ++generation) {
    advance(evolution, evaluator);
    ASSERT_GE(evolution.archive().size(), size);
    size = evolution.archive().size();
  }
  EXPECT_EQ(evolution.counters().added, static_cast<std::int64_t>(size));
  EXPECT_GT(evolution.counters().swapped, 0);
  std::set<std::int64_t> ids;
  for (const Entry& entry : evolution.archive().entries()) {
    EXPECT_TRUE(ids.insert(entry.id).second);
    EXPECT_EQ(entry.genome, canonical(entry.genome));
    EXPECT_GE(entry.evaluation, 1);
    EXPECT_LE(entry.evaluation, 4000);
    const Outcome outcome = evaluator.outcomeOf(entry.genome);
    ASSERT_TRUE(outcome.walked());
    EXPECT_EQ(entry.end_pose.x_m, outcome.end_pose.x_m);
    EXPECT_EQ(entry.cost, outcome.cost);
  }
}

TEST(BrEvolution, ASwapPutsTheOldEntryInTheIndividualsPlace) {
  AnalyticEvaluator evaluator;
  BrEvolution evolution({}, kGenes, Random(3));
  bool returned = false;
  for (int generation = 0; generation < 30; ++generation) {
    const auto before = evolution.archive().entries();
    advance(evolution, evaluator);
    for (const Individual& individual : evolution.population()) {
      for (const Entry& entry : before) {
        const bool left = !evolution.archive().contains(entry.genome);
        returned = returned || (left && individual.id == entry.id);
      }
    }
  }
  EXPECT_TRUE(returned);
}

TEST(BrEvolution, SameSeedSameArchiveOtherSeedAnother) {
  std::vector<std::string> digests;
  for (const std::uint64_t seed : {4U, 4U, 5U}) {
    AnalyticEvaluator evaluator;
    BrEvolution evolution({}, kGenes, Random(seed));
    runTo(3000, evaluator, evolution);
    std::string digest;
    for (const Entry& entry : evolution.archive().entries()) {
      digest += std::to_string(entry.id) + toString(entry.genome);
    }
    digests.push_back(digest);
  }
  EXPECT_EQ(digests[0], digests[1]);
  EXPECT_NE(digests[0], digests[2]);
}

TEST(BrEvolution, EvaluatesEachCandidateOnceAndNeverItsParentsAgain) {
  AnalyticEvaluator evaluator;
  BrEvolution evolution(optionsOfSize(16), kGenes, Random(6));
  for (int generation = 0; generation < 10; ++generation) advance(evolution, evaluator);
  EXPECT_EQ(evaluator.calls, 10);
  EXPECT_EQ(evaluator.candidates, 160);
  EXPECT_EQ(evolution.counters().evaluations, 160);
  EXPECT_EQ(evolution.counters().generations, 10);
}

TEST(BrEvolution, WorksWithAnyPopulationSizeAndMoreNeighboursThanIndividuals) {
  for (const std::int64_t size : {1, 2, 15, 16, 33}) {
    for (const std::int64_t neighbours : {1, 15, 10000}) {
      AnalyticEvaluator evaluator;
      EvolutionOptions options = optionsOfSize(size);
      options.neighbours = neighbours;
      BrEvolution evolution(options, kGenes, Random(7));
      for (int generation = 0; generation < 20; ++generation) advance(evolution, evaluator);
      EXPECT_EQ(evolution.population().size(), static_cast<std::size_t>(size));
      EXPECT_EQ(evolution.counters().evaluations, 20 * size);
      EXPECT_GE(evolution.archive().size(), 1U);
    }
  }
}

TEST(BrEvolution, MeetsABudgetThatIsNoMultipleOfThePopulation) {
  AnalyticEvaluator evaluator;
  BrEvolution evolution({}, kGenes, Random(8));
  runTo(1234, evaluator, evolution);
  EXPECT_EQ(evaluator.candidates, 1234);
  EXPECT_EQ(evolution.population().size(), 100U);
  EXPECT_THROW(advance(evolution, evaluator, 0), std::invalid_argument);
  BrEvolution tiny({}, kGenes, Random(8));
  advance(tiny, evaluator, 3);
  EXPECT_EQ(tiny.population().size(), 3U);
}

TEST(BrEvolution, GoesOnWhenEverythingFalls) {
  for (const Verdict verdict : {Verdict::kFell, Verdict::kSelfCollided, Verdict::kDiverged}) {
    ConstantEvaluator evaluator({verdict, {}, 0.0});
    BrEvolution evolution(optionsOfSize(10), kGenes, Random(9));
    for (int generation = 0; generation < 5; ++generation) advance(evolution, evaluator);
    EXPECT_EQ(evolution.archive().size(), 0U);
    EXPECT_EQ(evolution.population().size(), 10U);
    const EvolutionCounters& counters = evolution.counters();
    EXPECT_EQ(counters.fell, verdict == Verdict::kFell ? 50 : 0);
    EXPECT_EQ(counters.self_collided, verdict == Verdict::kSelfCollided ? 50 : 0);
    EXPECT_EQ(counters.diverged, verdict == Verdict::kDiverged ? 50 : 0);
  }
}

TEST(BrEvolution, CountsOutcomesThatAreNotFiniteAsDiverged) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Outcome& outcome : {Outcome{Verdict::kWalked, {nan, 0.0, 0.0}, 0.1},
                                 Outcome{Verdict::kWalked, {0.1, 0.0, 0.0}, nan},
                                 Outcome{Verdict::kWalked, {0.1, 0.0, 0.0}, -0.1}}) {
    ConstantEvaluator evaluator(outcome);
    BrEvolution evolution(optionsOfSize(10), kGenes, Random(10));
    advance(evolution, evaluator);
    EXPECT_EQ(evolution.counters().diverged, 10);
    EXPECT_EQ(evolution.archive().size(), 0U);
  }
}

TEST(BrEvolution, TheFallenAreTheFirstToGo) {
  AnalyticEvaluator evaluator;
  BrEvolution evolution({}, kGenes, Random(11));
  for (int generation = 0; generation < 10; ++generation) advance(evolution, evaluator);
  ASSERT_GT(evolution.counters().fell, 0);
  for (const Individual& individual : evolution.population()) {
    EXPECT_TRUE(individual.outcome.walked());
  }
}

TEST(BrEvolution, AnInterruptedGenerationHasChangedNothing) {
  FailingEvaluator evaluator;
  BrEvolution evolution({}, kGenes, Random(12));
  AnalyticEvaluator undisturbed_evaluator;
  BrEvolution undisturbed({}, kGenes, Random(12));
  for (int generation = 0; generation < 12; ++generation) {
    evaluator.fails = generation % 3 == 1;
    if (evaluator.fails) {
      EXPECT_THROW(advance(evolution, evaluator), std::runtime_error);
    }
    evaluator.fails = false;
    evaluator.loses_one = generation % 4 == 2;
    if (evaluator.loses_one) {
      EXPECT_THROW(advance(evolution, evaluator), std::logic_error);
    }
    evaluator.loses_one = false;
    advance(evolution, evaluator);
    advance(undisturbed, undisturbed_evaluator);
  }
  ASSERT_EQ(evolution.archive().size(), undisturbed.archive().size());
  for (std::size_t i = 0; i < evolution.archive().size(); ++i) {
    EXPECT_EQ(evolution.archive().entries()[i].id, undisturbed.archive().entries()[i].id);
  }
}

TEST(BrEvolution, WithoutMutationChildrenAreTheirParents) {
  AnalyticEvaluator evaluator;
  EvolutionOptions options = optionsOfSize(10);
  options.mutation_rate = 0.0;
  BrEvolution evolution(options, kGenes, Random(13));
  advance(evolution, evaluator);
  std::set<Genome> initial;
  for (const Individual& individual : evolution.population()) initial.insert(individual.genome);
  for (int generation = 0; generation < 5; ++generation) advance(evolution, evaluator);
  for (const Individual& individual : evolution.population()) {
    EXPECT_EQ(initial.count(individual.genome), 1U);
  }
}

}  // namespace
}  // namespace hexapod
