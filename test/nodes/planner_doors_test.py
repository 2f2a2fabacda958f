#!/usr/bin/python3
"""What clients of a walking robot rely on when something happens; no simulated time."""
import math
import os
import re
import signal
import subprocess
import sys
import time

import actionlib
import pytest
import rospy
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import Twist
from hexapod_repertoire.msg import ExecutorState, WalkToAction, WalkToGoal
from hexapod_repertoire.srv import GoToResponse
from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal
from nav_msgs.msg import Path
from nav_msgs.srv import GetPlan, GetPlanRequest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import walking_session as ws  # noqa: E402
from action_burst import ActionBurst  # noqa: E402
from walking_client import XY_TOLERANCE_M, WalkingClient, goal_message  # noqa: E402

BEHAVIOR_S = 3.9
# The planner's own time: from what happened, or the cancel, to the stamp of its answer.
TOLD_S = 2.0
CANCELLED_S = 0.2
UNARMED = (ExecutorState.DISARMED, ExecutorState.STOPPED)


@pytest.fixture(scope="module")
def session():
    # A dead robot is to be told of within TOLD_S; this much earlier its silence is one.
    with ws.WalkingSession(params={"/executor/feedback_timeout_s": 1.0}) as a_session:
        yield a_session


@pytest.fixture(scope="module")
def client(session):  # pylint: disable=unused-argument
    return WalkingClient()


@pytest.fixture(autouse=True)
def ready(session, client):
    client.wait_ready()
    yield
    if session.is_running("master"):
        client.cancel_everything()


def ahead(client, distance_m, frame="odom"):
    """A goal ahead of the robot, in odom although the robot stands anywhere there."""
    if frame == "base_footprint":
        return goal_message(distance_m, 0.1, 0.2, frame)
    x, y, yaw = client.pose()
    return goal_message(x + distance_m * math.cos(yaw), y + distance_m * math.sin(yaw), yaw)


def answer(asked, timeout_s=60.0):
    return ws.wait_for(lambda: asked.answers, timeout_s, "an answer of " + asked.door)[0]


def code(name):
    return getattr(GoToResponse, name)


def way(plan):
    return [stamped.pose for stamped in plan.poses]


def expect_standstill(client):
    """The robot does not move for as long as a behaviour takes."""
    ws.wait_for(lambda: client.state != ExecutorState.WALKING, 5.0, "the robot to stop")
    ws.wait_for(lambda: client.state == ExecutorState.READY, 5.0, "the executor to be READY")
    before = client.pose()
    end = time.monotonic() + BEHAVIOR_S
    while time.monotonic() < end:
        assert client.state == ExecutorState.READY
        assert math.dist(client.pose()[:2], before[:2]) < 0.05  # a behaviour leads farther
        time.sleep(0.02)


@pytest.mark.parametrize("after_s", [0.0, 0.02, 0.1, 2.0])
def test_a_cancel_is_never_lost_and_answered_at_once(client, after_s):
    far = client.walk_to(ahead(client, 12.0))
    time.sleep(after_s)  # when in the life of the goal, not a wait for something
    client.cancel(far)
    assert answer(far).code == code("PREEMPTED")
    assert far.answered_stamp_s - far.cancelled_stamp_s < CANCELLED_S
    ws.wait_for(lambda: far.handle.get_goal_status() == GoalStatus.PREEMPTED, 5.0, "PREEMPTED")


@pytest.mark.parametrize("cancel_all", ["cancel_everything", "cancel_all_actions"])
def test_after_a_cancel_while_planning_the_robot_stays(client, cancel_all):
    far = client.walk_to(ahead(client, 15.0))
    getattr(client, cancel_all)()  # it may come first, by another connection
    assert answer(far).code == code("PREEMPTED")
    expect_standstill(client)
    assert len(far.answers) == 1


