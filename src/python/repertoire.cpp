#include <pybind11/stl.h>

#include "python/arrays.h"
#include "python/bindings.h"
#include "repertoire/repertoire_file.h"

namespace py = pybind11;

namespace hexapod {
namespace {

py::array_t<std::uint8_t> genomesOfEntries(const Repertoire& repertoire) {
  const std::vector<Genome> genomes = genomesOf(repertoire.entries);
  return arrayOf(genomes, genomes.empty() ? 0 : genomes[0].size());
}

/// `path`: a text or a pathlib.Path.
Repertoire load(const py::object& path) {
  const auto file = py::module::import("os").attr("fspath")(path).cast<std::string>();
  const py::gil_scoped_release released;
  return loadRepertoire(file);
}

}  // namespace

void bindRepertoire(py::module& module) {
  py::class_<Repertoire>(module, "Repertoire", R"(A learned repertoire, as its file has it.

The arrays are made anew whenever they are asked for: keep them.)")
      .def_readonly("run_id", &Repertoire::run_id)
      .def_readonly("robot_id", &Repertoire::robot_id, "Robot.digest of its robot.")
      .def_readonly("seed", &Repertoire::seed)
      .def_readonly("generation", &Repertoire::generation)
      .def_readonly("evaluations", &Repertoire::evaluations)
      .def_readonly("behavior_duration_s", &Repertoire::behavior_duration_s,
                    "Of every entry, the return to the neutral pose included [s].")
      .def_readonly("joint_names", &Repertoire::joint_names)
      .def_readonly("options", &Repertoire::options, "The options of the run, by name, as text.")
      .def_readonly("facts", &Repertoire::facts, "What else is known of it, by name, as text.")
      .def_property_readonly(
          "entries", [](const Repertoire& repertoire) { return arrayOf(repertoire.entries); },
          R"(The entries by id: structured array of shape (n,) with the fields

id; x_m, y_m, yaw_rad: end pose as learned, in the start frame; orientation_error_rad: of that pose;
cost: what the entry won its place with; evaluation: number of its candidate; executed_x_m,
executed_y_m, executed_yaw_rad: mean end pose after random predecessors; spread_m, spread_rad: root
mean square distance from that; trials, falls. The last seven are NaN or 0 until validated.)")
      .def_property_readonly("genomes", &genomesOfEntries,
                             "Genes of each entry, shape (n, genes), uint8, 0 .. gene_levels - 1.")
      .def_property_readonly("gene_levels", &Repertoire::geneLevels,
                             "What Simulation and commands() play its genomes with.")
      .def_property_readonly(
          "history", [](const Repertoire& repertoire) { return arrayOf(repertoire.history); },
          R"(Structured array of shape (rows,), a row about every 1000 evaluations: evaluations,
archive_size, sparseness_m, median_orientation_error_rad, max_reach_m, elapsed_s.)")
      .def("__len__", [](const Repertoire& repertoire) { return repertoire.entries.size(); });
  module.def("load", &load, py::arg("file"), R"(Reads a repertoire file.

Args:
    file: Path of a file that the learner, evolve or the demonstration wrote.

Returns:
    A Repertoire.

Raises:
    ValueError: The file is missing, damaged, another program's or of another version.)");
}

}  // namespace hexapod
