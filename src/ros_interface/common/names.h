#pragma once

namespace hexapod {

/// Names that more than one node of this package uses: topics, actions and frames. All are
/// relative, so that a namespace has its own. What only one node uses is named in that node's room.
namespace names {

// Topics.
constexpr char kRepertoire[] = "repertoire";
constexpr char kRepertoireFilter[] = "repertoire_filter";
constexpr char kRepertoirePointer[] = "repertoire_pointer";
constexpr char kJointCommand[] = "joint_command";
constexpr char kJointStates[] = "joint_states";
constexpr char kRobotReset[] = "robot_reset";
constexpr char kBodyBelief[] = "body_belief";
constexpr char kExecutorState[] = "executor/state";

// Actions.
constexpr char kExecute[] = "execute";

// Frames (REP-105, REP-120); without a leading slash.
constexpr char kOdomFrame[] = "odom";
constexpr char kFootprintFrame[] = "base_footprint";
// Of the repertoire that is shown: where the robot last stood.
constexpr char kRepertoireOriginFrame[] = "repertoire_origin";

}  // namespace names
}  // namespace hexapod
