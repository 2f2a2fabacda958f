#!/usr/bin/python3
"""The learner's services and what it says of its file, in every phase."""
import os
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
import unittest

import rospy
import rostest
from hexapod_repertoire.msg import LearningProgress
from std_srvs.srv import SetBool, Trigger

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import robot_session as rs  # noqa: E402

OPTIONS = {"population_size": 20, "evaluations": 100000000, "seed": 1, "threads": 1,
           "verify_with_ode": False, "resimulate": False, "validation_trials": 1,
           "checkpoint_period_s": 3600.0}


class Learner(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("learner_test")
        cls.binaries = rospy.get_param("~binaries")
        cls.root = rospy.get_param("~root")

    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.file = os.path.join(self.folder, "sub", "gaits.db")
        self.progress = rs.Recorder("learner/progress", LearningProgress)

    def tearDown(self):
        self.process.kill()
        self.process.communicate()
        if os.path.islink(os.path.dirname(self.file)):
            os.remove(os.path.dirname(self.file))
        shutil.rmtree(self.folder)

    def start(self, **options):
        rospy.set_param("/learner", dict(OPTIONS, repertoire_file=self.file,
                                         robot_config=self.root + "/config/hexapod.yaml",
                                         **options))
        self.process = subprocess.Popen(
            [self.binaries + "/learner", "__name:=learner"], text=True,
            env=dict(os.environ, ROSCONSOLE_STDOUT_LINE_BUFFERED="1"), stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT)
        rs.wait_for(lambda: self.progress.last() and self.progress.last().generation > 0, 20.0,
                    "the first generations")

    def save(self):
        rospy.wait_for_service("learner/save", 10.0)
        return rospy.ServiceProxy("learner/save", Trigger)()

    def pause(self, paused):
        rospy.wait_for_service("learner/pause", 10.0)
        return rospy.ServiceProxy("learner/pause", SetBool)(paused)

    def state_in_file(self):
        with sqlite3.connect(self.file) as database:
            state = dict(database.execute("SELECT key, value FROM state"))
        return {key: value.decode() if isinstance(value, bytes) else value
                for key, value in state.items()}

    def make_unwritable(self):
        folder = os.path.dirname(self.file)
        os.rename(folder, folder + ".away")
        os.symlink("/nowhere", folder)

    def make_writable(self):
        folder = os.path.dirname(self.file)
        os.remove(folder)
        os.rename(folder + ".away", folder)

    def wait_phase(self, phase):
        rs.wait_for(lambda: self.progress.last() and self.progress.last().phase == phase, 30.0, phase)

    def test_paused_it_goes_on_telling_and_saving_and_stands_still(self):
        self.start()
        self.assertTrue(self.pause(True).success)
        self.wait_phase("paused")
        first = self.progress.last()
        count = self.progress.count()
        self.assertTrue(self.save().success)
        self.assertEqual(int(self.state_in_file()["generations"]), first.generation)
        rs.wait_for(lambda: self.progress.count() >= count + 3, 10.0, "progress while paused")
        last = self.progress.last()
        self.assertEqual((last.phase, last.evaluations), ("paused", first.evaluations))
        self.assertGreater(last.header.stamp, first.header.stamp)
        self.assertTrue(self.pause(False).success)
        rs.wait_for(lambda: self.progress.last().evaluations > first.evaluations, 10.0,
                    "learning to go on")

    def test_a_save_that_fails_is_told_with_the_reason_and_one_that_succeeds_is_in_the_file(self):
        self.start()
        self.make_unwritable()
        answer = self.save()
        self.assertFalse(answer.success)
        self.assertIn(os.path.dirname(self.file), answer.message)
        self.make_writable()
        generation = self.progress.last().generation
        answer = self.save()
        self.assertTrue(answer.success, answer.message)
        self.assertGreaterEqual(int(self.state_in_file()["generations"]), generation)

    def test_when_done_it_saves_and_refuses_to_pause(self):
        self.start(evaluations=400)
        self.wait_phase("done")
        os.remove(self.file)
        answer = self.save()
        self.assertTrue(answer.success, answer.message)
        self.assertEqual(self.state_in_file()["session.phase"], "done")
        answer = self.pause(True)
        self.assertFalse(answer.success)
        self.assertIn("nothing to pause", answer.message)

    def test_left_with_an_unsaved_run_it_ends_with_an_error_that_says_so_last(self):
        self.start()
        self.assertTrue(self.save().success)
        self.make_unwritable()
        self.process.send_signal(signal.SIGINT)
        output, _ = self.process.communicate(timeout=30.0)
        self.assertEqual(self.process.returncode, 1, output)
        self.assertIn("is lost", output.strip().splitlines()[-1])


if __name__ == "__main__":
    rostest.rosrun("hexapod_repertoire", "learner_process", Learner, sys.argv)
