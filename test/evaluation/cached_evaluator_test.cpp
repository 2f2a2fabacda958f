#include "evaluation/cached_evaluator.h"

#include <gtest/gtest.h>

#include <set>

#include "evolution/analytic_evaluator.h"

namespace hexapod {
namespace {

/// Remembers what it was asked, and refuses to be asked twice. Its second look turns y by 0.1 m.
class Witness : public AnalyticEvaluator {
 public:
  std::vector<Outcome> evaluate(const std::vector<Genome>& genomes) override {
    for (const Genome& genome : genomes) {
      EXPECT_EQ(genome, canonical(genome));
      EXPECT_TRUE(forgetful || asked.insert(genome).second) << toString(genome);
    }
    return AnalyticEvaluator::evaluate(genomes);
  }
  int looks() const override { return 2; }
  std::vector<Outcome> lookAgain(int, const std::vector<Genome>& genomes,
                                 const std::vector<Outcome>& first) override {
    second_looks += static_cast<int>(genomes.size());
    std::vector<Outcome> outcomes = first;
    for (Outcome& outcome : outcomes) outcome.end_pose.y_m += 0.1;
    return outcomes;
  }

  std::set<Genome> asked;
  bool forgetful = false;
  int second_looks = 0;
};

/// Four legs whose left-right image exchanges 0, 1 with 2, 3, and fore-aft 0, 2 with 1, 3.
std::vector<Symmetry> mirrors() {
  using Legs = std::vector<Symmetry::LegImage>;
  const Legs sides = {
      {2, {true, false}}, {3, {true, false}}, {0, {true, false}}, {1, {true, false}}};
  const Legs ends = {
      {1, {true, false}}, {0, {true, false}}, {3, {true, false}}, {2, {true, false}}};
  const Legs both = {
      {3, {false, false}}, {2, {false, false}}, {1, {false, false}}, {0, {false, false}}};
  return {Symmetry(1, -1, sides), Symmetry(-1, 1, ends), Symmetry(-1, -1, both)};
}

const GenomeSpace kGaits = 16;

std::vector<Genome> someGenomes(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Genome> genomes(count, Genome(16));
  for (Genome& genome : genomes) {
    for (auto& level : genome) level = static_cast<std::uint8_t>(random.below(kGeneLevels));
  }
  return genomes;
}

void expectSame(const Outcome& a, const Outcome& b) {
  EXPECT_EQ(a.verdict, b.verdict);
  EXPECT_EQ(a.end_pose.x_m, b.end_pose.x_m);
  EXPECT_EQ(a.end_pose.y_m, b.end_pose.y_m);
  EXPECT_EQ(a.end_pose.yaw_rad, b.end_pose.yaw_rad);
  EXPECT_EQ(a.cost, b.cost);
}

TEST(CachedEvaluator, GivesTheOutcomesOfTheEvaluatorBehindIt) {
  AnalyticEvaluator plain(7, 16);
  Witness witness;
  CachedEvaluator cached(witness, 1000, kGaits);
  for (int round = 0; round < 2; ++round) {
    for (const Genome& genome : someGenomes(50, 1)) {
      expectSame(cached.evaluate({genome})[0], plain.outcomeOf(canonical(genome)));
    }
  }
  EXPECT_EQ(cached.counts().asked, 100);
  EXPECT_EQ(cached.counts().passed_on, 50);
  EXPECT_EQ(cached.counts().saved(), 50);
}

TEST(CachedEvaluator, AsksOnceForEqualGaitsOfOneBatch) {
  Witness witness;
  CachedEvaluator cached(witness, 0, kGaits);
  Genome genome(16, 0);
  Genome same_gait = genome;
  same_gait[1] = 3;  // phase of a zero amplitude
  const auto outcomes = cached.evaluate({genome, same_gait, genome});
  ASSERT_EQ(outcomes.size(), 3u);
  EXPECT_EQ(witness.candidates, 1);
  expectSame(outcomes[0], outcomes[1]);
}

/// Ends where its genes say, whatever else is the same.
class Numbers : public Evaluator {
 public:
  std::vector<Outcome> evaluate(const std::vector<Genome>& genomes) override {
    std::vector<Outcome> outcomes;
    for (const Genome& genome : genomes) {
      outcomes.push_back({Verdict::kWalked, {1.0 * genome[0], 1.0 * genome[1], 0.0}, 0.0});
    }
    return outcomes;
  }
};

TEST(CachedEvaluator, KeepsGenotypesOfAnotherTaskApart) {
  Numbers numbers;
  CachedEvaluator cached(numbers, 1000, GenomeSpace(2, 101));
  // As gaits the first three would be one, and the last two.
  const std::vector<Genome> genomes = {{0, 0}, {0, 3}, {0, 100}, {7, 4}, {7, 0}};
  for (int round = 0; round < 2; ++round) {
    const std::vector<Outcome> outcomes = cached.evaluate(genomes);
    for (std::size_t i = 0; i < genomes.size(); ++i) {
      EXPECT_EQ(outcomes[i].end_pose.x_m, genomes[i][0]);
      EXPECT_EQ(outcomes[i].end_pose.y_m, genomes[i][1]);
    }
  }
  EXPECT_EQ(cached.counts().passed_on, 5);
}

TEST(CachedEvaluator, MergesGaitsOfMoreLevels) {
  Numbers numbers;
  CachedEvaluator cached(numbers, 1000, gaits(2, 253));
  // Level 4 is a phase of its own, 252 a whole period.
  cached.evaluate({{9, 0}, {9, 252}, {9, 4}, {0, 17}, {0, 0}});
  EXPECT_EQ(cached.counts().passed_on, 3);
}

TEST(CachedEvaluator, AnswersForAllMirrorImagesFromOneSimulation) {
  Witness witness;
  CachedEvaluator cached(witness, 1000, kGaits, mirrors());
  for (const Genome& genome : someGenomes(20, 2)) {
    const std::int64_t before = cached.counts().passed_on;
    const Outcome outcome = cached.evaluate({genome})[0];
    for (const Symmetry& mirror : mirrors()) {
      expectSame(cached.evaluate({mirror.image(genome)})[0], mirror.image(outcome));
    }
    EXPECT_EQ(cached.counts().passed_on, before + 1);
  }
}

TEST(CachedEvaluator, DoesNotDependOnWhatWasAskedBefore) {
  Witness first;
  Witness second;
  CachedEvaluator forward(first, 1000, kGaits, mirrors());
  CachedEvaluator backward(second, 1000, kGaits, mirrors());
  std::vector<Genome> genomes = someGenomes(20, 3);
  for (const Symmetry& mirror : mirrors()) genomes.push_back(mirror.image(genomes[0]));
  std::vector<Genome> reversed(genomes.rbegin(), genomes.rend());
  const auto outcomes = forward.evaluate(genomes);
  const auto others = backward.evaluate(reversed);
  for (std::size_t i = 0; i < genomes.size(); ++i) {
    expectSame(outcomes[i], others[genomes.size() - 1 - i]);
  }
}

TEST(CachedEvaluator, RemembersNoMoreThanItsCapacityAndForgetsTheOldest) {
  Witness witness;
  witness.forgetful = true;
  CachedEvaluator cached(witness, 10, kGaits);
  const auto genomes = someGenomes(11, 4);
  for (const Genome& genome : genomes) cached.evaluate({genome});
  EXPECT_EQ(cached.size(), 10u);
  cached.evaluate({genomes[1]});
  EXPECT_EQ(cached.counts().passed_on, 11);
  expectSame(cached.evaluate({genomes[0]})[0],
             AnalyticEvaluator(7, 16).outcomeOf(canonical(genomes[0])));
  EXPECT_EQ(cached.counts().passed_on, 12);
}

TEST(CachedEvaluator, CachesSecondLooksTooAndHandsThemTheFirst) {
  Witness witness;
  CachedEvaluator cached(witness, 1000, kGaits, mirrors());
  EXPECT_EQ(cached.looks(), 2);
  for (const Genome& genome : someGenomes(20, 5)) {
    const int before = witness.second_looks;
    const auto first = cached.evaluate({genome});
    if (!first[0].walked()) continue;
    const Outcome final = cached.lookAgain(2, {genome}, first)[0];
    // Whichever image was asked moved by 0.1 m to its left.
    EXPECT_NEAR(std::abs(final.end_pose.y_m - first[0].end_pose.y_m), 0.1, 1e-12);
    EXPECT_EQ(final.end_pose.x_m, first[0].end_pose.x_m);
    expectSame(cached.lookAgain(2, {genome}, first)[0], final);
    EXPECT_EQ(witness.second_looks, before + 1);
  }
}

}  // namespace
}  // namespace hexapod
