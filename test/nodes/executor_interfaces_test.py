#!/usr/bin/python3
"""Each command interface: topics, types, order; and the one that sends nothing."""
import math
import os
import sys
import unittest

import rospy
import rostest
import yaml
from hexapod_repertoire.msg import ExecutorState
from std_msgs.msg import Float64, Float64MultiArray
from std_srvs.srv import Trigger
from trajectory_msgs.msg import JointTrajectory

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import robot_session as rs  # noqa: E402


LEG_SITTING = (0.0, math.pi / 4, -math.pi / 4)


class ExecutorInterfaces(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("executor_interfaces_test")

    def sitting(self, robot, topic, message_type):
        """Has a robot sit down; its last command. In that pose a leg's joints are at 0, pi / 4 and
        -pi / 4, so signs, offsets and order matter."""
        recorder = rs.Recorder(robot + "/" + topic, message_type)
        recorder.next(20.0)
        states = rs.Recorder(robot + "/executor/state", ExecutorState)
        rospy.wait_for_service(robot + "/executor/sit", 10.0)
        sit = rospy.ServiceProxy(robot + "/executor/sit", Trigger)
        rs.wait_for(lambda: sit().success, 20.0, "the executor to sit down")
        rs.wait_for(lambda: states.last() and states.last().state == ExecutorState.DISARMED, 20.0,
                    "the robot to sit")
        return recorder.last()

    def test_one_trajectory_controller_per_leg(self):
        third = self.sitting("trajectory", "c/command", JointTrajectory)
        self.assertEqual(third.joint_names, ["body_leg_2", "leg_2_1_2", "leg_2_2_3"])
        self.assertTrue(third.header.stamp.is_zero())
        self.assertEqual(len(third.points), 1)
        for position, expected in zip(third.points[0].positions, LEG_SITTING):
            self.assertAlmostEqual(position, expected)
        ahead_ns = third.points[0].time_from_start.to_nsec()
        self.assertGreaterEqual(ahead_ns, rs.PERIOD_NS)
        self.assertLessEqual(ahead_ns, 2 * rs.PERIOD_NS)

    def test_one_group_controller_for_all(self):
        message = self.sitting("group", "position_controller/command", Float64MultiArray)
        self.assertEqual(len(message.data), 18)
        for position, expected in zip(message.data, LEG_SITTING * 6):
            self.assertAlmostEqual(position, expected)

    def test_one_topic_per_joint_with_names_signs_and_offsets_of_the_joint_map(self):
        with open(rospy.get_param("~root") + "/config/joint_map_phantomx.yaml") as stream:
            joints = yaml.safe_load(stream)["joints"]
        recorders = {joint: rs.Recorder("single/%s_position_controller/command" % wire["name"],
                                        Float64) for joint, wire in joints.items()}
        self.sitting("single", "j_c1_lr_position_controller/command", Float64)
        for name, angle in zip(rs.JOINTS, LEG_SITTING * 6):
            wire = joints[name]
            self.assertAlmostEqual(recorders[name].last().data,
                                   wire["sign"] * angle + wire["offset_rad"], msg=name)

    def test_the_shadow_works_and_sends_nothing(self):
        states = rs.Recorder("shadow/executor/state", ExecutorState)
        rs.wait_for(lambda: states.last() and states.last().state == ExecutorState.READY, 20.0,
                    "the shadow to stand")
        topics = [topic for topic, nodes in rospy.get_master().getSystemState()[2][0]
                  if "/shadow/executor" in nodes]
        self.assertFalse([topic for topic in topics if "command" in topic], topics)


if __name__ == "__main__":
    rostest.rosrun("hexapod_repertoire", "executor_interfaces", ExecutorInterfaces)
