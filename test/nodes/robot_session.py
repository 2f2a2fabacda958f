"""What the tests of executor and simulated robot share: waiting, recording, asking."""
import math
import os
import subprocess
import sys
import threading
import time
import xmlrpc.client

import actionlib
import rosgraph
import rospy
from hexapod_repertoire.msg import (ExecuteBehaviorAction, ExecuteBehaviorGoal,
                                    ExecuteBehaviorResult, ExecutorState)
from nav_msgs.msg import Odometry
from sensor_msgs.msg import JointState
from std_srvs.srv import Trigger

PERIOD_NS = 30_000_000
LATENCY_NS = 60_000_000
# A tripod gait that walks about half a metre, and a turn.
TRIPOD = [4, 0, 4, 1, 4, 2, 4, 3, 4, 0, 4, 1, 4, 0, 4, 3, 4, 2, 4, 1, 4, 0, 4, 3]
TURN = [2, 0, 2, 1, 2, 2, 2, 3, 2, 0, 2, 1, 2, 2, 2, 3, 2, 0, 2, 1, 2, 2, 2, 3]


def wait_for(condition, timeout_s, what):
    """Waits until condition() is truthy and returns it; fails after timeout_s of wall time."""
    deadline = time.monotonic() + timeout_s
    while time.monotonic() < deadline:
        value = condition()
        if value:
            return value
        time.sleep(0.005)
    raise AssertionError("Waited %g s in vain for %s." % (timeout_s, what))


def pid_of(node):
    """The process id of a node."""
    uri = rosgraph.Master(rospy.get_name()).lookupNode(node)
    return xmlrpc.client.ServerProxy(uri).getPid(rospy.get_name())[2]


class Recorder:
    """Keeps every message of a topic, in order."""

    def __init__(self, topic, message_type):
        self._lock = threading.Lock()
        self._messages = []
        self._subscriber = rospy.Subscriber(topic, message_type, self._add, queue_size=1000,
                                            tcp_nodelay=True)

    def _add(self, message):
        with self._lock:
            self._messages.append(message)

    def all(self):
        with self._lock:
            return list(self._messages)

    def last(self):
        with self._lock:
            return self._messages[-1] if self._messages else None

    def count(self):
        with self._lock:
            return len(self._messages)

    def clear(self):
        with self._lock:
            self._messages = []

    def next(self, timeout_s=5.0):
        """The first message that comes from now on."""
        before = self.count()
        wait_for(lambda: self.count() > before, timeout_s, "a message on " + self._subscriber.name)
        return self.all()[before]

    def wait_publisher(self):
        wait_for(lambda: self._subscriber.get_num_connections() > 0, 20.0,
                 "a publisher of " + self._subscriber.name)


JOINTS = [name for leg in range(6)
          for name in ("body_leg_%d" % leg, "leg_%d_1_2" % leg, "leg_%d_2_3" % leg)]


class FakeRobot:
    """Publishes joint_states: the last command, after `spoil` has had its way with it.

    At 100 Hz for all joints; with `leg_by_leg` as six drivers of 20 Hz do, one leg after the other.
    """

    def __init__(self):
        self.spoil = lambda message: message
        self.leg_by_leg = False
        self._turn = 0
        self._positions = dict.fromkeys(JOINTS, 0.0)
        self._publisher = rospy.Publisher("joint_states", JointState, queue_size=6)
        self._subscriber = rospy.Subscriber("joint_command", JointState, self._obey,
                                            tcp_nodelay=True)
        self._timer = rospy.Timer(rospy.Duration(1.0 / 120.0), self._publish)

    def _obey(self, message):
        self._positions = dict(zip(message.name, message.position))

    def _publish(self, _):
        self._turn += 1
        first = 3 * (self._turn % 6)
        names = JOINTS[first:first + 3] if self.leg_by_leg else list(JOINTS)
        message = JointState(name=names, position=[self._positions[j] for j in names])
        message.header.stamp = rospy.Time.now()
        message = self.spoil(message)
        if message is not None:
            self._publisher.publish(message)


class OtherNode:
    """Python code in a process of its own, with `rospy` and the messages; killed at the end.

    What it prints comes line by line.
    """

    BEGIN = """
import sys, rospy, actionlib
from sensor_msgs.msg import JointState
from hexapod_repertoire.msg import ExecuteBehaviorAction, ExecuteBehaviorGoal
rospy.init_node(sys.argv[1])
"""

    def __init__(self, name, code, **environment):
        self._process = subprocess.Popen(
            [sys.executable, "-u", "-c", self.BEGIN + code, name], stdout=subprocess.PIPE,
            universal_newlines=True, env=dict(os.environ, **environment))

    def line(self):
        return self._process.stdout.readline().strip()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._process.kill()
        self._process.communicate()


