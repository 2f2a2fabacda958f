#include "evolution/neighbourhood.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "analytic_evaluator.h"
#include "gait/random_genome.h"

namespace hexapod {
namespace {

/// eq. 1 and 2 over the set of controllers, without any index.
Objectives byDefinition(const Individual& self, const std::vector<Entry>& archive,
                        const std::vector<Individual>& pool, std::size_t neighbours,
                        double heading_m_per_rad = 0.0) {
  std::map<Genome, Entry> controllers;
  for (const Individual& individual : pool) {
    if (individual.outcome.walked()) {
      const auto [found, is_new] = controllers.insert({individual.genome, entryOf(individual)});
      if (!is_new && individual.id < found->second.id) found->second = entryOf(individual);
    }
  }
  for (const Entry& entry : archive) controllers[entry.genome] = entry;
  controllers.erase(self.genome);
  std::vector<std::tuple<double, std::int64_t, double>> others;
  for (const auto& [genome, entry] : controllers) {
    const double dx = entry.end_pose.x_m - self.outcome.end_pose.x_m;
    const double dy = entry.end_pose.y_m - self.outcome.end_pose.y_m;
    const double turn_m =
        heading_m_per_rad * wrapAngle(entry.end_pose.yaw_rad - self.outcome.end_pose.yaw_rad);
    others.emplace_back(dx * dx + dy * dy + turn_m * turn_m, entry.id, entry.cost);
  }
  std::sort(others.begin(), others.end());
  others.resize(std::min(others.size(), neighbours));
  Objectives result{0.0, 0.0, 0.0};
  for (const auto& [squared_m2, id, error_rad] : others) {
    result[0] += std::sqrt(squared_m2);
    result[1] += error_rad > self.outcome.cost ? 1.0 : 0.0;
  }
  result[0] /= static_cast<double>(others.size());
  return result;
}

class NeighbourhoodOf : public ::testing::Test {
 protected:
  Individual born(const Genome& genome) {
    const std::int64_t id = next_id_++;
    return {id, id, genome, genome, evaluator_.outcomeOf(genome), {}, true};
  }
  std::vector<Individual> randomPool(std::size_t count) {
    std::vector<Individual> pool;
    for (std::size_t i = 0; i < count; ++i) pool.push_back(born(canonical(randomGenome(random_))));
    return pool;
  }

  Individual at(double x_m, double error_rad) {
    const std::int64_t id = next_id_++;
    const Genome genome = canonical(randomGenome(random_));
    return {id, id, genome, genome, {Verdict::kWalked, {x_m, 0.0, 0.0}, error_rad}, {}, true};
  }

