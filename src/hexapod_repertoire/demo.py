"""The demonstration: waits for a validated repertoire, walks to goals, tells how it went."""
import math
import os
import sys
import threading
from dataclasses import dataclass
from typing import List, Optional

import rospy
from geometry_msgs.msg import Pose as PoseMsg
from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import Odometry

from hexapod_repertoire.msg import ExecutorState, Repertoire
from hexapod_repertoire.pictures import Pose, Walk, save_picture
from hexapod_repertoire.srv import GoTo, GoToRequest, GoToResponse

TRAIL_SPACING_M = 0.01


@dataclass(frozen=True)
class Report:
    """One goal and what became of it."""

    goal: Pose
    response: GoToResponse
    seconds: float

    @property
    def reached(self) -> bool:
        return self.response.accepted and self.response.code == GoToResponse.SUCCEEDED


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
    """Waits until a repertoire is published whose entries were validated."""
    while True:
        message = rospy.wait_for_message("repertoire", Repertoire)
        if message.entries and all(entry.trials > 0 for entry in message.entries):
            return message


def wait_until_ready() -> None:
    """Waits until the executor stands and is ready to walk."""
    while rospy.wait_for_message("executor/state", ExecutorState).state != ExecutorState.READY:
        pass


def read_goals() -> List[Pose]:
    """The parameter ~goals: a list of [x_m, y_m, yaw_rad] in the frame ~frame."""
    goals = rospy.get_param("~goals")
    for goal in goals:
        if len(goal) != 3 or not all(isinstance(v, (int, float)) and math.isfinite(v) for v in goal):
            raise ValueError(f"~goals: expected [x_m, y_m, yaw_rad], found {goal}.")
    return [(float(x), float(y), float(yaw)) for x, y, yaw in goals]


def walk_to(goal: Pose, frame: str) -> Report:
    """Calls go_to and waits for the end of the walk."""
    request = GoToRequest(wait=True)
    request.target_pose = PoseStamped(pose=to_message(goal))
    request.target_pose.header.frame_id = frame
    begin = rospy.get_time()
    response = rospy.ServiceProxy("go_to", GoTo)(request)
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
        reached = to_pose(r.final_pose.pose) if r.accepted else None
        error = f"{100 * r.final_xy_error_m:5.1f} cm {math.degrees(r.final_yaw_error_rad):5.1f} deg"
        lines.append(
            f"{pose_text(report.goal)} | {pose_text(predicted)} | {pose_text(reached)} | "
            f"{error} | {r.steps:5d} | {report.seconds:7.1f}"
        )
    return "\n".join(lines)


def main() -> int:
    """Runs the demonstration; returns 0 only if every goal was reached within tolerance."""
    rospy.init_node("demo")
    goals = read_goals()
    frame = rospy.get_param("~frame", "odom")
    picture = os.path.expanduser(rospy.get_param("~picture_file"))
    rospy.loginfo("Waiting for a validated repertoire.")
    repertoire = validated_repertoire()
    wait_until_ready()
    rospy.wait_for_service("go_to")
    trail = Trail()
    reports, walks = [], []
    for goal in goals:
        rospy.loginfo("Walking to %s.", pose_text(goal))
        report = walk_to(goal, frame)
        rospy.loginfo(report.response.message)
        reports.append(report)
        planned = [to_pose(stamped.pose) for stamped in report.response.plan.poses]
        walks.append(Walk(goal, planned, trail.take()))
    save_picture(
        picture,
        [(e.executed_pose.x, e.executed_pose.y, e.executed_pose.theta) for e in repertoire.entries],
        walks,
    )
    missed = [report for report in reports if not report.reached]
    print(table(reports))
    print(f"{len(reports) - len(missed)} of {len(reports)} goals reached. Picture: {picture}")
    sys.stdout.flush()
    return 1 if missed else 0
