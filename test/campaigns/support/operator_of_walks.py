"""Puts a walking session in order, and looks at what its executor commands."""
import time
import xml.etree.ElementTree

import rospy
from hexapod_repertoire.msg import ExecutorState
from hexapod_repertoire.srv import Disturb, GoToResponse
from nav_msgs.msg import OccupancyGrid
from sensor_msgs.msg import JointState
from std_msgs.msg import Bool
from std_srvs.srv import SetBool

from walking_client import goal_message
from walking_session import ROOT, wait_for

ARM_TIMEOUT_S = 60.0
ANSWER_TIMEOUT_S = 60.0
# A second source of joint_states is remembered so long, and keeps the executor from being armed.
QUIET_S = 2.1
UNARMED = (ExecutorState.DISARMED, ExecutorState.STOPPED, ExecutorState.FAULT)
LIMIT_SLACK_RAD = 1e-6


def joint_limits():
    """{joint: (lower, upper)} of the URDF [rad]."""
    root = xml.etree.ElementTree.parse(ROOT / "urdf/hexapod.urdf").getroot()
    return {joint.get("name"): tuple(float(joint.find("limit").get(end))
                                     for end in ("lower", "upper"))
            for joint in root.iter("joint") if joint.find("limit") is not None}


class SetPoints:
    """What the executor commands: how much of it, and what lies outside the joints' limits."""

    def __init__(self, client):
        self._client, self._limits = client, joint_limits()
        self.count, self.walking, self.outside = 0, 0, []
        self._subscriber = rospy.Subscriber("joint_command", JointState, self._take)

    def _take(self, message):
        if message._connection_header["callerid"] != "/executor":
            return
        self.count += 1
        self.walking += self._client.state == ExecutorState.WALKING
        for name, position in zip(message.name, message.position):
            lower, upper = self._limits[name]
            if not lower - LIMIT_SLACK_RAD <= position <= upper + LIMIT_SLACK_RAD:
                self.outside.append(f"{name}: {position} rad")


class Operator:
    """Puts a session in order, and sees whether it walks."""

    def __init__(self, client, dice):
        self._client, self._dice = client, dice

    def _somewhere(self):
        x, y, _ = self._client.pose()
        return goal_message(x + self._dice.uniform(-0.3, 0.3), y + self._dice.uniform(-0.3, 0.3), 0)

    def put_in_order(self, listeners):
        """Has all calls answered, repairs, releases, forgets, shows a free floor, arms, and sends the
        robot somewhere."""
        self._client.call("planner/cancel")
        unanswered = listeners.unanswered(ANSWER_TIMEOUT_S)
        assert not unanswered, f"{unanswered} calls of services are not answered"
        time.sleep(QUIET_S)
        rospy.ServiceProxy("simulated_robot/pause", SetBool)(False)
        rospy.ServiceProxy("simulated_robot/disturb", Disturb)()
        self._client.call("simulated_robot/reset")
        self._client.call("planner/reset_belief")
        free = OccupancyGrid(data=[0] * 40000)
        free.header.frame_id, free.info.origin.orientation.w = "odom", 1.0
        free.info.resolution, free.info.width, free.info.height = 0.5, 200, 200
        free.info.origin.position.x = free.info.origin.position.y = -50.0
        listeners.publish("/map", free)
        listeners.publish("/e_stop", Bool(False))
        self.arm()
        self._client.simple_goal(self._somewhere())

    def arm(self):
        """Until it can be sent somewhere."""
        deadline = time.monotonic() + ARM_TIMEOUT_S
        answer = ""
        while self._client.state not in (ExecutorState.READY, ExecutorState.WALKING):
            if self._client.state in UNARMED:
                answer = self._client.call("executor/arm").message
            assert time.monotonic() < deadline, f"the executor cannot be armed: {answer}"
            time.sleep(0.02)

    def walk(self, timeout_s=90.0):
        """What is wrong with a real goal, "" when it is reached; sent again, as a person would, while
        the last garbage is on its way."""
        deadline = time.monotonic() + timeout_s
        while time.monotonic() < deadline:
            self.arm()
            asked = self._client.go_to(self._somewhere(), wait=True)
            wait_for(lambda a=asked: a.answers, timeout_s, "an answer")
            if asked.answers[0].code == GoToResponse.SUCCEEDED:
                return ""
            time.sleep(1.0)
        return asked.answers[0].message
