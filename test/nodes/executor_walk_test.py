#!/usr/bin/python3
"""The executor walks the simulated robot: goals, cancel, stops, stamps."""
import os
import sys
import unittest

import rospy
import rostest
from actionlib_msgs.msg import GoalID, GoalStatus, GoalStatusArray
from hexapod_repertoire.msg import (ExecuteBehaviorActionGoal, ExecuteBehaviorResult,
                                    ExecutorState)
from std_msgs.msg import Bool
from std_srvs.srv import Trigger

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import robot_session as rs  # noqa: E402


class ExecutorWalk(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("executor_walk_test")
        cls.session = rs.Session()
        cls.e_stop = rospy.Publisher("e_stop", Bool, queue_size=1)

    def setUp(self):
        self.session.make_ready()
        self.session.commands.clear()

    def test_stamps_are_exactly_one_period_apart(self):
        rs.wait_for(lambda: self.session.commands.count() >= 50, 10.0, "50 commands")
        stamps = [rs.stamp_ns(m) for m in self.session.commands.all()]
        gaps = [b - a for a, b in zip(stamps, stamps[1:])]
        self.assertEqual({gap % rs.PERIOD_NS for gap in gaps}, {0})
        self.assertGreater(min(gaps), 0)

    def test_a_second_goal_is_rejected_and_does_not_disturb_the_first(self):
        first = self.session.send(rs.TURN)
        self.session.wait_state(ExecutorState.WALKING)
        second = self.session.send(rs.TRIPOD)
        self.assertEqual(self.session.result(second).code, ExecuteBehaviorResult.NOT_READY)
        self.assertEqual(second.get_terminal_state(), GoalStatus.REJECTED)
        self.assertTrue(rs.played(self.session.result(first)))

    def test_goals_that_name_no_behaviour_are_refused_with_a_sentence(self):
        for genome, entry, run, says in [
                (rs.TRIPOD[:23], -1, "", "24"), (rs.TRIPOD + [0], -1, "", "24"), ([], -1, "", "24"),
                ([5] * 24, -1, "", "expected 0 .. 4"), ([], 7, "some run", "repertoire")]:
            handle = self.session.send(genome, entry, run)
            result = self.session.result(handle)
            self.assertEqual(result.code, ExecuteBehaviorResult.INVALID_GOAL)
            self.assertIn(says, result.message)
        self.assertEqual(self.session.state(), ExecutorState.READY)

    def test_senseless_stamps_and_ids_of_others_keep_no_goal_from_being_played(self):
        statuses = rs.Recorder("execute/status", GoalStatusArray)
        cancel = rospy.Publisher("execute/cancel", GoalID, queue_size=10)
        goals = rospy.Publisher("execute/goal", ExecuteBehaviorActionGoal, queue_size=10)
        rs.wait_for(lambda: cancel.get_num_connections() and goals.get_num_connections(), 10.0,
                    "the executor's ears")

        def know(goal_id):
            return [status.status for message in statuses.all() for status in message.status_list
                    if status.goal_id.id == goal_id]
        last_s = 2**32 - 1
        cancel.publish(GoalID(id="ahead of its time", stamp=rospy.Time(last_s)))
        rs.wait_for(lambda: know("ahead of its time"), 10.0, "the cancel to come")
        goals.publish(goal_id=GoalID(id="x" * 100000))
        again = ExecuteBehaviorActionGoal(goal_id=GoalID(id="again", stamp=rospy.Time(last_s)))
        goals.publish(again)
        rs.wait_for(lambda: GoalStatus.REJECTED in know("again"), 10.0, "a goal to be rejected")
        goals.publish(again)
        self.assertTrue(rs.played(self.session.result(self.session.send(rs.TURN))))
        self.assertFalse(know("x" * 100000))

    def test_cancel_ends_in_the_neutral_pose(self):
        handle = self.session.send(rs.TRIPOD)
        before = self.session.commands.count()
        rs.wait_for(lambda: self.session.commands.count() > before + 30, 5.0, "30 commands")
        handle.cancel()
        result = self.session.result(handle)
        self.assertEqual(result.code, ExecuteBehaviorResult.PREEMPTED, result.message)
        self.assertEqual(handle.get_terminal_state(), GoalStatus.PREEMPTED)
        self.assertEqual(set(self.session.commands.next().position), {0.0})
        positions = [m.position for m in self.session.commands.all()]
        step = max(abs(x - y) for a, b in zip(positions, positions[1:]) for x, y in zip(a, b))
        self.assertLessEqual(step, 6.28 * 0.030 * (1 + 1e-8))

    def test_the_emergency_stop_stops_until_armed_again(self):
        handle = self.session.send(rs.TRIPOD)
        self.session.wait_state(ExecutorState.WALKING)
        rs.wait_for(lambda: self.e_stop.get_num_connections() > 0, 5.0, "a subscriber of e_stop")
        self.e_stop.publish(True)
        result = self.session.result(handle)
        self.assertEqual(result.code, ExecuteBehaviorResult.STOPPED)
        self.session.wait_state(ExecutorState.STOPPED)
        self.session.commands.clear()
        self.assertFalse(self.session.call("arm").success)
        self.e_stop.publish(False)
        self.assertFalse(self.session.call("stand").success)
        # The state comes once a second: two of them later nothing was sent.
        self.session.states.next()
        self.session.states.next()
        self.assertEqual(self.session.commands.count(), 0)
        self.session.make_ready()

    def test_the_stop_service_stops_at_once(self):
        handle = self.session.send(rs.TRIPOD)
        self.session.wait_state(ExecutorState.WALKING)
        self.assertTrue(self.session.call("stop").success)
        stopped = rospy.Time.now().to_nsec()
        self.assertEqual(self.session.result(handle).code, ExecuteBehaviorResult.STOPPED)
        self.session.states.next()
        self.assertLess(rs.stamp_ns(self.session.commands.last()), stopped)

    def test_sits_and_stands_up_again(self):
        self.assertTrue(self.session.call("sit").success)
        self.session.wait_state(ExecutorState.DISARMED)
        self.assertGreater(max(map(abs, self.session.commands.last().position)), 0.5)
        self.assertTrue(self.session.call("stand").success)
        self.session.wait_state(ExecutorState.READY)

    def test_a_reset_of_the_robot_breaks_the_behaviour_off(self):
        handle = self.session.send(rs.TRIPOD)
        before = self.session.commands.count()
        rs.wait_for(lambda: self.session.commands.count() > before + 20, 5.0, "20 commands")
        self.assertTrue(rospy.ServiceProxy("simulated_robot/reset", Trigger)().success)
        result = self.session.result(handle)
        self.assertEqual(result.code, ExecuteBehaviorResult.FAULT)
        self.assertIn("reset", result.message)
        self.session.wait_state(ExecutorState.READY)


if __name__ == "__main__":
    rostest.rosrun("hexapod_repertoire", "executor_walk", ExecutorWalk)
