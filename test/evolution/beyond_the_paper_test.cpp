#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "demanding_evaluators.h"
#include "evolution/br_evolution.h"
#include "evolution/evolution_state.h"
#include "geometry/pose2.h"
#include "repertoire/metrics.h"

namespace hexapod {
namespace {

/// Keeps the last batch.
class RecordingEvaluator : public AnalyticEvaluator {
 public:
  RecordingEvaluator() : AnalyticEvaluator(7, kGenes) {}
  std::vector<Outcome> evaluate(const std::vector<Genome>& batch) override {
    genomes = batch;
    return AnalyticEvaluator::evaluate(batch);
  }
  std::vector<Genome> genomes;
};

RepertoireMetrics metricsOf(const BrEvolution& evolution) {
  return measure(learnedEndings(evolution.archive().entries()));
}

TEST(WarmStart, MakesTheFirstGenerationOfAllThatAreGiven) {
  AnalyticEvaluator evaluator(7, kGenes);
  EvolutionOptions options;
  options.population_size = 10;
  std::vector<Genome> given;
  for (std::uint8_t level = 1; level <= 4; ++level) {
    for (std::size_t gene = 0; gene < kGenes; gene += 2) {
      given.push_back(Genome(kGenes, 0));
      given.back()[gene] = level;
    }
  }
  BrEvolution evolution(options, Task(kGenes), Random(3));
  evolution.beginWith(given);
  advance(evolution, evaluator);
  EXPECT_EQ(evolution.counters().evaluations, static_cast<std::int64_t>(given.size()));
  EXPECT_EQ(evolution.population().size(), 10u);
  for (const Entry& entry : evolution.archive().entries()) {
    EXPECT_EQ(std::count(given.begin(), given.end(), entry.genome), 1);
  }
  advance(evolution, evaluator);
  EXPECT_EQ(evolution.counters().evaluations, static_cast<std::int64_t>(given.size()) + 10);
  EXPECT_THROW(evolution.beginWith({Genome(kGenes + 1, 0)}), std::invalid_argument);
}

TEST(WarmStart, FillsItWithRandomOnesWhereTheyAreFew) {
  AnalyticEvaluator evaluator(7, kGenes);
  EvolutionOptions options;
  options.population_size = 10;
  BrEvolution evolution(options, Task(kGenes), Random(3));
  evolution.beginWith({Genome(kGenes, 0)});
  advance(evolution, evaluator);
  EXPECT_EQ(evolution.counters().evaluations, 10);
  EXPECT_EQ(evolution.population().size(), 10u);
}

TEST(Twins, CostNoEvaluationAndFillTheArchive) {
  SymmetricEvaluator evaluator;
  BrEvolution alone({}, pairs(), Random(1));
  BrEvolution paired(withTwins(), pairs(), Random(1));
  for (int generation = 0; generation < 40; ++generation) {
    advance(alone, evaluator);
    advance(paired, evaluator);
  }
  EXPECT_EQ(paired.counters().evaluations, 4000);
  EXPECT_EQ(evaluator.candidates, 8000);
  EXPECT_GT(paired.archive().size(), alone.archive().size());
  EXPECT_LT(metricsOf(paired).sparseness_m, metricsOf(alone).sparseness_m);
}

TEST(Twins, AreEntriesThatKeepWhatTheirGenomesDo) {
  SymmetricEvaluator evaluator;
  BrEvolution evolution(withTwins(), pairs(), Random(2));
  for (int generation = 0; generation < 30; ++generation) advance(evolution, evaluator);
  std::int64_t twins = 0;
  for (const Entry& entry : evolution.archive().entries()) {
    const Outcome outcome = evaluator.evaluate({entry.genome})[0];
    EXPECT_EQ(outcome.end_pose.x_m, entry.end_pose.x_m);
    EXPECT_EQ(outcome.end_pose.y_m, entry.end_pose.y_m);
    EXPECT_EQ(outcome.end_pose.yaw_rad, entry.end_pose.yaw_rad);
    EXPECT_EQ(outcome.cost, entry.cost);
    // Ids 1, 3, 5 .. are candidates, each followed by its twin.
    EXPECT_EQ((entry.id + 1) / 2, entry.evaluation);
    twins += entry.id % 2 == 0;
  }
  EXPECT_GT(twins, static_cast<std::int64_t>(evolution.archive().size()) / 4);
}

TEST(Twins, OfARobotWithoutSymmetryChangeNothing) {
  AnalyticEvaluator evaluator(7, kGenes);
  BrEvolution plain({}, kGenes, Random(3));
  BrEvolution without(withTwins(), kGenes, Random(3));
  for (int generation = 0; generation < 10; ++generation) {
    advance(plain, evaluator);
    advance(without, evaluator);
  }
  EXPECT_EQ(digestOf(toLearnerState(plain.state())), digestOf(toLearnerState(without.state())));
}

TEST(ArchiveParents, AreAsManyAsTheShareAsksFor) {
  AnalyticEvaluator evaluator(7, kGenes);
  BrEvolution evolution({}, kGenes, Random(4));
  for (int generation = 0; generation < 10; ++generation) advance(evolution, evaluator);
  // A population of one genome that is not in the archive; children are what their parents were.
  EvolutionState state = evolution.state();
  const Genome outsider(kGenes, 1);
  ASSERT_FALSE(evolution.archive().contains(outsider));
  for (Individual& individual : state.population) {
    individual.id = state.next_id++;
    individual.genotype = outsider;
  }
  EvolutionOptions options;
  options.mutation_rate = 0.0;
  const std::map<double, std::pair<int, int>> allowed = {
      {0.0, {0, 0}}, {0.5, {30, 70}}, {1.0, {100, 100}}};
  for (const auto& [share, range] : allowed) {
    options.archive_parents = share;
    RecordingEvaluator recorder;
    BrEvolution resumed(options, kGenes, state);
    advance(resumed, recorder);
    const auto entries =
        std::count_if(recorder.genomes.begin(), recorder.genomes.end(),
                      [&](const Genome& genome) { return evolution.archive().contains(genome); });
    EXPECT_GE(entries, range.first);
    EXPECT_LE(entries, range.second);
    EXPECT_EQ(entries + std::count(recorder.genomes.begin(), recorder.genomes.end(), outsider),
              100);
  }
}

TEST(ArchiveTournament, TakesTheBestAlignedOfTheEntriesAroundTheOneDrawn) {
  AnalyticEvaluator evaluator(7, kGenes);
  BrEvolution evolution({}, kGenes, Random(8));
  for (int generation = 0; generation < 20; ++generation) advance(evolution, evaluator);
  EvolutionOptions options;
  options.mutation_rate = 0.0;
  options.archive_parents = 1.0;
  options.archive_tournament = 5;
  RecordingEvaluator recorder;
  BrEvolution resumed(options, kGenes, evolution.state());
  advance(resumed, recorder);
  std::set<Genome> winners;
  const std::vector<Entry>& entries = evolution.archive().entries();
  for (const Entry& drawn : entries) {
    std::vector<Entry> around = entries;
    std::partial_sort(
        around.begin(), around.begin() + 5, around.end(), [&](const Entry& a, const Entry& b) {
          return distance(a.end_pose, drawn.end_pose) < distance(b.end_pose, drawn.end_pose);
        });
    winners.insert(
        std::min_element(around.begin(), around.begin() + 5, [](const Entry& a, const Entry& b) {
          return a.cost < b.cost;
        })->genome);
  }
  ASSERT_LT(winners.size(), entries.size() / 2);
  for (const Genome& genome : recorder.genomes) EXPECT_EQ(winners.count(genome), 1u);
}

TEST(NoveltyDecay, LowersTheThresholdWithTheCandidatesEvaluatedAndStopsAtItsMinimum) {
  AnalyticEvaluator evaluator(7, kGenes);
  EvolutionOptions options;
  options.novelty_decay = 0.5;
  options.novelty_decay_from = 1600;
  options.novelty_threshold_min_m = 0.04;
  BrEvolution refined(options, kGenes, Random(5));
  BrEvolution coarse({}, kGenes, Random(5));
  for (int generation = 0; generation < 150; ++generation) {
    advance(refined, evaluator);
    advance(coarse, evaluator);
    const std::int64_t evaluations = refined.counters().evaluations;
    const double decayed_m = 0.10 / std::sqrt(static_cast<double>(evaluations) / 1600.0);
    EXPECT_NEAR(refined.noveltyThreshold(), std::clamp(decayed_m, 0.04, 0.10), 1e-12);
  }
  EXPECT_EQ(refined.noveltyThreshold(), 0.04);
  EXPECT_EQ(coarse.noveltyThreshold(), 0.10);
  EXPECT_LT(metricsOf(refined).sparseness_m, metricsOf(coarse).sparseness_m);
}

TEST(Candidates, OfAGenerationMayBeMoreThanThePopulation) {
  AnalyticEvaluator evaluator(7, kGenes);
  EvolutionOptions options;
  options.population_size = 20;
  options.candidates = 50;
  BrEvolution evolution(options, kGenes, Random(5));
  for (int generation = 1; generation <= 3; ++generation) {
    EXPECT_EQ(evolution.ask().genomes.size(), 50u);
    advance(evolution, evaluator);
    EXPECT_EQ(evolution.population().size(), 20u);
    EXPECT_EQ(evolution.counters().evaluations, 50 * generation);
  }
}

void expectOnlyFinalOutcomesInTheArchive(CarefulEvaluator& evaluator) {
  BrEvolution evolution({}, {kGenes, evaluator.looks()}, Random(6));
  for (int generation = 0; generation < 40; ++generation) advance(evolution, evaluator);
  for (const Entry& entry : evolution.archive().entries()) {
    EXPECT_EQ(evaluator.seen_to_the_end.count(entry.genome), 1u);
    EXPECT_EQ(entry.cost, evaluator.outcomeOf(entry.genome).cost);
    EXPECT_FALSE(entry.genome[0] == 4 && entry.genome[4] == 4);
  }
  EXPECT_GT(evolution.archive().size(), 50u);
  EXPECT_GT(evaluator.fell, 0);
  EXPECT_EQ(evolution.counters().failed_later, evaluator.fell);
  EXPECT_GE(evolution.counters().fell, evaluator.fell);
  EXPECT_EQ(evolution.counters().looked_twice, evaluator.counts[2]);
  EXPECT_LT(evolution.counters().looked_twice, evolution.counters().evaluations);
  EXPECT_EQ(evolution.counters().evaluations, 4000);
}

TEST(SecondLooks, DecideWhatEntersTheArchive) {
  CarefulEvaluator evaluator;
  expectOnlyFinalOutcomesInTheArchive(evaluator);
}

TEST(ThirdLooks, DecideWhatEntersTheArchiveAndAreSparedThoseThatTheSecondOnesRuleOut) {
  CarefulEvaluator evaluator(3);
  expectOnlyFinalOutcomesInTheArchive(evaluator);
  EXPECT_LT(evaluator.counts[3], evaluator.counts[2]);
}

/// A robot on which the first gene's level decides how far simulation is off.
class GeneDisparity : public Transferability {
 public:
  double disparity(const Genome& genome, const Outcome&) const override {
    return 0.3 * static_cast<double>(genome[1]);
  }
};

double meanLevel(const std::vector<Entry>& entries) {
  double sum = 0.0;
  for (const Entry& entry : entries) sum += static_cast<double>(entry.genome[1]);
  return sum / static_cast<double>(entries.size());
}

TEST(Transferability, GivesControllersThatDoOnTheRobotWhatTheyDoInSimulation) {
  AnalyticEvaluator evaluator(7, kGenes);
  BrEvolution plain({}, kGenes, Random(4)), judged({}, kGenes, Random(4));
  judged.judgeBy(std::make_shared<GeneDisparity>());
  for (int generation = 0; generation < 40; ++generation) {
    advance(plain, evaluator);
    advance(judged, evaluator);
  }
  EXPECT_LT(meanLevel(judged.entries()), 0.75 * meanLevel(plain.entries()));
  EXPECT_NEAR(metricsOf(judged).sparseness_m, metricsOf(plain).sparseness_m, 0.01);
}

TEST(Transferability, JudgesWhatThereIsAnewAndIsNoPartOfTheState) {
  AnalyticEvaluator evaluator(7, kGenes);
  const auto judge = std::make_shared<GeneDisparity>();
  BrEvolution undisturbed({}, kGenes, Random(4));
  for (int generation = 0; generation < 5; ++generation) advance(undisturbed, evaluator);
  BrEvolution resumed({}, kGenes, undisturbed.state());
  for (BrEvolution* evolution : {&undisturbed, &resumed}) {
    evolution->judgeBy(judge);
    for (const Entry& entry : evolution->entries()) {
      EXPECT_EQ(entry.disparity, judge->disparity(entry.genome, {}));
    }
    for (int generation = 0; generation < 5; ++generation) advance(*evolution, evaluator);
  }
  EXPECT_EQ(digestOf(toLearnerState(resumed.state())),
            digestOf(toLearnerState(undisturbed.state())));
}

/// Of all but the order of the archive, which plays no part.
std::string digestOfAnyOrder(EvolutionState state) {
  std::sort(state.archive.begin(), state.archive.end(),
            [](const Entry& a, const Entry& b) { return a.id < b.id; });
  return digestOf(toLearnerState(state));
}

TEST(AllOptionsBeyondThePaper, SurviveARestartAtAnyGeneration) {
  CarefulEvaluator evaluator(3);
  EvolutionOptions options = withTwins();
  options.archive_parents = 0.5;
  options.archive_tournament = 3;
  options.novelty_decay = 0.5;
  options.candidates = 130;
  const Task task(kGenes, evaluator.looks(), {leftRight()});
  BrEvolution undisturbed(options, task, Random(7));
  for (int generation = 0; generation < 25; ++generation) advance(undisturbed, evaluator);
  for (const int stop : {0, 1, 12, 24}) {
    BrEvolution first(options, task, Random(7));
    for (int generation = 0; generation < stop; ++generation) advance(first, evaluator);
    EvolutionState state = first.state();
    std::reverse(state.archive.begin(), state.archive.end());
    BrEvolution second(options, task, evolutionStateFrom(toLearnerState(state)));
    for (int generation = stop; generation < 25; ++generation) advance(second, evaluator);
    EXPECT_EQ(digestOfAnyOrder(second.state()), digestOfAnyOrder(undisturbed.state()));
  }
}

}  // namespace
}  // namespace hexapod
