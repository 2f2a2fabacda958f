// A mistake made on purpose, which the fuzzer must find: it shows that the others would.
#include <array>
#include <stdexcept>

#include "execution/joint_map.h"
#include "fuzz/input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::array<int, 4> turns{};
  try {
    const auto map = hexapod::JointMap::fromYaml(hexapod::textOf(data, size), {"a"}, "yaml");
    // An offset of four turns or more reads beyond the end.
    const auto turn = static_cast<std::size_t>(map.joints().front().offset_rad / 6.3);
    return turns[turn % 1000];
  } catch (const std::runtime_error&) {
    return 0;
  }
}
