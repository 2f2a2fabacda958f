"""Sends goals, cancels and crowds of make_plan calls while a large map comes once a second."""
import argparse
import os
import pathlib
import random
import statistics
import sys
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "nodes"))
import walking_session as ws  # noqa: E402
from support import large_map  # noqa: E402

SEED = 11
FACTOR = 2.0
GOAL_PERIOD_S = 0.1
CROWD, CROWD_PERIOD_S = 50, 15.0
ANSWER_TIMEOUT_S = 120.0
NO_ANSWER = 255  # the client's word for a call that failed
CANCELLED_S = 0.2
CANCELLED_SHORT_S = 1.5  # among other tests on a busy machine
# One map and its distances more than during the first half of the storm.
GROWTH_KIB = 96 * 1024


class Crowd:
    """So many callers of make_plan at once, now and then."""

    def __init__(self, random_numbers, client):
        self.random, self.client = random_numbers, client
        self.threads, self.took_s, self.failed, self.called = [], [], [], 0

    def call(self):
        """Starts a crowd unless the one before is still waiting."""
        if any(thread.is_alive() for thread in self.threads):
            return
        self.threads = [
            threading.Thread(target=self._ask, args=(self._target(),)) for _ in range(CROWD)]
        self.called += CROWD
        for thread in self.threads:
            thread.start()

    def _target(self):
        x, y, _ = self.client.pose()
        return (x + self.random.uniform(-15.0, 15.0), y + self.random.uniform(-15.0, 15.0),
                self.random.uniform(-3.1, 3.1))

    def _ask(self, target):
        import rospy
        from nav_msgs.srv import GetPlan, GetPlanRequest
        from walking_client import goal_message
        begin = time.monotonic()
        try:
            rospy.ServiceProxy("make_plan", GetPlan)(
                GetPlanRequest(goal=goal_message(*target), tolerance=0.1))
            self.took_s.append(time.monotonic() - begin)
        except rospy.ServiceException as error:
            self.failed.append(str(error))

    def join(self):
        for thread in self.threads:
            thread.join(ANSWER_TIMEOUT_S)


class Storm:
    """One campaign; events are drawn from one seed, their times are the machine's."""

    def __init__(self, session, client, maps):
        self.session, self.client, self.maps = session, client, maps
        self.random = random.Random(SEED)
        self.crowd = Crowd(random.Random(SEED + 1), client)
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
            return goal_message(*self.maps.position(self.maps.recent[-1]), 0.0)
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
        """Goals at their rate for so long, then waits for the answers."""
        begin = time.monotonic()
        due, crowd_due, memory_due = begin, begin + 3.0, begin
        while time.monotonic() < begin + duration_s:
            self.client.arm_after_a_fault()  # of a machine that is too busy
            self.send()
            due += GOAL_PERIOD_S
            while time.monotonic() < due:
                self.cancel_those_due()
                time.sleep(0.005)
            if due > crowd_due:
                self.crowd.call()
                crowd_due += CROWD_PERIOD_S
            if due > memory_due:
                self.memory_kib.append(self.session.resident_kib("planner"))
                memory_due += 1.0
        self.crowd.join()
        self.client.cancel_everything()
        ws.wait_for(lambda: all(asked.answers for asked in self.client.asked), ANSWER_TIMEOUT_S,
                    "answers to %d goals" % sum(not a.answers for a in self.client.asked))
        time.sleep(1.0)  # a second answer would come by now

    def latest_map_is_in_use(self):
        """Whether a goal in the box that came last is refused for it."""
        from hexapod_repertoire.srv import GoToResponse
        from walking_client import goal_message
        target = goal_message(*self.maps.position(self.maps.recent[-1]), 0.0)
        asked = self.client.walk_to(target, plan_only=True)
        ws.wait_for(lambda: asked.answers, ANSWER_TIMEOUT_S, "an answer")
        return asked.answers[0].code == GoToResponse.GOAL_OCCUPIED

    def waits_s(self):
        """From a cancel of a goal of walk_to to its answer."""
        return sorted(a.answered_s - a.cancelled_s for a in self.client.asked
                      if a.cancelled_s is not None and a.door == "walk_to")

    def problems(self, cancelled_s):
        """What was promised and did not hold, a line each."""
        from hexapod_repertoire.srv import GoToResponse
        found = []
        for asked in self.client.asked:
            if len(asked.answers) != 1:
                found.append(f"a goal of {asked.door} has {len(asked.answers)} answers")
            if asked.answers[0].code in (GoToResponse.INTERNAL_ERROR, NO_ANSWER):
                found.append(f"{asked.door}: {asked.answers[0].message}")
        found += self.crowd.failed
        if len(self.crowd.took_s) + len(self.crowd.failed) != self.crowd.called:
            found.append("calls of make_plan without an answer")
        late = [wait for wait in self.waits_s() + self.cancel_calls_s if wait > cancelled_s]
        if late:
            found.append(f"{len(late)} cancels took up to {max(late):.3f} s")
        half = len(self.memory_kib) // 2
        growth_kib = max(self.memory_kib[half:]) - max(self.memory_kib[:half])
        if growth_kib > GROWTH_KIB:
            found.append(f"the planner's memory grew by {growth_kib} KiB")
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
                 f"{CROWD} calls of make_plan at once every {CROWD_PERIOD_S:g} s.", "",
                 "| event | times |", "|---|---|"]
        lines += [f"| {what} | {count} |" for what, count in sorted(self.counts.items())]
        lines += [f"| map | {self.maps.sent} |", f"| make_plan | {self.crowd.called} |"]
        lines += ["", "| answer of walk_to and go_to | times |", "|---|---|"]
        lines += [f"| {name} | {count} |" for name, count in sorted(answers.items())]
        lines += ["", "| measured | |", "|---|---|",
                  f"| goals answered, each once | {len(self.client.asked)} |",
                  f"| calls of make_plan answered | {len(self.crowd.took_s)} |"]
        for what, times_s in (("cancel of a goal of walk_to until its answer", self.waits_s()),
                              ("call of ~cancel", self.cancel_calls_s),
                              ("call of make_plan in the crowd", self.crowd.took_s)):
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
        with large_map.MapStream(random.Random(SEED + 2), client.pose()) as maps:
            storm = Storm(session, client, maps)
            storm.run(12.0 if arguments.short else arguments.seconds)
        ws.wait_for(storm.latest_map_is_in_use, 20.0, "the last map to be in use")
        print(storm.report())
        problems = storm.problems(CANCELLED_SHORT_S if arguments.short else CANCELLED_S)
        if problems:
            print("\n" + "\n".join(problems) + "\n\n" + session.log("planner")[-5000:])
        return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
