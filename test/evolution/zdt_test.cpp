// NSGA-II on problems whose Pareto fronts are known (Zitzler, Deb & Thiele 2000), to be minimised.
#include <gtest/gtest.h>

#include <cmath>

#include "evolution/target_evolution.h"

namespace hexapod {
namespace {

constexpr std::size_t kVariables = 10;
constexpr std::size_t kLevels = 101;  // of a variable in 0 .. 1

/// The first objective is the distance from the target in the origin, the second the orientation
/// error; h tells the problem.
class Zdt : public Evaluator {
 public:
  using Shape = double (*)(double f1, double g);
  explicit Zdt(Shape shape) : shape_(shape) {}

  std::vector<Outcome> evaluate(const std::vector<Genome>& genomes) override {
    std::vector<Outcome> outcomes;
    for (const Genome& genome : genomes) {
      double sum = 0.0;
      for (std::size_t i = 1; i < genome.size(); ++i) sum += 0.01 * genome[i];
      const double g = 1.0 + 9.0 * sum / static_cast<double>(kVariables - 1);
      const double f1 = 0.01 * genome[0];
      outcomes.push_back({Verdict::kWalked, {f1, 0.0, 0.0}, g * shape_(f1, g)});
    }
    return outcomes;
  }

 private:
  Shape shape_;
};

double zdt1(double f1, double g) { return 1.0 - std::sqrt(f1 / g); }
double zdt2(double f1, double g) { return 1.0 - (f1 / g) * (f1 / g); }

class KnownFront : public testing::TestWithParam<Zdt::Shape> {};

TEST_P(KnownFront, IsReachedAndCovered) {
  Zdt problem(GetParam());
  EvolutionOptions options;
  options.mutation_rate = 0.1;
  TargetEvolution evolution(options, GenomeSpace(kVariables, kLevels), Random(1), {0.0, 0.0});
  for (int generation = 0; generation < 600; ++generation) advance(evolution, problem);
  double sum = 0.0;
  std::vector<bool> covered(10, false);
  for (const Individual& individual : evolution.population()) {
    const double f1 = individual.outcome.end_pose.x_m;
    sum += individual.outcome.cost - GetParam()(f1, 1.0);
    covered[std::min<std::size_t>(9, static_cast<std::size_t>(10.0 * f1))] = true;
  }
  // Mean distance above the front, of whose range each tenth has somebody.
  EXPECT_LT(sum / static_cast<double>(evolution.population().size()), 0.05);
  for (std::size_t tenth = 0; tenth < covered.size(); ++tenth) EXPECT_TRUE(covered[tenth]) << tenth;
}

INSTANTIATE_TEST_SUITE_P(Zdt, KnownFront, testing::Values(zdt1, zdt2));

}  // namespace
}  // namespace hexapod