class Session:
    """An executor, seen from outside."""

    def __init__(self):
        self.commands = Recorder("joint_command", JointState)
        self.states = Recorder("executor/state", ExecutorState)
        self.client = actionlib.ActionClient("execute", ExecuteBehaviorAction)
        assert self.client.wait_for_server(rospy.Duration(20.0)), "no action server"
        self.states.wait_publisher()
        self.commands.wait_publisher()

    def state(self):
        last = self.states.last()
        return last.state if last else None

    def wait_state(self, state, timeout_s=10.0):
        wait_for(lambda: self.state() == state, timeout_s, "executor state %d" % state)

    def call(self, name):
        rospy.wait_for_service("executor/" + name, 10.0)
        return rospy.ServiceProxy("executor/" + name, Trigger)()

    def make_ready(self):
        wait_for(lambda: self.call("arm").success, 10.0, "the executor to arm")
        self.wait_state(ExecutorState.READY)

    def send(self, genome=None, entry_id=-1, run_id=""):
        goal = ExecuteBehaviorGoal(entry_id=entry_id, run_id=run_id, genome=bytes(genome or []))
        return self.client.send_goal(goal)

    def result(self, handle, timeout_s=15.0):
        """The goal's result; its terminal state is handle.get_terminal_state()."""
        wait_for(lambda: handle.get_comm_state() == actionlib.CommState.DONE, timeout_s,
                 "the end of a behaviour")
        return handle.get_result()


def played(result):
    """True when a behaviour came to its end, skipped commands of a busy machine or not."""
    return result.code in (ExecuteBehaviorResult.SUCCEEDED, ExecuteBehaviorResult.SKIPPED)


def stamp_ns(message):
    return message.header.stamp.to_nsec()


def planar(odometry):
    """(x, y, yaw) of an Odometry."""
    pose = odometry.pose.pose
    return (pose.position.x, pose.position.y,
            2.0 * math.atan2(pose.orientation.z, pose.orientation.w))


def moved(start, end):
    """The pose `end` in the frame of the pose `start`."""
    dx, dy = end[0] - start[0], end[1] - start[1]
    cosine, sine = math.cos(start[2]), math.sin(start[2])
    turn = end[2] - start[2]
    return (cosine * dx + sine * dy, cosine * dy - sine * dx,
            math.atan2(math.sin(turn), math.cos(turn)))


def odometry_at(odometry, time_ns, timeout_s=5.0):
    """The first odometry not before time_ns, from a Recorder of odom."""
    def first():
        return next((m for m in odometry.all() if stamp_ns(m) >= time_ns), None)
    return wait_for(first, timeout_s, "odom at %d" % time_ns)


# The stand after a reset was settled at a finer step; by now it has settled at the present one too.
SETTLED_STEPS = 100


def offline_outcome(binaries, root, genome):
    """((x, y, yaw), robot id) of a genome, as the learner plays it, from the settled stand."""
    line = subprocess.check_output(
        [binaries + "/offline_outcome", root + "/urdf/hexapod.urdf",
         root + "/config/hexapod.yaml", "".join(map(str, genome)),
         str(SETTLED_STEPS)], text=True).split()
    return tuple(map(float, line[:3])), line[3]


def end_pose_error(odometry, result, expected):
    """(distance [m], angle [rad]) between the pose measured after a behaviour and `expected`."""
    finished_ns = result.finished.to_nsec()
    count = 130  # 3 s of gait, 0.6 s back, 0.3 s of rest
    first_ns = finished_ns - (count - 1) * PERIOD_NS
    start = odometry_at(odometry, first_ns + LATENCY_NS)
    end = odometry_at(odometry, finished_ns + LATENCY_NS + PERIOD_NS)
    pose = moved(planar(start), planar(end))
    turn = pose[2] - expected[2]
    return (math.hypot(pose[0] - expected[0], pose[1] - expected[1]),
            abs(math.atan2(math.sin(turn), math.cos(turn))))


def check_end_pose(test, session, odometry, runs):
    """Plays TRIPOD from the settled stand; each run must end where the learner says."""
    expected, _ = offline_outcome(rospy.get_param("~binaries"), rospy.get_param("~root"), TRIPOD)
    whole = 0
    for run in range(3 * runs):
        test.assertTrue(rospy.ServiceProxy("simulated_robot/reset", Trigger)().success)
        odometry.clear()
        wait_for(lambda: odometry.count() > SETTLED_STEPS, 10.0, "the stand")
        result = session.result(session.send(TRIPOD))
        if result.code == ExecuteBehaviorResult.SKIPPED:
            continue  # the machine was too busy; another try
        test.assertEqual(result.code, ExecuteBehaviorResult.SUCCEEDED, result.message)
        distance_m, turn_rad = end_pose_error(odometry, result, expected)
        print("run %d: end pose off by %.2e m, %.2e rad" % (run, distance_m, turn_rad))
        test.assertLess(distance_m, 1e-3)
        test.assertLess(turn_rad, 1e-2)
        whole += 1
        if whole == runs:
            return
    test.fail("%d of %d runs came to their end without skipped commands" % (whole, 3 * runs))


def odometry_recorder():
    recorder = Recorder("odom", Odometry)
    recorder.wait_publisher()
    return recorder
