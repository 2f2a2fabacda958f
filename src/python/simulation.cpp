#include <pybind11/stl.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "evaluation/behavior_evaluator.h"
#include "evaluation/cached_evaluator.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/keywords.h"
#include "simulation/reduced/batch_rollout.h"

namespace py = pybind11;

namespace hexapod {
namespace {

// A large batch is played in parts, between which Ctrl-C is looked for: some tenths of a second.
constexpr std::size_t kRoundsBetweenLooks = 32;
constexpr std::chrono::milliseconds kBetweenLooks{50};

/// Passes on what Python makes of signals: KeyboardInterrupt. (It delivers them to its main thread
/// alone.)
void lookForSignals() {
  const py::gil_scoped_acquire acquired;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

/// How a Simulation is made, besides robot and physics.
struct SimulationOptions {
  std::string engine = "reduced";
  std::int64_t threads = 0;
  std::int64_t cached_genomes = 300000;
  BehaviorOptions behavior;
};

std::vector<Option> declareOptions(SimulationOptions& options) {
  std::vector<Option> all = {
      option("engine", options.engine, "Simulation engine.", engineNames()),
      option("threads", options.threads, "Threads that simulate; 0: all cores.", 0, 1024),
      option("cached_genomes", options.cached_genomes, "Genomes whose outcomes are remembered.", 0,
             100000000)};
  for (const Option& more : declareOptions(options.behavior)) all.push_back(more);
  return all;
}

SimulationOptions optionsFrom(const py::kwargs& keywords) {
  SimulationOptions options;
  applyKeywords(declareOptions(options), keywords, "Simulation");
  return options;
}

/// Plays genomes for Python. Its threads may call it at once: they take turns.
class Simulation {
 public:
  Simulation(const RobotDescription& robot, const Physics& physics,
             const SimulationOptions& options)
      : choice_(chooseEngine(options.engine, robot)),
        worlds_(std::make_shared<WorldPool>(choice_.engine, robot, physics,
                                            static_cast<int>(options.threads))),
        simulator_(worlds_, options.behavior),
        cached_(simulator_, static_cast<std::size_t>(options.cached_genomes),
                gaitsOf(robot, options.behavior)) {}

  /// To be called without Python's interpreter.
  std::vector<Outcome> play(const std::vector<Genome>& genomes) {
    const std::unique_lock<std::timed_mutex> lock = waitForMyTurn();
    const std::size_t most =
        kRoundsBetweenLooks * runsAtOnce(worlds_->engine()) * static_cast<std::size_t>(threads());
    std::vector<Outcome> outcomes;
    for (std::size_t begin = 0; begin < genomes.size(); begin += most) {
      if (begin > 0) lookForSignals();
      const std::size_t end = std::min(begin + most, genomes.size());
      for (const Outcome& outcome :
           cached_.evaluate({genomes.begin() + static_cast<std::ptrdiff_t>(begin),
                             genomes.begin() + static_cast<std::ptrdiff_t>(end)})) {
        outcomes.push_back(outcome);
      }
      simulations_ = simulator_.counts().simulations;
    }
    return outcomes;
  }

  /// Behaviours simulated so far.
  std::int64_t simulations() const { return simulations_; }
  int threads() const { return worlds_->threads(); }
  const EngineChoice& choice() const { return choice_; }

 private:
  std::unique_lock<std::timed_mutex> waitForMyTurn() {
    std::unique_lock<std::timed_mutex> lock(mutex_, std::defer_lock);
    while (!lock.try_lock_for(kBetweenLooks)) lookForSignals();
    return lock;
  }

  EngineChoice choice_;
  std::shared_ptr<WorldPool> worlds_;
  std::atomic<std::int64_t> simulations_{0};
  std::timed_mutex mutex_;  // whoever uses the evaluators has it
  BehaviorEvaluator simulator_;
  CachedEvaluator cached_;
};

/// The attributes of a Physics by keywords.
Physics physicsFrom(const py::kwargs& keywords) {
  py::object physics = py::cast(Physics());
  for (const auto& [name, value] : keywords) {
    if (!py::hasattr(physics, name)) {
      throw std::invalid_argument("Physics has no '" + name.cast<std::string>() +
                                  "'; help(hexapod_repertoire.Physics) lists what it has.");
    }
    py::setattr(physics, name, value);
  }
  return physics.cast<Physics>();
}

void bindPhysics(py::module& module) {
  py::class_<Physics>(module, "Physics",
                      R"(What can differ from the nominal world. Keywords set the attributes.

Values out of range are refused by the Simulation that is given them.)")
      .def(py::init(&physicsFrom))
      .def_readwrite("step_s", &Physics::step_s,
                     "Step of the integrator [s]; the command period must be a multiple of it.")
      .def_readwrite("gravity_m_per_s2", &Physics::gravity_m_per_s2)
      .def_readwrite("friction_scale", &Physics::friction_scale)
      .def_readwrite("mass_scale", &Physics::mass_scale, "Of every mass and inertia.")
      .def_readwrite("servo_gain_scale", &Physics::servo_gain_scale)
      .def_readwrite("torque_scale", &Physics::torque_scale, "Of every joint's largest torque.")
      .def_readwrite("slope_x_rad", &Physics::slope_x_rad, "The floor rises toward +x [rad].")
      .def_readwrite("slope_y_rad", &Physics::slope_y_rad, "The floor rises toward +y [rad].")
      .def_readwrite("command_latency_s", &Physics::command_latency_s,
                     "Commands act this much later, to the nearest step [s].")
      .def_readwrite("joint_torque_scales", &Physics::joint_torque_scales,
                     "One per joint, beside torque_scale; empty: all 1.");
}

}  // namespace

void bindSimulation(py::module& module) {
  bindPhysics(module);
  py::class_<Simulation>(module, "Simulation", R"(Plays the behaviours of genomes on many threads.

What a genome does depends on the genome alone: neither on the batch nor on the number of threads.
It is what the learner's first look says.

Args:
    robot: A Robot.
    physics: A Physics; nominal by default.
    **options: engine ('reduced' or 'ode'), threads (0: all cores), cached_genomes (gaits whose
        outcomes are remembered, 0: none), and gait_duration_s, command_period_s,
        return_duration_s, rest_duration_s, end_pose, limit_velocity, gene_levels, as the learner
        has them (doc/options.md).

Raises:
    ValueError: Physics or options do not fit the robot or each other.)")
      .def(py::init([](const RobotDescription& robot, const Physics& physics,
                       const py::kwargs& keywords) {
             return std::make_unique<Simulation>(robot, physics, optionsFrom(keywords));
           }),
           py::arg("robot"), py::arg("physics") = Physics())
      .def(
          "play",
          [](Simulation& simulation, const py::array& genomes) {
            const std::vector<Genome> asked = genomesFrom(genomes);
            std::vector<Outcome> outcomes;
            {
              const py::gil_scoped_release released;
              outcomes = simulation.play(asked);
            }
            return arrayOf(outcomes);
          },
          py::arg("genomes"), R"(Plays each genome's behaviour once, from the settled stand.

Other threads go on meanwhile; Ctrl-C ends it within some tenths of a second.

Args:
    genomes: Shape (n, genes), integers 0 .. gene_levels - 1.

Returns:
    Structured array of shape (n,), of outcome_dtype: verdict (WALKED, FELL, SELF_COLLIDED or
    DIVERGED); x_m, y_m, yaw_rad: end pose in the start frame, 0 unless it walked; cost: the end
    pose's orientation error [rad].

Raises:
    ValueError: A genome is not one of the robot's.)")
      .def_property_readonly("simulations", &Simulation::simulations,
                             "Behaviours simulated so far; gaits that were known are not.")
      .def_property_readonly("threads", &Simulation::threads)
      .def_property_readonly(
          "engine", [](const Simulation& self) { return toString(self.choice().engine); },
          "'reduced' or 'ode'.")
      .def_property_readonly(
          "remark", [](const Simulation& self) { return self.choice().remark; },
          "Why it is not the engine that was asked for, or ''.");
}

}  // namespace hexapod
