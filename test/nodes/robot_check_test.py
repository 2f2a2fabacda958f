"""Before a robot walks, and without odometry: checks that find what is wrong, walks that arrive."""
import math
import os
import subprocess
import sys

import pytest

rospy = pytest.importorskip("rospy")
# pylint: disable=wrong-import-position
from hexapod_repertoire.msg import ExecutorState
from hexapod_repertoire.srv import Disturb, GoToResponse
from sensor_msgs.msg import JointState
from std_srvs.srv import Trigger
from walking_session import BINARIES, ROOT, WalkingSession, wait_for

WALL_TIMEOUT_S = 60.0
NODES = ("repertoire_server", "simulated_robot", "executor")


def check(*words):
    """Runs the command line; (exit code, what it printed)."""
    result = subprocess.run(
        [sys.executable, "-m", "hexapod_repertoire.robot_check", "--programs", str(BINARIES), *words],
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True,
        timeout=4 * WALL_TIMEOUT_S, env=os.environ, check=False)
    return result.returncode, result.stdout


def wait_ready():
    states = []
    subscriber = rospy.Subscriber("executor/state", ExecutorState, states.append, queue_size=10)
    wait_for(lambda: states and states[-1].state == ExecutorState.READY, WALL_TIMEOUT_S,
             "an executor that is ready")
    subscriber.unregister()


@pytest.fixture(scope="module", name="session")
def start_session():
    with WalkingSession(real_time_factor=4.0, sim_time=True,
                        nodes=NODES + ("planner",)) as session:
        rospy.init_node("robot_check_test", disable_signals=True)
        wait_ready()
        yield session


def test_a_good_robot_is_ready(session):
    code, text = check("preflight")
    assert code == 0, text
    assert "/simulated_robot listens to /joint_command" in text
    assert "Ready: with its feet off the floor" in text


def test_a_second_teller_is_found(session):
    publisher = rospy.Publisher("joint_states", JointState, queue_size=1)
    message = JointState(name=["body_leg_0"], position=[0.0])
    timer = rospy.Timer(rospy.Duration(0.05), lambda _: publisher.publish(message))
    try:
        wait_for(publisher.get_num_connections, WALL_TIMEOUT_S, "a subscriber")
        code, text = check("preflight")
    finally:
        timer.shutdown()
        publisher.unregister()
    assert code == 1, text
    assert "/robot_check_test, /simulated_robot all tell body_leg_0" in text


def test_every_joint_of_a_good_robot_moves_as_it_should(session):
    wait_ready()
    code, text = check("joint_check", "--yes")
    assert code == 0, text
    assert text.count("alone: watch the foot go") == 18
    assert "WRONG" not in text


def test_a_leg_that_hangs_limp_is_found(session):
    disturb = rospy.ServiceProxy("simulated_robot/disturb", Disturb)
    disturb(legs=["left_middle"], states=[3])
    try:
        code, text = check("joint_check", "--yes")
    finally:
        disturb()
        rospy.ServiceProxy("simulated_robot/reset", Trigger)()
        rospy.ServiceProxy("executor/arm", Trigger)()
        wait_ready()
    assert code == 1, text
    assert "leg_1_" in text


def test_nothing_is_moved_by_an_executor_that_is_disarmed(session):
    rospy.ServiceProxy("executor/disarm", Trigger)()
    code, text = check("joint_check", "--yes")
    assert code == 1
    assert "arm it with ./run arm" in text and "watch" not in text
    rospy.ServiceProxy("executor/arm", Trigger)()
    wait_ready()


def launched(*arguments):
    """Runs joint_check.launch with a simulated robot, four times as fast; (code, what it said)."""
    result = subprocess.run(
        [sys.executable, "-m", "hexapod_repertoire.launch", str(ROOT / "launch/joint_check.launch"),
         "simulated:=true", "publish_clock:=true", "real_time_factor:=4", *arguments],
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True,
        timeout=4 * WALL_TIMEOUT_S, env=os.environ, check=False)
    return result.returncode, result.stdout


def test_the_launch_file_moves_every_joint_once_the_feet_are_off_the_floor():
    with WalkingSession(nodes=()):
        code, text = launched("feet_off_floor:=true")
    assert code == 0, text
    assert text.count("alone: watch the foot go") == 18, text
    assert "WRONG" not in text
    assert "Every joint moved as far as it should, and no other." in text


def test_the_launch_file_only_looks_otherwise():
    with WalkingSession(nodes=()):
        code, text = launched()
    assert code == 0, text
    assert "watch the foot go" not in text
    assert "to be armed: ./run arm" in text


def test_a_walk_arrives_without_measured_odometry():
    with WalkingSession(real_time_factor=4.0, sim_time=True, nodes=()) as session:
        session.start("repertoire_server")
        session.start("simulated_robot", remappings=("tf:=true_tf", "odom:=true_odom"))
        session.start("executor")
        session.start("predicted_odometry.py", name="predicted_odometry")
        session.start("planner")
        text = walk_blindly()
    told, x_m, y_m = map(float, text.split()[-3:])
    assert told == GoToResponse.SUCCEEDED, text
    assert math.hypot(x_m - 0.6, y_m - 0.2) < 0.08, text


def walk_blindly():
    """In a process of its own: this one is a client of another master."""
    code = f"""
import rospy
from hexapod_repertoire.msg import WalkToGoal
from hexapod_repertoire.demo import to_message
from hexapod_repertoire.waiting import Latest, Walker
from hexapod_repertoire.msg import ExecutorState
from nav_msgs.msg import Odometry
rospy.init_node("blind", disable_signals=True)
Latest("executor/state", ExecutorState).wait(
    lambda s: s.state == ExecutorState.READY, {WALL_TIMEOUT_S}, "no executor")
Latest("odom", Odometry).wait(lambda m: True, {WALL_TIMEOUT_S}, "no odometry")
goal = WalkToGoal()
goal.target_pose.header.frame_id = "odom"
goal.target_pose.pose = to_message((0.6, 0.2, 0.5))
result = Walker().walk(goal)
truth = Latest("true_odom", Odometry).wait(lambda m: True, 20.0, "no truth").pose.pose.position
print(result.message, result.code, truth.x, truth.y)
"""
    result = subprocess.run([sys.executable, "-c", code], stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, universal_newlines=True, env=os.environ,
                            timeout=4 * WALL_TIMEOUT_S, check=False)
    assert result.returncode == 0, result.stdout
    return result.stdout
