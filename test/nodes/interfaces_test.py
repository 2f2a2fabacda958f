"""A walk by every command interface, to a robot whose servos have other names, signs and zeros.

Behind each interface stands a driver that turns what comes on the wire back into the simulated robot's
own joints, and tells joint_states as six drivers do, one per leg, 20 times a second, positions alone.
Were a sign, an offset or an order wrong, the robot would not get to its goal.
"""
import math
import os
import subprocess
import sys
import threading

import pytest

rospy = pytest.importorskip("rospy")
# pylint: disable=wrong-import-position
import genpy.dynamic
import yaml
from hexapod_repertoire import servo_relay
from hexapod_repertoire.demo import to_message
from hexapod_repertoire.msg import ExecutorState, WalkToGoal
from hexapod_repertoire.waiting import Latest, Walker
from nav_msgs.msg import Odometry
from sensor_msgs.msg import JointState
from std_msgs.msg import Float64, Float64MultiArray
from std_srvs.srv import Trigger
from trajectory_msgs.msg import JointTrajectory
from walking_session import WalkingSession, wait_for

WALL_TIMEOUT_S = 60.0
JOINTS = [name for leg in range(6)
          for name in (f"body_leg_{leg}", f"leg_{leg}_1_2", f"leg_{leg}_2_3")]
WIRE = {joint: {"name": f"servo_{17 - i}", "sign": 1 if i % 3 else -1,
                "offset_rad": round(0.05 * i - 0.4, 3)} for i, joint in enumerate(JOINTS)}
JOINT_OF = {wire["name"]: joint for joint, wire in WIRE.items()}
NAMES = [WIRE[joint]["name"] for joint in JOINTS]
LEGS = "abcdef"  # their controllers
GROUP_ORDER = sorted(NAMES)
DRIVER_RATE_HZ = 20.0

JOINT_GROUP = genpy.dynamic.generate_dynamic(
    "interbotix_xs_msgs/JointGroupCommand", "string name\nfloat32[] cmd\n")[
        "interbotix_xs_msgs/JointGroupCommand"]
SERVO_TYPES = genpy.dynamic.generate_dynamic(
    "i2cpwm_board/ServoArray",
    "i2cpwm_board/Servo[] servos\n" + "=" * 80 +
    "\nMSG: i2cpwm_board/Servo\nint16 servo\nfloat32 value\n")
PULSES = {name: {"servo": i + 1, "per_rad": 130.4 if i % 2 else -100.0}
          for i, name in enumerate(NAMES)}


class Drivers:
    """The servos of all legs."""

    def __init__(self):
        self._lock = threading.Lock()
        self._angles_rad = {}
        self._commands = rospy.Publisher("servo_command", JointState, queue_size=1)
        self._states = rospy.Publisher("joint_states", JointState, queue_size=12)
        self._subscribers = [rospy.Subscriber("true_joint_states", JointState, self._measure,
                                              queue_size=1)]
        self._turn = 0
        self._timer = rospy.Timer(rospy.Duration(1.0 / (6 * DRIVER_RATE_HZ)), self._tell)

    def listen(self, topic, message_type, values):
        """Obeys a topic from now on; values(message): wire angles by wire name."""
        self._subscribers.append(rospy.Subscriber(
            topic, message_type, lambda message: self._obey(values(message)), queue_size=10,
            tcp_nodelay=True))

    def forget(self):
        """Obeys nobody any more."""
        while len(self._subscribers) > 1:
            self._subscribers.pop().unregister()

    def _obey(self, wire):
        if not wire:
            return
        message = JointState(name=[JOINT_OF[name] for name in wire])
        message.header.stamp = rospy.Time.now()
        message.position = [(angle - WIRE[JOINT_OF[name]]["offset_rad"]) *
                            WIRE[JOINT_OF[name]]["sign"] for name, angle in wire.items()]
        self._commands.publish(message)

    def _measure(self, message):
        with self._lock:
            self._angles_rad = dict(zip(message.name, message.position))

    def _tell(self, _):
        self._turn = (self._turn + 1) % 6
        joints = JOINTS[3 * self._turn:3 * self._turn + 3]
        with self._lock:
            if not self._angles_rad:
                return
            positions = [WIRE[joint]["sign"] * self._angles_rad[joint] + WIRE[joint]["offset_rad"]
                         for joint in joints]
        message = JointState(name=[WIRE[joint]["name"] for joint in joints], position=positions)
        message.header.stamp = rospy.Time.now()
        self._states.publish(message)


@pytest.fixture(scope="module", name="session")
def start_session():
    with WalkingSession(real_time_factor=5.0, sim_time=True, nodes=()) as session:
        session.joint_map = session.folder / "map.yaml"
        session.joint_map.write_text(yaml.safe_dump({"joints": WIRE}))
        session.start("simulated_robot", remappings=("joint_states:=true_joint_states",
                                                     "joint_command:=servo_command"))
        session.start("repertoire_server")
        rospy.init_node("interfaces_test", disable_signals=True)
        session.drivers = Drivers()
        session.start("planner")
        yield session


