#include "evaluation/test_set.h"

#include <cstddef>
#include <cstdint>
#include <utility>

#include "common/stratified.h"

namespace hexapod {
namespace {

constexpr std::size_t kWorlds = 20;
constexpr std::uint64_t kSeed = 20131211;

}  // namespace

std::vector<Physics> testSet(const Physics& nominal, double command_period_s) {
  Random random(kSeed);
  const auto drawn = [&](double low, double high) {
    return stratified(kWorlds, low, high, random);
  };
  const auto friction = drawn(0.7, 1.3);
  const auto gain = drawn(0.7, 1.3);
  const auto mass = drawn(0.85, 1.15);
  const auto torque = drawn(0.8, 1.15);
  const auto slope_x_rad = drawn(-0.0087, 0.0087);
  const auto slope_y_rad = drawn(-0.0087, 0.0087);
  const auto latency_s = drawn(0.0, 0.030);
  const auto steps = drawn(6.0, 11.0);
  std::vector<Physics> worlds(kWorlds, nominal);
  for (std::size_t i = 0; i < kWorlds; ++i) {
    worlds[i].friction_scale *= friction[i];
    worlds[i].servo_gain_scale *= gain[i];
    worlds[i].mass_scale *= mass[i];
    worlds[i].torque_scale *= torque[i];
    worlds[i].slope_x_rad += slope_x_rad[i];
    worlds[i].slope_y_rad += slope_y_rad[i];
    worlds[i].command_latency_s += latency_s[i];
    worlds[i].step_s = command_period_s / static_cast<double>(static_cast<int>(steps[i]));
  }
  return worlds;
}

}  // namespace hexapod
