"""Sends goals, cancels and crowds of make_plan calls while a large map comes once a second."""
import argparse
import json
import os
import pathlib
import random
import statistics
import subprocess
import sys
import threading
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "nodes"))
import walking_session as ws  # noqa: E402
from support import large_map, plan_crowd  # noqa: E402

SEED = 11
FACTOR = 2.0
GOAL_PERIOD_S = 0.1
ANSWER_TIMEOUT_S = 120.0
NO_ANSWER = 255  # the client's word for a call that failed
CANCELLED_S = 0.2
# At any time, and above what was in use during the first half of the storm: another map and its
# distances.
MEMORY_KIB, GROWTH_KIB = 1024 * 1024, 96 * 1024


class Partner:
    """A program of support/ that goes on until it is left, and the values it printed, a line of
    JSON each."""

    def __init__(self, name, *arguments):
        self._command = [sys.executable, str(HERE / "support" / name), *map(str, arguments)]
        self.values = []

    def __enter__(self):
        # pylint: disable=consider-using-with
        self._process = subprocess.Popen(self._command, stdin=subprocess.PIPE,
                                         stdout=subprocess.PIPE, universal_newlines=True)
        self._thread = threading.Thread(target=self._read)
        self._thread.start()
        return self

    def _read(self):
        for line in self._process.stdout:
            self.values.append(json.loads(line))

    def finish(self):
        """Lets it begin nothing more, but stay."""
        self._process.stdin.write("\n")
        self._process.stdin.flush()

    def leave(self):
        """Ends it; it may still have to wait for something."""
        self._process.stdin.close()
        self._thread.join()
        self._process.wait()

    def __exit__(self, *_):
        if self._process.poll() is None:
            self.leave()


