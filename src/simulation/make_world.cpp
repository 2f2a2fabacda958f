#include <stdexcept>

#include "simulation/ode_world.h"
#include "simulation/world.h"

namespace hexapod {

Engine engineFromName(const std::string& name) {
  if (name == "ode") return Engine::kOde;
  throw std::invalid_argument("'engine' is '" + name + "', expected ode.");
}

std::unique_ptr<World> makeWorld(Engine engine, const RobotDescription& robot,
                                 const Physics& physics) {
  switch (engine) {
    case Engine::kOde:
      return std::make_unique<OdeWorld>(robot, physics);
  }
  throw std::invalid_argument("Unknown simulation engine.");
}

}  // namespace hexapod
