#include "evolution/nsga2.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexapod {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// On a small lattice, so that equal objectives and equal points abound; with `axes` 2 the third
/// objective plays no part.
std::vector<Objectives> latticeObjectives(std::size_t count, std::uint64_t levels, Random& random,
                                          std::size_t axes = 3) {
  std::vector<Objectives> objectives(count, {0.0, 0.0, 0.0});
  for (Objectives& point : objectives) {
    for (std::size_t axis = 0; axis < axes; ++axis) {
      point[axis] = static_cast<double>(random.below(levels));
    }
  }
  return objectives;
}

/// The definition: a front is what nobody left dominates.
std::vector<Front> frontsByDefinition(const std::vector<Objectives>& objectives) {
  std::vector<Front> fronts;
  std::vector<bool> placed(objectives.size(), false);
  while (std::count(placed.begin(), placed.end(), false) > 0) {
    Front front;
    for (std::size_t i = 0; i < objectives.size(); ++i) {
      bool dominated = placed[i];
      for (std::size_t j = 0; j < objectives.size() && !dominated; ++j) {
        dominated = !placed[j] && dominates(objectives[j], objectives[i]);
      }
      if (!dominated) front.push_back(i);
    }
    for (const std::size_t i : front) placed[i] = true;
    fronts.push_back(front);
  }
  return fronts;
}

TEST(NonDominatedFronts, AreThoseOfTheDefinition) {
  Random random(1);
  for (const std::uint64_t levels : {1U, 2U, 5U, 15U, 1000U}) {
    for (const std::size_t count : {0U, 1U, 2U, 15U, 200U}) {
      for (std::size_t trial = 0; trial < 6; ++trial) {
        const auto objectives = latticeObjectives(count, levels, random, 2 + trial % 2);
        ASSERT_EQ(nonDominatedFronts(objectives), frontsByDefinition(objectives));
      }
    }
  }
}

TEST(NonDominatedFronts, PutFailuresLastAndTakeInfinityAsBest) {
  const std::vector<Objectives> objectives{
      {-1.0, -1.0}, {kInfinity, 0.0}, {0.0, 0.0}, {-1.0, -1.0}};
  EXPECT_EQ(nonDominatedFronts(objectives), (std::vector<Front>{{1}, {2}, {0, 3}}));
}

TEST(Dominates, NeedsOneStrictlyBetterObjectiveAndNoneWorse) {
  EXPECT_TRUE(dominates({1.0, 1.0}, {1.0, 0.0}));
  EXPECT_FALSE(dominates({1.0, 1.0}, {1.0, 1.0}));
  EXPECT_FALSE(dominates({2.0, 0.0}, {1.0, 1.0}));
  EXPECT_TRUE(dominates({1.0, 1.0, 0.0}, {1.0, 1.0, -1.0}));
  EXPECT_FALSE(dominates({2.0, 2.0, -1.0}, {1.0, 1.0, 0.0}));
}

TEST(CrowdingDistances, AreTheNormalisedGapsAroundEachMember) {
  // Along the first objective 0, 1, 4, 10 (range 10), along the second 8, 6, 5, 0 (range 8).
  const std::vector<Objectives> objectives{{0.0, 8.0}, {4.0, 5.0}, {1.0, 6.0}, {10.0, 0.0}};
  const auto distances = crowdingDistances(objectives, {0, 1, 2, 3});
  EXPECT_EQ(distances[0], kInfinity);
  EXPECT_EQ(distances[3], kInfinity);
  EXPECT_DOUBLE_EQ(distances[1], (10.0 - 1.0) / 10.0 + (6.0 - 0.0) / 8.0);
  EXPECT_DOUBLE_EQ(distances[2], (4.0 - 0.0) / 10.0 + (8.0 - 5.0) / 8.0);
}

/// The sum over all objectives of the gap between the next smaller and the next larger value over
/// the range, infinite where there is none; all values differ.
double crowdingByBruteForce(const std::vector<Objectives>& objectives, std::size_t member) {
  double sum = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double own = objectives[member][axis];
    double below = -1.0, above = 2.0, least = 2.0, largest = -1.0;
    for (const Objectives& other : objectives) {
      const double value = other[axis];
      if (value < own) below = std::max(below, value);
      if (value > own) above = std::min(above, value);
      least = std::min(least, value);
      largest = std::max(largest, value);
    }
    if (below < 0.0 || above > 1.0) return std::numeric_limits<double>::infinity();
    sum += (above - below) / (largest - least);
  }
  return sum;
}

