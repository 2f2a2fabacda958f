#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "analytic_evaluator.h"
#include "evolution/br_evolution.h"
#include "evolution/evolution_state.h"
#include "geometry/pose2.h"
#include "repertoire/metrics.h"

namespace hexapod {
namespace {

constexpr std::size_t kGenes = 16;

/// Legs 0, 1 on the left and 2, 3 on the right side exchange their genes.
Symmetry leftRight() {
  std::vector<Symmetry::LegImage> legs(4);
  for (std::size_t leg = 0; leg < 4; ++leg) legs[leg].leg = (leg + 2) % 4;
  return Symmetry(1.0, -1.0, legs);
}

/// A stand-in for a robot with that symmetry: outcomes of images are images of outcomes.
class SymmetricEvaluator : public AnalyticEvaluator {
 public:
  SymmetricEvaluator() : AnalyticEvaluator(7, kGenes) {}
  std::vector<Outcome> evaluate(const std::vector<Genome>& genomes) override {
    calls += 1;
    candidates += static_cast<std::int64_t>(genomes.size());
    std::vector<Outcome> outcomes;
    for (const Genome& genome : genomes) {
      const Genome image = leftRight().image(genome);
      outcomes.push_back(image < genome ? leftRight().image(outcomeOf(image)) : outcomeOf(genome));
    }
    return outcomes;
  }
};

/// The first look knows no falls and no heading; the second one knows the falls, and the last one
/// all. (It may be the same.)
class CarefulEvaluator : public AnalyticEvaluator {
 public:
  explicit CarefulEvaluator(int looks = 2) : AnalyticEvaluator(7, kGenes), looks_(looks) {}
  std::vector<Outcome> evaluate(const std::vector<Genome>& genomes) override {
    std::vector<Outcome> outcomes = AnalyticEvaluator::evaluate(genomes);
    for (Outcome& outcome : outcomes) {
      if (outcome.walked()) outcome.cost *= 0.5;
    }
    return outcomes;
  }
  int looks() const override { return looks_; }
  std::vector<Outcome> lookAgain(int look, const std::vector<Genome>& genomes,
                                 const std::vector<Outcome>& previous) override {
    counts[look] += static_cast<std::int64_t>(genomes.size());
    std::vector<Outcome> outcomes;
    for (std::size_t i = 0; i < genomes.size(); ++i) {
      Outcome outcome = outcomeOf(genomes[i]);
      const double before = look == 2 ? 0.5 : 0.75;
      EXPECT_EQ(previous[i].cost, before * outcome.cost);
      if (look < looks_) outcome.cost *= 0.75;
      if (look == looks_) seen_to_the_end.insert(genomes[i]);
      const bool falls = genomes[i][0] == 4 && genomes[i][4] == 4;
      outcomes.push_back(falls ? Outcome{Verdict::kFell, {}, 0.0} : outcome);
    }
    return outcomes;
  }

  std::set<Genome> seen_to_the_end;
  std::map<int, std::int64_t> counts;  // of genomes, by look

