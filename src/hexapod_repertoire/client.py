"""Asks a walking session from the command line: go, stop, arm, info."""
import argparse
import math
import os
import sys
from typing import Any, List, Optional

import rosgraph
import rospy
from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import Odometry
from std_srvs.srv import Trigger

from hexapod_repertoire import walk_log
from hexapod_repertoire.demo import to_message, to_pose
from hexapod_repertoire.msg import (ExecutorState, Repertoire, StepReport, WalkToActionFeedback,
                                    WalkToGoal, WalkToResult)
from hexapod_repertoire.srv import GoToResponse
from hexapod_repertoire.waiting import Latest, Silence, Walker

PATIENCE_S = 3.0
INTERRUPTED = 130
CODES = {value: name for name, value in vars(GoToResponse).items()
         if name.isupper() and isinstance(value, int)}
STATES = {value: name for name, value in vars(ExecutorState).items()
          if name.isupper() and isinstance(value, int)}


def parser() -> argparse.ArgumentParser:
    """Of the words after ./run."""
    top = argparse.ArgumentParser(prog="./run", description=__doc__)
    verbs = top.add_subparsers(dest="verb", required=True)
    go = verbs.add_parser("go", help="walk to a pose and wait until the walk has ended")
    go.add_argument("x_m", type=float)
    go.add_argument("y_m", type=float)
    go.add_argument("yaw_deg", type=float, nargs="?", help="left out: any heading will do")
    go.add_argument("--frame", help="of the pose; base_footprint: from here [the planner's: odom]")
    go.add_argument("--plan", action="store_true", help="plan only, show it in rviz, do not move")
    go.add_argument("--log", metavar="FILE.csv",
                    help="write what each behaviour was predicted and measured to do, for ./run report "
                         "--walk and ./run show --walk")
    verbs.add_parser("stop", help="the executor sends nothing from this moment on")
    verbs.add_parser("arm", help="the executor stands the robot up, ready to walk")
    verbs.add_parser("info", help="what runs, and in what state it is")
    return top


def call(name: str) -> int:
    """Calls a Trigger service of the executor, prints its answer."""
    try:
        rospy.wait_for_service(name, PATIENCE_S)
        response = rospy.ServiceProxy(name, Trigger)()
    except (rospy.ROSException, rospy.ServiceException):
        print(f"No executor answers on {name}; start a session with ./run walk.", file=sys.stderr)
        return 1
    print(response.message)
    return 0 if response.success else 1


def tell_step(message: WalkToActionFeedback) -> None:
    """One line before each behaviour; before the first that the goal was accepted."""
    feedback = message.feedback
    steps = max(feedback.steps_planned, feedback.step + 1)
    if feedback.step == 0:
        print(f"Accepted: {steps} behaviour{'s' if steps > 1 else ''} planned.")
    print(f"step {feedback.step + 1} of {steps}, {feedback.distance_left_m:.2f} m left")


def tell_end_of_step(report: StepReport) -> None:
    """One line after each behaviour."""
    print(f"  ended {100.0 * report.xy_error_m:.1f} cm and {math.degrees(report.yaw_error_rad):.1f} "
          "deg from where it was predicted")


def goal_of(arguments: argparse.Namespace) -> WalkToGoal:
    """The message of the words after go."""
    yaw_deg = arguments.yaw_deg
    numbers = (arguments.x_m, arguments.y_m, yaw_deg or 0.0)
    if not all(map(math.isfinite, numbers)):
        raise ValueError(f"go {numbers}: expected three finite numbers, metres and degrees.")
    target = PoseStamped(pose=to_message((numbers[0], numbers[1], math.radians(numbers[2]))))
    target.header.frame_id = arguments.frame or rospy.get_param("planner/global_frame", "odom")
    return WalkToGoal(target_pose=target, plan_only=arguments.plan,
                      yaw_tolerance_rad=-1.0 if yaw_deg is None else 0.0)


