"""Kills a node or the master of a walking session: the robot stands, and the next session walks.

Each trial starts a session, walks to a goal, which must succeed, sends another one, and kills -9 a
process at a random moment of that walk. The joints must come to rest, the session must end when it
is asked to, if it has not already, and leave no process behind. A learner is killed in trials of
its own: the next one resumes its run.
"""
import argparse
import collections
import contextlib
import json
import os
import pathlib
import random
import select
import signal
import socket
import subprocess
import sys
import tempfile
import time
import uuid

from support import programs

ROOT = programs.ROOT
OBSERVER = pathlib.Path(__file__).resolve().parent / "support" / "walk_observer.py"
VICTIMS = ["executor", "planner", "simulated_robot", "rosmaster", "learner"]
START_S = 90
STILL_S = 20
ANSWER_S = 60
END_S = 40
MARK = "HEXAPOD_CAMPAIGN"


def free_port():
    with socket.socket() as listener:
        listener.bind(("127.0.0.1", 0))
        return listener.getsockname()[1]


class Session:
    """A launch file under a master of its own, and what belongs to it."""

    def __init__(self, launch_file, *arguments):
        self.mark = str(uuid.uuid4())
        self.environment = {**os.environ, MARK: self.mark, "ROS_IP": "127.0.0.1",
                            "ROS_MASTER_URI": f"http://127.0.0.1:{free_port()}"}
        self.log = tempfile.TemporaryFile()
        self.launch = subprocess.Popen(
            [sys.executable, "-m", "hexapod_repertoire.launch", str(ROOT / "launch" / launch_file),
             *arguments], env=self.environment, stdout=self.log, stderr=subprocess.STDOUT,
            start_new_session=True)

    def observer(self):
        return subprocess.Popen([sys.executable, str(OBSERVER)], env=self.environment, text=True,
                                stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                stderr=subprocess.DEVNULL)

    def processes(self):
        """{pid: command line} of all that belongs to it, by the mark in their environment."""
        found = {}
        for folder in pathlib.Path("/proc").glob("[0-9]*"):
            with contextlib.suppress(OSError):
                if f"{MARK}={self.mark}".encode() in (folder / "environ").read_bytes():
                    words = (folder / "cmdline").read_bytes().split(b"\0")
                    found[int(folder.name)] = b" ".join(words).decode(errors="replace")
        return found

    def pid_of(self, name):
        deadline = time.monotonic() + START_S
        while time.monotonic() < deadline:
            for pid, command in self.processes().items():
                if f"/{name} " in command + " " and "launch" not in command:
                    return pid
            time.sleep(0.1)
        raise RuntimeError(f"no process {name}")

    def end(self):
        """Asks it to end and returns what is wrong with how it did, or ""."""
        with contextlib.suppress(ProcessLookupError):
            self.launch.send_signal(signal.SIGINT)
        try:
            self.launch.wait(timeout=END_S)
        except subprocess.TimeoutExpired:
            return "did not end"
        deadline = time.monotonic() + 5.0
        while self.processes() and time.monotonic() < deadline:
            time.sleep(0.1)
        left = self.processes()
        return f"left running: {sorted(left.values())}" if left else ""

    def clean_up(self):
        for pid in self.processes():
            with contextlib.suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)
        self.launch.wait()

    def words(self):
        self.log.seek(0)
        return self.log.read().decode(errors="replace")[-3000:]


def ask(observer, request, timeout_s):
    """What the observer finds wrong, or ""; it is given that time, and some to begin."""
    observer.stdin.write(f"{request[0]} {timeout_s} {' '.join(map(str, request[1:]))}\n")
    observer.stdin.flush()
    if not select.select([observer.stdout], [], [], timeout_s + ANSWER_S)[0]:
        return "the observer is silent"
    return json.loads(observer.stdout.readline() or '{"problem": "the observer died"}')["problem"]


def disturb_walk(victim, repertoire, dice):
    """What was wrong, or ""."""
    session = Session("walk.launch", f"repertoire_file:={repertoire}", "rviz:=false")
    observer = session.observer()
    try:
        problem = ask(observer, ("walk_to", 0.3, 0.0), START_S)
        if problem:
            return f"the first goal: {problem}\n{session.words()}"
        ask(observer, ("send_goal", dice.uniform(-0.8, 0.8), dice.uniform(-0.8, 0.8)), START_S)
        time.sleep(dice.uniform(0.0, 6.0))
        os.kill(session.pid_of(victim), signal.SIGKILL)
        problem = ask(observer, ("wait_still",), STILL_S)
        observer.kill()
        observer.wait()
        return problem or session.end()
    finally:
        observer.kill()
        observer.wait()
        session.clean_up()


def disturb_learner(folder, dice):
    """What was wrong, or ""."""
    file = folder / f"{uuid.uuid4()}.db"
    arguments = [f"repertoire_file:={file}", "exit_when_done:=true", "resume:=true"]
    session = Session("learn.launch", *arguments, "evaluations:=1000000")
    try:
        learner = session.pid_of("learner")
        time.sleep(dice.uniform(0.5, 6.0))
        os.kill(learner, signal.SIGKILL)
        session.launch.wait(timeout=END_S)
        problem = session.end()
        if problem:
            return problem
        if session.launch.returncode == 0:
            return "a killed learner was told as a success"
    finally:
        session.clean_up()
    again = Session("learn.launch", *arguments, "time_budget_s:=1.0", "evaluations:=1000000")
    try:
        code = again.launch.wait(timeout=2 * START_S)
        return "" if code == 0 else f"resumed, it ended with {code}\n{again.words()}"
    finally:
        again.clean_up()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--short", action="store_true", help="under a minute")
    parser.add_argument("--trials", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    victims = VICTIMS[:1] if arguments.short else VICTIMS
    trials = 1 if arguments.short else arguments.trials
    dice = random.Random(arguments.seed)
    counts = collections.Counter()
    wrong = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        repertoire = folder / "walk.db"
        subprocess.run([programs.path("evolve"), "--file", str(repertoire), "--evaluations",
                        "4000", "--resimulate", "false", "--verify_with_ode", "false"], check=True,
                       stdout=subprocess.DEVNULL)
        for trial in range(trials):
            victim = victims[trial % len(victims)]
            problem = (disturb_learner(folder, dice) if victim == "learner"
                       else disturb_walk(victim, repertoire, dice))
            counts[victim, bool(problem)] += 1
            print(f"{trial + 1} of {trials}: {victim}: {problem or 'good'}", file=sys.stderr)
            if problem:
                wrong.append(f"trial {trial}, {victim}: {problem}")
    print(f"{trials} kills at random moments, seed {arguments.seed}. Each session's first goal is "
          "the test of what the one before left behind.\n")
    print("| killed | times | joints at rest, nothing left, first goal reached | otherwise |")
    print("|---|---|---|---|")
    for victim in victims:
        good, bad = counts[victim, False], counts[victim, True]
        print(f"| {victim} | {good + bad} | {good} | {bad} |")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