 private:
  int looks_;
};

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

EvolutionOptions withTwins() {
  EvolutionOptions options;
  options.offer_twins = true;
  return options;
}

RepertoireMetrics metricsOf(const BrEvolution& evolution) {
  return measure(learnedEndings(evolution.archive().entries()));
}

TEST(Twins, CostNoEvaluationAndFillTheArchive) {
  SymmetricEvaluator evaluator;
  BrEvolution alone({}, kGenes, evaluator, Random(1), {leftRight()});
  BrEvolution paired(withTwins(), kGenes, evaluator, Random(1), {leftRight()});
  for (int generation = 0; generation < 40; ++generation) {
    alone.step();
    paired.step();
  }
  EXPECT_EQ(paired.counters().evaluations, 4000);
  EXPECT_EQ(evaluator.candidates, 8000);
  EXPECT_GT(paired.archive().size(), alone.archive().size());
  EXPECT_LT(metricsOf(paired).sparseness_m, metricsOf(alone).sparseness_m);
}

TEST(Twins, AreEntriesThatKeepWhatTheirGenomesDo) {
  SymmetricEvaluator evaluator;
  BrEvolution evolution(withTwins(), kGenes, evaluator, Random(2), {leftRight()});
  for (int generation = 0; generation < 30; ++generation) evolution.step();
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
  BrEvolution plain({}, kGenes, evaluator, Random(3));
  BrEvolution without(withTwins(), kGenes, evaluator, Random(3), {});
  for (int generation = 0; generation < 10; ++generation) {
    plain.step();
    without.step();
  }
  EXPECT_EQ(toTexts(plain.state()), toTexts(without.state()));
}

TEST(ArchiveParents, AreAsManyAsTheShareAsksFor) {
  AnalyticEvaluator evaluator(7, kGenes);
  BrEvolution evolution({}, kGenes, evaluator, Random(4));
  for (int generation = 0; generation < 10; ++generation) evolution.step();
  // A population of one genome that is not in the archive; children are what their parents were.
  EvolutionState state = evolution.state();
  const Genome outsider(kGenes, 1);
  ASSERT_FALSE(evolution.archive().contains(outsider));
  for (Individual& individual : state.population) individual.genotype = outsider;
  EvolutionOptions options;
  options.mutation_rate = 0.0;
  const std::map<double, std::pair<int, int>> allowed = {
      {0.0, {0, 0}}, {0.5, {30, 70}}, {1.0, {100, 100}}};
  for (const auto& [share, range] : allowed) {
    options.archive_parents = share;
    RecordingEvaluator recorder;
    BrEvolution(options, kGenes, recorder, state).step();
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
  BrEvolution evolution({}, kGenes, evaluator, Random(8));
  for (int generation = 0; generation < 20; ++generation) evolution.step();
  EvolutionOptions options;
  options.mutation_rate = 0.0;
  options.archive_parents = 1.0;
  options.archive_tournament = 5;
  RecordingEvaluator recorder;
  BrEvolution(options, kGenes, recorder, evolution.state()).step();
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

TEST(NoveltyRefinement, LowersTheThresholdWhenFewAreAddedAndStopsAtItsMinimum) {
  AnalyticEvaluator evaluator(7, kGenes);
  EvolutionOptions options;
  options.novelty_refinement = 0.5;
  options.novelty_threshold_min_m = 0.04;
  BrEvolution refined(options, kGenes, evaluator, Random(5));
  BrEvolution coarse({}, kGenes, evaluator, Random(5));
  double threshold_m = refined.noveltyThreshold();
  EXPECT_EQ(threshold_m, 0.10);
  for (int generation = 0; generation < 150; ++generation) {
    const std::int64_t added = refined.counters().added;
    refined.step();
    coarse.step();
    const bool few = refined.counters().added - added < 2;
    EXPECT_EQ(refined.noveltyThreshold(), few ? std::max(0.04, threshold_m * 0.5) : threshold_m);
    threshold_m = refined.noveltyThreshold();
  }
  EXPECT_EQ(threshold_m, 0.04);
  EXPECT_EQ(coarse.noveltyThreshold(), 0.10);
  EXPECT_LT(metricsOf(refined).sparseness_m, metricsOf(coarse).sparseness_m);
}

void expectOnlyFinalOutcomesInTheArchive(CarefulEvaluator& evaluator) {
  BrEvolution evolution({}, kGenes, evaluator, Random(6));
  for (int generation = 0; generation < 40; ++generation) evolution.step();
  for (const Entry& entry : evolution.archive().entries()) {
    EXPECT_EQ(evaluator.seen_to_the_end.count(entry.genome), 1u);
    EXPECT_EQ(entry.cost, evaluator.outcomeOf(entry.genome).cost);
    EXPECT_FALSE(entry.genome[0] == 4 && entry.genome[4] == 4);
  }
  EXPECT_GT(evolution.archive().size(), 50u);
  EXPECT_GT(evolution.counters().fell, 0);
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

TEST(AllOptionsBeyondThePaper, SurviveARestartAtAnyGeneration) {
  CarefulEvaluator evaluator(3);
  EvolutionOptions options = withTwins();
  options.archive_parents = 0.5;
  options.archive_tournament = 3;
  options.novelty_refinement = 0.05;
  BrEvolution undisturbed(options, kGenes, evaluator, Random(7), {leftRight()});
  for (int generation = 0; generation < 25; ++generation) undisturbed.step();
  for (const int stop : {0, 1, 12, 24}) {
    BrEvolution first(options, kGenes, evaluator, Random(7), {leftRight()});
    for (int generation = 0; generation < stop; ++generation) first.step();
    EvolutionState state = first.state();
    std::reverse(state.archive.begin(), state.archive.end());
    BrEvolution second(options, kGenes, evaluator, stateFromTexts(toTexts(state), state.archive),
                       {leftRight()});
    for (int generation = stop; generation < 25; ++generation) second.step();
    EXPECT_EQ(toTexts(second.state()), toTexts(undisturbed.state()));
  }
}

}  // namespace
}  // namespace hexapod
