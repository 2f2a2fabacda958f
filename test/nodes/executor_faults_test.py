#!/usr/bin/python3
"""What the executor does when the robot, its feedback, other nodes or its own process misbehave.

The robot is this test: it answers each command with joint states, as well or badly as asked.
"""
import math
import os
import random
import signal
import sys
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from hexapod_repertoire.msg import (ExecuteBehaviorResult, ExecutorState, Repertoire,
                                    RepertoireEntry)
from sensor_msgs.msg import JointState

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import robot_session as rs  # noqa: E402

def shuffled(message):
    order = random.Random(1).sample(range(18), 18)
    message.name = [message.name[i] for i in order] + ["camera_pan"]
    message.position = [message.position[i] for i in order] + [9.0]
    return message


def with_nan(message):
    message.position[4] = math.nan
    return message


def with_a_missing_joint(message):
    del message.name[3], message.position[3]
    return message


def with_a_joint_twice(message):
    message.name[3] = message.name[4]
    return message


def with_an_old_stamp(message):
    message.header.stamp -= rospy.Duration(2.0)
    return message


def stuck(message):
    message.position = [0.0] * 18
    return message


def diagnostic(recorder, name):
    """The newest diagnostic status whose name ends in `name`."""
    for array in reversed(recorder.all()):
        for status in array.status:
            if status.name.endswith(name):
                return status
    return None


class ExecutorFaults(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("executor_faults_test")
        cls.robot = rs.FakeRobot()
        cls.session = rs.Session()
        cls.diagnostics = rs.Recorder("/diagnostics", DiagnosticArray)
        cls.repertoires = rospy.Publisher("repertoire", Repertoire, queue_size=1, latch=True)
        cls.digest = rs.offline_outcome(rospy.get_param("~binaries"), rospy.get_param("~root"),
                                        rs.TURN)[1]

    def setUp(self):
        self.robot.spoil = lambda message: message
        self.session.make_ready()
        self.session.commands.clear()

    def test_feedback_in_any_order_and_with_other_joints_is_used(self):
        self.robot.spoil = shuffled
        handle = self.session.send(rs.TURN)
        self.assertTrue(rs.played(self.session.result(handle)))

    def test_lost_or_useless_feedback_is_a_fault_and_nothing_is_sent(self):
        for spoil in (lambda message: None, with_nan, with_a_missing_joint, with_a_joint_twice,
                      with_an_old_stamp):
            self.session.make_ready()
            handle = self.session.send(rs.TURN)
            self.session.wait_state(ExecutorState.WALKING)
            self.robot.spoil = spoil
            result = self.session.result(handle)
            self.assertEqual(result.code, ExecuteBehaviorResult.FAULT)
            self.assertIn("joint_states", result.message)
            self.session.wait_state(ExecutorState.FAULT)
            self.session.commands.clear()
            self.assertFalse(self.session.call("arm").success)
            self.session.states.next()
            self.assertEqual(self.session.commands.count(), 0)
            self.robot.spoil = lambda message: message

    def test_a_servo_that_does_not_follow_is_a_fault_that_names_it(self):
        handle = self.session.send([0, 0, 4, 0] + [0] * 20)
        self.robot.spoil = stuck
        result = self.session.result(handle)
        self.assertEqual(result.code, ExecuteBehaviorResult.FAULT)
        self.assertRegex(result.message, "leg_0_[12]_[23]")

    def test_a_stopped_process_skips_and_does_not_burst(self):
        handle = self.session.send(rs.TURN)
        rs.wait_for(lambda: self.session.commands.count() > 20, 5.0, "20 commands")
        pid = rs.pid_of("/executor")
        os.kill(pid, signal.SIGSTOP)
        try:
            stopped_ns = rospy.Time.now().to_nsec()
            rs.wait_for(lambda: rospy.Time.now().to_nsec() > stopped_ns + 10**9, 5.0, "a second")
        finally:
            os.kill(pid, signal.SIGCONT)
        result = self.session.result(handle)
        self.assertEqual(result.code, ExecuteBehaviorResult.SKIPPED, result.message)
        self.assertGreater(result.skipped, 30)
        self.assertIn("%d of its 130 commands" % result.skipped, result.message)
        stamps = [rs.stamp_ns(m) for m in self.session.commands.all()]
        gaps = [b - a for a, b in zip(stamps, stamps[1:])]
        self.assertGreaterEqual(max(gaps), 30 * rs.PERIOD_NS)
        self.assertEqual({gap % rs.PERIOD_NS for gap in gaps}, {0})
        self.assertGreater(min(gaps), 0)
        self.assertGreater(self.session.states.next().skipped, 30)
        state = {v.key: v.value for v in diagnostic(self.diagnostics, "executor: state").values}
        self.assertGreater(float(state["Largest lateness [ms]"]), 900.0)

    def test_a_second_publisher_of_commands_is_an_error(self):
        publisher = rospy.Publisher("joint_command", JointState, queue_size=1)

        def level():
            status = diagnostic(self.diagnostics, "commands")
            return status.level if status else None
        rs.wait_for(lambda: level() == DiagnosticStatus.ERROR, 10.0, "an ERROR in diagnostics")
        self.assertIn(rospy.get_name(), diagnostic(self.diagnostics, "commands").message)
        publisher.unregister()
        rs.wait_for(lambda: level() == DiagnosticStatus.OK, 10.0, "OK in diagnostics")

    def repertoire(self, **changes):
        message = Repertoire(format_version=1, run_id="run", robot_id=self.digest,
                             behavior_duration_s=3.9, joint_names=rs.JOINTS)
        message.header.frame_id = "base_footprint"
        message.entries = [RepertoireEntry(id=7, genome=bytes(rs.TURN))]
        for name, value in changes.items():
            setattr(message, name, value)
        return message

    def refusal(self, entry_id, run_id="run"):
        result = self.session.result(self.session.send(entry_id=entry_id, run_id=run_id))
        self.assertEqual(result.code, ExecuteBehaviorResult.INVALID_GOAL)
        return result.message

    def publish(self, message, says):
        """Publishes a repertoire and waits until a goal for an unknown entry is refused with it."""
        self.repertoires.publish(message)
        rs.wait_for(lambda: says in self.refusal(99, message.run_id), 5.0, says)

    def test_plays_entries_of_the_repertoire_and_of_no_other_run_or_robot(self):
        self.publish(self.repertoire(robot_id="0123"), "learned for the robot 0123")
        self.publish(self.repertoire(behavior_duration_s=3.0), "behaviours take 3 s")
        self.publish(self.repertoire(behavior_duration_s=math.nan), "behaviours take nan")
        self.publish(self.repertoire(joint_names=rs.JOINTS[:17]), "joint names")
        for genome in ([1] * 23, [5] * 24):
            self.publish(self.repertoire(entries=[RepertoireEntry(id=7, genome=bytes(genome))]),
                         "Entry 7 of the repertoire is refused")
        twice = [RepertoireEntry(id=7, genome=bytes(rs.TURN))] * 2
        self.publish(self.repertoire(entries=twice), "occurs twice")
        self.publish(self.repertoire(), "Entry 99 is not")
        handle = self.session.send(entry_id=7, run_id="run")
        rs.wait_for(lambda: self.session.states.last().entry_id == 7, 5.0, "entry 7 in the state")
        self.assertTrue(rs.played(self.session.result(handle)))
        self.assertIn("'run'", self.refusal(7, "other run"))


if __name__ == "__main__":
    rostest.rosrun("hexapod_repertoire", "executor_faults", ExecutorFaults)