def test_a_newer_near_goal_wins_over_an_older_far_one(client):
    older = client.go_to(ahead(client, 15.0), wait=True)
    time.sleep(0.02)
    newer = client.go_to(ahead(client, 0.3), wait=True)
    assert answer(newer).code == code("SUCCEEDED"), answer(newer).message
    assert answer(older).code == code("PREEMPTED")
    assert newer.error()[0] < 0.08


def test_cancelling_one_goal_by_its_id_leaves_the_others(client):
    walked = client.walk_to(ahead(client, 0.4, "base_footprint"))
    planned = client.walk_to(ahead(client, 14.0), plan_only=True)
    client.cancel(planned)
    answer(planned)
    assert answer(walked).code == code("SUCCEEDED"), answer(walked).message


def test_a_burst_of_goals_and_cancels_is_answered_each_goal_once(client):
    burst = ActionBurst("walk_to", WalkToAction)
    ws.wait_for(burst.is_connected, 10.0, "walk_to")
    ids = burst.send(WalkToGoal(target_pose=ahead(client, 12.0), xy_tolerance_m=0.06), 1000)
    burst.cancel(ids)
    ws.wait_for(lambda: not burst.unanswered(), 30.0, "the answers to the burst")
    expect_standstill(client)
    for results in burst.answers().values():
        assert [result.result.code for result in results] == [code("PREEMPTED")]


def go(*words):
    """./run go: (exit code, what it printed)."""
    result = subprocess.run([sys.executable, "-m", "hexapod_repertoire.client", "go", *words],
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                            universal_newlines=True, timeout=120.0, env=os.environ, check=False)
    return result.returncode, result.stdout


def test_the_command_line_tells_what_is_planned_and_what_came_of_it(client):
    x_m, y_m, _ = client.pose()
    place = (f"{x_m + 0.5:.3f}", f"{y_m:.3f}")
    code_of_plan, text = go(*place, "--plan")
    assert code_of_plan == 0 and "It would end at" in text and "step" not in text, text
    code_of_walk, text = go(*place)
    assert code_of_walk == 0, text
    assert re.match(r"Accepted: \d+ behaviours? planned\.\nstep 1 of \d+, 0\.\d\d m left\n", text), text
    assert re.search(r"  ended \d\.\d cm and \d\.\d deg from where it was predicted", text), text
    assert re.search(r"Arrived at .* It stands \d\.\d cm from the goal\.", text), text
    code_of_refusal, text = go("500", "0", "0")
    assert code_of_refusal == 1 and "INVALID_GOAL" in text and "max_goal_distance_m" in text, text


def test_a_client_of_move_base_walks_cancels_and_plans(client):
    move_base = actionlib.SimpleActionClient("move_base", MoveBaseAction)
    assert move_base.wait_for_server(rospy.Duration(10.0))
    feedback = []
    move_base.send_goal(MoveBaseGoal(target_pose=goal_message(0.3, 0.0, 0.1, "base_link")),
                        feedback_cb=feedback.append)
    assert move_base.wait_for_result(rospy.Duration(60.0))
    assert move_base.get_state() == GoalStatus.SUCCEEDED, move_base.get_goal_status_text()
    assert feedback[0].base_position.header.frame_id == "odom"
    move_base.send_goal(MoveBaseGoal(target_pose=goal_message(5.0, 0.0, 0.0, "base_link")))
    ws.wait_for(lambda: client.state == ExecutorState.WALKING, 10.0, "the robot to walk")
    move_base.cancel_goal()
    assert move_base.wait_for_result(rospy.Duration(5.0))
    assert move_base.get_state() == GoalStatus.PREEMPTED
    move_base.send_goal(MoveBaseGoal(target_pose=goal_message(math.nan, 0.0, 0.0, "base_link")))
    assert move_base.wait_for_result(rospy.Duration(5.0))
    assert move_base.get_state() == GoalStatus.REJECTED
    assert "not a finite number" in move_base.get_goal_status_text()
    plan = rospy.ServiceProxy("move_base/make_plan", GetPlan)(
        GetPlanRequest(goal=ahead(client, 1.0), tolerance=0.1)).plan
    assert len(plan.poses) > 10


