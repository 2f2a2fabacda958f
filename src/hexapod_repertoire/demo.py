"""The demonstration: waits for a validated repertoire, walks to goals, tells how it went."""
import math
import os
import threading
import time
from dataclasses import dataclass
from typing import List, Optional

import rospy
from geometry_msgs.msg import Pose as PoseMsg
from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import Odometry
from std_srvs.srv import Trigger

from hexapod_repertoire.injury import Damage, Injury
from hexapod_repertoire.msg import (ExecutorState, LearningProgress, Repertoire, WalkToGoal,
                                    WalkToResult)
from hexapod_repertoire.pictures import Pose, Walk, save_picture
from hexapod_repertoire.srv import GoToResponse
from hexapod_repertoire.waiting import Latest, Silence, Walker

TRAIL_SPACING_M = 0.01
PATIENCE_S = 60.0


@dataclass(frozen=True)
class Report:
    """One goal and what became of it."""

    goal: Pose
    response: WalkToResult
    seconds: float

    @property
    def reached(self) -> bool:
        return self.response.code == GoToResponse.SUCCEEDED


def leave_last_words(sentence: str) -> None:
    """Leaves a sentence for whoever launched this node, to be told when it has ended."""
    rospy.set_param("~last_words", sentence)


def to_pose(message: PoseMsg) -> Pose:
    """(x [m], y [m], yaw [rad]) of a pose in the plane."""
    q = message.orientation
    return (message.position.x, message.position.y, 2.0 * math.atan2(q.z, q.w))


def to_message(pose: Pose) -> PoseMsg:
    """The message of (x [m], y [m], yaw [rad])."""
    message = PoseMsg()
    message.position.x, message.position.y = pose[0], pose[1]
    message.orientation.z, message.orientation.w = math.sin(pose[2] / 2), math.cos(pose[2] / 2)
    return message


