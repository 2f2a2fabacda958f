"""Where a robot should be that nobody measures: what its repertoire promises of each behaviour.

For robots without odometry of their own. Publishes the topic odom and tf ~odom_frame ->
~base_frame at ~rate_hz: each behaviour that the executor plays adds its expected end pose, along its
arc while it is played, and its spread to the covariance. Errors add up; fuse it with what does see
the world (robot_localization, a camera), or keep walks short.
"""
import threading
import time
from typing import Any, Dict, Optional, Tuple

import rospy
import tf2_ros
from geometry_msgs.msg import TransformStamped
from nav_msgs.msg import Odometry

from hexapod_repertoire.dead_reckoning import DeadReckoner, Promise
from hexapod_repertoire.demo import to_message
from hexapod_repertoire.msg import ExecutorState, Repertoire

def promises_of(repertoire: Any) -> Dict[int, Promise]:
    """The expected ends of the entries of a Repertoire message, by id."""
    promises = {}
    for entry in repertoire.entries:
        pose = entry.executed_pose if entry.trials else entry.end_pose
        promises[entry.id] = Promise((pose.x, pose.y, pose.theta), entry.spread_m, entry.spread_rad)
    return promises


class PredictedOdometry:
    """The DeadReckoner on ROS."""

    def __init__(self) -> None:
        self._frames: Tuple[str, str] = (rospy.get_param("~odom_frame", "odom"),
                                         rospy.get_param("~base_frame", "base_footprint"))
        # Time as the robot has it: simulated where there is such, else steady.
        self._now = (rospy.get_time if rospy.get_param("/use_sim_time", False)
                     else time.monotonic)
        self._lock = threading.Lock()
        self._reckoner = DeadReckoner()
        self._heard: Optional[Tuple[int, int]] = None
        self._odometry = rospy.Publisher("odom", Odometry, queue_size=10)
        self._transforms = tf2_ros.TransformBroadcaster()
        self._subscribers = [
            rospy.Subscriber("repertoire", Repertoire, self._learn, queue_size=1),
            rospy.Subscriber("executor/state", ExecutorState, self._hear, queue_size=50)]

    def _learn(self, message: Any) -> None:
        with self._lock:
            self._reckoner.learn(promises_of(message), message.behavior_duration_s)

    def _hear(self, message: Any) -> None:
        heard = (message.state, message.entry_id)
        with self._lock:
            # The state comes once a second although it has not changed.
            if heard == self._heard:
                return
            self._heard = heard
            if message.state == ExecutorState.WALKING:
                self._reckoner.begin(message.entry_id, self._now())
            else:
                self._reckoner.end(message.state == ExecutorState.READY, self._now())

    def publish(self) -> None:
        """Tells where the robot should be now."""
        with self._lock:
            pose, variance = self._reckoner.pose(self._now()), self._reckoner.variance()
        odometry = Odometry(child_frame_id=self._frames[1])
        odometry.header.stamp = rospy.Time.now()
        odometry.header.frame_id = self._frames[0]
        odometry.pose.pose = to_message(pose)
        covariance = [0.0] * 36
        covariance[0] = covariance[7] = variance.position
        covariance[35] = variance.heading
        odometry.pose.covariance = covariance
        self._odometry.publish(odometry)
        transform = TransformStamped(header=odometry.header, child_frame_id=self._frames[1])
        transform.transform.translation.x, transform.transform.translation.y = pose[0], pose[1]
        transform.transform.rotation = odometry.pose.pose.orientation
        self._transforms.sendTransform(transform)


def main() -> int:
    """Publishes until ROS shuts down."""
    rospy.init_node("predicted_odometry")
    rate_hz = rospy.get_param("~rate_hz", 20.0)
    if not isinstance(rate_hz, (int, float)) or not 1.0 <= rate_hz <= 1000.0:
        rospy.logfatal("~rate_hz is %r: expected 1 .. 1000.", rate_hz)
        return 2
    odometry = PredictedOdometry()
    period_s = 1.0 / rate_hz
    # Steady time: simulated time may stand still.
    while not rospy.is_shutdown():
        odometry.publish()
        time.sleep(period_s)
    return 0
