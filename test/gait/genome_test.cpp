#include "gait/genome.h"

#include <gtest/gtest.h>

#include <set>

#include "gait/gait.h"
#include "gait/random_genome.h"
#include "made_robot.h"

namespace hexapod {
namespace {

TEST(Genome, LevelsAreQuarters) {
  EXPECT_EQ(geneValue(0), 0.0);
  EXPECT_EQ(geneValue(3), 0.75);
  EXPECT_EQ(geneValue(4), 1.0);
}

TEST(Genome, TextRoundTrips) {
  EXPECT_EQ(toString(Genome{0, 1, 2, 3, 4, 0, 0, 4}), "01234004");
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const Genome genome = randomGenome(random);
    EXPECT_EQ(genomeFromString(toString(genome)), genome);
  }
  EXPECT_EQ(genomeFromString(""), Genome{});
}

TEST(Genome, TextRoundTripsForLevelsOfAnyNumber) {
  EXPECT_EQ(toString(Genome{0, 9}), "09");
  EXPECT_EQ(toString(Genome{0, 10, 252}), "x000afc");
  Random random(3);
  for (const std::uint64_t levels : {9u, 10u, 11u, 101u, 253u, 256u}) {
    for (int i = 0; i < 100; ++i) {
      Genome genome(random.below(30));
      for (auto& level : genome) level = static_cast<std::uint8_t>(random.below(levels));
      EXPECT_EQ(genomeFromString(toString(genome)), genome);
    }
  }
}

TEST(Genome, TextThatIsNoGenomeIsRefusedWithItsPosition) {
  const auto said = [](const std::string& text) {
    return complaintOf([&] { genomeFromString(text); });
  };
  EXPECT_NE(said("0123 004").find("position 4"), std::string::npos);
  EXPECT_NE(said("0123400\xff").find("position 7"), std::string::npos);
  EXPECT_NE(said("-1234004").find("position 0"), std::string::npos);
  EXPECT_NE(said("012a").find("position 3"), std::string::npos);
  EXPECT_NE(said("x0a0").find("position 4 its end"), std::string::npos);
  EXPECT_NE(said("x0A").find("position 2"), std::string::npos);
}

TEST(Genome, MoreLevelsAreFinerStepsOfTheSameValues) {
  EXPECT_EQ(geneValue(63, 253), 0.25);
  EXPECT_EQ(geneValue(252, 253), 1.0);
  EXPECT_EQ(withLevels({0, 1, 2, 3, 4}, 5, 253), (Genome{0, 63, 126, 189, 252}));
  EXPECT_EQ(withLevels({0, 1, 4}, 5, 5), (Genome{0, 1, 4}));
  EXPECT_THROW(withLevels({0, 1}, 253, 5), std::invalid_argument);
  EXPECT_THROW(withLevels({0, 1}, 9, 13), std::invalid_argument);
  for (const std::int64_t levels : {5, 9, 253}) EXPECT_NO_THROW(requireGeneLevels(levels));
  for (const std::int64_t levels : {-3, 0, 1, 6, 7, 8, 256, 257}) {
    EXPECT_THROW(requireGeneLevels(levels), std::invalid_argument) << levels;
  }
}

TEST(Genome, CanonicalDropsWholePeriodsAndPhasesOfSilence) {
  EXPECT_EQ(canonical(Genome{1, 4, 2, 3}), (Genome{1, 0, 2, 3}));
  EXPECT_EQ(canonical(Genome{0, 3, 0, 4}), (Genome{0, 0, 0, 0}));
  EXPECT_EQ(canonical(Genome{4, 1, 0, 2}), (Genome{4, 1, 0, 0}));
  EXPECT_EQ(canonical(Genome{7, 4, 1, 8, 0, 5}, 9), (Genome{7, 4, 1, 0, 0, 0}));
}

TEST(Genome, CanonicalGenomesAreTheSmallestSetOfDifferentGaits) {
  // One signal: 4 amplitudes of 4 phases and silence are 17 gaits; a leg has two: 17 * 17.
  std::set<Genome> genomes;
  for (std::uint8_t a = 0; a < 5; ++a)
    for (std::uint8_t b = 0; b < 5; ++b)
      for (std::uint8_t c = 0; c < 5; ++c)
        for (std::uint8_t d = 0; d < 5; ++d) genomes.insert(canonical({a, b, c, d}));
  EXPECT_EQ(genomes.size(), 17u * 17u);
}

TEST(Genome, CanonicalIsIdempotentAndKeepsTheGait) {
  const RobotDescription robot = madeRobot(6, 3);
  Random random(2);
  std::vector<double> a;
  std::vector<double> b;
  for (int i = 0; i < 50; ++i) {
    const Genome genome = randomGenome(random);
    const Genome same = canonical(genome);
    EXPECT_EQ(canonical(same), same);
    for (double t : {0.0, 0.03, 0.5, 1.23, 2.97}) {
      Gait(robot, genome).angles(t, a);
      Gait(robot, same).angles(t, b);
      for (std::size_t j = 0; j < a.size(); ++j) EXPECT_NEAR(a[j], b[j], 1e-12);
    }
  }
}

}  // namespace
}  // namespace hexapod
