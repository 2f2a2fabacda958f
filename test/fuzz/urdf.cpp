// Any text as the URDF of a robot.
#include <stdexcept>

#include "fuzz/input.h"
#include "robot/load_robot.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string yaml = hexapod::contentOf("config/hexapod.yaml");
  try {
    hexapod::parseRobot(hexapod::textOf(data, size), yaml, "urdf", "yaml");
  } catch (const std::runtime_error&) {
    // The sentence that it is there for.
  }
  return 0;
}