class Trail:
    """The positions the robot passed, from odometry, one per centimetre."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._poses: List[Pose] = []
        self._subscriber = rospy.Subscriber("odom", Odometry, self._add, tcp_nodelay=True)

    def _add(self, message: Odometry) -> None:
        pose = to_pose(message.pose.pose)
        with self._lock:
            if not self._poses or math.dist(pose[:2], self._poses[-1][:2]) > TRAIL_SPACING_M:
                self._poses.append(pose)

    def take(self) -> List[Pose]:
        """The poses since the last call."""
        with self._lock:
            poses, self._poses = self._poses, []
        return poses


def validated_repertoire() -> Repertoire:
    """Waits until a repertoire is published whose entries were validated, as long as one learns."""
    return Latest("repertoire", Repertoire).wait(
        lambda message: message.entries and all(entry.trials > 0 for entry in message.entries),
        PATIENCE_S,
        "No repertoire with validated entries is published, and nobody learns one; start "
        "learn.launch, or a repertoire_server with a file whose run has ended.",
        also=Latest("learner/progress", LearningProgress),
    )


def wait_until_ready(arm_after_fault: bool = False) -> None:
    """Waits until the executor stands and is ready to walk.

    With arm_after_fault it arms after a fault: for a simulated robot, which falls behind while a
    learner takes all cores.
    """
    end_s = time.monotonic() + PATIENCE_S

    def is_over(message: ExecutorState) -> bool:
        if arm_after_fault and message.state == ExecutorState.FAULT:
            rospy.ServiceProxy("executor/arm", Trigger)()
        return message.state == ExecutorState.READY or time.monotonic() > end_s

    state = Latest("executor/state", ExecutorState).wait(
        is_over, PATIENCE_S, "No executor answers on executor/state; start it.")
    if state.state != ExecutorState.READY:
        raise Silence(f"The executor does not become ready ({state.reason}); call executor/arm.")


def read_goals() -> List[Pose]:
    """The parameter ~goals: a list of [x_m, y_m, yaw_rad] in the frame ~frame."""
    goals = rospy.get_param("~goals")
    for goal in goals:
        if len(goal) != 3 or not all(isinstance(v, (int, float)) and math.isfinite(v) for v in goal):
            raise ValueError(f"~goals: expected [x_m, y_m, yaw_rad], found {goal}.")
    return [(float(x), float(y), float(yaw)) for x, y, yaw in goals]


def walk_to(walker: Walker, goal: Pose, frame: str) -> Report:
    """Walks to a goal and tells what became of it."""
    target = PoseStamped(pose=to_message(goal))
    target.header.frame_id = frame
    begin = rospy.get_time()
    response = walker.walk(WalkToGoal(target_pose=target))
    return Report(goal, response, rospy.get_time() - begin)


def pose_text(pose: Optional[Pose]) -> str:
    """ "+0.80 +0.30  +45 deg" or dashes."""
    if pose is None:
        return f"{'-':^20}"
    return f"{pose[0]:+.2f} {pose[1]:+.2f} {math.degrees(pose[2]):+5.0f} deg"


def table(reports: List[Report]) -> str:
    """The table of the demonstration, one line a goal."""
    lines = [
        f"{'goal [m m]':^20} | {'predicted':^20} | {'reached':^20} | {'error':^17} | steps | seconds"
    ]
    for report in reports:
        r = report.response
        predicted = to_pose(r.plan.poses[-1].pose) if r.plan.poses else None
        reached = to_pose(r.final_pose.pose) if r.final_pose.header.frame_id else None
        error = f"{100 * r.final_xy_error_m:5.1f} cm {math.degrees(r.final_yaw_error_rad):5.1f} deg"
        lines.append(
            f"{pose_text(report.goal)} | {pose_text(predicted)} | {pose_text(reached)} | "
            f"{error} | {r.steps:5d} | {report.seconds:7.1f}"
        )
    return "\n".join(lines)


def main() -> int:
    """Runs the demonstration; returns 0 only if every goal was reached within tolerance."""
    rospy.init_node("demo", disable_signals=True)
    try:
        return demonstrate()
    except (Silence, ValueError) as problem:
        rospy.logfatal(problem)
        leave_last_words(str(problem))
        return 1
    except (rospy.ROSInterruptException, KeyboardInterrupt):
        return 1  # the session ended


def demonstrate() -> int:
    """What main() runs, once there is a node."""
    goals = read_goals()
    injury = Injury(Damage.from_param("~injury")) if rospy.get_param("~damage", False) else None
    frame = rospy.get_param("~frame", "odom")
    picture = os.path.expanduser(rospy.get_param("~picture_file"))
    rospy.loginfo("Waiting for a validated repertoire.")
    repertoire = validated_repertoire()
    wait_until_ready(arm_after_fault=True)
    walker = Walker()
    trail = Trail()
    factor = rospy.get_param("~real_time_factor", 1.0)
    if factor != 1.0:
        rospy.loginfo("The simulated robot's seconds are %g times as fast as real ones.", factor)
    reports, walks = [], []
    for number, goal in enumerate(goals):
        if injury and number == 1:
            injury.strike()
        rospy.loginfo("Walking to %s.", pose_text(goal))
        report = walk_to(walker, goal, frame)
        reports.append(report)
        planned = [to_pose(stamped.pose) for stamped in report.response.plan.poses]
        walks.append(Walk(goal, planned, trail.take()))
    save_picture(
        picture,
        [(e.executed_pose.x, e.executed_pose.y, e.executed_pose.theta) for e in repertoire.entries],
        walks,
    )
    if injury:
        print(injury.summary())
    missed = [report for report in reports if not report.reached]
    print(table(reports))
    reached = f"{len(reports) - len(missed)} of {len(reports)} goals reached."
    print(reached, flush=True)
    leave_last_words(f"{reached} Picture: {picture}. To walk on with what was learned: ./run walk; "
                     "to look at it: ./run view")
    return 1 if missed else 0