def end_of_walk(result: WalkToResult, goal: WalkToGoal) -> str:
    """What became of the goal, in a sentence or two."""
    text = result.message
    if result.plan.poses and goal.plan_only:
        x_m, y_m, yaw = to_pose(result.plan.poses[-1].pose)
        text += f" It would end at {x_m:.2f} m, {y_m:.2f} m, {math.degrees(yaw):.0f} deg."
    elif result.final_pose.header.frame_id:
        turned = f" and {math.degrees(result.final_yaw_error_rad):.1f} deg"
        text += (f" It stands {100.0 * result.final_xy_error_m:.1f} cm"
                 f"{turned if goal.yaw_tolerance_rad >= 0.0 else ''} from the goal.")
    if result.code != GoToResponse.SUCCEEDED:
        text = f"{CODES.get(result.code, result.code)}: {text}"
    return text


class Logbook:
    """The behaviours of a walk, written when it is over."""

    def __init__(self, path: Optional[str]) -> None:
        self._path = path
        self._steps: List[walk_log.Step] = []
        self._subscriber = rospy.Subscriber("planner/step_report", StepReport, self._add)

    def _add(self, message: StepReport) -> None:
        poses = ((pose.x, pose.y, pose.theta)
                 for pose in (message.start, message.predicted, message.measured))
        self._steps.append(walk_log.Step(message.entry_id, *poses))

    def write(self) -> None:
        """Writes the log, if a path was named."""
        if self._path:
            walk_log.write(self._path, self._steps)
            print(f"Written: {os.path.abspath(self._path)}")


def go(arguments: argparse.Namespace) -> int:
    """Walks; 0 only if the goal was reached. Ctrl-C cancels the goal."""
    goal = goal_of(arguments)
    walker = Walker()
    _steps = rospy.Subscriber("walk_to/feedback", WalkToActionFeedback, tell_step)
    _ends = rospy.Subscriber("planner/step_report", StepReport, tell_end_of_step)
    logbook = Logbook(arguments.log)
    try:
        result = walker.walk(goal)
    except (KeyboardInterrupt, rospy.ROSInterruptException):
        walker.cancel()
        print("Cancelled: the robot stops at the end of its behaviour.", file=sys.stderr)
        return INTERRUPTED
    print(end_of_walk(result, goal))
    logbook.write()
    return 0 if result.code == GoToResponse.SUCCEEDED else 1


def heard(topic: Latest) -> Optional[Any]:
    """The last message of a topic, or None when nobody says anything there."""
    try:
        return topic.wait(lambda message: True, PATIENCE_S, "")
    except Silence:
        return None


def described(repertoire: Repertoire) -> str:
    """Its size and run, and the body it was learned for if that is not the robot's own."""
    text = f"{len(repertoire.entries)} entries of run {repertoire.run_id}"
    body = dict(zip(repertoire.option_names, repertoire.option_values)).get("body")
    return text + (f", learned for this body: {body}" if body else "")


def info() -> int:
    """Prints what runs; 0 when there is an executor and a repertoire."""
    topics = {"executor/state": ExecutorState, "repertoire": Repertoire, "odom": Odometry}
    latest = {name: Latest(name, kind) for name, kind in topics.items()}
    state, repertoire, odometry = (heard(latest[name]) for name in topics)
    print("executor:   " + (f"{STATES[state.state]}: {state.reason}" if state else
                            "none; start a session with ./run walk"))
    print("repertoire: " + (described(repertoire) if repertoire else "none is published"))
    if odometry:
        x_m, y_m, yaw = to_pose(odometry.pose.pose)
        print(f"robot:      at {x_m:.2f} m, {y_m:.2f} m, {math.degrees(yaw):.0f} deg in "
              f"{odometry.header.frame_id}")
    else:
        print("robot:      nobody tells where it is (topic odom)")
    return 0 if state and repertoire else 1


def main(argv: List[str]) -> int:
    """Carries out the words after ./run; returns the exit code."""
    arguments = parser().parse_args(argv)
    if not rosgraph.is_master_online():
        print(f"No ROS master answers at {rosgraph.get_master_uri()}; start a session with "
              "./run walk.", file=sys.stderr)
        return 1
    rospy.init_node("client", anonymous=True, disable_signals=True, log_level=rospy.ERROR)
    try:
        if arguments.verb == "go":
            return go(arguments)
        if arguments.verb == "info":
            return info()
        return call("executor/" + arguments.verb)
    except (Silence, ValueError) as problem:
        print(problem, file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
