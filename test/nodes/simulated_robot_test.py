#!/usr/bin/python3
"""The simulated robot, seen from its topics."""
import math
import os
import signal
import sys
import unittest

import rospy
import rostest
import tf2_ros
from diagnostic_msgs.msg import DiagnosticArray
from hexapod_repertoire.msg import Repertoire
from hexapod_repertoire.srv import Disturb, DisturbRequest
from nav_msgs.msg import Odometry
from rosgraph_msgs.msg import Log
from sensor_msgs.msg import JointState
from std_srvs.srv import SetBool, Trigger

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import robot_session as rs  # noqa: E402

JOINTS = [name for leg in range(6)
          for name in ("body_leg_%d" % leg, "leg_%d_1_2" % leg, "leg_%d_2_3" % leg)]


class SimulatedRobot(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("simulated_robot_test")
        cls.joints = rs.Recorder("joint_states", JointState)
        cls.odometry = rs.odometry_recorder()
        cls.diagnostics = rs.Recorder("/diagnostics", DiagnosticArray)
        cls.commands = rospy.Publisher("joint_command", JointState, queue_size=20)
        rs.wait_for(lambda: cls.commands.get_num_connections() > 0, 20.0, "the simulated robot")

    def setUp(self):
        self.reset()

    def reset(self):
        self.assertTrue(rospy.ServiceProxy("simulated_robot/reset", Trigger)().success)
        self.joints.next()

    def command(self, positions, names=None, stamp=None):
        message = JointState(name=names or JOINTS, position=positions)
        message.header.stamp = stamp or rospy.Time(0)
        self.commands.publish(message)

    def angles(self):
        last = self.joints.last() or self.joints.next()
        return dict(zip(last.name, last.position))

    def wait_angle(self, joint, angle_rad):
        rs.wait_for(lambda: abs(self.angles()[joint] - angle_rad) < 0.02, 5.0,
                    "%s at %g rad" % (joint, angle_rad))

    def report(self):
        for array in reversed(self.diagnostics.all()):
            for status in array.status:
                if "simulation" in status.name:
                    return {pair.key: pair.value for pair in status.values}
        return {}

    def test_says_when_the_repertoire_is_of_another_robot(self):
        logs = rs.Recorder("/rosout", Log)
        publisher = rospy.Publisher("repertoire", Repertoire, queue_size=1)
        rs.wait_for(lambda: publisher.get_num_connections() > 0, 10.0, "the simulated robot")
        publisher.publish(Repertoire(run_id="a run", robot_id="another"))
        rs.wait_for(lambda: any("learned for the robot another" in m.msg for m in logs.all()), 10.0,
                    "the error")

    def test_names_its_joints_as_the_description_and_stands(self):
        self.assertEqual(self.joints.next().name, JOINTS)
        self.assertLess(max(map(abs, self.joints.last().position)), 0.05)
        pose = self.odometry.next()
        self.assertEqual(pose.header.frame_id, "odom")
        self.assertEqual(pose.child_frame_id, "base_footprint")
        self.assertLess(math.hypot(*rs.planar(pose)[:2]), 1e-3)

    def test_steps_are_exactly_a_step_apart(self):
        self.odometry.clear()
        rs.wait_for(lambda: self.odometry.count() > 60, 10.0, "60 steps")
        stamps = [rs.stamp_ns(m) for m in self.odometry.all()]
        self.assertEqual({b - a for a, b in zip(stamps, stamps[1:])}, {15_000_000})

    def test_follows_a_command_and_holds_it_in_silence(self):
        target = [0.0] * 18
        target[1] = 0.4
        self.command(target)
        self.wait_angle("leg_0_1_2", 0.4)
        before = self.joints.count()
        rs.wait_for(lambda: self.joints.count() > before + 100, 10.0, "100 steps of silence")
        self.wait_angle("leg_0_1_2", 0.4)

    def test_a_command_acts_its_latency_after_its_stamp(self):
        target = [0.0] * 18
        target[0] = 0.3
        self.joints.clear()
        stamp = rospy.Time.now()
        self.command(target, stamp=stamp)
        self.wait_angle("body_leg_0", 0.3)
        still = [m for m in self.joints.all()
                 if rs.stamp_ns(m) <= stamp.to_nsec() + rs.LATENCY_NS]
        moving = next(m for m in self.joints.all() if m.position[0] > 0.01)
        self.assertTrue(still)
        self.assertLess(max(m.position[0] for m in still), 0.01)
        self.assertLessEqual(rs.stamp_ns(moving), stamp.to_nsec() + rs.LATENCY_NS + 30_000_000)

    def test_physics_never_sees_what_is_no_command(self):
        before = int(rs.wait_for(self.report, 10.0, "diagnostics")["Commands ignored"])
        bad = [[math.nan] + [0.5] * 17, [math.inf] * 18, [9.0] * 18, [0.5] * 17]
        for positions in bad:
            self.command(positions)
        self.command([0.5] * 18, names=JOINTS[:17] + ["tail"])
        self.command([0.5] * 18, names=JOINTS[:17] + JOINTS[:1])
        rs.wait_for(lambda: int(self.report()["Commands ignored"]) == before + 6, 10.0,
                    "six more commands ignored")
        self.assertLess(max(map(abs, self.joints.next().position)), 0.05)

    def test_reset_puts_it_back_and_time_goes_on(self):
        target = [0.3] * 18
        self.command(target)
        self.wait_angle("body_leg_0", 0.3)
        before = rs.stamp_ns(self.joints.last())
        self.odometry.clear()
        self.reset()
        self.wait_angle("body_leg_0", 0.0)
        self.assertGreater(rs.stamp_ns(self.joints.last()), before)
        stamps = [rs.stamp_ns(m) for m in self.odometry.all()]
        self.assertEqual(stamps, sorted(set(stamps)))

    def test_what_it_reports_is_never_old_also_after_its_process_was_stopped(self):
        pid = rs.pid_of("/simulated_robot")
        self.odometry.clear()
        self.odometry.next()
        os.kill(pid, signal.SIGSTOP)
        try:
            stopped_ns = rospy.Time.now().to_nsec()
            rs.wait_for(lambda: rospy.Time.now().to_nsec() > stopped_ns + 10**9, 5.0, "a second")
        finally:
            os.kill(pid, signal.SIGCONT)
        rs.wait_for(lambda: self.odometry.count() > 60, 10.0, "60 steps")
        stamps = [rs.stamp_ns(m) for m in self.odometry.all()]
        gaps = [b - a for a, b in zip(stamps, stamps[1:])]
        self.assertGreaterEqual(max(gaps), 500_000_000)
        self.assertEqual({gap % 15_000_000 for gap in gaps}, {0})
        rs.wait_for(lambda: float(self.report()["Stood still because too late [s]"]) > 0.5, 10.0,
                    "diagnostics that say so")

    def test_pause_holds_the_robot_while_time_goes_on(self):
        pause = rospy.ServiceProxy("simulated_robot/pause", SetBool)
        self.assertTrue(pause(True).success)
        try:
            self.command([0.3] * 18)
            before = self.joints.next()
            rs.wait_for(lambda: rs.stamp_ns(self.joints.last()) > rs.stamp_ns(before) + 200_000_000,
                        5.0, "time to go on")
            self.assertEqual(self.joints.last().position, before.position)
        finally:
            pause(False)
        self.wait_angle("body_leg_0", 0.3)

    def test_tf_carries_the_footprint_and_the_height_above_it(self):
        buffer = tf2_ros.Buffer()
        listener = tf2_ros.TransformListener(buffer)
        odom = self.odometry.next()
        self.assertIsInstance(odom, Odometry)
        flat = rs.wait_for(
            lambda: buffer.can_transform("odom", "base_footprint", rospy.Time(0)) and
            buffer.lookup_transform("odom", "base_footprint", rospy.Time(0)), 5.0, "tf")
        self.assertEqual(flat.transform.translation.z, 0.0)
        self.assertEqual((flat.transform.rotation.x, flat.transform.rotation.y), (0.0, 0.0))
        body = buffer.lookup_transform("base_footprint", "base_link", rospy.Time(0)).transform
        self.assertLess(math.hypot(body.translation.x, body.translation.y), 1e-9)
        self.assertGreater(body.translation.z, 0.05)
        listener.unregister()

    def disturb(self, **fields):
        return rospy.ServiceProxy("simulated_robot/disturb", Disturb)(DisturbRequest(**fields))

    def break_leg(self, leg, state, **fields):
        answer = self.disturb(legs=[leg], states=[state], **fields)
        self.assertTrue(answer.success, answer.message)
        self.assertIn(leg, answer.message)

    def test_a_leg_goes_up_when_it_is_lifted_and_obeys_again_when_repaired(self):
        self.break_leg("left_middle", DisturbRequest.LIFTED)
        self.wait_angle("leg_1_1_2", math.pi / 4)
        self.wait_angle("leg_1_2_3", -math.pi / 4)
        target = [0.0] * 18
        target[0] = target[3] = 0.3
        self.command(target)
        self.wait_angle("body_leg_0", 0.3)
        self.assertLess(abs(self.angles()["body_leg_1"]), 0.05)
        self.assertTrue(self.disturb().success)
        self.command(target)
        self.wait_angle("body_leg_1", 0.3)
        self.wait_angle("leg_1_1_2", 0.0)

    def test_a_leg_is_locked_where_it_is_and_a_limp_one_does_not_move(self):
        target = [0.0] * 18
        target[3] = target[6] = 0.3
        self.command(target)
        self.wait_angle("body_leg_1", 0.3)
        self.wait_angle("body_leg_2", 0.3)
        self.assertTrue(self.disturb(
            legs=["left_middle", "left_front"],
            states=[DisturbRequest.LOCKED, DisturbRequest.LIMP]).success)
        self.command([0.0] * 3 + [-0.3] + [0.0] * 2 + [-0.3] + [0.0] * 2 + [0.3] + [0.0] * 8)
        self.wait_angle("body_leg_3", 0.3)
        self.wait_angle("body_leg_1", 0.3)
        self.assertGreater(self.angles()["body_leg_2"], 0.1)

    def test_joints_of_a_missing_leg_are_not_reported_until_a_reset(self):
        self.break_leg("right_rear", DisturbRequest.MISSING)
        self.joints.clear()
        self.assertEqual(self.joints.next().name, JOINTS[:15])
        self.reset()
        self.joints.clear()
        self.assertEqual(self.joints.next().name, JOINTS)

    def test_commands_get_lost_and_late(self):
        target = [0.0] * 18
        target[0] = 0.3
        self.assertTrue(self.disturb(dropped_share=1.0).success)
        self.command(target)
        before = self.joints.count()
        rs.wait_for(lambda: self.joints.count() > before + 40, 10.0, "40 steps")
        self.assertLess(abs(self.angles()["body_leg_0"]), 0.05)
        self.assertTrue(self.disturb(latency_s=0.5).success)
        self.joints.clear()
        stamp = rospy.Time.now()
        self.command(target, stamp=stamp)
        self.wait_angle("body_leg_0", 0.3)
        still = [m for m in self.joints.all() if abs(m.position[0]) < 0.02]
        self.assertGreater((still[-1].header.stamp - stamp).to_sec(), 0.5)

    def test_feedback_is_as_noisy_as_asked_and_a_dead_band_swallows_small_commands(self):
        self.assertTrue(self.disturb(feedback_noise_rad=0.1).success)
        self.joints.clear()
        rs.wait_for(lambda: self.joints.count() > 30, 10.0, "30 steps")
        values = [value for m in self.joints.all() for value in m.position]
        mean = sum(values) / len(values)
        deviation = math.sqrt(sum((value - mean) ** 2 for value in values) / len(values))
        self.assertAlmostEqual(deviation, 0.1, delta=0.02)
        self.assertTrue(self.disturb(dead_band_rad=0.1).success)
        self.command([0.05, 0.0, 0.0, 0.3] + [0.0] * 14)
        self.wait_angle("body_leg_1", 0.3)
        self.assertLess(abs(self.angles()["body_leg_0"]), 0.02)

    def test_says_what_is_wrong_with_a_disturbance(self):
        for fields, words in (({"legs": ["tail"], "states": [1]}, "'tail'; expected one of left_rear"),
                              ({"legs": ["left_rear"], "states": [7]}, "is 7; expected 0 (intact)"),
                              ({"legs": ["left_rear"], "states": []}, "a state for each leg"),
                              ({"dropped_share": 1.5}, "dropped_share is 1.5; expected 0 .. 1"),
                              ({"slope_x_rad": 2.0}, "slope_x_rad")):
            answer = self.disturb(**fields)
            self.assertFalse(answer.success)
            self.assertIn(words, answer.message)


if __name__ == "__main__":
    rostest.rosrun("hexapod_repertoire", "simulated_robot_test", SimulatedRobot)
