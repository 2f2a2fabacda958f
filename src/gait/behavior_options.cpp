#include "gait/behavior_options.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/text.h"

namespace hexapod {
namespace {

// Bounds a typing error would break: the longest behaviour has 60,000 commands.
constexpr double kMaxDuration_s = 60.0;
constexpr double kMinPeriod_s = 0.001;
constexpr double kMaxPeriod_s = 1.0;

void requireRange(const std::string& name, double value, double min, double max) {
  if (std::isfinite(value) && value >= min && value <= max) return;
  throw std::invalid_argument("Option " + name + " is " + numberText(value) + " s; expected " +
                              numberText(min) + " .. " + numberText(max) + " s.");
}

std::size_t commandsIn(const std::string& name, double duration_s, double period_s) {
  const double commands = std::round(duration_s / period_s);
  // A nanosecond covers the rounding of decimal options.
  if (std::abs(commands * period_s - duration_s) > 1e-9) {
    throw std::invalid_argument("Option " + name + " is " + numberText(duration_s) +
                                " s; expected a whole multiple of command_period_s (" +
                                numberText(period_s) + " s), such as " +
                                numberText(std::ceil(duration_s / period_s) * period_s) + " s.");
  }
  return static_cast<std::size_t>(commands);
}

}  // namespace

std::vector<Option> declarePlayingOptions(BehaviorOptions& options) {
  return {
      option("gait_duration_s", options.gait_duration_s, "s",
             "How long the gait of a behaviour is played; a multiple of command_period_s.",
             kMinPeriod_s, kMaxDuration_s),
      option("command_period_s", options.command_period_s, "s",
             "Time between two joint commands; the paper's 30 ms.", kMinPeriod_s, kMaxPeriod_s),
      option("return_duration_s", options.return_duration_s, "s",
             "Ramp from the end of the gait back to the neutral pose; a multiple of "
             "command_period_s.",
             0.0, kMaxDuration_s),
      option("rest_duration_s", options.rest_duration_s, "s",
             "How long the neutral pose is held at the end of a behaviour; a multiple of "
             "command_period_s.",
             0.0, kMaxDuration_s),
      option("end_pose", options.end_pose,
             "When the end pose is read: at rest after the return to the neutral pose, or right "
             "after the gait as in the paper.",
             {EndPose::kAtRest, EndPose::kAfterGait}),
      option(
          "gene_levels", options.gene_levels,
          "Values of amplitudes and phases: 5, the paper's 0, 0.25, 0.5, 0.75 and 1, or one more "
          "than another multiple of 4; 253 are as good as continuous.",
          kGeneLevels, kMostGeneLevels),
  };
}

std::vector<Option> declareOptions(BehaviorOptions& options) {
  std::vector<Option> all = declarePlayingOptions(options);
  all.push_back(
      option("limit_velocity", options.limit_velocity,
             "Keep the commands within the joints' velocity limits; false sends the paper's eq. 3 "
             "as it is."));
  return all;
}

BehaviorOptions behaviorOptionsOf(const std::map<std::string, std::string>& kept,
                                  BehaviorOptions defaults) {
  applyKept(declareOptions(defaults), kept, "repertoire");
  return defaults;
}

BehaviorParts behaviorParts(const BehaviorOptions& options) {
  requireGeneLevels(options.gene_levels);
  requireRange("command_period_s", options.command_period_s, kMinPeriod_s, kMaxPeriod_s);
  requireRange("gait_duration_s", options.gait_duration_s, kMinPeriod_s, kMaxDuration_s);
  requireRange("return_duration_s", options.return_duration_s, 0.0, kMaxDuration_s);
  requireRange("rest_duration_s", options.rest_duration_s, 0.0, kMaxDuration_s);

  BehaviorParts parts;
  const double period_s = options.command_period_s;
  parts.gait = commandsIn("gait_duration_s", options.gait_duration_s, period_s);
  if (options.end_pose == EndPose::kAfterGait) return parts;
  if (options.end_pose != EndPose::kAtRest) {
    throw std::invalid_argument("Option end_pose is \"" + options.end_pose + "\"; expected " +
                                EndPose::kAtRest + " or " + EndPose::kAfterGait + ".");
  }
  parts.way_back = commandsIn("return_duration_s", options.return_duration_s, period_s);
  parts.rest = commandsIn("rest_duration_s", options.rest_duration_s, period_s);
  if (parts.way_back + parts.rest == 0) {
    throw std::invalid_argument(
        "Options return_duration_s and rest_duration_s are both 0, so a behaviour would not end in "
        "the neutral pose; set one of them, or end_pose to after_gait.");
  }
  return parts;
}

void checkReturnIsSlowEnough(const RobotDescription& robot, const BehaviorOptions& options) {
  const BehaviorParts parts = behaviorParts(options);
  if (!options.limit_velocity || parts.way_back + parts.rest == 0) return;
  // Without a ramp the first command at rest is the whole way.
  const double ramp_s = std::max<std::size_t>(parts.way_back, 1) * options.command_period_s;
  for (const Joint* joint : robot.joints()) {
    const double needed_s = std::abs(joint->amplitude_rad) / joint->max_velocity_rad_per_s;
    if (needed_s <= ramp_s) continue;
    throw std::invalid_argument("Option return_duration_s is " +
                                numberText(options.return_duration_s) + " s; joint " + joint->name +
                                " needs at least " + numberText(needed_s) +
                                " s for its way back to the neutral pose at " +
                                numberText(joint->max_velocity_rad_per_s) + " rad/s.");
  }
}

}  // namespace hexapod