def whole(wires):
    """Merges the parts of a command: obeyed when all have come, the newest of each."""
    held = {}

    def merge(message):
        held.update(wires(message))
        if len(held) < len(NAMES):
            return {}
        command = dict(held)
        held.clear()
        return command
    return merge


def of_trajectory(message):
    return dict(zip(message.joint_names, message.points[0].positions))


def of_ticks(message):
    by_number = {pulse["servo"]: (name, pulse["per_rad"]) for name, pulse in PULSES.items()}
    return {by_number[servo.servo][0]: (servo.value - 307.2) / by_number[servo.servo][1]
            for servo in message.servos}


def wires_of(interface):
    """What a driver of one command interface listens to: (topic, type, values) each."""
    merge = whole(of_trajectory)
    merge_joints = whole(lambda pair: dict([pair]))
    return {
        "joint_trajectory": [("position_controller/command", JointTrajectory, of_trajectory)],
        "joint_trajectory per leg": [(f"{leg}/command", JointTrajectory, merge) for leg in LEGS],
        "joint_group_position": [("position_controller/command", Float64MultiArray,
                                  lambda message: dict(zip(NAMES, message.data)))],
        "per_joint": [(f"{name}_position_controller/command", Float64,
                       lambda message, name=name: merge_joints((name, message.data)))
                      for name in NAMES]}[interface]


def walk(session, interface, goal):
    """Starts an executor, walks to a goal, ends the executor; how far from the goal it led [m]."""
    controllers = ", ".join(LEGS) if interface.endswith("per leg") else "position_controller"
    for name, value in {"command_interface": interface.split()[0], "controllers": controllers,
                        "joint_map": str(session.joint_map), "auto_arm": False}.items():
        session.set_param(f"/executor/{name}", value)
    assert rospy.ServiceProxy("simulated_robot/reset", Trigger)().success
    session.start("executor")
    try:
        states = Latest("executor/state", ExecutorState)
        rospy.wait_for_service("executor/arm", WALL_TIMEOUT_S)
        arm = rospy.ServiceProxy("executor/arm", Trigger)
        wait_for(lambda: arm().success, WALL_TIMEOUT_S, "an executor that can be armed")
        states.wait(lambda state: state.state == ExecutorState.READY, WALL_TIMEOUT_S,
                    "no executor that is ready")
        target = WalkToGoal()
        target.target_pose.header.frame_id = "odom"
        target.target_pose.pose = to_message(goal)
        result = Walker().walk(target)
        assert result.code == 0, result.message
        at = Latest("odom", Odometry).wait(lambda _: True, 20.0, "no odometry").pose.pose.position
        return math.hypot(at.x - goal[0], at.y - goal[1])
    finally:
        session.drivers.forget()
        session.leave("executor")


# joint_state: by the relays, below.
@pytest.mark.parametrize("interface", [
    "joint_trajectory", "joint_trajectory per leg", "joint_group_position", "per_joint"])
def test_a_walk_by_each_interface(session, interface):
    for wire in wires_of(interface):
        session.drivers.listen(*wire)
    assert walk(session, interface, (0.25, 0.05, 0.1)) < 0.08


RELAY = """
import sys
sys.path.insert(0, {folder!r})
import interfaces_test
from hexapod_repertoire import servo_relay
known = {{"interbotix_xs_msgs/JointGroupCommand": interfaces_test.JOINT_GROUP,
          **interfaces_test.SERVO_TYPES}}
servo_relay.get_message_class = known.get
sys.exit(servo_relay.main())
"""
RELAYS = {
    "interbotix": ({"group": "legs", "joints": GROUP_ORDER}, "commands/joint_group", JOINT_GROUP,
                   lambda message: dict(zip(GROUP_ORDER, message.cmd))),
    "servo_array": ({"servos": PULSES}, "servos_absolute", SERVO_TYPES["i2cpwm_board/ServoArray"],
                    of_ticks)}


@pytest.mark.parametrize("driver", sorted(RELAYS))
def test_a_walk_by_each_relay(session, driver):
    config, topic, message_type, values = RELAYS[driver]
    file = session.folder / f"{driver}.yaml"
    file.write_text(yaml.safe_dump(config))
    rospy.set_param("/servo_relay", {"driver": driver, "config": str(file)})
    session.drivers.listen(topic, message_type, values)
    relay = subprocess.Popen(  # pylint: disable=consider-using-with
        [sys.executable, "-c", RELAY.format(folder=os.path.dirname(os.path.abspath(__file__)))],
        env=os.environ)
    try:
        assert walk(session, "joint_state", (0.25, 0.05, 0.1)) < 0.08
    finally:
        relay.kill()
        relay.wait()


def test_a_relay_without_its_message_says_so():
    with pytest.raises(servo_relay.RelayError, match="interbotix_xs_msgs/JointGroupCommand is not"):
        servo_relay.converter("interbotix", {})
    with pytest.raises(servo_relay.RelayError, match="expected interbotix or servo_array"):
        servo_relay.converter("smoke", {})
