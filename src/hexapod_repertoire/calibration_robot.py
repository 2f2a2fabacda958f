"""Has the executor play the behaviours of a calibration, and measures where each of them ends."""
import csv
import math
import pathlib
import sys
import time
import typing

import actionlib
import rosgraph
import rospy
import tf2_ros

from hexapod_repertoire.demo import wait_until_ready
from hexapod_repertoire.msg import (ExecuteBehaviorAction, ExecuteBehaviorGoal,
                                    ExecuteBehaviorResult)
from hexapod_repertoire.pictures import Pose
from hexapod_repertoire.repertoire_data import genes_of
from hexapod_repertoire.waiting import Silence

PATIENCE_S = 10.0
SETTLE_S = 0.2  # as the planner's pose_settle_s: the robot is at rest then
TRIES = 3  # of a behaviour of which the executor skipped commands
COLUMNS = ("use", "genome", "before_x_m", "before_y_m", "before_yaw_rad", "after_x_m", "after_y_m",
           "after_yaw_rad")


class Poses:
    """The robot's pose in tf.

    Args:
        global_frame: the frame of the poses.
        base_frame: the robot's footprint.
    """

    def __init__(self, global_frame: str, base_frame: str) -> None:
        self._frames = (global_frame, base_frame)
        self._buffer = tf2_ros.Buffer()
        self._listener = tf2_ros.TransformListener(self._buffer)

    def since(self, stamp: rospy.Time) -> Pose:
        """The first pose that is stamped no earlier.

        Raises:
            Silence: none comes.
        """
        end_s = time.monotonic() + PATIENCE_S
        while time.monotonic() < end_s and not rospy.is_shutdown():
            try:
                found = self._buffer.lookup_transform(*self._frames, rospy.Time(0))
                if found.header.stamp >= stamp:
                    return self._planar(found.transform)
            except tf2_ros.TransformException:
                pass  # none has come yet
            time.sleep(0.01)
        raise Silence(f"No new transform from {self._frames[0]} to {self._frames[1]} has come for "
                      f"{PATIENCE_S:.0f} s; check that the robot publishes its odometry to tf.")

    @staticmethod
    def _planar(transform: typing.Any) -> Pose:
        q = transform.rotation
        return (transform.translation.x, transform.translation.y, 2.0 * math.atan2(q.z, q.w))


class Player:
    """The executor's action, one behaviour at a time."""

    def __init__(self) -> None:
        self._client = actionlib.SimpleActionClient("execute", ExecuteBehaviorAction)
        if not self._client.wait_for_server(rospy.Duration(PATIENCE_S)):
            raise Silence("No executor answers on the action execute; start a session with "
                          "./run walk.")

    def play(self, genome: str) -> ExecuteBehaviorResult:
        """Plays a behaviour to its end.

        Raises:
            Silence: it was not played; the text says why.
        """
        self._client.send_goal(ExecuteBehaviorGoal(entry_id=-1, genome=genes_of(genome)))
        self._client.wait_for_result()
        result = self._client.get_result()
        if result is None:
            raise Silence("The executor left in the middle of a behaviour; see its log.")
        if result.code not in (ExecuteBehaviorResult.SUCCEEDED, ExecuteBehaviorResult.SKIPPED):
            raise Silence(f"A behaviour was not played: {result.message}")
        return result


def play_all(plan: typing.Sequence[typing.Mapping[str, str]], poses: Poses,
             player: Player) -> typing.List[typing.Dict[str, typing.Any]]:
    """Rows of the trials: what was planned, with the poses before and after.

    A behaviour some of whose commands were skipped is played again; one that never was whole is
    left out. What is played again begins in a state that the fit does not know: the feet lie
    otherwise than after the behaviour before.
    """
    rows = []
    before = poses.since(rospy.Time.now())
    for number, row in enumerate(plan):
        skipped = 0
        for _ in range(TRIES):
            result = player.play(row["genome"])
            start, before = before, poses.since(result.finished + rospy.Duration(SETTLE_S))
            if result.code == ExecuteBehaviorResult.SUCCEEDED:
                rows.append(dict(zip(COLUMNS, (row["use"], row["genome"], *start, *before))))
                break
            skipped += 1
        again = f", {skipped} tries with skipped commands" if skipped else ""
        print(f"{number + 1} of {len(plan)} behaviours played{again}", flush=True)
    return rows


def main(plan_file: pathlib.Path, trials_file: pathlib.Path, global_frame: str,
         base_frame: str) -> int:
    """Plays a file's behaviours and writes the trials; returns the exit code."""
    if not rosgraph.is_master_online():
        print(f"No ROS master answers at {rosgraph.get_master_uri()}: start a session with "
              "./run walk, or say --simulated 'friction: 0.8' for a simulated robot without ROS.",
              file=sys.stderr)
        return 1
    rospy.init_node("calibrate", anonymous=True, disable_signals=True, log_level=rospy.ERROR)
    try:
        with open(plan_file, encoding="utf-8", newline="") as stream:
            plan = list(csv.DictReader(stream))
        wait_until_ready()
        rows = play_all(plan, Poses(global_frame, base_frame), Player())
        with open(trials_file, "w", encoding="utf-8", newline="") as stream:
            writer = csv.DictWriter(stream, COLUMNS, lineterminator="\n")
            writer.writeheader()
            writer.writerows(rows)
    except (Silence, OSError) as problem:
        print(problem, file=sys.stderr)
        return 1
    except (KeyboardInterrupt, rospy.ROSInterruptException):
        return 130
    return 0
