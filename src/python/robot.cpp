#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>

#include "gait/behavior.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/keywords.h"
#include "robot/load_robot.h"

namespace py = pybind11;

namespace hexapod {
namespace {

py::array_t<double> commands(const RobotDescription& robot, const py::array& genome,
                             const py::kwargs& keywords) {
  BehaviorOptions options;
  applyKeywords(declareOptions(options), keywords, "commands");
  const std::vector<Genome> genomes = genomesFrom(genome.attr("reshape")(1, -1));
  const Behavior behavior(robot, genomes[0], options);
  py::array_t<double> array(
      std::vector<py::ssize_t>{static_cast<py::ssize_t>(behavior.commandCount()),
                               static_cast<py::ssize_t>(robot.jointCount())});
  double* next = array.mutable_data();
  for (std::size_t k = 0; k < behavior.commandCount(); ++k) {
    const std::vector<double>& command = behavior.command(k);
    next = std::copy(command.begin(), command.end(), next);
  }
  return array;
}

}  // namespace

void bindRobot(py::module& module) {
  py::class_<RobotDescription>(module, "Robot", "A robot as its URDF and YAML describe it.")
      .def_readonly("name", &RobotDescription::name)
      .def_readonly("digest", &RobotDescription::digest, "Robot id, as repertoire files have it.")
      .def_readonly("remarks", &RobotDescription::remarks,
                    "What the files say and was taken otherwise, a sentence each.")
      .def_property_readonly(
          "gene_count", &RobotDescription::geneCount,
          "Number of genes of a gait: an amplitude and a phase for each signal of each leg.")
      .def_property_readonly("joint_names", &RobotDescription::jointNames,
                             "In the order of commands().")
      .def_property_readonly("neutral_pose", &RobotDescription::neutralPose,
                             "Angle of each joint in the neutral pose [rad].");
  module.def("load_robot", &loadRobot, py::arg("urdf_file"), py::arg("yaml_file"));
  module.def("commands", &commands, py::arg("robot"), py::arg("genome"),
             R"(The joint commands of a genome's behaviour: gait, way back, rest.

Args:
    robot: A Robot.
    genome: Its genes, shape (genes,), integers 0 .. gene_levels - 1.
    **options: gait_duration_s, command_period_s, return_duration_s, rest_duration_s, end_pose,
        limit_velocity, gene_levels, as the learner has them (doc/options.md).

Returns:
    Joint angles [rad], shape (commands, joints); command k is sent at k * command_period_s.

Raises:
    ValueError: Genome or options do not fit the robot or each other.)");
}

}  // namespace hexapod