  AnalyticEvaluator evaluator_;
  Random random_{5};
  std::int64_t next_id_ = 1;
};

TEST_F(NeighbourhoodOf, APoolWithDuplicatesAndArchiveCopiesIsThatOfTheSet) {
  for (const double heading_m_per_rad : {0.0, 0.2}) {
    std::vector<Individual> pool = randomPool(120);
    Archive archive(PoseMetric{heading_m_per_rad});
    for (const Individual& individual : randomPool(300)) {
      if (individual.outcome.walked()) archive.offer(entryOf(individual), 1.0, 0.1);
    }
    for (std::size_t i = 0; i < 20; ++i) {
      if (pool[i].outcome.walked()) archive.offer(entryOf(pool[i]), 1.0, 0.1);
      pool.push_back(born(pool[i + 30].genome));
    }
    for (const std::size_t neighbours : {1U, 15U, 10000U}) {
      const Neighbourhood neighbourhood(archive, pool, neighbours);
      for (const Individual& individual : pool) {
        if (!individual.outcome.walked()) continue;
        const auto expected =
            byDefinition(individual, archive.entries(), pool, neighbours, heading_m_per_rad);
        const auto found = neighbourhood.objectives(individual);
        ASSERT_NEAR(found[0], expected[0], 1e-12);
        ASSERT_EQ(found[1], expected[1]);
      }
    }
  }
}

TEST_F(NeighbourhoodOf, AGenerationFollowsWhatMovesBetweenPoolAndArchive) {
  std::vector<Individual> pool = randomPool(150);
  Archive archive;
  Neighbourhood neighbourhood(archive, pool, 15);
  int moves = 0;
  for (Individual& individual : pool) {
    if (!individual.outcome.walked()) continue;
    const OfferResult result = archive.offer(entryOf(individual), random_.uniform(0.0, 0.2), 0.1);
    if (result.status == AddStatus::kRejected) continue;
    ++moves;
    neighbourhood.moveToArchive(individual, result.displaced);
    if (result.displaced) {
      const Entry& left = *result.displaced;
      individual = {left.id,
                    left.evaluation,
                    left.genome,
                    left.genome,
                    {Verdict::kWalked, left.end_pose, left.cost},
                    {},
                    true};
      neighbourhood.moveToPool(individual);
    }
    const auto expected = byDefinition(individual, archive.entries(), pool, 15);
    ASSERT_DOUBLE_EQ(neighbourhood.objectives(individual)[0], expected[0]);
    ASSERT_EQ(neighbourhood.objectives(individual)[1], expected[1]);
  }
  EXPECT_GT(moves, 20);
}

TEST_F(NeighbourhoodOf, ARefreshedViewIsTheOneOfNow) {
  const std::vector<Individual> pool = randomPool(100);
  Archive archive;
  Neighbourhood neighbourhood(archive, pool, 15);
  std::vector<Neighbourhood::View> views;
  for (const Individual& individual : pool) views.push_back(neighbourhood.view(individual));
  int changed = 0, offers = 0;
  for (const Individual& outsider : randomPool(60)) {
    if (!outsider.outcome.walked()) continue;
    const OfferResult result = archive.offer(entryOf(outsider), random_.uniform(0.0, 0.2), 0.1);
    if (result.status == AddStatus::kRejected) continue;
    ++offers;
    neighbourhood.moveToArchive(outsider, result.displaced);
    for (std::size_t i = 0; i < pool.size(); ++i) {
      const Objectives before = views[i].objectives;
      neighbourhood.refresh(pool[i], views[i]);
      ASSERT_EQ(views[i].objectives, neighbourhood.objectives(pool[i]));
      changed += views[i].objectives != before;
    }
  }
  EXPECT_GT(changed, offers);
  EXPECT_LT(changed, 50 * offers);  // most see nothing of it
}

TEST_F(NeighbourhoodOf, ThreeOnALineCountsByHand) {
  const std::vector<Individual> pool{at(0.0, 0.2), at(0.1, 0.3), at(0.4, 0.2)};
  const Archive archive;
  const Neighbourhood neighbourhood(archive, pool, 15);
  // The first is 0.1 and 0.4 from the others; only the second is worse than it.
  EXPECT_DOUBLE_EQ(neighbourhood.objectives(pool[0])[0], (0.1 + 0.4) / 2.0);
  EXPECT_EQ(neighbourhood.objectives(pool[0])[1], 1.0);
  EXPECT_EQ(neighbourhood.objectives(pool[1])[1], 0.0);
}

TEST_F(NeighbourhoodOf, OneAloneIsInfinitelyNovel) {
  const std::vector<Individual> pool{at(0.0, 0.2)};
  const Archive archive;
  EXPECT_TRUE(std::isinf(Neighbourhood(archive, pool, 15).objectives(pool[0])[0]));
}

TEST_F(NeighbourhoodOf, TheFallenHaveNoneAndAreNobodys) {
  std::vector<Individual> pool{at(0.0, 0.2), at(0.1, 0.3)};
  pool[1].outcome = {Verdict::kFell, {}, 0.0};
  const Archive archive;
  const Neighbourhood neighbourhood(archive, pool, 15);
  EXPECT_EQ(neighbourhood.objectives(pool[1]), kFailed);
  EXPECT_TRUE(std::isinf(neighbourhood.objectives(pool[0])[0]));
}

}  // namespace
}  // namespace hexapod