def test_a_stream_of_velocities_is_walked_and_stopped(client):
    # What teleop_twist_keyboard sends while i is held, then k.
    publisher = rospy.Publisher("cmd_vel", Twist, queue_size=1)
    ws.wait_for(lambda: publisher.get_num_connections() > 0, 10.0, "the planner on cmd_vel")
    ahead_at_half_a_metre_per_second = Twist()
    ahead_at_half_a_metre_per_second.linear.x = 0.5
    start = client.pose()

    def stream_until(condition, what):
        def send():
            publisher.publish(ahead_at_half_a_metre_per_second)
            time.sleep(0.1)
            return condition()
        ws.wait_for(send, 20.0, what)

    stream_until(lambda: math.dist(client.pose()[:2], start[:2]) > 0.15, "the robot to walk")
    publisher.publish(Twist())
    expect_standstill(client)
    # A stream in the middle of which the robot was stopped does not go on when somebody arms.
    stream_until(lambda: client.state == ExecutorState.WALKING, "the robot to walk")
    client.call("executor/stop")
    stream_until(lambda: client.state == ExecutorState.STOPPED, "the robot to stop")
    client.call("executor/arm")
    stream_until(lambda: client.state == ExecutorState.READY, "the robot to stand")
    for _ in range(5):
        publisher.publish(ahead_at_half_a_metre_per_second)
        time.sleep(0.1)
        assert client.state == ExecutorState.READY
    # A silence ends the stream; the next one walks, and rests when it falls silent.
    time.sleep(1.2)
    stream_until(lambda: client.state == ExecutorState.WALKING, "the robot to walk")
    expect_standstill(client)


def test_plan_only_publishes_its_plan_and_does_not_move(client):
    plans = []
    subscriber = rospy.Subscriber("plan", Path, plans.append)
    ws.wait_for(lambda: subscriber.get_num_connections() > 0, 10.0, "the planner's plan")
    target = ahead(client, 1.0)
    planned = answer(client.walk_to(target, plan_only=True))
    assert planned.code == code("SUCCEEDED"), planned.message
    end = planned.plan.poses[-1].pose.position
    miss_m = math.hypot(end.x - target.pose.position.x, end.y - target.pose.position.y)
    # What the robot is believed to be after the walks before may leave no better one.
    assert miss_m <= XY_TOLERANCE_M + 1e-6 or "outside of the tolerance" in planned.message
    assert miss_m < 0.2
    # The first that comes is the latched one of the walk before.
    expected = way(planned.plan)
    ws.wait_for(lambda: any(way(plan) == expected for plan in plans), 5.0, "the answer's plan")
    expect_standstill(client)


def test_a_robot_that_cannot_be_commanded_is_not_sent_anywhere(client):
    for stop, word in (("executor/stop", "stopped"), ("executor/disarm", "disarmed")):
        assert client.call(stop).success
        ws.wait_for(lambda: client.state in UNARMED, 5.0, "the executor to stop")
        for ask in (client.walk_to, lambda goal: client.go_to(goal, wait=True)):
            asked = ask(ahead(client, 0.5))
            refusal = answer(asked, 5.0)
            assert refusal.code == code("EXECUTOR_NOT_READY")
            assert word in refusal.message and "executor/arm" in refusal.message
        client.simple_goal(ahead(client, 0.5))
        ws.wait_for(lambda: client.call("executor/arm").success, 10.0, "the executor to arm")
        client.wait_ready()
        expect_standstill(client)


def test_a_stop_in_mid_walk_ends_the_goal_for_good(client):
    walked = client.walk_to(ahead(client, 3.0))
    ws.wait_for(lambda: client.state == ExecutorState.WALKING, 10.0, "the robot to walk")
    client.call("executor/stop")
    client.call("executor/arm")
    assert answer(walked, 5.0).code in (code("EXECUTOR_FAULT"), code("EXECUTOR_NOT_READY"))
    client.wait_ready()
    expect_standstill(client)


