"""Sets the wall clock, freezes /clock and lets it jump at random moments of walks."""
import argparse
import contextlib
import pathlib
import random
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "nodes"))
import walking_session as ws  # noqa: E402

SEED = 11
FACTOR = 4.0  # simulated time
ANSWER_TIMEOUT_S = 30.0
# Once time stands, all clients are to hear of it so soon; as a test, on a machine that is busy with
# others, later.
TOLD_S, TOLD_SHORT_S = 2.0, 4.0


class Disturbance:
    """What is done to the time of a session, and undone."""

    def __init__(self, name, session, client, random_numbers):
        self.name, self.session, self.client, self.random = name, session, client, random_numbers

    def begin(self):
        """Now."""
        import rospy
        from rosgraph_msgs.msg import Clock
        from std_srvs.srv import SetBool
        if self.name == "set":
            offset_s = self.random.choice((-3600, -40, 0, 40, 3600))
            self.session.set_clock(offset_s)
            ws.wait_for(lambda: abs(self.client.clock_offset_s - offset_s) < 10.0, 10.0,
                        "the executor's clock to be set")
        elif self.name == "frozen":
            rospy.ServiceProxy("simulated_robot/pause", SetBool)(True)
        else:
            jump = rospy.Time.from_sec(time.time() + self.random.choice((-3600, -30, 30, 3600)))
            publisher = rospy.Publisher("/clock", Clock, queue_size=1)
            ws.wait_for(lambda: publisher.get_num_connections() >= 3, 10.0, "who reads /clock")
            publisher.publish(Clock(jump))

    def end(self):
        """Time goes on as it should."""
        import rospy
        from std_srvs.srv import SetBool
        if self.name == "frozen":
            rospy.ServiceProxy("simulated_robot/pause", SetBool)(False)


def make_ready(client):
    """Arms again where a disturbance made the executor stop."""
    from hexapod_repertoire.msg import ExecutorState
    unarmed = (ExecutorState.DISARMED, ExecutorState.STOPPED, ExecutorState.FAULT)

    def ready():
        if client.state in unarmed:
            client.call("executor/arm")
        return client.state == ExecutorState.READY

    ws.wait_for(ready, 30.0, "the executor to be READY")


def one_run(disturbance, client, random_numbers):
    """(codes, seconds from the disturbance to the last answer) of a walk that is disturbed."""
    from walking_client import goal_message
    client.asked.clear()
    x, y, _ = client.pose()
    target = goal_message(x + random_numbers.choice((-0.4, 0.4)),
                          y + random_numbers.uniform(-0.2, 0.2), 0.0)
    client.walk_to(target)
    time.sleep(random_numbers.uniform(0.0, 4.5 if disturbance.name == "set" else 1.5))
    client.go_to(target, wait=True)
    disturbance.begin()
    begin = time.monotonic()
    ws.wait_for(lambda: all(asked.answers for asked in client.asked), ANSWER_TIMEOUT_S,
                "the answers to disturbed goals")
    disturbance.end()
    answered = max(asked.answered_s for asked in client.asked)
    return [asked.answers[0].code for asked in client.asked], max(0.0, answered - begin)


def campaign(name, runs, told_s):
    """The rows of the report for one disturbance, and the problems."""
    from walking_client import WalkingClient
    from hexapod_repertoire.srv import GoToResponse
    random_numbers = random.Random(SEED)
    names = {value: key for key, value in vars(GoToResponse).items()
             if key.isupper() and isinstance(value, int)}
    counts, problems, longest_s, after = {}, [], 0.0, 0
    with contextlib.ExitStack() as stack:
        session = stack.enter_context(ws.WalkingSession(
            real_time_factor=1.0 if name == "set" else FACTOR, sim_time=name != "set",
            settable_clock=name == "set"))
        client = WalkingClient()
        client.wait_ready()
        disturbance = Disturbance(name, session, client, random_numbers)
        for run in range(runs):
            codes, took_s = one_run(disturbance, client, random_numbers)
            longest_s = max(longest_s, took_s)
            for code in codes:
                counts[names.get(code, code)] = counts.get(names.get(code, code), 0) + 1
                if name == "set" and code not in (GoToResponse.SUCCEEDED, GoToResponse.PREEMPTED):
                    problems.append(f"run {run}: a clock that was set ended a walk with "
                                    f"{names.get(code, code)}: "
                                    f"{[a.answers[0].message for a in client.asked]}")
            for asked in client.asked:
                answer = asked.answers[0]
                if (name == "jumps" and answer.code == GoToResponse.EXECUTOR_FAULT
                        and "ROS time jumped back" not in answer.message):
                    problems.append(f"run {run}: a jump ended a walk with: {answer.message}")
            if name == "frozen" and took_s > told_s:
                problems.append(f"run {run}: told {took_s:.1f} s after time stood still")
            make_ready(client)
            x, y, yaw = client.pose()
            from walking_client import goal_message
            here = client.walk_to(goal_message(x, y, yaw))
            ws.wait_for(lambda: here.answers, ANSWER_TIMEOUT_S, "the goal after the disturbance")
            if here.answers[0].code == GoToResponse.SUCCEEDED:
                after += 1
            else:
                problems.append(f"run {run}: the next goal failed: {here.answers[0].message}")
        if problems:
            print(*(session.log(node)[-4000:] for node in ws.NODES), file=sys.stderr)
        _, left_s = session.leave("planner")
    answers = ", ".join(f"{key} {value}" for key, value in sorted(counts.items()))
    return (f"| {name} | {runs} | {2 * runs} | {answers} | {longest_s:.1f} | {after} | "
            f"{left_s:.1f} |"), problems


def main():
    """Returns 0 when every client was answered as promised."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--short", action="store_true", help="seconds instead of minutes")
    parser.add_argument("--only", choices=("set", "frozen", "jumps"), help="one of the three")
    parser.add_argument("--runs", type=int, default=100, help="of each disturbance")
    arguments = parser.parse_args()
    names = [arguments.only] if arguments.only else ["set", "frozen", "jumps"]
    print(f"Seed {SEED}. The wall clock of all nodes is set by up to an hour, back or forth; "
          f"simulated time, at\n{FACTOR:g} times real time, stands still or jumps by 30 s or an "
          "hour and back. EXECUTOR_FAULT where it\njumps: the behaviour was broken off because "
          "ROS time jumped back, and says so.\n")
    print("| time is | runs | clients | their answers | longest wait after it [s] | "
          "next goals reached | planner left in [s] |\n|---|---|---|---|---|---|---|", flush=True)
    failed = False
    for name in names:
        # rospy belongs to one master per process.
        import multiprocessing
        with multiprocessing.get_context("spawn").Pool(1) as pool:
            how = (2, TOLD_SHORT_S) if arguments.short else (arguments.runs, TOLD_S)
            row, problems = pool.apply(campaign, (name, *how))
        print(row, flush=True)
        for problem in problems:
            print(problem, file=sys.stderr)
        failed = failed or bool(problems)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
