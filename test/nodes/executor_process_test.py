#!/usr/bin/python3
"""The processes of executor and simulated robot: wrong parameters, no master, shutdown."""
import os
import signal
import socket
import subprocess
import sys
import time
import unittest

import rosgraph
import rospy
import rostest
from hexapod_repertoire.msg import ExecutorState

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import robot_session as rs  # noqa: E402


# Has a behaviour played and prints when it is under way, then the code of its result.
CLIENT = """
client = actionlib.ActionClient("execute", ExecuteBehaviorAction)
client.wait_for_server()
goal = ExecuteBehaviorGoal(entry_id=-1, genome=bytes(%r))
while True:
    told = []
    handle = client.send_goal(goal, feedback_cb=lambda *_: told.append(print("walking", flush=True))
                              if not told else None)
    while handle.get_comm_state() != actionlib.CommState.DONE:
        rospy.sleep(0.05)
    if told:
        break
print(handle.get_result().code, flush=True)
"""


class ExecutorProcess(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("executor_process_test")
        cls.binaries = rospy.get_param("~binaries")
        cls.root = rospy.get_param("~root")

    def setUp(self):
        self.processes = []

    def tearDown(self):
        for process in self.processes:
            if process.poll() is None:
                process.kill()
            process.communicate()

    def start(self, program, name, *arguments, **environment):
        process = subprocess.Popen(
            [self.binaries + "/" + program, "__name:=" + name] + list(arguments),
            env=dict(os.environ, **environment), text=True, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT)
        self.processes.append(process)
        return process

    def refusal(self, program, **params):
        """Starts a node with parameters that are wrong; what it says before it ends with code 2."""
        name = "wrong_" + program
        rospy.set_param("/" + name, dict({"robot_config": self.root + "/config/hexapod.yaml"},
                                         **params))
        try:
            process = self.start(program, name)
            output, _ = process.communicate(timeout=20.0)
        finally:
            rospy.delete_param("/" + name)
        self.assertEqual(process.returncode, 2, output)
        return output

    def test_wrong_parameters_end_with_a_sentence_and_code_2(self):
        for params, says in [
                ({"ramp_tme_s": 1.0}, "ramp_tme_s"),
                ({"ramp_time_s": "1e0"}, "ramp_time_s"),
                ({"ramp_time_s": -1.0}, "ramp_time_s"),
                ({"command_interface": "smoke_signals"}, "command_interface"),
                ({"command_interface": "joint_trajectory", "controllers": "a,b"}, "controllers"),
                ({"command_interface": "per_joint", "joint_topic": "command"}, "{joint}"),
                ({"robot_config": "/nowhere.yaml"}, "/nowhere.yaml"),
                ({"joint_map": self.root + "/config/hexapod.yaml"}, "joints"),
                ({"gait_duration_s": 3.01}, "gait_duration_s")]:
            self.assertIn(says, self.refusal("executor", **params))
        for params, says in [
                ({"real_time_factor": 2.0}, "publish_clock"),
                ({"publish_clock": True}, "use_sim_time"),
                ({"engine": "steam"}, "engine"),
                ({"friction_scale": -1.0}, "friction_scale"),
                ({"step_s": 1}, "step_s")]:
            self.assertIn(says, self.refusal("simulated_robot", **params))

    def test_all_problems_are_told_at_once(self):
        output = self.refusal("executor", ramp_time_s=-1.0, nonsense=1, auto_arm="yes")
        for says in ("ramp_time_s", "nonsense", "auto_arm"):
            self.assertIn(says, output)

    def test_leaves_within_two_seconds_while_walking(self):
        for number, ending in enumerate((signal.SIGINT, signal.SIGTERM)):
            name = "leaver_%d" % number
            rospy.set_param("/" + name, {
                "robot_config": self.root + "/config/hexapod.yaml", "feedback_timeout_s": 0,
                "auto_arm": True, "ramp_time_s": 0.1})
            states = rs.Recorder("/" + name + "/state", ExecutorState)
            process = self.start("executor", name)
            rs.wait_for(lambda: states.last() and states.last().state == ExecutorState.READY,
                        20.0, "the executor to stand")
            asked = time.monotonic()
            process.send_signal(ending)
            self.assertEqual(process.wait(timeout=10.0), 0)
            self.assertLess(time.monotonic() - asked, 4.0)

    def test_stands_up_by_itself_once_in_a_session(self):
        rospy.set_param("/riser", {
            "robot_config": self.root + "/config/hexapod.yaml", "feedback_timeout_s": 0,
            "auto_arm": True, "ramp_time_s": 0.1})
        states = rs.Recorder("/riser/state", ExecutorState)
        process = self.start("executor", "riser")
        rs.wait_for(lambda: states.last() and states.last().state == ExecutorState.READY, 20.0,
                    "the executor to stand")
        process.kill()
        process.wait()
        states.clear()
        self.start("executor", "riser")  # as roslaunch starts it again
        for _ in range(3):
            self.assertEqual(states.next(20.0).state, ExecutorState.DISARMED)

    def test_finishes_the_behaviour_when_the_master_is_gone_and_ends_with_code_3(self):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        uri = "http://127.0.0.1:%d" % port
        core = subprocess.Popen(["rosmaster", "--core", "-p", str(port)],
                                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.processes.append(core)
        master = rosgraph.Master("/executor_process_test", uri)
        rs.wait_for(master.is_online, 20.0, "the other master")
        master.setParam("/robot_description", rospy.get_param("/robot_description"))
        master.setParam("/walker", {
            "robot_config": self.root + "/config/hexapod.yaml", "feedback_timeout_s": 0,
            "auto_arm": True, "ramp_time_s": 0.1})
        walker = self.start("executor", "walker", ROS_MASTER_URI=uri)
        client = rs.OtherNode("client", CLIENT % rs.TRIPOD, ROS_MASTER_URI=uri)
        with client:
            self.assertEqual(client.line(), "walking")
            core.kill()
            self.assertIn(client.line(), ("0", "6"), "SUCCEEDED, or SKIPPED on a busy machine")
        self.assertEqual(walker.wait(timeout=20.0), 3)

    def test_waits_for_a_master_and_leaves_when_asked(self):
        for program in ("executor", "simulated_robot"):
            process = self.start(program, "lonely", ROS_MASTER_URI="http://127.0.0.1:1",
                                 ROSCONSOLE_STDOUT_LINE_BUFFERED="1")
            line = process.stdout.readline()
            self.assertIn("No ROS master answers at http://127.0.0.1:1", line)
            process.send_signal(signal.SIGINT)
            self.assertEqual(process.wait(timeout=10.0), 0)


if __name__ == "__main__":
    rostest.rosrun("hexapod_repertoire", "executor_process", ExecutorProcess)
