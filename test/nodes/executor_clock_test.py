#!/usr/bin/python3
"""Executor and simulated robot on simulated time, as fast as it goes."""
import os
import sys
import unittest

import rospy
import rostest
from hexapod_repertoire.msg import ExecutorState
from rosgraph_msgs.msg import Clock, Log
from std_srvs.srv import SetBool

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
        rs.check_end_pose(self, self.session, self.odometry, runs=3)

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
