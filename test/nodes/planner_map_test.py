#!/usr/bin/python3
"""What a walking robot does about a map: around it, up to it, not into it."""
import math
import os
import sys
import threading
import time

import actionlib
import pytest
import rospy
from actionlib_msgs.msg import GoalStatus
from hexapod_repertoire.msg import (ExecutorState, WalkRouteAction, WalkRouteGoal, WalkSummary,
                                    Waypoint)
from hexapod_repertoire.srv import GoToResponse
from map_msgs.msg import OccupancyGridUpdate
from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal
from nav_msgs.msg import OccupancyGrid

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import walking_session as ws  # noqa: E402
from walking_client import WalkingClient, goal_message  # noqa: E402

FACTOR = 4.0
RESOLUTION_M = 0.05
SIDE = 120
# Body and feet sweep 0.30 m around base_footprint; its margin is there to be used.
SWEPT_M = 0.29
MISS_M = 0.01  # of a behaviour, from where it was planned to end
CANCELLED_S = 1.5  # promised are 0.2 s; the rest is for a machine that is busy with other tests


@pytest.fixture(scope="module")
def session():
    nodes = [node for node in ws.NODES if node != "planner"]
    with ws.WalkingSession(FACTOR, sim_time=True, nodes=nodes) as a_session:
        a_session.set_param("/planner/pose_timeout_s", 5.0)  # a busy machine loses no pose
        a_session.start("planner")
        yield a_session


@pytest.fixture(scope="module")
def client(session):  # pylint: disable=unused-argument
    return WalkingClient()


@pytest.fixture(scope="module")
def floor(client):
    client.wait_ready()
    return Floor(client)


@pytest.fixture(autouse=True)
def ready(client, floor):
    client.wait_ready()
    floor.show(lambda x, y: False)
    yield
    client.cancel_everything()
    ws.wait_for(lambda: client.state == ExecutorState.READY, 20.0, "the robot to stand")


