#include "tools/bench_evolution.h"

#include <string>
#include <vector>

#include "common/text.h"
#include "evolution/br_evolution.h"
#include "tools/bench_cases.h"
#include "tools/bench_machine.h"
#include "tools/machine.h"

namespace hexapod {

const char* const kEvolutionHeading =
    "| archive | evolution, ms per generation | its share beside 100 evaluations | peak memory so "
    "far |\n"
    "|---|---|---|---|\n";

namespace {

constexpr double kMeasuringTime_s = 1.0;

/// Ends anywhere on the disc, at no cost.
class Lottery : public Evaluator {
 public:
  std::vector<Outcome> evaluate(const std::vector<Genome>& genomes) override {
    std::vector<Outcome> outcomes;
    for (std::size_t i = 0; i < genomes.size(); ++i) outcomes.push_back(anywhere(random_));
    return outcomes;
  }

 private:
  Random random_{2};
};

}  // namespace

GenerationCost measureGeneration(std::size_t archive, std::size_t gene_count) {
  Lottery evaluator;
  BrEvolution young(EvolutionOptions(), gene_count, Random(1));
  for (int generation = 0; generation < 3; ++generation) advance(young, evaluator);
  EvolutionState state = young.state();
  state.archive = spreadArchive(archive, gene_count);
  BrEvolution evolution(EvolutionOptions(), gene_count, state);
  advance(evolution, evaluator);
  GenerationCost cost;
  cost.archive = archive;
  cost.candidates = static_cast<std::size_t>(EvolutionOptions().candidatesPerGeneration());
  const double begin_s = threadCpu_s();
  int generations = 0;
  for (; threadCpu_s() - begin_s < kMeasuringTime_s; ++generations) advance(evolution, evaluator);
  cost.cpu_s = (threadCpu_s() - begin_s) / generations;
  cost.peak_memory_mb = peakMemory_mb();
  return cost;
}

std::string describe(const GenerationCost& cost, double evaluation_cpu_s) {
  const double simulation_s = static_cast<double>(cost.candidates) * evaluation_cpu_s;
  return tableRow({std::to_string(cost.archive), fixedText(1e3 * cost.cpu_s, 2),
                   fixedText(100.0 * cost.cpu_s / (cost.cpu_s + simulation_s), 2) + " %",
                   fixedText(cost.peak_memory_mb, 0) + " MB"});
}

}  // namespace hexapod
