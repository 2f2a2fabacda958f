// Any text as the YAML of a robot, as that of a joint map, and as a file of options.
#include <stdexcept>

#include "common/options.h"
#include "execution/joint_map.h"
#include "fuzz/input.h"
#include "robot/load_robot.h"

namespace {

template <typename Call>
void expectSentence(const Call& call) {
  try {
    call();
  } catch (const std::runtime_error&) {
    // The sentence that it is there for.
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string urdf = hexapod::contentOf("urdf/hexapod.urdf");
  const std::string text = hexapod::textOf(data, size);
  expectSentence([&] { hexapod::parseRobot(urdf, text, "urdf", "yaml"); });
  expectSentence([&] { hexapod::JointMap::fromYaml(text, {"a", "b"}, "yaml"); });
  expectSentence([&] { hexapod::optionValuesFromYamlText(text, "yaml"); });
  return 0;
}
