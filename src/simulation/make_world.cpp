#include <stdexcept>

#include "simulation/ode/ode_world.h"
#include "simulation/reduced/reduced_world.h"
#include "simulation/world.h"

namespace hexapod {

const std::vector<std::string>& engineNames() {
  static const std::vector<std::string> names = {toString(Engine::kReduced),
                                                 toString(Engine::kOde)};
  return names;
}

std::string toString(Engine engine) { return engine == Engine::kOde ? "ode" : "reduced"; }

EngineChoice chooseEngine(const std::string& name, const RobotDescription& robot) {
  if (name == toString(Engine::kOde)) return {Engine::kOde, ""};
  if (name != toString(Engine::kReduced)) {
    throw std::invalid_argument("'engine' is '" + name + "', expected reduced or ode.");
  }
  std::string reason;
  if (coversRobot(robot, reason)) return {Engine::kReduced, ""};
  return {Engine::kOde,
          "Simulating with ODE, about a hundred times as slow as the engine reduced: " + reason};
}

std::unique_ptr<World> makeWorld(Engine engine, const RobotDescription& robot,
                                 const Physics& physics, const WorldState* settled) {
  switch (engine) {
    case Engine::kOde:
      return std::make_unique<OdeWorld>(robot, physics, settled);
    case Engine::kReduced:
      return std::make_unique<ReducedWorld>(robot, physics, settled);
  }
  throw std::invalid_argument("Unknown simulation engine.");
}

}  // namespace hexapod
