#include "tools/bench_agreement.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <string>

#include "common/text.h"
#include "evaluation/behavior_evaluator.h"
#include "evaluation/verify.h"
#include "evolution/br_evolution.h"

namespace hexapod {

const char* const kAgreementHeading =
    "| robot, step | controllers | failed in ODE | verdicts differ | end pose: median | 99 % | "
    "99.9 % | largest | heading: median | 99 % | 99.9 % | largest |\n"
    "|---|---|---|---|---|---|---|---|---|---|---|---|\n";

namespace {

constexpr std::size_t kAtOnce = 500;

/// Passes candidates on and remembers them.
class Recorder : public Evaluator {
 public:
  explicit Recorder(Evaluator& evaluator) : evaluator_(&evaluator) {}

  std::vector<Outcome> evaluate(const std::vector<Genome>& genomes) override {
    for (const Genome& genome : genomes) asked_.push_back(canonical(genome));
    return evaluator_->evaluate(genomes);
  }

  const std::vector<Genome>& asked() const { return asked_; }

 private:
  Evaluator* evaluator_;
  std::vector<Genome> asked_;
};

std::vector<Genome> evolvedCandidates(const BenchCase& bench_case, std::size_t count,
                                      std::uint64_t seed, int threads) {
  BehaviorEvaluator evaluator(
      std::make_shared<WorldPool>(Engine::kReduced, bench_case.robot, bench_case.physics, threads),
      BehaviorOptions());
  Recorder recorder(evaluator);
  BrEvolution evolution(EvolutionOptions(), bench_case.robot.geneCount(), Random(seed));
  while (recorder.asked().size() < 2 * count + 2000) advance(evolution, recorder);
  return {recorder.asked().rbegin(), recorder.asked().rend()};
}

void add(const Genome& genome, const End& ode, const End& reduced, Agreement& agreement) {
  ++agreement.compared;
  agreement.failed += ode.verdict != Verdict::kWalked;
  if (ode.verdict != reduced.verdict) {
    agreement.verdicts.push_back(toString(genome) + ": " + toString(ode.verdict) + " in ODE, " +
                                 toString(reduced.verdict) + " in reduced");
  } else if (ode.verdict == Verdict::kWalked) {
    agreement.apart_m.push_back(distance(ode.pose, reduced.pose));
    agreement.apart_rad.push_back(headingDistance(ode.pose, reduced.pose));
  }
}

/// The median, 99 %, 99.9 % and the largest of ascending values, in thousandths.
void addDistribution(const std::vector<double>& values, const std::string& unit,
                     std::vector<std::string>& cells) {
  for (const double share : {0.5, 0.99, 0.999, 1.0}) {
    if (values.empty()) {
      cells.emplace_back("-");
      continue;
    }
    const auto rank = static_cast<std::size_t>(std::ceil(share * values.size()));
    cells.push_back(numberText(1000.0 * values[std::max<std::size_t>(rank, 1) - 1], 2) + unit);
  }
}

}  // namespace

std::vector<Genome> mixedControllers(const BenchCase& bench_case, std::size_t count,
                                     std::uint64_t seed, int threads) {
  std::vector<Genome> genomes;
  std::set<Genome> known;
  const auto take = [&](const std::vector<Genome>& from, std::size_t until) {
    for (const Genome& genome : from) {
      if (genomes.size() < until && known.insert(genome).second) genomes.push_back(genome);
    }
  };
  take(evolvedCandidates(bench_case, count / 2, seed, threads), count / 2);
  take(randomGenomes(2 * count, bench_case.robot.geneCount(), seed), count);
  return genomes;
}

Agreement compareEngines(const BenchCase& bench_case, const std::vector<Genome>& genomes,
                         int threads, const AgreementProgress& progress) {
  const auto ode =
      std::make_shared<WorldPool>(Engine::kOde, bench_case.robot, bench_case.physics, threads);
  const auto reduced =
      std::make_shared<WorldPool>(Engine::kReduced, bench_case.robot, bench_case.physics, threads);
  Agreement agreement;
  // Every part is as mixed as the whole.
  const std::size_t parts = (genomes.size() + kAtOnce - 1) / kAtOnce;
  for (std::size_t part = 0; part < parts; ++part) {
    std::vector<Genome> some;
    for (std::size_t i = part; i < genomes.size(); i += parts) some.push_back(genomes[i]);
    const std::vector<End> expected = playFromTheStand(ode, BehaviorOptions(), some);
    const std::vector<End> found = playFromTheStand(reduced, BehaviorOptions(), some);
    for (std::size_t i = 0; i < some.size(); ++i) add(some[i], expected[i], found[i], agreement);
    std::sort(agreement.apart_m.begin(), agreement.apart_m.end());
    std::sort(agreement.apart_rad.begin(), agreement.apart_rad.end());
    if (progress) progress(agreement);
  }
  return agreement;
}

std::string describe(const std::string& name, const Agreement& agreement) {
  std::vector<std::string> cells = {name, std::to_string(agreement.compared),
                                    std::to_string(agreement.failed),
                                    std::to_string(agreement.verdicts.size())};
  addDistribution(agreement.apart_m, " mm", cells);
  addDistribution(agreement.apart_rad, " mrad", cells);
  return tableRow(cells);
}

}  // namespace hexapod
