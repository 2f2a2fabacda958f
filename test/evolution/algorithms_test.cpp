#include "evolution/algorithms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>

#include "demanding_evaluators.h"
#include "evolution/evolution_state.h"

namespace hexapod {
namespace {

/// Every algorithm by its name, with twins, in a task of three looks.
class EveryAlgorithm : public testing::TestWithParam<std::string> {
 protected:
  AlgorithmChoice choice() const { return {GetParam(), withTwins(), {}}; }
  std::unique_ptr<Generational> begun(std::uint64_t seed = 1) const {
    return makeAlgorithm(choice(), task, Random(seed));
  }
  std::unique_ptr<Generational> resumed(const EvolutionState& state) const {
    return makeAlgorithm(choice(), task, evolutionStateFrom(toLearnerState(state)));
  }

  CarefulEvaluator evaluator{3};
  const Task task{kGenes, 3, {leftRight()}};
};

std::string digestOf(const Algorithm& algorithm) {
  std::string digest;
  for (const Entry& entry : algorithm.entries()) {
    digest += std::to_string(entry.id) + " " + toString(entry.genome) + " " +
              std::to_string(entry.cost) + "\n";
  }
  return digest;
}

TEST_P(EveryAlgorithm, HasChangedNothingBeforeTheLastAnswerIsIn) {
  const auto algorithm = begun();
  for (int generation = 0; generation < 5; ++generation) {
    const std::string before = digestOf(toLearnerState(algorithm->state()));
    const std::string entries = digestOf(*algorithm);
    int answered = 0;
    for (; algorithm->counters().generations == generation; ++answered) {
      EXPECT_EQ(digestOf(toLearnerState(algorithm->state())), before);
      EXPECT_EQ(digestOf(*algorithm), entries);
      algorithm->tell(answersOf(evaluator, algorithm->ask()));
    }
    EXPECT_EQ(answered, 3);  // a look each
    EXPECT_NE(digestOf(*algorithm), entries);
  }
}

TEST_P(EveryAlgorithm, AsksTheSameUntilItIsTold) {
  const auto algorithm = begun();
  const Questions first = algorithm->ask(7);
  EXPECT_EQ(first.look, 1);
  EXPECT_EQ(first.genomes.size(), 7u);
  EXPECT_EQ(algorithm->ask(50).genomes, first.genomes);
  EXPECT_THROW(algorithm->tell({Outcome()}), std::invalid_argument);
  EXPECT_EQ(algorithm->ask().genomes, first.genomes);
  algorithm->tell(std::vector<Outcome>(7));
  EXPECT_EQ(algorithm->counters().diverged, 7);
  EXPECT_THROW(algorithm->tell({}), std::invalid_argument);
  EXPECT_THROW(algorithm->ask(0), std::invalid_argument);
  EXPECT_EQ(algorithm->ask().genomes.size(), 100u);
}

TEST_P(EveryAlgorithm, EndsLikeTheUndisturbedOneWhenStoppedAtAnyGeneration) {
  const auto undisturbed = begun();
  for (int generation = 0; generation < 20; ++generation) advance(*undisturbed, evaluator);
  for (const int stop : {0, 1, 13}) {
    const auto first = begun();
    for (int generation = 0; generation < stop; ++generation) advance(*first, evaluator);
    const auto second = resumed(first->state());
    for (int generation = stop; generation < 20; ++generation) advance(*second, evaluator);
    EXPECT_EQ(digestOf(toLearnerState(second->state())),
              digestOf(toLearnerState(undisturbed->state())));
    EXPECT_EQ(digestOf(*second), digestOf(*undisturbed));
  }
}

TEST_P(EveryAlgorithm, KeepsFinalOutcomesOnlyEachGenomeOnceAndTwinsToo) {
  const auto algorithm = begun();
  for (int generation = 0; generation < 40; ++generation) advance(*algorithm, evaluator);
  std::set<Genome> genomes;
  std::int64_t twins = 0;
  for (const Entry& entry : algorithm->entries()) {
    EXPECT_TRUE(genomes.insert(entry.genome).second);
    EXPECT_EQ((entry.id + 1) / 2, entry.evaluation);  // 1, 3, 5 .. are candidates
    const bool is_twin = entry.id % 2 == 0;
    const Genome walked = is_twin ? leftRight().image(entry.genome) : entry.genome;
    EXPECT_EQ(evaluator.seen_to_the_end.count(walked), 1u);
    EXPECT_EQ(entry.cost, evaluator.outcomeOf(walked).cost);
    twins += is_twin;
  }
  EXPECT_GT(twins, static_cast<std::int64_t>(genomes.size()) / 4);
  EXPECT_EQ(algorithm->counters().evaluations, 4000);
  EXPECT_EQ(algorithm->counters().looked_twice, evaluator.counts[2]);
  EXPECT_LT(evaluator.counts[3], evaluator.counts[2]);
  EXPECT_EQ(algorithm->counters().added, static_cast<std::int64_t>(genomes.size()));
}

TEST_P(EveryAlgorithm, IsAnotherRunWithAnotherSeed) {
  const auto one = begun(1), again = begun(1), other = begun(2);
  for (const auto* algorithm : {&one, &again, &other}) {
    for (int generation = 0; generation < 5; ++generation) advance(**algorithm, evaluator);
  }
  EXPECT_EQ(digestOf(*one), digestOf(*again));
  EXPECT_NE(digestOf(*one), digestOf(*other));
}

TEST_P(EveryAlgorithm, RefusesTheStateOfOtherGenomes) {
  const auto algorithm = begun();
  advance(*algorithm, evaluator);
  EXPECT_THROW(makeAlgorithm(choice(), 24, algorithm->state()), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(Algorithms, EveryAlgorithm, testing::ValuesIn(algorithmNames()));

/// Most entries that end within 5 cm of one and are turned by more than 0.5 rad against it.
std::size_t mostHeadingsInOnePlace(const std::vector<Entry>& entries) {
  std::size_t most = 0;
  for (const Entry& one : entries) {
    most = std::max<std::size_t>(
        most, std::count_if(entries.begin(), entries.end(), [&](const Entry& other) {
          return distance(one.end_pose, other.end_pose) < 0.05 &&
                 headingDistance(one.end_pose, other.end_pose) > 0.5;
        }));
  }
  return most;
}

class AlgorithmOfPoses : public testing::TestWithParam<std::string> {};

TEST_P(AlgorithmOfPoses, KeepsSeveralHeadingsInOnePlace) {
  std::map<double, std::size_t> headings, entries;
  for (const double heading_m_per_rad : {0.0, 0.2}) {
    AnalyticEvaluator evaluator(7, kGenes);
    AlgorithmChoice choice{GetParam(), {}, {}};
    choice.evolution.heading_m_per_rad = heading_m_per_rad;
    const auto algorithm = makeAlgorithm(choice, kGenes, Random(1));
    for (int generation = 0; generation < 20; ++generation) advance(*algorithm, evaluator);
    headings[heading_m_per_rad] = mostHeadingsInOnePlace(algorithm->entries());
    entries[heading_m_per_rad] = algorithm->entries().size();
  }
  EXPECT_GT(headings[0.2], 2 * headings[0.0]);
  EXPECT_GT(entries[0.2], entries[0.0]);
}

INSTANTIATE_TEST_SUITE_P(Algorithms, AlgorithmOfPoses,
                         testing::Values("br_evolution", "map_elites"));

TEST(Algorithms, VoronoiCellsOfThePlaneTakeNoHeadings) {
  AlgorithmChoice choice{"cvt_map_elites", {}, {}};
  choice.evolution.heading_m_per_rad = 0.2;
  EXPECT_THROW(makeAlgorithm(choice, 24, Random(1)), std::invalid_argument);
}

TEST(Algorithms, AnUnknownNameIsToldWithTheKnownOnes) {
  try {
    makeAlgorithm({"annealing", {}, {}}, 24, Random(1));
    FAIL() << "annealing was made";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()),
              "There is no algorithm 'annealing'; there are br_evolution, map_elites, "
              "cvt_map_elites.");
  }
}

}  // namespace
}  // namespace hexapod
