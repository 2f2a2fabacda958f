#include <stdexcept>

#include "simulation/ode_world.h"
#include "simulation/world.h"

namespace hexapod_repertoire {

std::unique_ptr<World> makeWorld(Engine engine, const RobotDescription& robot,
                                 const Physics& physics) {
  switch (engine) {
    case Engine::kOde:
      return std::make_unique<OdeWorld>(robot, physics);
  }
  throw std::invalid_argument("Unknown simulation engine.");
}

}  // namespace hexapod_repertoire