class Storm:
    """One campaign; events are drawn from one seed, their times are the machine's."""

    def __init__(self, session, client, maps, home):
        self.session, self.client, self.maps, self.home = session, client, maps, home
        self.random = random.Random(SEED)
        self.crowd = {"called": 0, "took_s": [], "failed": []}
        self.counts = {}
        self.cancel_calls_s = []
        self.memory_kib = []
        self._to_cancel = []  # (when, goal)

    def count(self, what):
        self.counts[what] = self.counts.get(what, 0) + 1

    def target(self):
        """Near, far, in an obstacle, or too far."""
        from walking_client import goal_message
        kind = self.random.random()
        if kind < 0.1:
            return goal_message(*self.maps.values[-1], 0.0)
        x, y, _ = self.client.pose()
        size_m = self.random.choice((0.3, 1.0, 3.0, 12.0, 12.0, 100.0))
        return goal_message(x + self.random.uniform(-size_m, size_m),
                            y + self.random.uniform(-size_m, size_m),
                            self.random.uniform(-3.1, 3.1))

    def send(self):
        """One goal through a door, perhaps with a cancel to follow."""
        draw = self.random.random()
        if draw < 0.7:
            self.count("walk_to")
            asked = self.client.walk_to(self.target(), plan_only=self.random.random() < 0.1)
            if self.random.random() < 0.4:
                self._to_cancel.append((time.monotonic() + self.random.uniform(0.0, 0.3), asked))
        elif draw < 0.85:
            self.count("go_to")
            self.client.go_to(self.target(), wait=False)
        else:
            self.count("move_base_simple/goal")
            self.client.simple_goal(self.target())
        if self.random.random() < 0.02:
            self.count("~cancel")
            self.cancel_calls_s.append(self.client.cancel_everything()[1])

    def cancel_those_due(self):
        now = time.monotonic()
        # The client of the action looks at every goal whose handle is kept, at each status.
        for asked in self.client.asked[-100:]:
            if asked.answers:
                asked.handle = None
        for when, asked in [due for due in self._to_cancel if due[0] <= now]:
            self._to_cancel.remove((when, asked))
            if not asked.answers and asked.cancelled_s is None:
                self.count("cancel of one goal")
                self.client.cancel(asked)

    def run(self, duration_s):
        """Goals at their rate for so long beside the crowd, then waits for the answers."""
        with Partner("plan_crowd.py", SEED + 1) as crowd:
            self.send_for(duration_s)
            crowd.leave()
            self.crowd = crowd.values[-1]
        self.client.cancel_everything()
        ws.wait_for(lambda: all(asked.answers for asked in self.client.asked), ANSWER_TIMEOUT_S,
                    "answers to %d goals" % sum(not a.answers for a in self.client.asked))
        time.sleep(1.0)  # a second answer would come by now

    def send_for(self, duration_s):
        begin = time.monotonic()
        due, memory_due = begin, begin
        while time.monotonic() < begin + duration_s:
            self.client.arm_after_a_fault()  # of a machine that is too busy
            self.send()
            due += GOAL_PERIOD_S
            while time.monotonic() < due:
                self.cancel_those_due()
                time.sleep(0.005)
            if due > memory_due:
                self.memory_kib.append(self.session.resident_kib("planner"))
                memory_due += 1.0

    def latest_map_is_in_use(self):
        """Whether plans from where the storm began, which maps leave free, lead to a place nearby but
        not into the box that came last. The storm may have left the robot itself in a box."""
        x, y, yaw = self.home
        return self.is_planned_to(x + 0.5, y, yaw) and not self.is_planned_to(*self.maps.values[-1], 0.0)

    def is_planned_to(self, *goal):
        import rospy
        from nav_msgs.srv import GetPlan
        from walking_client import goal_message
        return bool(rospy.ServiceProxy("make_plan", GetPlan)(
            start=goal_message(*self.home), goal=goal_message(*goal), tolerance=0.1).plan.poses)

    def waits_s(self):
        """From a cancel of a goal of walk_to to its answer."""
        return sorted(a.answered_s - a.cancelled_s for a in self.client.asked
                      if a.cancelled_s is not None and a.door == "walk_to")

    def problems(self, is_short):
        """What was promised and did not hold, a line each. The short form, among other tests on a
        busy machine, measures neither times nor growth."""
        from hexapod_repertoire.srv import GoToResponse
        found = []
        for asked in self.client.asked:
            if len(asked.answers) != 1:
                found.append(f"a goal of {asked.door} has {len(asked.answers)} answers")
            if asked.answers[0].code in (GoToResponse.INTERNAL_ERROR, NO_ANSWER):
                found.append(f"{asked.door}: {asked.answers[0].message}")
        found += self.crowd["failed"]
        if len(self.crowd["took_s"]) != self.crowd["called"]:
            found.append("calls of make_plan without an answer")
        late = [wait for wait in self.waits_s() + self.cancel_calls_s if wait > CANCELLED_S]
        if late and not is_short:
            found.append(f"{len(late)} cancels took up to {max(late):.3f} s")
        half = len(self.memory_kib) // 2
        growth_kib = max(self.memory_kib[half:]) - max(self.memory_kib[:half])
        if growth_kib > GROWTH_KIB and not is_short:
            found.append(f"the planner's memory grew by {growth_kib} KiB")
        if max(self.memory_kib) > MEMORY_KIB:
            found.append(f"the planner had {max(self.memory_kib)} KiB of memory")
        if not self.session.is_running("planner"):
            found.append("the planner is gone")
        return found

    def report(self):
        """The campaign as Markdown."""
        from hexapod_repertoire.srv import GoToResponse
        names = {value: name for name, value in vars(GoToResponse).items()
                 if name.isupper() and isinstance(value, int)}
        answers = {}
        for asked in self.client.asked:
            name = names.get(asked.answers[0].code, asked.answers[0].code)
            answers[name] = answers.get(name, 0) + 1
        lines = [f"Seed {SEED}, simulated robot at {FACTOR:g} times real time; a goal every "
                 f"{GOAL_PERIOD_S:g} s, a map of {large_map.SIDE} x {large_map.SIDE} cells every "
                 f"{large_map.PERIOD_S:g} s, "
                 f"{plan_crowd.CROWD} calls of make_plan at once every {plan_crowd.PERIOD_S:g} s "
                 "or as soon as those before are answered.", "",
                 "| event | times |", "|---|---|"]
        lines += [f"| {what} | {count} |" for what, count in sorted(self.counts.items())]
        lines += [f"| map | {len(self.maps.values)} |", f"| make_plan | {self.crowd['called']} |"]
        lines += ["", "| answer of walk_to and go_to | times |", "|---|---|"]
        lines += [f"| {name} | {count} |" for name, count in sorted(answers.items())]
        lines += ["", "| measured | |", "|---|---|",
                  f"| goals answered, each once | {len(self.client.asked)} |",
                  f"| calls of make_plan answered | {len(self.crowd['took_s'])} |"]
        for what, times_s in (("cancel of a goal of walk_to until its answer", self.waits_s()),
                              ("call of ~cancel", self.cancel_calls_s),
                              ("call of make_plan in the crowd", self.crowd["took_s"])):
            if times_s:
                lines.append(f"| {what}: median, largest of {len(times_s)} | "
                             f"{1e3 * statistics.median(times_s):.0f} ms, "
                             f"{1e3 * max(times_s):.0f} ms |")
        half = len(self.memory_kib) // 2
        lines += ["| planner's resident memory, largest in the first half and in the second | "
                  f"{max(self.memory_kib[:half]) / 1024:.0f} MiB, "
                  f"{max(self.memory_kib[half:]) / 1024:.0f} MiB |",
                  f"| load of the machine | {os.getloadavg()[0]:.1f} |"]
        return "\n".join(lines)


def main():
    """Returns 0 when every promise held."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--short", action="store_true", help="seconds instead of minutes")
    parser.add_argument("--seconds", type=float, default=600.0, help="how long the storm lasts")
    arguments = parser.parse_args()
    with ws.WalkingSession(real_time_factor=FACTOR, sim_time=True) as session:
        from walking_client import WalkingClient
        client = WalkingClient()
        client.wait_ready()
        home = client.pose()
        with Partner("large_map.py", *home[:2]) as maps:
            ws.wait_for(lambda: maps.values, 30.0, "the first map")
            storm = Storm(session, client, maps, home)
            storm.run(12.0 if arguments.short else arguments.seconds)
            maps.finish()
            ws.wait_for(storm.latest_map_is_in_use, 30.0, "the last map to be in use")
        print(storm.report())
        problems = storm.problems(arguments.short)
        if problems:
            print("\n" + "\n".join(problems) + "\n\n" + session.log("planner")[-5000:])
        return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
