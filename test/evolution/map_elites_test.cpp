#include "evolution/map_elites.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "analytic_evaluator.h"

namespace hexapod {
namespace {

constexpr double kCell_m = 0.1;

/// Remembers all it was asked.
class Witness : public AnalyticEvaluator {
 public:
  std::vector<Outcome> evaluate(const std::vector<Genome>& genomes) override {
    const std::vector<Outcome> outcomes = AnalyticEvaluator::evaluate(genomes);
    seen.insert(seen.end(), outcomes.begin(), outcomes.end());
    return outcomes;
  }
  std::vector<Outcome> seen;
};

MapElites after(std::int64_t generations, Evaluator& evaluator, std::uint64_t seed = 1) {
  MapElites elites({}, 24, gridCells(kCell_m), Random(seed));
  for (std::int64_t i = 0; i < generations; ++i) advance(elites, evaluator);
  return elites;
}

std::pair<long, long> cellOf(const Pose2& end) {
  return {std::lround(end.x_m / kCell_m), std::lround(end.y_m / kCell_m)};
}

TEST(MapElites, KeepsTheBestAlignedOfEachCell) {
  Witness evaluator;
  const std::vector<Entry> elites = after(20, evaluator).entries();
  std::map<std::pair<long, long>, double> best_rad;  // by brute force over all that was seen
  for (const Outcome& outcome : evaluator.seen) {
    if (!outcome.walked()) continue;
    const auto cell = best_rad.emplace(cellOf(outcome.end_pose), outcome.cost);
    cell.first->second = std::min(cell.first->second, outcome.cost);
  }
  ASSERT_EQ(elites.size(), best_rad.size());
  for (const Entry& elite : elites) {
    EXPECT_EQ(elite.cost, best_rad.at(cellOf(elite.end_pose)));
  }
}

TEST(MapElites, CountsCandidatesAndCutsTheLastGeneration) {
  AnalyticEvaluator evaluator;
  MapElites elites({}, 24, gridCells(kCell_m), Random(1));
  advance(elites, evaluator, 1000);
  advance(elites, evaluator, 30);
  EXPECT_EQ(elites.counters().evaluations, 130);
  EXPECT_EQ(evaluator.candidates, 130);
}

TEST(MapElites, GivesTheSameForTheSameSeed) {
  AnalyticEvaluator evaluator;
  const auto once = after(10, evaluator, 4).entries();
  const auto again = after(10, evaluator, 4).entries();
  ASSERT_EQ(once.size(), again.size());
  for (std::size_t i = 0; i < once.size(); ++i) EXPECT_EQ(once[i].genome, again[i].genome);
}

}  // namespace
}  // namespace hexapod
