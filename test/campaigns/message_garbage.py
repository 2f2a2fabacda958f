"""Sends garbage to every topic and service of a walking session; afterwards it walks as before.

All that the nodes listen to is asked of the master. Messages of the right type have senseless
content; connections break the rules of TCPROS. Now and then an operator puts the session in order
and sends the robot somewhere, so that it is hit while it walks.
"""
import argparse
import collections
import os
import pathlib
import random
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "nodes"))
import walking_session as ws  # noqa: E402

SEED = 1
NODES = ws.NODES
PAUSE_S = 0.004  # between two messages
MEMORY_KIB = 12288  # the stack of a thread, which the executor locks, and a half
MEMORY_TURNS = 8  # before so many turns a node still meets some messages for the first time
# What a node frees it gives back, so that its resident memory is what it uses.
os.environ.update(MALLOC_ARENA_MAX="1", MALLOC_TRIM_THRESHOLD_="131072",
                  MALLOC_MMAP_THRESHOLD_="131072")
CONNECTIONS = 40  # a broken connection for so many messages
ORDERS, SHORTEST_TURN = 40, 200  # times that the session is put in order, messages in between
# What stops the robot whatever it says comes towards the end of each time.
STOPS = {"/e_stop", "/simulated_robot/pause"}
STOPS_FROM = 0.8


class Flood:
    """One campaign; what is sent is drawn from one seed, when it arrives is the machine's."""

    def __init__(self, session, listeners, operator, samples):
        from support import broken_wire, garbage
        self.session, self.listeners, self.operator = session, listeners, operator
        self.dice = random.Random(SEED)
        self.garbage = garbage.Garbage(SEED, samples)
        self.faults = broken_wire.Faults(self.dice)
        self.counts = collections.Counter()
        self.memory_kib = collections.defaultdict(list)
        self.silence = ""

    def send(self, stops):
        """A message to a topic, or a call of a service; one that may stop the robot or not."""
        while True:
            name = self.dice.choice(self.listeners.names)
            if name in self.listeners.wordless or (name in STOPS and not stops):
                continue
            if name in self.listeners.topics:
                self.listeners.publish(name, self.garbage.message(self.listeners.types[name]))
                self.counts["messages"] += 1
                return
            request = self.garbage.request(self.listeners.request_class(name))
            if self.listeners.call(name, request):
                self.counts["calls"] += 1
                return

    def break_connection(self, publisher):
        name = self.dice.choice(self.listeners.names)
        if name not in self.listeners.topics:
            self.listeners.call_broken(name, self.faults)
        elif not publisher.publish(name, self.listeners.types[name]):
            self.counts["topics nobody came to"] += 1

    def run(self, count):
        """Sends so many messages, and breaks connections; until one of the nodes is gone."""
        from support import broken_wire
        with broken_wire.BrokenPublisher(
                self.session.uri, self.faults,
                lambda topic: self.garbage.plausible(self.listeners.types[topic])) as publisher:
            turn = max(SHORTEST_TURN, count // ORDERS)
            for number in range(count):
                if number % turn == 0 and not self.look_after_it():
                    return
                if number % CONNECTIONS == 0:
                    self.break_connection(publisher)
                self.send(number % turn > STOPS_FROM * turn)
                time.sleep(PAUSE_S)

    def gone(self):
        """The nodes that have ended, with their exit codes."""
        return {node: self.session.process(node).poll() for node in NODES
                if not self.session.is_running(node)}

    def look_after_it(self):
        """Puts the session in order and sends the robot somewhere; False when it does not answer."""
        import rospy
        try:
            self.operator.put_in_order(self.listeners)
        except (rospy.ServiceException, AssertionError) as error:
            self.silence = str(error)
            return False
        for node in NODES:
            self.memory_kib[node].append(self.session.resident_kib(node))
        return True

    def problems(self, set_points):
        """What was promised and did not hold, a line each."""
        if self.silence or self.gone():
            return [self.silence] + [f"the {node} ended with {code}"
                                     for node, code in self.gone().items()]
        found = [f"set-point outside the limits: {text}" for text in set_points.outside[:5]]
        for node, kib in self.memory_kib.items():
            growth_kib = kib[-1] - kib[len(kib) // 4]
            if len(kib) >= MEMORY_TURNS and growth_kib > MEMORY_KIB:
                found.append(f"the memory of the {node} grew by {growth_kib} KiB")
        self.look_after_it()
        self.listeners.disconnect()
        problem = self.silence or self.operator.walk()
        return found + ([f"a real goal: {problem}"] if problem else [])

    def report(self, set_points):
        """The campaign as Markdown."""
        lines = [f"Seed {SEED}; {len(self.listeners.topics)} topics and "
                 f"{len(self.listeners.places)} services.", "", "| sent | times |", "|---|---|"]
        lines += [f"| {what} | {count} |" for what, count in sorted(self.counts.items())]
        lines += [f"| connection with fault: {what} | {count} |"
                  for what, count in sorted(self.faults.counts.items())]
        lines += ["", f"{set_points.count} set-points of the executor, {set_points.walking} of them while "
                  f"walking, {len(set_points.outside)} outside the joints' limits.", "",
                  "| node | memory after a quarter | at the end |", "|---|---|---|"]
        lines += [f"| {node} | {kib[len(kib) // 4] / 1024:.1f} MiB | {kib[-1] / 1024:.1f} MiB |"
                  for node, kib in sorted(self.memory_kib.items())]
        return "\n".join(lines)


def flooded(session, count):
    """The campaign, and its set-points."""
    from support.listeners import Listeners
    from support.operator_of_walks import Operator, SetPoints
    from walking_client import WalkingClient
    client = WalkingClient()
    client.wait_ready()
    set_points = SetPoints(client)
    operator = Operator(client, random.Random(SEED))
    listeners = Listeners(session.uri, NODES)
    samples = listeners.samples(operator.walk)
    listeners.connect()
    flood = Flood(session, listeners, operator, samples)
    flood.run(count)
    return flood, set_points


def main():
    """Returns 0 when every promise held."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--short", action="store_true", help="seconds instead of minutes")
    parser.add_argument("--messages", type=int, default=20000, help="messages to send")
    arguments = parser.parse_args()
    with ws.WalkingSession() as session:
        flood, set_points = flooded(session, 400 if arguments.short else arguments.messages)
        problems = flood.problems(set_points)
        print(flood.report(set_points))
        if problems:
            print("\n" + "\n".join(problems))
            for node in NODES:
                print(f"\n{node}:\n{session.log(node)[-3000:]}")
        return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
