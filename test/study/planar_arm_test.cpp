// The example of doc/another_task.md: other genotypes, another behaviour, another quality.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "repertoire/metrics.h"
#include "study/methods.h"

namespace hexapod {
namespace {

// [the task]
/// A planar arm of eight links of 8 cm. Each joint is at one of 101 angles in -90 .. 90 degrees;
/// the tip's position is what is to be new, and the more evenly the arm bends the better.
class PlanarArm : public Evaluator {
 public:
  static GenomeSpace genotypes() { return GenomeSpace(8, 101); }

  std::vector<Outcome> evaluate(const std::vector<Genome>& genomes) override {
    std::vector<Outcome> outcomes;
    for (const Genome& genome : genomes) outcomes.push_back(outcomeOf(genome));
    return outcomes;
  }

 private:
  static Outcome outcomeOf(const Genome& genome) {
    double heading_rad = 0.0;
    double squares = 0.0;
    Pose2 tip;
    for (const auto level : genome) {
      const double angle_rad = M_PI * (level / 100.0 - 0.5);
      heading_rad += angle_rad;
      squares += angle_rad * angle_rad;
      tip.x_m += 0.08 * std::cos(heading_rad);
      tip.y_m += 0.08 * std::sin(heading_rad);
    }
    const auto joints = static_cast<double>(genome.size());
    const double mean_rad = heading_rad / joints;
    return {Verdict::kWalked, tip,
            std::sqrt(std::max(0.0, squares / joints - mean_rad * mean_rad))};
  }
};
// [the task]

double sparseness_m(const std::vector<Entry>& entries) {
  return measure(learnedEndings(entries)).sparseness_m;
}

double medianUnevenness(const std::vector<Entry>& entries) {
  std::vector<double> values;
  for (const Entry& entry : entries) values.push_back(entry.cost);
  return *median(values);
}

TEST(AnotherTask, IsLearnedByEveryAlgorithm) {
  for (const std::string& name : methodNames()) {
    // [the run]
    PlanarArm arm;
    StudyOptions options;
    options.evolution.novelty_threshold_m = 0.03;
    options.targets = 20;
    const Method method = makeMethod(name, PlanarArm::genotypes(), options, Random(1));
    while (method.algorithm->counters().evaluations < 20000) advance(*method.algorithm, arm);
    // [the run]
    const Method young = makeMethod(name, PlanarArm::genotypes(), options, Random(1));
    // A generation for every target.
    while (young.algorithm->counters().evaluations < 2000) advance(*young.algorithm, arm);
    for (const auto& [repertoire, entries] : method.repertoires()) {
      ASSERT_FALSE(entries.empty()) << repertoire;
      const std::vector<Entry> before = young.repertoires().at(repertoire);
      EXPECT_LT(sparseness_m(entries), 1.05 * sparseness_m(before)) << repertoire;
      if (repertoire == "nearest") {  // does not look at the quality
        EXPECT_LT(sparseness_m(entries), sparseness_m(before));
        continue;
      }
      EXPECT_LT(medianUnevenness(entries), medianUnevenness(before)) << repertoire;
    }
  }
}

TEST(AnotherTask, TellsOfGenotypesThatCannotBe) {
  for (const std::size_t levels : {0, 257}) {
    EXPECT_THROW(makeMethod("map_elites", GenomeSpace(8, levels), {}, Random(1)),
                 std::invalid_argument);
  }
}

}  // namespace
}  // namespace hexapod
