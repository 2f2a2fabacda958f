"""Sends goals to a walking session and watches its joints, as lines on standard input ask for.

    walk_to TIMEOUT_S X_M Y_M     waits for the executor, walks there and waits for the end
    send_goal TIMEOUT_S X_M Y_M   sends a goal that the robot then walks to
    wait_still TIMEOUT_S          waits until neither commands nor measured angles change

Each is answered by a line of JSON: {"problem": "" or a sentence}.
"""
import json
import sys
import threading
import time

import rospy
from hexapod_repertoire.msg import ExecutorState
from hexapod_repertoire.srv import GoTo, GoToRequest, GoToResponse
from sensor_msgs.msg import JointState
from std_srvs.srv import Trigger

# Servos that hold a pose tremble a little.
STILL_RAD = 0.02
STILL_FOR_S = 1.0


class Angles:
    """When a topic's angles last changed."""

    def __init__(self, topic):
        self._lock = threading.Lock()
        self._kept = None
        self._changed_s = time.monotonic()
        self._subscriber = rospy.Subscriber(topic, JointState, self._receive)

    def _receive(self, message):
        with self._lock:
            if self._kept is None or len(self._kept) != len(message.position) or any(
                    abs(a - b) > STILL_RAD for a, b in zip(self._kept, message.position)):
                self._kept = message.position
                self._changed_s = time.monotonic()

    def still_for_s(self):
        with self._lock:
            return time.monotonic() - self._changed_s


class Observer:
    def __init__(self):
        self._state = None
        rospy.Subscriber("executor/state", ExecutorState, self._keep_state)
        self._watched = [Angles("joint_command"), Angles("joint_states")]

    def _keep_state(self, message):
        self._state = message.state

    @staticmethod
    def _go(x_m, y_m, wait):
        request = GoToRequest(yaw_tolerance_rad=-1.0, xy_tolerance_m=0.1, wait=wait)
        request.target_pose.header.frame_id = "odom"
        request.target_pose.pose.position.x = x_m
        request.target_pose.pose.position.y = y_m
        request.target_pose.pose.orientation.w = 1.0
        rospy.wait_for_service("go_to", 20.0)
        return rospy.ServiceProxy("go_to", GoTo)(request)

    def walk_to(self, timeout_s, x_m, y_m):
        """As a person would: sends the goal again, and arms again, where a machine that is too busy
        let the executor miss its feedback."""
        deadline = time.monotonic() + timeout_s
        message = "the executor is not ready"
        while time.monotonic() < deadline:
            if self._state in (ExecutorState.FAULT, ExecutorState.DISARMED):
                rospy.ServiceProxy("executor/arm", Trigger)()
            if self._state == ExecutorState.READY:
                answer = self._go(x_m, y_m, True)
                message = answer.message
                if answer.code == GoToResponse.SUCCEEDED:
                    return ""
            time.sleep(0.2)
        return message

    def send_goal(self, timeout_s, x_m, y_m):
        del timeout_s
        answer = self._go(x_m, y_m, False)
        return "" if answer.accepted else answer.message

    def wait_still(self, timeout_s):
        deadline = time.monotonic() + timeout_s
        while time.monotonic() < deadline:
            if all(angles.still_for_s() > STILL_FOR_S for angles in self._watched):
                return ""
            time.sleep(0.05)
        return f"the joints still move {timeout_s} s later"

    def answer(self, words):
        try:
            return getattr(self, words[0])(*map(float, words[1:]))
        except (rospy.ROSException, rospy.ServiceException) as error:
            return str(error)


def wait_for_master(timeout_s=60.0):
    deadline = time.monotonic() + timeout_s
    while time.monotonic() < deadline:
        try:
            rospy.get_master().getPid()
            return
        except OSError:
            time.sleep(0.1)


def main():
    answers, sys.stdout = sys.stdout, sys.stderr  # rospy prints what it logs
    wait_for_master()
    rospy.init_node("walk_observer", disable_signals=True)
    observer = Observer()
    for line in sys.stdin:
        print(json.dumps({"problem": observer.answer(line.split())}), file=answers, flush=True)


if __name__ == "__main__":
    main()
