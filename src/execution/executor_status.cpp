#include "execution/executor_status.h"

#include "common/text.h"

namespace hexapod {
namespace {

std::string jointName(const Cause& cause, const std::vector<std::string>& joint_names) {
  const auto joint = static_cast<std::size_t>(cause.joint);
  return cause.joint >= 0 && joint < joint_names.size() ? joint_names[joint] : "unknown";
}

}  // namespace

const char* toString(ExecutorMode mode) {
  switch (mode) {
    case ExecutorMode::kDisarmed:
      return "DISARMED";
    case ExecutorMode::kStandingUp:
      return "STANDING_UP";
    case ExecutorMode::kReady:
      return "READY";
    case ExecutorMode::kWalking:
      return "WALKING";
    case ExecutorMode::kHolding:
      return "HOLDING";
    case ExecutorMode::kStopped:
      return "STOPPED";
    case ExecutorMode::kFault:
      return "FAULT";
    case ExecutorMode::kSittingDown:
      return "SITTING_DOWN";
  }
  return "UNKNOWN";
}

bool sendsCommands(ExecutorMode mode) {
  return mode == ExecutorMode::kStandingUp || mode == ExecutorMode::kReady ||
         mode == ExecutorMode::kWalking || mode == ExecutorMode::kHolding ||
         mode == ExecutorMode::kSittingDown;
}

std::string sentence(const Cause& cause, const std::vector<std::string>& joint_names) {
  switch (cause.reason) {
    case Reason::kNone:
      return "Done.";
    case Reason::kNeverArmed:
      return "Not armed yet; call ~arm to stand up.";
    case Reason::kDisarmRequested:
      return "Disarmed on request; call ~arm to stand up.";
    case Reason::kSatDown:
      return "Sitting; call ~stand to stand up.";
    case Reason::kArmRequested:
      return "Standing up.";
    case Reason::kNeutral:
      return "Standing in the neutral pose.";
    case Reason::kPlaying:
      return "Playing a behaviour.";
    case Reason::kFinished:
      return "The behaviour is finished.";
    case Reason::kCancelled:
      return "Broken off on request.";
    case Reason::kTimeJumped:
      return "Broken off because ROS time jumped back.";
    case Reason::kRobotReset:
      return "Broken off because the robot was reset.";
    case Reason::kSittingDown:
      return "Sitting down.";
    case Reason::kStopRequested:
      return "Stopped on request; call ~arm to stand up again.";
    case Reason::kEStop:
      return "Emergency stop; release it (e_stop false), then call ~arm.";
    case Reason::kEStopSilent:
      return "Nothing has come on e_stop within e_stop_timeout_s; start its publisher, then call "
             "~arm.";
    case Reason::kShutDown:
      return "The executor shuts down.";
    case Reason::kFeedbackLost:
      return "No valid joint_states of joint '" + jointName(cause, joint_names) +
             "' within feedback_timeout_s; repair the feedback, then call ~arm.";
    case Reason::kFeedbackFrozen:
      return "The joint_states do not change although joint '" + jointName(cause, joint_names) +
             "' and others are moved: the driver repeats itself or the servos have no power; "
             "repair it, then call ~arm.";
    case Reason::kTwoSources:
      return "More than one node publishes joint_states of joint '" +
             jointName(cause, joint_names) + "'; stop one of them, then call ~arm.";
    case Reason::kNotFollowing:
      return "Joint '" + jointName(cause, joint_names) + "' is " + numberText(cause.value_rad, 3) +
             " rad away from its command and does not follow; free or repair it, then call ~arm.";
    case Reason::kCommandRefused:
      return "A command was not finite or had the wrong length and was not sent; this behaviour "
             "must not be played.";
    case Reason::kNoFeedback:
      return "No valid joint_states of joint '" + jointName(cause, joint_names) +
             "', so the pose of the robot is unknown; start its driver, name the leg in dead_legs "
             "if it is not there, or set feedback_timeout_s to 0 for open loop.";
    case Reason::kFarFromNeutral:
      return "Joint '" + jointName(cause, joint_names) + "' is " + numberText(cause.value_rad, 3) +
             " rad away from its neutral angle, more than start_tolerance_rad; bring the robot "
             "nearer by hand, or set far_start to ramp.";
    case Reason::kAlreadyArmed:
      return "Already armed.";
    case Reason::kNotReady:
      return std::string("The executor is ") + toString(cause.mode) +
             "; it plays one behaviour at a time and only when READY.";
    case Reason::kNothingToCancel:
      return "No behaviour is being played.";
    case Reason::kBadBehavior:
      return "The behaviour has no commands or not one angle per joint of this robot.";
    case Reason::kOvertaken:
      return "A stop came in between; call ~arm.";
    case Reason::kNoAnswer:
      return "The command loop did not answer; with /use_sim_time, check that /clock comes.";
  }
  return "Unknown reason.";
}

}  // namespace hexapod
