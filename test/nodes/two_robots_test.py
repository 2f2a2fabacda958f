"""Two robots in two namespaces, with frames of their own, walk side by side."""
import math
import os
import subprocess
import sys

import pytest

rospy = pytest.importorskip("rospy")
# pylint: disable=wrong-import-position
import tf2_msgs.msg
from visualization_msgs.msg import MarkerArray

from walking_session import ROOT, WalkingSession, wait_for

WALL_TIMEOUT_S = 60.0
GOALS = {"left": (0.25, 0.1, 0.2), "right": (-0.2, -0.1, -0.2)}

# Walks by the actions and topics of one namespace; prints the code and the measured end.
WALK = """
import sys, rospy
from hexapod_repertoire.demo import to_message
from hexapod_repertoire.msg import ExecutorState, WalkToGoal
from hexapod_repertoire.waiting import Latest, Walker
from nav_msgs.msg import Odometry
rospy.init_node("walker_" + sys.argv[1], disable_signals=True)
Latest("executor/state", ExecutorState).wait(
    lambda s: s.state == ExecutorState.READY, 60.0, "no executor")
goal = WalkToGoal()
goal.target_pose.header.frame_id = sys.argv[1] + "/odom"
goal.target_pose.pose = to_message(tuple(map(float, sys.argv[2:5])))
result = Walker().walk(goal)
odometry = Latest("odom", Odometry).wait(lambda m: True, 20.0, "no odometry")
at = odometry.pose.pose.position
print(result.message)
print(result.code, odometry.header.frame_id, odometry.child_frame_id, at.x, at.y)
"""


def launch_file(folder, repertoire):
    """Includes walk.launch once per robot, and what rviz.launch starts beside rviz."""
    robots = "".join(f"""
      <group ns="{name}">
        <include file="{ROOT}/launch/walk.launch">
          <arg name="repertoire_file" value="{repertoire}"/>
          <arg name="engine" value="reduced"/>
          <arg name="tf_prefix" value="{name}"/>
        </include>
        <node name="browser" pkg="hexapod_repertoire" type="browser">
          <param name="robot_config" value="{ROOT}/config/hexapod.yaml"/>
          <param name="player" value="robot"/>
          <param name="global_frame" value="{name}/odom"/>
          <param name="base_frame" value="{name}/base_footprint"/>
        </node>
      </group>""" for name in GOALS)
    file = folder / "two.launch"
    file.write_text(f"<launch>{robots}</launch>")
    return file


@pytest.fixture(scope="module", name="session")
def start_session():
    with WalkingSession(nodes=()) as session:
        rospy.init_node("two_robots_test", disable_signals=True)
        file = launch_file(session.folder, session.folder / "small.db")
        launch = subprocess.Popen(  # pylint: disable=consider-using-with
            [sys.executable, "-m", "hexapod_repertoire.launch", str(file)],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=os.environ)
        try:
            yield session
        finally:
            launch.terminate()
            launch.wait(WALL_TIMEOUT_S)


def test_each_repertoire_is_shown_where_its_robot_stands(session):
    heard = set()
    subscriber = rospy.Subscriber("/tf_static", tf2_msgs.msg.TFMessage, lambda message: heard.update(
        (one.header.frame_id, one.child_frame_id) for one in message.transforms), queue_size=10)
    for name in GOALS:
        shown = rospy.wait_for_message(f"/{name}/repertoire_markers", MarkerArray, WALL_TIMEOUT_S)
        assert {marker.header.frame_id for marker in shown.markers
                if marker.action == marker.ADD} == {f"{name}/repertoire_origin"}
        wait_for(lambda: (f"{name}/odom", f"{name}/repertoire_origin") in heard, WALL_TIMEOUT_S,
                 f"the place of the repertoire of {name}")
    subscriber.unregister()


def test_each_walks_to_its_goal_in_frames_of_its_own(session):
    heard = set()
    subscriber = rospy.Subscriber("/tf", tf2_msgs.msg.TFMessage, lambda message: heard.update(
        (one.header.frame_id, one.child_frame_id) for one in message.transforms), queue_size=100)
    walks = {name: subprocess.Popen(  # pylint: disable=consider-using-with
        [sys.executable, "-c", WALK, name, *map(str, goal)], stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT, universal_newlines=True,
        env=dict(os.environ, ROS_NAMESPACE=name)) for name, goal in GOALS.items()}
    told = {name: walk.communicate(timeout=4 * WALL_TIMEOUT_S)[0] for name, walk in walks.items()}
    for name, goal in GOALS.items():
        words = told[name].split()[-5:]
        assert words[0] == "0", told[name]
        assert words[1:3] == [f"{name}/odom", f"{name}/base_footprint"]
        assert math.hypot(float(words[3]) - goal[0], float(words[4]) - goal[1]) < 0.08, told[name]
    frames = {frame for pair in heard for frame in pair}
    assert {frame.split("/")[0] for frame in frames} == set(GOALS), frames
    for name in GOALS:
        wait_for(lambda: (f"{name}/base_footprint", f"{name}/base_link") in heard, WALL_TIMEOUT_S,
                 f"the base link of {name}")
    subscriber.unregister()
