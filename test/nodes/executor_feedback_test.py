#!/usr/bin/python3
"""Whose feedback the executor believes, and that a busy one hears it and the emergency stop."""
import os
import sys
import unittest

import rospy
import rostest
from hexapod_repertoire.msg import (ExecuteBehaviorAction, ExecuteBehaviorGoal,
                                    ExecuteBehaviorResult, ExecutorState)
from std_msgs.msg import Bool, Header

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import robot_session as rs  # noqa: E402
from action_burst import ActionBurst  # noqa: E402

# A joint_state_publisher that somebody left running: zeros at 50 Hz.
STRAY = """
publisher = rospy.Publisher("joint_states", JointState, queue_size=1)
message = JointState(name=%r, position=[0.0] * 18)
rate = rospy.Rate(50)
while not rospy.is_shutdown():
    message.header.stamp = rospy.Time.now()
    publisher.publish(message)
    rate.sleep()
""" % rs.JOINTS


class ExecutorFeedback(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("robot_driver")
        cls.robot = rs.FakeRobot()
        cls.e_stop = rospy.Publisher("e_stop", Bool, queue_size=1)
        cls.beating = True
        cls.heart = rospy.Timer(rospy.Duration(0.1), cls.beat)
        cls.session = rs.Session()

    @classmethod
    def beat(cls, _):
        if cls.beating:
            cls.e_stop.publish(False)

    def setUp(self):
        self.robot.spoil = lambda message: message
        self.robot.leg_by_leg = False
        self.session.make_ready()

    def test_walks_with_six_drivers_of_20_hertz(self):
        self.robot.leg_by_leg = True
        self.session.call("disarm")
        self.session.make_ready()
        self.assertTrue(rs.played(self.session.result(self.session.send(rs.TRIPOD))))

    def test_a_second_publisher_is_named_at_arming_and_never_believed(self):
        handle = self.session.send(rs.TRIPOD)
        self.session.wait_state(ExecutorState.WALKING)
        with rs.OtherNode("joint_state_publisher", STRAY):
            self.assertTrue(rs.played(self.session.result(handle)), "the driver is still believed")
            self.session.call("disarm")
            answer = rs.wait_for(
                lambda: next((a for a in [self.session.call("arm")] if not a.success),
                             self.session.call("disarm") and None), 10.0, "a refusal")
            self.assertIn(rospy.get_name() + " and /joint_state_publisher", answer.message)
            self.robot.spoil = lambda message: None
            rs.wait_for(lambda: not self.session.call("arm").success, 5.0, "still a refusal")
            self.robot.spoil = lambda message: message
        self.session.make_ready()

    def test_a_driver_that_repeats_itself_is_noticed(self):
        frozen = {}

        def repeat(message):
            message.position = frozen.setdefault("position", message.position)
            return message
        handle = self.session.send(rs.TRIPOD)
        self.robot.spoil = repeat
        result = self.session.result(handle)
        self.assertEqual(result.code, ExecuteBehaviorResult.FAULT)
        self.assertIn("do not change", result.message)

    def test_a_burst_of_goals_is_answered_and_does_not_disturb_the_walk(self):
        burst = ActionBurst("execute", ExecuteBehaviorAction)
        rs.wait_for(burst.is_connected, 10.0, "the action server")
        handle = self.session.send(rs.TRIPOD)
        self.session.wait_state(ExecutorState.WALKING)
        burst.send(ExecuteBehaviorGoal(entry_id=-1, genome=bytes(rs.TURN)), 1000)
        rs.wait_for(lambda: not burst.unanswered(), 30.0, "the answers to the burst")
        self.assertTrue(rs.played(self.session.result(handle)))
        for results in burst.answers().values():
            self.assertEqual([result.result.code for result in results],
                             [ExecuteBehaviorResult.NOT_READY])

    def test_a_reset_breaks_off_what_began_before_it_and_one_that_is_not_now_does_not(self):
        publisher = rospy.Publisher("robot_reset", Header, queue_size=1)
        rs.wait_for(lambda: publisher.get_num_connections() > 0, 10.0, "the executor")

        def result_of_reset(offset_s):
            handle = self.session.send(rs.TRIPOD)
            self.session.wait_state(ExecutorState.WALKING)
            for _ in range(3):
                self.session.commands.next()  # WALKING is told before the first command is due
            publisher.publish(Header(stamp=rospy.Time.now() + rospy.Duration(offset_s)))
            return self.session.result(handle)

        for offset_s in (3600.0, -3600.0):
            self.assertTrue(rs.played(result_of_reset(offset_s)))
        result = result_of_reset(0.0)
        self.assertFalse(rs.played(result))
        self.assertIn("reset", result.message)

    def test_an_emergency_stop_that_falls_silent_stops_and_holds(self):
        handle = self.session.send(rs.TRIPOD)
        self.session.wait_state(ExecutorState.WALKING)
        type(self).beating = False
        try:
            result = self.session.result(handle)
            self.assertEqual(result.code, ExecuteBehaviorResult.STOPPED)
            self.assertIn("e_stop_timeout_s", result.message)
            self.session.states.next()
            self.session.states.next()  # by now the last word is out
            count = self.session.commands.count()
            self.assertIn("e_stop", self.session.call("arm").message)
            self.session.states.next()
            self.assertEqual(self.session.commands.count(), count)
        finally:
            type(self).beating = True
        self.session.make_ready()

    def test_a_behaviour_whose_client_is_gone_is_played_to_its_end(self):
        code = """
client = actionlib.SimpleActionClient("execute", ExecuteBehaviorAction)
client.wait_for_server()
client.send_goal(ExecuteBehaviorGoal(entry_id=-1, genome=bytes(%r)))
print("sent", flush=True)
rospy.spin()
""" % rs.TRIPOD
        with rs.OtherNode("client", code) as client:
            self.assertEqual(client.line(), "sent")
            self.session.wait_state(ExecutorState.WALKING)
        states = self.session.states
        before = states.count()
        self.session.wait_state(ExecutorState.READY)
        self.assertEqual({m.state for m in states.all()[before:]} -
                         {ExecutorState.WALKING, ExecutorState.READY}, set())
        self.assertTrue(rs.played(self.session.result(self.session.send(rs.TURN))))


if __name__ == "__main__":
    rostest.rosrun("hexapod_repertoire", "executor_feedback", ExecutorFeedback)
