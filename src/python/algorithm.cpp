#include <pybind11/stl.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "evolution/algorithms.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/keywords.h"

namespace py = pybind11;

namespace hexapod {
namespace {

std::unique_ptr<Generational> make(const std::string& name, const Task& task, std::uint64_t seed,
                                   const py::kwargs& keywords) {
  AlgorithmChoice choice{name, {}, {}};
  std::vector<Option> options = declareOptions(choice.evolution);
  for (const Option& more : declareOptions(choice.map_elites)) options.push_back(more);
  applyKeywords(options, keywords, "Algorithm");
  return makeAlgorithm(choice, task, Random(seed));
}

Task gaitTask(const RobotDescription& robot, std::int64_t gene_levels) {
  requireGeneLevels(gene_levels);
  const auto levels = static_cast<std::size_t>(gene_levels);
  return {gaits(robot.geneCount(), levels), 1, symmetriesOf(robot, levels)};
}

py::array_t<std::uint8_t> ask(Generational& algorithm, std::optional<std::int64_t> most) {
  const Questions& questions =
      algorithm.ask(most.value_or(std::numeric_limits<std::int64_t>::max()));
  return arrayOf(questions.genomes, questions.genomes.at(0).size());
}

py::array_t<std::uint8_t> genomesOfPopulation(const Generational& algorithm) {
  const std::vector<Genome> genomes = genomesOf(algorithm.entries());
  return arrayOf(genomes, genomes.empty() ? 0 : genomes[0].size());
}

}  // namespace

void bindAlgorithm(py::module& module) {
  module.def("algorithm_names", &algorithmNames, "The names that Algorithm knows.");
  py::class_<Generational>(module, "Algorithm", R"(A search for controllers, by ask and tell.

Each ask is answered by a tell, which completes a generation. Same name, task, seed, options and
answers: same entries.

Args:
    name: 'br_evolution', 'map_elites' or 'cvt_map_elites'.
    robot: A Robot whose gaits are searched, its symmetries giving twins (offer_twins), with
    gene_levels: 5 by default, as the learner has it; or
    genes, levels: Genotypes of another task, so many genes of the levels 0 .. levels - 1.
    seed: Of everything random.
    **options: population_size, novelty_threshold_m, mutation_rate, cell_m .. as the learner has
        them (doc/options.md); the defaults are the paper's.

Raises:
    ValueError: An unknown name or option, or a value out of range.)")
      .def(py::init([](const std::string& name, const RobotDescription& robot, std::uint64_t seed,
                       std::int64_t gene_levels, const py::kwargs& keywords) {
             return make(name, gaitTask(robot, gene_levels), seed, keywords);
           }),
           py::arg("name"), py::arg("robot"), py::arg("seed") = 1, py::kw_only(),
           py::arg("gene_levels") = kGeneLevels)
      .def(py::init([](const std::string& name, std::size_t genes, std::size_t levels,
                       std::uint64_t seed, const py::kwargs& keywords) {
             return make(name, GenomeSpace(genes, levels), seed, keywords);
           }),
           py::arg("name"), py::arg("genes"), py::arg("levels"), py::arg("seed") = 1)
      .def("ask", &ask, py::arg("most") = py::none(), R"(The genomes it wants to know about.

The same ones until they are told.

Args:
    most: No more than so many candidates; None: as many as candidates and population_size say.

Returns:
    Shape (n, genes), uint8.)")
      .def(
          "tell",
          [](Generational& algorithm, const py::array& outcomes) {
            algorithm.tell(outcomesFrom(outcomes));
          },
          py::arg("outcomes"), R"(What the genomes of the last ask() do.

Args:
    outcomes: Shape (n,), of outcome_dtype, as Simulation.play() and outcomes() make it.

Raises:
    ValueError: There are more or fewer outcomes than genomes, or nothing was asked.)")
      .def_property_readonly(
          "entries", [](const Generational& algorithm) { return arrayOf(algorithm.entries()); },
          "The controllers found so far: structured array of shape (n,), as Repertoire.entries.")
      .def_property_readonly("genomes", &genomesOfPopulation,
                             "Genes of each entry, shape (n, genes), uint8.")
      .def_property_readonly(
          "evaluations",
          [](const Generational& algorithm) { return algorithm.counters().evaluations; },
          "Candidates so far.")
      .def_property_readonly(
          "generations",
          [](const Generational& algorithm) { return algorithm.counters().generations; })
      .def("__len__", [](const Generational& algorithm) { return algorithm.entries().size(); });
}

}  // namespace hexapod