def test_a_second_publisher_is_an_error_and_the_first_stays_in_use(session, client):
    session.set_param("/other_server/repertoire_file", str(session.folder / "small.db"))
    session.start("repertoire_server", "other_server")
    try:
        ws.wait_for(lambda: "Two nodes publish a repertoire: /repertoire_server and /other_server"
                    in session.log("planner"), 10.0, "the error")
    finally:
        session.leave("other_server")
    assert answer(client.go_to(ahead(client, 0.3), wait=True)).code == code("SUCCEEDED")


@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGSTOP])
def test_a_dead_executor_is_told_within_two_seconds(session, client, number):
    walked = client.walk_to(ahead(client, 3.0))
    ws.wait_for(lambda: client.state == ExecutorState.WALKING, 10.0, "the robot to walk")
    waiting = client.go_to(ahead(client, 3.0), wait=True)
    gone_s = time.time()
    session.send_signal("executor", number)
    ended = answer(waiting, 10.0)
    assert ended.code in (code("EXECUTOR_FAULT"), code("EXECUTOR_NOT_READY")), ended.message
    assert answer(walked).code == code("EXECUTOR_FAULT")
    assert walked.answered_stamp_s - gone_s < TOLD_S
    refused = client.go_to(ahead(client, 0.3), wait=True)
    assert answer(refused, 5.0).code == code("EXECUTOR_NOT_READY")
    session.kill("executor")
    session.start("executor")
    client.state = None
    ws.wait_for(lambda: client.state is not None, 20.0, "the executor")
    ws.wait_for(lambda: client.call("executor/arm").success or client.state == ExecutorState.READY, 20.0,
                "the executor to arm")


def test_a_dead_robot_is_told_within_two_seconds(session, client):
    walked = client.walk_to(ahead(client, 3.0))
    ws.wait_for(lambda: client.state == ExecutorState.WALKING, 10.0, "the robot to walk")
    gone_s = time.time()
    session.kill("simulated_robot")
    assert answer(walked, 10.0).code in (code("EXECUTOR_FAULT"), code("POSE_LOST"))
    assert walked.answered_stamp_s - gone_s < TOLD_S
    session.start("simulated_robot")
    ws.wait_for(lambda: client.call("executor/arm").success, 20.0, "the executor to arm")


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_leaving_planner_answers_everybody_and_leaves_in_time(session, client, number):
    walked = client.walk_to(ahead(client, 3.0))
    ws.wait_for(lambda: client.state == ExecutorState.WALKING, 10.0, "the robot to walk")
    waiting = client.go_to(ahead(client, 15.0), wait=True)
    exit_code, took_s = session.leave("planner", number)
    assert exit_code == 0
    assert took_s < TOLD_S
    assert answer(walked, 5.0).code in (code("SHUTDOWN"), code("PREEMPTED"))
    assert answer(waiting, 5.0).code in (code("SHUTDOWN"), code("PREEMPTED"))
    session.start("planner")
    expect_standstill(client)


def test_the_first_goal_right_after_the_start_is_walked_to(session, client):
    session.leave("planner")
    session.start("planner")
    rospy.wait_for_service("go_to", 20.0)
    assert answer(client.go_to(ahead(client, 0.3), wait=True)).code == code("SUCCEEDED")


def test_without_its_master_the_planner_tells_and_leaves(session, client):
    walked = client.walk_to(ahead(client, 3.0))
    ws.wait_for(lambda: client.state == ExecutorState.WALKING, 10.0, "the robot to walk")
    gone_s = time.time()
    session.kill("master")
    assert answer(walked, 10.0).code == code("SHUTDOWN")
    assert walked.answered_stamp_s - gone_s < TOLD_S
    assert session.process("planner").wait(5.0) == 3
