#!/usr/bin/python3
"""What the executor plays on the simulated robot is what the learner evaluates, to the last command.
"""
import os
import sys
import unittest

import rospy
import rostest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import robot_session as rs  # noqa: E402


class ExecutorEndPose(unittest.TestCase):
    def test_three_runs_end_where_the_learner_says(self):
        rospy.init_node("executor_end_pose_test")
        odometry = rs.odometry_recorder()
        session = rs.Session()
        session.make_ready()
        rs.check_end_pose(self, session, odometry, runs=3)


if __name__ == "__main__":
    rostest.rosrun("hexapod_repertoire", "executor_end_pose", ExecutorEndPose)