class Floor:
    """A map of 6 m around where the robot stood when it was shown, turned as that, and the robot's
    track in it. Its publisher latches, as map_server's does."""

    def __init__(self, client):
        self.client = client
        self.publisher = rospy.Publisher("map", OccupancyGrid, latch=True, queue_size=1)
        self.updates = rospy.Publisher("map_updates", OccupancyGridUpdate, queue_size=10)
        ws.wait_for(lambda: self.publisher.get_num_connections() > 0, 20.0, "the planner on map")
        ws.wait_for(lambda: self.updates.get_num_connections() > 0, 20.0, "it on map_updates")
        self.origin, self.occupied = None, []

    def show(self, occupied):
        """Cells whose centre is occupied, in the robot's frame of now."""
        self.origin = self.client.pose()
        message = OccupancyGrid(data=self.cells(occupied))
        message.header.frame_id = "odom"
        message.info.resolution = RESOLUTION_M
        message.info.width = message.info.height = SIDE
        corner = -SIDE * RESOLUTION_M / 2.0
        message.info.origin = self.goal(corner, corner, 0.0).pose
        self.publisher.publish(message)

    def update(self, occupied):
        """The same, of the map that was shown, by an update of all its rows but the outer ones."""
        self.updates.publish(OccupancyGridUpdate(
            header=rospy.Header(frame_id="odom"), x=0, y=1, width=SIDE, height=SIDE - 2,
            data=self.cells(occupied)[SIDE:-SIDE]))

    def cells(self, occupied):
        """Row by row; keeps the lower left corners of those that are."""
        half_m = SIDE * RESOLUTION_M / 2.0
        corners = [((i % SIDE) * RESOLUTION_M - half_m, (i // SIDE) * RESOLUTION_M - half_m)
                   for i in range(SIDE * SIDE)]
        values = [100 if occupied(x + RESOLUTION_M / 2.0, y + RESOLUTION_M / 2.0) else 0
                  for x, y in corners]
        self.occupied = [corner for corner, value in zip(corners, values) if value]
        return values

    def goal(self, x_m, y_m, yaw_rad):
        """A pose of that frame, in odom."""
        x, y, yaw = self.origin
        return goal_message(x + math.cos(yaw) * x_m - math.sin(yaw) * y_m,
                            y + math.sin(yaw) * x_m + math.cos(yaw) * y_m, yaw + yaw_rad)

    def robot(self):
        """Position in that frame."""
        x, y, _ = self.client.pose()
        dx, dy, yaw = x - self.origin[0], y - self.origin[1], self.origin[2]
        return (math.cos(yaw) * dx + math.sin(yaw) * dy, math.cos(yaw) * dy - math.sin(yaw) * dx)

    def room_m(self):
        """From base_footprint to the nearest occupied cell, by looking at all that are."""
        x, y = self.robot()
        return min((math.hypot(max(west - x, 0.0, x - west - RESOLUTION_M),
                               max(south - y, 0.0, y - south - RESOLUTION_M))
                    for west, south in self.occupied), default=math.inf)


def wall(x, y):
    return 0.8 < x < 0.9 and abs(y) < 0.9


def ring(x, y):
    return 1.0 < max(abs(x), abs(y)) < 1.1


def code(name):
    return getattr(GoToResponse, name)


def answer(asked, timeout_s=90.0):
    return ws.wait_for(lambda: asked.answers, timeout_s, "an answer of " + asked.door)[0]


def expect_map(client, floor, goal, name):
    """The planner knows the map by now: a plan to there ends with that code."""
    ws.wait_for(lambda: answer(client.walk_to(floor.goal(*goal), plan_only=True)).code == code(name),
                20.0, f"the planner to know the map: {name}")


def test_a_goal_behind_a_wall_is_reached_without_touching_it(client, floor):
    floor.show(wall)
    expect_map(client, floor, (0.85, 0.0, 0.0), "GOAL_OCCUPIED")
    summaries = []
    subscriber = rospy.Subscriber("planner/walk_summary", WalkSummary, summaries.append)
    move_base = actionlib.SimpleActionClient("move_base", MoveBaseAction)
    assert move_base.wait_for_server(rospy.Duration(10.0))
    room_m = []
    move_base.send_goal(MoveBaseGoal(target_pose=floor.goal(1.6, 0.0, 0.0)),
                        feedback_cb=lambda _: None)
    ws.wait_for(lambda: room_m.append(floor.room_m())
                or move_base.get_state() not in (GoalStatus.PENDING, GoalStatus.ACTIVE),
                120.0, "the end of the walk")
    assert move_base.get_state() == GoalStatus.SUCCEEDED, move_base.get_goal_status_text()
    assert math.dist(floor.robot(), (1.6, 0.0)) < 0.1
    assert min(room_m) > SWEPT_M
    summary = ws.wait_for(lambda: summaries and summaries[-1], 5.0, "the summary")
    assert summary.code == code("SUCCEEDED") and summary.steps > 3
    assert summary.distance_m > 2.0 and -MISS_M < summary.clearance_m < 1.0
    subscriber.unregister()


def test_goals_that_cannot_be_walked_to_are_refused_with_the_reason_and_the_nearest_pose(
        client, floor):
    floor.show(ring)
    expect_map(client, floor, (1.05, 0.0, 0.0), "GOAL_OCCUPIED")
    blocked = answer(client.go_to(floor.goal(1.8, 0.0, 0.0), wait=True))
    assert blocked.code == code("BLOCKED") and not blocked.accepted
    assert "close every way" in blocked.message
    nearest, middle = blocked.nearest_pose.pose.position, floor.goal(0.0, 0.0, 0.0).pose.position
    assert blocked.nearest_pose.header.frame_id == "odom"
    assert math.dist((nearest.x, nearest.y), (middle.x, middle.y)) < 1.0  # within the ring
    move_base = actionlib.SimpleActionClient("move_base", MoveBaseAction)
    assert move_base.wait_for_server(rospy.Duration(10.0))
    move_base.send_goal(MoveBaseGoal(target_pose=floor.goal(1.05, 0.0, 0.0)))
    assert move_base.wait_for_result(rospy.Duration(10.0))
    assert move_base.get_state() == GoalStatus.REJECTED
    assert "touch an obstacle" in move_base.get_goal_status_text()
    assert client.state == ExecutorState.READY


def test_a_map_that_changes_in_mid_walk_is_walked_around(client, floor):
    floor.show(lambda x, y: False)
    expect_map(client, floor, (1.05, 0.0, 0.0), "SUCCEEDED")  # and no longer the ring
    walked = client.walk_to(floor.goal(1.8, 0.0, 0.0))
    ws.wait_for(lambda: client.state == ExecutorState.WALKING, 20.0, "the robot to walk")
    ahead_m = floor.robot()[0] + 0.8

    def in_the_way(x, y):
        return ahead_m < x < ahead_m + 0.1 and abs(y) < 0.9

    floor.update(in_the_way)
    room_m = []
    ws.wait_for(lambda: room_m.append(floor.room_m()) or walked.answers, 120.0, "the answer")
    assert answer(walked).code == code("SUCCEEDED"), answer(walked).message
    assert min(room_m) > SWEPT_M


def test_a_route_is_walked_through_all_its_waypoints_around_a_wall(client, floor):
    floor.show(wall)
    expect_map(client, floor, (0.85, 0.0, 0.0), "GOAL_OCCUPIED")
    route = actionlib.SimpleActionClient("walk_route", WalkRouteAction)
    assert route.wait_for_server(rospy.Duration(10.0))
    poses = ((0.3, 0.6), (0.85, 1.5), (1.5, 0.5))
    waypoints = [Waypoint(pose=floor.goal(x, y, 0.0), xy_tolerance_m=0.08, yaw_tolerance_rad=-1.0)
                 for x, y in poses]
    told, room_m = [], []
    route.send_goal(WalkRouteGoal(waypoints=waypoints), feedback_cb=told.append)
    ws.wait_for(lambda: room_m.append(floor.room_m()) or
                route.get_state() not in (GoalStatus.PENDING, GoalStatus.ACTIVE), 150.0, "the end")
    assert route.get_state() == GoalStatus.SUCCEEDED, route.get_goal_status_text()
    result = route.get_result()
    assert result.waypoints_reached == 3 and result.steps == len(told)
    assert [feedback.waypoint for feedback in told] == sorted(feedback.waypoint for feedback in told)
    assert {feedback.waypoint for feedback in told} == {0, 1, 2}
    assert math.dist(floor.robot(), poses[-1]) < 0.1
    assert min(room_m) > SWEPT_M
    # One that leads through the wall is refused before a step is made.
    waypoints[1].pose = floor.goal(0.85, 0.0, 0.0)
    route.send_goal(WalkRouteGoal(waypoints=waypoints))
    assert route.wait_for_result(rospy.Duration(20.0))
    assert route.get_state() == GoalStatus.REJECTED
    assert route.get_goal_status_text().startswith("Waypoint 2 of 3: ")
    route.send_goal(WalkRouteGoal())
    assert route.wait_for_result(rospy.Duration(20.0))
    assert "no waypoints" in route.get_result().message


def test_a_planner_that_starts_later_knows_the_latched_map(session, client, floor):
    floor.show(wall)
    session.leave("planner")
    session.start("planner")
    rospy.wait_for_service("go_to", 20.0)
    client.wait_ready()
    expect_map(client, floor, (0.85, 0.0, 0.0), "GOAL_OCCUPIED")


def test_a_storm_of_large_maps_holds_up_no_cancel(client, floor):
    big = OccupancyGrid()
    big.header.frame_id = "odom"
    big.info.resolution = RESOLUTION_M
    big.info.width = big.info.height = 2000
    big.info.origin = floor.goal(-50.0, -50.0, 0.0).pose
    cells = [bytes(4000000), bytes(3999999) + b"\x64"]
    over = threading.Event()

    def storm():
        number = 0
        while not over.wait(0.1):
            number += 1
            big.data = cells[number % 2]
            floor.publisher.publish(big)

    thread = threading.Thread(target=storm)
    thread.start()
    try:
        for _ in range(8):
            asked = client.walk_to(floor.goal(12.0, 3.0, 0.0))
            time.sleep(0.25)  # when in the life of the goal, not a wait for something
            client.cancel(asked)
            assert answer(asked).code == code("PREEMPTED")
            assert asked.answered_s - asked.cancelled_s < CANCELLED_S
    finally:
        over.set()
        thread.join()
