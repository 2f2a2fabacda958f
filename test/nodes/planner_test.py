#!/usr/bin/python3
"""Learner, planner, executor and simulated robot together: what a user asks of them."""
import math
import os
import sqlite3
import unittest

import actionlib
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import PoseStamped
from hexapod_repertoire.demo import to_message, validated_repertoire, wait_until_ready
from hexapod_repertoire.msg import (ExecuteBehaviorActionResult, ExecuteBehaviorResult,
                                    ExecutorState, LearningProgress, StepReport, WalkToAction,
                                    WalkToGoal)
from hexapod_repertoire.srv import GetRepertoire, GoTo, GoToRequest, GoToResponse
from nav_msgs.msg import Path
from nav_msgs.srv import GetPlan, GetPlanRequest
from robot_session import Recorder, wait_for
from std_srvs.srv import Trigger

WALL_TIMEOUT_S = 60
BEHAVIOR_S = 3.9


def goal_message(x_m, y_m, yaw_rad, frame="odom"):
    message = PoseStamped(pose=to_message((x_m, y_m, yaw_rad)))
    message.header.frame_id = frame
    return message


class Planner(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("planner_session")
        cls.repertoire = validated_repertoire()
        wait_until_ready()
        for service in ("go_to", "make_plan", "planner/cancel", "get_repertoire"):
            rospy.wait_for_service(service, WALL_TIMEOUT_S)
        cls.go_to = rospy.ServiceProxy("go_to", GoTo)
        cls.walk_to = actionlib.SimpleActionClient("walk_to", WalkToAction)
        cls.steps = Recorder("planner/step_report", StepReport)
        cls.plans = Recorder("plan", Path)
        # The planner has the repertoire as soon as it plans with it.
        wait_for(lambda: cls.ask(0.3, 0.0, 0.0).code != GoToResponse.NO_REPERTOIRE,
                 WALL_TIMEOUT_S, "a planner that knows the repertoire")
        cls.cancel()

    @classmethod
    def ask(cls, x_m, y_m, yaw_rad, frame="odom", wait=False, xy_m=0.0, heading_rad=0.0):
        return cls.go_to(GoToRequest(
            target_pose=goal_message(x_m, y_m, yaw_rad, frame), wait=wait,
            xy_tolerance_m=xy_m, yaw_tolerance_rad=heading_rad))

    @classmethod
    def cancel(cls):
        rospy.ServiceProxy("planner/cancel", Trigger)()
        wait_for(lambda: not rospy.ServiceProxy("planner/cancel", Trigger)().success,
                 WALL_TIMEOUT_S, "the end of the walk")

    def tearDown(self):
        self.cancel()

    def expect_standstill(self):
        """No behaviour begins for as long as one takes."""
        states = Recorder("executor/state", ExecutorState)
        end_s = rospy.get_time() + BEHAVIOR_S
        wait_for(lambda: rospy.get_time() > end_s, WALL_TIMEOUT_S, "simulated time to pass")
        self.assertGreater(states.count(), 0)
        self.assertNotIn(ExecutorState.WALKING, [message.state for message in states.all()])

    def test_walks_to_a_goal_and_reports_every_behaviour(self):
        results = Recorder("execute/result", ExecuteBehaviorActionResult)
        results.wait_publisher()
        before = self.steps.count()
        answer = self.ask(0.5, 0.2, 0.0, frame="base_footprint", wait=True, xy_m=0.08,
                          heading_rad=-1.0)
        self.assertTrue(answer.accepted, answer.message)
        self.assertEqual(answer.code, GoToResponse.SUCCEEDED, answer.message)
        self.assertLessEqual(answer.final_xy_error_m, 0.08)
        self.assertGreater(len(answer.plan.poses), 10)
        # A behaviour of which a busy machine had commands skipped is none of an entry: without report.
        ends = (ExecuteBehaviorResult.SUCCEEDED, ExecuteBehaviorResult.SKIPPED)

        def codes():
            # One that was broken off before may end only now.
            return [m.result.code for m in results.all() if m.result.code in ends]
        wait_for(lambda: len(codes()) >= answer.steps, WALL_TIMEOUT_S, "results of the executor")
        self.assertEqual(len(codes()), answer.steps)
        played = codes().count(ExecuteBehaviorResult.SUCCEEDED)
        wait_for(lambda: self.steps.count() >= before + played, WALL_TIMEOUT_S,
                 f"reports of {played} of {answer.steps} behaviours")
        self.assertEqual(answer.final_pose.header.frame_id, "odom")

    def test_does_nothing_when_it_is_there_already(self):
        answer = self.ask(0.0, 0.0, 0.0, frame="base_footprint", wait=True)
        self.assertEqual(answer.code, GoToResponse.SUCCEEDED, answer.message)
        self.assertEqual(answer.steps, 0)

    def test_refuses_bad_goals_with_a_sentence_and_moves_nothing(self):
        for x_m, frame, xy_m, code in (
                (math.nan, "odom", 0.0, GoToResponse.INVALID_GOAL),
                (math.inf, "odom", 0.0, GoToResponse.INVALID_GOAL),
                (0.5, "odom", -1.0, GoToResponse.INVALID_GOAL),
                (0.5, "odom", math.nan, GoToResponse.INVALID_GOAL),
                (1000.0, "odom", 0.0, GoToResponse.INVALID_GOAL),
                (0.5, "nowhere", 0.0, GoToResponse.UNKNOWN_FRAME),
                (0.5, "", 0.0, GoToResponse.UNKNOWN_FRAME)):
            answer = self.ask(x_m, 0.0, 0.0, frame=frame, xy_m=xy_m, wait=True)
            self.assertFalse(answer.accepted)
            self.assertEqual(answer.code, code, answer.message)
            self.assertGreater(len(answer.message), 20)
        no_rotation = GoToRequest()
        no_rotation.target_pose.header.frame_id = "odom"
        self.assertEqual(self.go_to(no_rotation).code, GoToResponse.INVALID_GOAL)
        self.expect_standstill()

    def test_make_plan_plans_and_does_not_move(self):
        plan = rospy.ServiceProxy("make_plan", GetPlan)(
            GetPlanRequest(goal=goal_message(0.6, 0.0, 0.0, "base_footprint"), tolerance=0.1)).plan
        self.assertGreater(len(plan.poses), 10)
        self.assertEqual(plan.header.frame_id, "odom")
        self.expect_standstill()

    def test_action_tells_progress_and_the_result(self):
        self.assertTrue(self.walk_to.wait_for_server(rospy.Duration(10)))
        feedback = []
        self.walk_to.send_goal(
            WalkToGoal(target_pose=goal_message(-0.4, 0.1, 0.0, "base_footprint"),
                       xy_tolerance_m=0.08, yaw_tolerance_rad=-1.0), feedback_cb=feedback.append)
        self.assertTrue(self.walk_to.wait_for_result(rospy.Duration(200)))
        self.assertEqual(self.walk_to.get_state(), GoalStatus.SUCCEEDED)
        self.assertEqual(len(feedback), self.walk_to.get_result().steps)
        self.assertGreater(feedback[0].distance_left_m, 0.3)

    def test_action_refuses_a_bad_goal(self):
        self.walk_to.wait_for_server(rospy.Duration(10))
        self.walk_to.send_goal(WalkToGoal(target_pose=goal_message(math.nan, 0.0, 0.0)))
        self.assertTrue(self.walk_to.wait_for_result(rospy.Duration(20)))
        self.assertEqual(self.walk_to.get_state(), GoalStatus.REJECTED)
        self.assertEqual(self.walk_to.get_result().code, GoToResponse.INVALID_GOAL)

    def test_newest_goal_takes_over_and_cancel_ends_it(self):
        self.walk_to.wait_for_server(rospy.Duration(10))
        feedback = []
        self.walk_to.send_goal(
            WalkToGoal(target_pose=goal_message(3.0, 0.0, 0.0, "base_footprint")),
            feedback_cb=feedback.append)
        wait_for(lambda: feedback, WALL_TIMEOUT_S, "the first behaviour")
        newer = self.ask(-3.0, 0.0, 0.0, frame="base_footprint")
        self.assertTrue(newer.accepted, newer.message)
        self.assertTrue(self.walk_to.wait_for_result(rospy.Duration(100)))
        self.assertEqual(self.walk_to.get_state(), GoalStatus.PREEMPTED)
        self.assertEqual(self.walk_to.get_result().code, GoToResponse.PREEMPTED)
        self.cancel()

    def test_rviz_goal_leads_to_a_plan(self):
        publisher = rospy.Publisher("move_base_simple/goal", PoseStamped, queue_size=1)
        wait_for(publisher.get_num_connections, WALL_TIMEOUT_S, "the planner's subscription")
        before = self.plans.count()
        publisher.publish(goal_message(0.5, 0.0, 0.0, "base_footprint"))
        wait_for(lambda: self.plans.count() > before, WALL_TIMEOUT_S, "a plan")

    def test_repertoire_is_published_served_and_stored_alike(self):
        served = rospy.ServiceProxy("get_repertoire", GetRepertoire)()
        self.assertTrue(served.success)
        self.assertEqual(len(served.repertoire.entries), len(self.repertoire.entries))
        with sqlite3.connect(rospy.get_param("~repertoire_file")) as database:
            rows = database.execute("select id, x_m, trials from entries order by id").fetchall()
        published = sorted((e.id, e.end_pose.x, e.trials) for e in self.repertoire.entries)
        self.assertEqual(rows, published)

    def test_progress_says_done(self):
        progress = rospy.wait_for_message("learner/progress", LearningProgress, WALL_TIMEOUT_S)
        self.assertEqual(progress.phase, "done")
        self.assertEqual(progress.evaluations, 1200)
        self.assertEqual(progress.archive_size, len(self.repertoire.entries))

    @classmethod
    def tearDownClass(cls):
        for suffix in ("", ".lock"):
            path = rospy.get_param("~repertoire_file") + suffix
            if os.path.exists(path):
                os.remove(path)


if __name__ == "__main__":
    rostest.rosrun("hexapod_repertoire", "planner_session", Planner)
