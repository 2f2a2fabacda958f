"""Measures what believing costs a walking robot: from the end of a behaviour to the next command."""
import argparse
import math
import multiprocessing
import pathlib
import statistics
import sys
import threading

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "nodes"))
import walking_session as ws  # noqa: E402

ARRIVAL_S = 240.0
TRIES = 3
# What believing may cost beside planning that believes nothing [s].
MOST_S = 0.5


class Pauses:
    """Seconds, real time, from the end of a behaviour to the next one's start, within walks."""

    def __init__(self):
        import rospy
        from hexapod_repertoire.msg import ExecutorState
        self._walking = ExecutorState.WALKING
        self._lock = threading.Lock()
        self._was_walking, self._ended_s, self.pauses_s = False, None, []
        self._subscriber = rospy.Subscriber("executor/state", ExecutorState, self._take,
                                            queue_size=1000, tcp_nodelay=True)

    def _take(self, message):
        stamp_s = message.header.stamp.to_sec()
        is_walking = message.state == self._walking
        with self._lock:
            if self._was_walking and not is_walking:
                self._ended_s = stamp_s
            if is_walking:
                if self._ended_s is not None:
                    self.pauses_s.append(stamp_s - self._ended_s)
                self._ended_s = None
            self._was_walking = is_walking

    def rest(self):
        """The walk is over: what comes next is no pause."""
        with self._lock:
            self._ended_s = None


def answer_to(goal, client):
    """The planner's answer. Where a busy machine let the executor miss its feedback, it is armed, and
    the goal is sent again, as a person would."""
    from hexapod_repertoire.srv import GoToResponse
    for _ in range(TRIES):
        asked = client.walk_to(goal)
        answer = ws.wait_for(lambda: asked.answers, ARRIVAL_S, "the end of a walk")[0]
        if answer.code not in (GoToResponse.EXECUTOR_FAULT, GoToResponse.EXECUTOR_NOT_READY):
            break
        print(answer.message, file=sys.stderr)
        client.wait_ready()
    return answer


def walk(adaptation, body, goals):
    """The pauses of walks to and fro, and how many goals were reached."""
    from walking_client import WalkingClient, goal_message
    from hexapod_repertoire.srv import Disturb, DisturbRequest, GoToResponse
    import rospy
    with ws.WalkingSession(nodes=()) as session:
        session.set_param("/planner/adaptation", adaptation)
        for node in ws.NODES:
            session.start(node)
        client = WalkingClient()
        client.wait_ready()
        pauses = Pauses()
        if body == "a leg lifted":
            request = DisturbRequest(legs=["left_middle"], states=[DisturbRequest.LIFTED])
            rospy.ServiceProxy("simulated_robot/disturb", Disturb)(request)
        reached = 0
        for number in range(goals):
            angle = 2.0 * math.pi * number / 5.0
            answer = answer_to(goal_message(math.cos(angle), math.sin(angle), 0.0), client)
            reached += answer.code == GoToResponse.SUCCEEDED
            pauses.rest()
    return pauses.pauses_s, reached


def main():
    """Returns 0 when believing costs no more than it may."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--short", action="store_true", help="a minute instead of many")
    parser.add_argument("--goals", type=int, default=20, help="of each walk")
    arguments = parser.parse_args()
    print("A simulated robot in real time; walks to points on a circle of 1 m, any heading. Without "
          "believing a robot with\na leg lifted does not arrive. The pause is from the end of a "
          "behaviour to the start of the next one: the pose comes\nto rest, is read, the body "
          "believed, the rest of the walk planned.\n")
    print("| body | adaptation | goals reached | pauses | median [s] | p95 [s] | longest [s] |\n"
          "|---|---|---|---|---|---|---|", flush=True)
    rows = [("intact", "none"), ("intact", "self_model"), ("a leg lifted", "self_model")]
    medians, missed = {}, 0
    for body, adaptation in rows[::2] if arguments.short else rows:
        goals = 2 if arguments.short else arguments.goals
        # rospy belongs to one master per process.
        with multiprocessing.get_context("spawn").Pool(1) as pool:
            pauses_s, reached = pool.apply(walk, (adaptation, body, goals))
        pauses_s.sort()
        missed += goals - reached
        medians[body, adaptation] = statistics.median(pauses_s)
        print(f"| {body} | {adaptation} | {reached} of {goals} | {len(pauses_s)} | "
              f"{medians[body, adaptation]:.2f} | {pauses_s[int(0.95 * (len(pauses_s) - 1))]:.2f} | "
              f"{pauses_s[-1]:.2f} |", flush=True)
    cost_s = max(medians.values()) - medians["intact", "none"]
    print(f"\nBelieving costs {cost_s:.2f} s in the median at most; {MOST_S:g} s are allowed.")
    # On a machine that does other things at the same time only the goals count.
    return 0 if missed == 0 and (arguments.short or cost_s <= MOST_S) else 1


if __name__ == "__main__":
    sys.exit(main())
