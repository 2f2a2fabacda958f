#!/usr/bin/python3
"""Executor and simulated robot on simulated time, as fast as it goes."""
import os
import sys
import unittest

import rospy
import rostest
from hexapod_repertoire.msg import ExecuteBehaviorResult, ExecutorState
from rosgraph_msgs.msg import Clock, Log
from std_srvs.srv import SetBool, Trigger

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import robot_session as rs  # noqa: E402


class ExecutorClock(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("executor_clock_test")
        cls.logs = rs.Recorder("/rosout", Log)
        cls.odometry = rs.odometry_recorder()
        cls.session = rs.Session()
        cls.session.wait_state(ExecutorState.READY)

    def test_three_runs_end_where_the_learner_says(self):
        expected, _ = rs.offline_outcome(rospy.get_param("~binaries"), rospy.get_param("~root"),
                                         rs.TRIPOD)
        for run in range(3):
            self.assertTrue(rospy.ServiceProxy("simulated_robot/reset", Trigger)().success)
            self.odometry.clear()
            rs.wait_for(lambda: self.odometry.count() > rs.SETTLED_STEPS, 10.0, "the stand")
            skipped = self.session.states.last().skipped
            result = self.session.result(self.session.send(rs.TRIPOD))
            self.assertEqual(result.code, ExecuteBehaviorResult.SUCCEEDED, result.message)
            distance_m, turn_rad = rs.end_pose_error(self.odometry, result, expected)
            late = self.session.states.next().skipped - skipped
            print("run %d: %d commands skipped, end pose off by %.2e m, %.2e rad" %
                  (run, late, distance_m, turn_rad))
            if late == 0:
                self.assertLess(distance_m, 1e-3)
                self.assertLess(turn_rad, 1e-2)

    def test_pausing_stops_time_and_the_executor_still_answers(self):
        clock = rs.Recorder("/clock", Clock)
        clock.next()
        pause = rospy.ServiceProxy("simulated_robot/pause", SetBool)
        self.assertTrue(pause(True).success)
        try:
            self.session.states.next()
            before = clock.last().clock
            self.session.states.next()
            self.assertEqual(clock.last().clock, before)
            self.assertTrue(self.session.call("disarm").success)
        finally:
            pause(False)
        self.session.make_ready()

    def test_a_clock_that_does_not_come_is_named(self):
        def named():
            return any("/clock" in m.msg and m.name == "/timeless/executor"
                       for m in self.logs.all())
        rs.wait_for(named, 10.0, "a sentence about /clock")


if __name__ == "__main__":
    rostest.rosrun("hexapod_repertoire", "executor_clock", ExecutorClock)
