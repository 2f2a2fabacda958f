// Emergency stops at random instants of walks: no command later, none of an old behaviour after
// arming.
//
// Part 1, in-process: the executor's loop as fast as it goes, its sending thread, stops from a
// third. Part 2, on the wire: the executor node on simulated time, a driver whose callback stalls.
//
//   --short       some stops of each part
//   --stops N     1,000 by default; --speed S of simulated time, 3 by default; --seed N 1 by
//   default
#include <cstdio>
#include <string>

#include "e_stops_in_process.h"
#include "e_stops_on_the_wire.h"
#include "robot/load_robot.h"

namespace hexapod {
namespace {

bool report(const char* part, const Tally& tally) {
  std::printf("| %s | %d | %d | %d | %lld | %d |\n", part, tally.stops, tally.walking, tally.late,
              static_cast<long long>(tally.latest_periods), tally.old_after_arm);
  std::fflush(stdout);
  return tally.late == 0 && tally.old_after_arm == 0;
}

int runCampaign(int stops, double speed, std::uint64_t seed) {
  const std::string root = RosSession::root();
  const RobotDescription robot =
      loadRobot(root + "/urdf/hexapod.urdf", root + "/config/hexapod.yaml");
  std::printf(
      "Stops at random instants of behaviours of random genomes (seed %llu).\n\n"
      "| where | stops | while walking | commands more than a period later | latest command after "
      "it [periods] | old set-points after arming |\n|---|---|---|---|---|---|\n",
      static_cast<unsigned long long>(seed));
  bool good = report("in-process", InProcess(robot, seed).run(stops));
  RosSession session("e_stops");
  beOnTime();
  OnTheWire wire(robot, speed, seed);
  good = report("wire, stalled driver", wire.run(stops)) && good;
  std::printf(
      "\nSimulated time at %.1f times real time on the wire. The driver stalls for 20 to 60 ms of "
      "real time in every\ncallback, queue size 1. A stop begins when it is published on e_stop "
      "or, every other time, when ~stop has\nanswered. A set-point is old when it is stamped no "
      "later than a period after the stop; what the driver does with\none before it is armed again "
      "is its own: later than a period after the %d stops it obeyed %d that its queue still\nheld "
      "or that were on their way, more than one after %d stops, at most %d.\nArming did not end in "
      "READY %d times and was repeated.\n",
      speed, stops, wire.oldSetPointsObeyedAfterStops(), wire.stopsWithMoreThanOne(),
      wire.mostAfterOneStop(), wire.armedAgain());
  // One that waited in the driver's queue; and one sent within the period after the stop that came
  // just when the driver had taken the first.
  good = good && wire.mostAfterOneStop() <= 2;
  std::printf("\n%s\n", good ? "All promises held." : "Not all promises held.");
  return good ? 0 : 1;
}

}  // namespace
}  // namespace hexapod

int main(int argc, char** argv) {
  int stops = 1000;
  double speed = 3.0;
  std::uint64_t seed = 1;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--driver") return hexapod::driveStalled();
    if (word == "--short") {
      stops = 5;
    } else if (word == "--stops" && i + 1 < argc) {
      stops = std::stoi(argv[++i]);
    } else if (word == "--speed" && i + 1 < argc) {
      speed = std::stod(argv[++i]);
    } else if (word == "--seed" && i + 1 < argc) {
      seed = std::stoull(argv[++i]);
    } else {
      std::fprintf(stderr, "usage: %s [--short] [--stops N] [--speed S] [--seed N]\n", argv[0]);
      return 2;
    }
  }
  return hexapod::runCampaign(stops, speed, seed);
}