TEST(CrowdingDistances, AreThoseOfBruteForce) {
  Random random(5);
  std::vector<Objectives> objectives;
  Front front;
  for (std::size_t i = 0; i < 60; ++i) {
    objectives.push_back({random.uniform(), random.uniform(), random.uniform()});
    front.push_back(i);
  }
  const std::vector<double> distances = crowdingDistances(objectives, front);
  for (const std::size_t i : front) {
    EXPECT_DOUBLE_EQ(distances[i], crowdingByBruteForce(objectives, i));
  }
}

TEST(CrowdingDistances, LookAtTheMembersOfTheFrontOnly) {
  const std::vector<Objectives> objectives{{0.0, 2.0}, {5.0, 5.0}, {1.0, 1.0}, {2.0, 0.0}};
  const auto distances = crowdingDistances(objectives, {0, 2, 3});
  EXPECT_DOUBLE_EQ(distances[1], 2.0);
}

TEST(CrowdingDistances, AreNumbersWhateverTheFront) {
  Random random(2);
  for (const std::uint64_t levels : {1U, 3U}) {
    const auto objectives = latticeObjectives(30, levels, random);
    for (const Front& front : nonDominatedFronts(objectives)) {
      for (const double value : crowdingDistances(objectives, front)) {
        EXPECT_FALSE(std::isnan(value));
      }
    }
  }
  for (const double value :
       crowdingDistances({{kInfinity, 0.0}, {1.0, 1.0}, {0.0, 2.0}}, {0, 1, 2})) {
    EXPECT_FALSE(std::isnan(value));
  }
  EXPECT_TRUE(crowdingDistances({}, {}).empty());
}

TEST(GenotypicDiversities, AreTheMeanNumbersOfDifferingGenesByBruteForce) {
  Random random(3);
  std::vector<Genome> genomes(60, Genome(24));
  for (Genome& genome : genomes) {
    for (auto& level : genome) level = static_cast<std::uint8_t>(random.below(kGeneLevels));
  }
  genomes[7] = genomes[3];
  Front front;
  for (std::size_t i = 0; i < genomes.size(); i += 2) front.push_back(i);
  front.push_back(7);
  front.push_back(3);
  const auto diversities = genotypicDiversities(genomes, front);
  for (std::size_t k = 0; k < front.size(); ++k) {
    double differences = 0.0;
    for (const std::size_t other : front) {
      for (std::size_t gene = 0; gene < 24; ++gene) {
        differences += genomes[front[k]][gene] != genomes[other][gene] ? 1.0 : 0.0;
      }
    }
    EXPECT_DOUBLE_EQ(diversities[k], differences / static_cast<double>(front.size() - 1));
  }
}

TEST(GenotypicDiversities, OfOneAloneIsZero) {
  EXPECT_EQ(genotypicDiversities({{1, 2}, {3, 4}}, {1}), std::vector<double>{0.0});
  EXPECT_TRUE(genotypicDiversities({}, {}).empty());
}

TEST(Tournament, PrefersLowerRankThenLargerDiversity) {
  EXPECT_TRUE(isBetter({0, 1.0}, {1, 9.0}));
  EXPECT_TRUE(isBetter({1, 9.0}, {1, 8.0}));
  EXPECT_FALSE(isBetter({1, 8.0}, {1, 8.0}));
  Random random(4);
  const std::vector<Standing> standings{{1, 0.0}, {0, 1.0}, {0, 2.0}};
  std::vector<int> wins(standings.size(), 0);
  for (int i = 0; i < 9000; ++i) ++wins[tournament(standings, random)];
  // Of the nine pairs the best wins five, the second three, the third only the one against itself.
  EXPECT_NEAR(wins[2], 5000, 200);
  EXPECT_NEAR(wins[1], 3000, 200);
  EXPECT_NEAR(wins[0], 1000, 200);
}

}  // namespace
}  // namespace hexapod
