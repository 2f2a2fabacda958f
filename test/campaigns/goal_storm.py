"""Sends goals, cancels and preemptions through all the planner's doors at once, at random times."""
import argparse
import os
import pathlib
import random
import statistics
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "nodes"))
import walking_session as ws  # noqa: E402

SEED = 7
MEAN_PAUSE_S = 0.12  # between two events; a behaviour takes a second at four times real time
LULL_S, LULLS = 3.0, 0.02  # now and then a walk comes to its end
FACTOR = 4.0
ANSWER_TIMEOUT_S = 120.0
# Odometry is this old, at most, when an answer comes: a robot under way moves 0.2 m/s, times FACTOR.
POSE_AGE_M = 0.05
MEMORY_KIB = 8192


def random_target(random_numbers, client):
    """Near, far, or too far: what is planned at once, at length, or refused."""
    from walking_client import goal_message
    x, y, _ = client.pose()
    size_m = random_numbers.choice((0.3, 0.3, 1.0, 1.0, 12.0, 100.0))
    return goal_message(x + random_numbers.uniform(-size_m, size_m),
                        y + random_numbers.uniform(-size_m, size_m),
                        random_numbers.uniform(-3.1, 3.1))


class Storm:
    """One campaign; events are drawn from one seed, their times are the machine's."""

    def __init__(self, session, client):
        self.session, self.client = session, client
        self.random = random.Random(SEED)
        self.counts = {}
        self.cancel_calls_s = []
        self.memory_kib = []

    def event(self):
        """One goal or cancel through a door."""
        client, draw = self.client, self.random.random()
        if draw < 0.35:
            self.count("walk_to")
            client.walk_to(random_target(self.random, client),
                           plan_only=self.random.random() < 0.15)
        elif draw < 0.55:
            if sum(thread.is_alive() for thread in client.threads) > 12:
                return  # no more callers than the service has threads
            self.count("go_to")
            client.go_to(random_target(self.random, client), wait=self.random.random() < 0.7)
        elif draw < 0.70:
            self.count("move_base_simple/goal")
            client.simple_goal(random_target(self.random, client))
        elif draw < 0.92:
            open_actions = [a for a in client.asked if a.door == "walk_to" and not a.answers
                            and a.cancelled_s is None]
            if open_actions:
                self.count("cancel of one goal")
                client.cancel(self.random.choice(open_actions[-5:]))
        elif draw < 0.96:
            self.count("~cancel")
            _, took_s = client.cancel_everything()
            self.cancel_calls_s.append(took_s)
        else:
            self.count("cancel of all goals of the action")
            client.cancel_all_actions()

    def count(self, what):
        self.counts[what] = self.counts.get(what, 0) + 1

    def run(self, events):
        """Lets so many events happen, then waits for the answers."""
        sent = 0
        while sent < events:
            self.client.arm_after_a_fault()  # of a machine that is too busy
            self.event()
            sent = sum(self.counts.values())
            lull = self.random.random() < LULLS
            time.sleep(LULL_S if lull else self.random.expovariate(1.0 / MEAN_PAUSE_S))
            if sent % max(1, events // 20) == 0:
                self.memory_kib.append(self.session.resident_kib("planner"))
        self.client.cancel_everything()
        ws.wait_for(lambda: all(asked.answers for asked in self.client.asked), ANSWER_TIMEOUT_S,
                    "answers to %d goals" % sum(not a.answers for a in self.client.asked))
        time.sleep(1.0)  # a second answer would come by now

    def problems(self):
        """What was promised and did not hold, a line each."""
        from hexapod_repertoire.srv import GoToResponse
        from walking_client import XY_TOLERANCE_M
        found = []
        for asked in self.client.asked:
            if len(asked.answers) != 1:
                found.append(f"a goal of {asked.door} has {len(asked.answers)} answers")
            answer = asked.answers[0]
            if answer.code > GoToResponse.SHUTDOWN:
                found.append(f"{asked.door}: code {answer.code}: {answer.message}")
            arrived = (answer.code == GoToResponse.SUCCEEDED and answer.final_pose.header.frame_id)
            if arrived and asked.error()[0] > XY_TOLERANCE_M + POSE_AGE_M:
                found.append(f"{asked.door}: SUCCEEDED {asked.error()[0]:.3f} m from the goal")
        growth_kib = self.memory_kib[-1] - self.memory_kib[len(self.memory_kib) // 4]
        if growth_kib > MEMORY_KIB:
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
        waits = sorted(a.answered_s - a.cancelled_s for a in self.client.asked
                       if a.cancelled_s is not None and a.door == "walk_to")
        lines = [f"Seed {SEED}, simulated robot at {FACTOR:g} times real time.", "",
                 "| event | times |", "|---|---|"]
        lines += [f"| {what} | {count} |" for what, count in sorted(self.counts.items())]
        lines += ["", "| answer of walk_to and go_to | times |", "|---|---|"]
        lines += [f"| {name} | {count} |" for name, count in sorted(answers.items())]
        lines += ["", "| measured | |", "|---|---|",
                  f"| goals answered, each once | {len(self.client.asked)} |"]
        if waits:
            lines += [f"| cancel of a goal of walk_to until its answer: median, largest of "
                      f"{len(waits)} | {1e3 * statistics.median(waits):.0f} ms, "
                      f"{1e3 * waits[-1]:.0f} ms |"]
        if self.cancel_calls_s:
            lines += [f"| call of ~cancel: median, largest of {len(self.cancel_calls_s)} | "
                      f"{1e3 * statistics.median(self.cancel_calls_s):.0f} ms, "
                      f"{1e3 * max(self.cancel_calls_s):.0f} ms |"]
        lines += [f"| planner's resident memory after a quarter of the events, at the end | "
                  f"{self.memory_kib[len(self.memory_kib) // 4] / 1024:.1f} MiB, "
                  f"{self.memory_kib[-1] / 1024:.1f} MiB |",
                  f"| load of the machine | {os.getloadavg()[0]:.1f} |"]
        return "\n".join(lines)


def main():
    """Returns 0 when every promise held."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--short", action="store_true", help="seconds instead of minutes")
    parser.add_argument("--events", type=int, default=2000, help="goals and cancels to send")
    arguments = parser.parse_args()
    with ws.WalkingSession(real_time_factor=FACTOR, sim_time=True) as session:
        from walking_client import WalkingClient
        client = WalkingClient()
        client.wait_ready()
        storm = Storm(session, client)
        storm.run(80 if arguments.short else arguments.events)
        print(storm.report())
        problems = storm.problems()
        if problems:
            print("\n" + "\n".join(problems) + "\n\n" + session.log("planner")[-5000:])
        return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
