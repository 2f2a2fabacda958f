#!/usr/bin/python3
"""A robot that is hurt in the middle of a walk goes on and arrives; simulated time."""
import math
import os
import sys

import pytest
import rospy
from hexapod_repertoire.msg import BodyBelief, ExecutorState, StepReport
from hexapod_repertoire.srv import Disturb, DisturbRequest, GoToResponse

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import walking_session as ws  # noqa: E402
from robot_session import Recorder  # noqa: E402
from walking_client import WalkingClient, goal_message  # noqa: E402

JOINTS = {"left_middle": ["body_leg_1", "leg_1_1_2", "leg_1_2_3"],
          "right_rear": ["body_leg_5", "leg_5_1_2", "leg_5_2_3"]}
ARRIVAL_S = 120.0


@pytest.fixture(scope="module")
def session():
    with ws.WalkingSession(real_time_factor=2.0, sim_time=True) as a_session:
        yield a_session


@pytest.fixture(scope="module")
def client(session):  # pylint: disable=unused-argument
    a_client = WalkingClient()
    a_client.wait_ready()
    return a_client


def disturb(**fields):
    rospy.wait_for_service("simulated_robot/disturb", 10.0)
    answer = rospy.ServiceProxy("simulated_robot/disturb", Disturb)(DisturbRequest(**fields))
    assert answer.success, answer.message


def far_goal(client):
    """Some behaviours away, back towards where the session began."""
    x, y, yaw = client.pose()
    direction = yaw if math.hypot(x, y) < 0.3 else math.atan2(-y, -x)
    return goal_message(x + 1.2 * math.cos(direction), y + 1.2 * math.sin(direction), direction)


def walk_until_hurt(client, **fields):
    """Sets out, and is hurt in the middle of the first behaviour."""
    asked = client.go_to(far_goal(client), wait=True)
    ws.wait_for(lambda: client.state == ExecutorState.WALKING, 20.0, "the first behaviour")
    disturb(**fields)
    return asked


def arrive(asked):
    answer = ws.wait_for(lambda: asked.answers, ARRIVAL_S, "the end of the walk")[0]
    assert answer.code == GoToResponse.SUCCEEDED, answer.message
    return answer


@pytest.mark.parametrize("leg, state", [("left_middle", "LIFTED"), ("right_rear", "MISSING")])
def test_a_leg_that_breaks_in_mid_walk_is_named_and_the_walk_arrives(client, leg, state):
    beliefs, steps = Recorder("body_belief", BodyBelief), Recorder("planner/step_report", StepReport)
    states = Recorder("executor/state", ExecutorState)
    steps.wait_publisher()
    states.next()
    assert not states.last().tolerated_joints
    arrive(walk_until_hurt(client, legs=[leg], states=[getattr(DisturbRequest, state)]))
    assert beliefs.last().bodies[0].startswith(leg), beliefs.last().sentence
    assert beliefs.last().dead_joints == JOINTS[leg]
    assert JOINTS[leg] in [m.tolerated_joints for m in states.all()]
    assert ExecutorState.FAULT not in [m.state for m in states.all()]
    assert leg in steps.last().belief
    disturb()
    assert client.call("planner/reset_belief").success
    ws.wait_for(lambda: not states.next().tolerated_joints, 20.0, "an executor that watches again")


def test_where_no_leg_may_be_given_up_a_broken_one_is_a_fault(session, client):
    session.kill("executor")
    session.set_param("/executor/max_dead_legs", 0)
    session.set_param("/executor/auto_arm", True)
    session.start("executor")
    client.state = None
    client.wait_ready()
    asked = walk_until_hurt(client, legs=["left_middle"], states=[DisturbRequest.MISSING])
    answer = ws.wait_for(lambda: asked.answers, ARRIVAL_S, "the end of the walk")[0]
    assert answer.code == GoToResponse.EXECUTOR_FAULT, answer.message
    assert "body_leg_1" in answer.message
