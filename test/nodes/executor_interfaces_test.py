#!/usr/bin/python3
"""Each command interface: topics, types, order; and the one that sends nothing."""
import os
import sys
import unittest

import rospy
import rostest
from hexapod_repertoire.msg import ExecutorState
from std_msgs.msg import Float64, Float64MultiArray
from trajectory_msgs.msg import JointTrajectory

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import robot_session as rs  # noqa: E402


class ExecutorInterfaces(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("executor_interfaces_test")

    def test_one_trajectory_controller_per_leg(self):
        third = rs.Recorder("trajectory/c/command", JointTrajectory).next(20.0)
        self.assertEqual(third.joint_names, ["body_leg_2", "leg_2_1_2", "leg_2_2_3"])
        self.assertTrue(third.header.stamp.is_zero())
        self.assertEqual(len(third.points), 1)
        self.assertEqual(third.points[0].positions, (0.0, 0.0, 0.0))
        ahead_ns = third.points[0].time_from_start.to_nsec()
        self.assertGreaterEqual(ahead_ns, rs.PERIOD_NS)
        self.assertLessEqual(ahead_ns, 2 * rs.PERIOD_NS)

    def test_one_group_controller_for_all(self):
        message = rs.Recorder("group/position_controller/command", Float64MultiArray).next(20.0)
        self.assertEqual(len(message.data), 18)

    def test_one_topic_per_joint_with_the_names_of_the_joint_map(self):
        recorders = [rs.Recorder("single/%s_position_controller/command" % joint, Float64)
                     for joint in ("j_c1_lr", "j_tibia_rr")]
        for recorder in recorders:
            self.assertEqual(abs(recorder.next(20.0).data), 0.0)

    def test_the_shadow_works_and_sends_nothing(self):
        states = rs.Recorder("shadow/executor/state", ExecutorState)
        rs.wait_for(lambda: states.last() and states.last().state == ExecutorState.READY, 20.0,
                    "the shadow to stand")
        topics = [topic for topic, nodes in rospy.get_master().getSystemState()[2][0]
                  if "/shadow/executor" in nodes]
        self.assertFalse([topic for topic in topics if "command" in topic], topics)


if __name__ == "__main__":
    rostest.rosrun("hexapod_repertoire", "executor_interfaces", ExecutorInterfaces)
