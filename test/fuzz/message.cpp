// Any values in the message of a repertoire: what is accepted must survive the way there and back.
#include <cstdlib>
#include <stdexcept>

#include "fuzz/input.h"
#include "repertoire/repertoire_file.h"
#include "ros_interface/common/conversions.h"

namespace {

hexapod_repertoire::Repertoire messageFrom(hexapod::Input& input) {
  hexapod_repertoire::Repertoire message;
  message.behavior_duration_s = input.number<double>();
  while (!input.isUsedUp()) {
    hexapod_repertoire::RepertoireEntry entry;
    entry.id = input.number<std::int8_t>();
    const std::size_t genes = input.number<std::uint8_t>() % 32;
    for (std::size_t i = 0; i < genes; ++i) entry.genome.push_back(input.number<std::uint8_t>());
    entry.end_pose.x = input.number<double>();
    entry.end_pose.y = input.number<double>();
    entry.end_pose.theta = input.number<double>();
    entry.cost = input.number<double>();
    entry.trials = input.number<std::uint32_t>();
    entry.falls = input.number<std::uint32_t>();
    entry.executed_pose.x = input.number<double>();
    entry.executed_pose.y = input.number<double>();
    entry.executed_pose.theta = input.number<double>();
    entry.spread_m = input.number<double>();
    entry.spread_rad = input.number<double>();
    message.entries.push_back(entry);
  }
  return message;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  hexapod::Input input(data, size);
  try {
    const hexapod::Repertoire accepted = hexapod::fromMsg(messageFrom(input));
    const hexapod::Repertoire again = hexapod::fromMsg(hexapod::toMsg(accepted, ros::Time()));
    if (hexapod::digestOf(accepted.entries) != hexapod::digestOf(again.entries)) std::abort();
  } catch (const std::invalid_argument&) {
    // The sentence that it is there for.
  }
  return 0;
}
