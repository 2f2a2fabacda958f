"""Looks at a robot's wires before it is armed: who listens, who tells, how often, and what of it."""
import collections
import math
import pathlib
import threading
import time
from typing import Any, Dict, Iterable, List, NamedTuple, Optional, Sequence, Tuple

OK, WARNING, PROBLEM = "ok", "look", "WRONG"
LOOK_S = 2.0
OLDEST_S = 0.5
FASTEST_TIMER_MS = 1


class Finding(NamedTuple):
    """A line of the report."""
    verdict: str
    subject: str
    text: str


class Reading(NamedTuple):
    """One joint_states message, and when it came."""
    heard_s: float
    age_s: float  # by its stamp; nan without one
    publisher: str
    names: Tuple[str, ...]
    positions: Tuple[float, ...]


def judge_joints(readings: Sequence[Reading], expected: Sequence[str], looked_s: float,
                 timeout_s: Optional[float]) -> List[Finding]:
    """What is to be said of joint_states for the joints that are expected on the wire.

    timeout_s: the executor's feedback_timeout_s, None where it has its default.
    """
    if timeout_s == 0.0:
        return [Finding(WARNING, "joint_states", "nobody looks at them (feedback_timeout_s: 0): no "
                        "joint that does not follow is noticed")]
    if not readings:
        return [Finding(PROBLEM, "joint_states", f"nothing came in {looked_s:.0f} s: start the "
                        "servo driver; a robot without feedback needs feedback_timeout_s: 0")]
    findings = []
    times: Dict[str, int] = collections.Counter()
    tellers: Dict[str, set] = collections.defaultdict(set)
    for reading in readings:
        times.update(set(reading.names))
        for name in reading.names:
            tellers[name].add(reading.publisher)
    missing = [name for name in expected if name not in times]
    if missing:
        strangers = sorted(set(times) - set(expected))
        text = "nobody tells " + ", ".join(missing)
        if strangers:
            text += "; told are also " + ", ".join(strangers) + ": does a joint_map name them?"
        findings.append(Finding(PROBLEM, "names", text))
    shared = [name for name in expected if len(tellers[name]) > 1]
    if shared:
        who = ", ".join(sorted(set().union(*(tellers[name] for name in shared))))
        findings.append(Finding(PROBLEM, "publishers",
                                f"{who} all tell {', '.join(shared)}: stop all but the driver"))
    rates = {name: times[name] / looked_s for name in expected if name in times}
    if rates:
        slowest = min(rates, key=lambda name: rates[name])
        is_slow = timeout_s is not None and rates[slowest] * timeout_s < 1.0
        findings.append(Finding(PROBLEM if is_slow else OK, "rate",
                                f"{rates[slowest]:.0f} Hz for {slowest}, the slowest" + (
                                    f": too seldom for feedback_timeout_s: {timeout_s}"
                                    if is_slow else "")))
    findings += judge_values(readings) + judge_ages(readings)
    return findings


def judge_values(readings: Sequence[Reading]) -> List[Finding]:
    """Positions that are missing or no numbers."""
    for reading in readings:
        if len(reading.names) != len(reading.positions):
            return [Finding(PROBLEM, "positions", f"{reading.publisher} tells {len(reading.names)} "
                            f"names and {len(reading.positions)} positions")]
        for name, position in zip(reading.names, reading.positions):
            if not math.isfinite(position):
                return [Finding(PROBLEM, "positions", f"{name} is at {position}")]
    return []


def judge_ages(readings: Sequence[Reading]) -> List[Finding]:
    """Stamps that are of another clock."""
    ages = sorted(reading.age_s for reading in readings if not math.isnan(reading.age_s))
    if not ages:
        return [Finding(WARNING, "stamps", "there are none: a message counts as new when it comes")]
    middle = ages[len(ages) // 2]
    if abs(middle) > OLDEST_S:
        return [Finding(PROBLEM, "stamps", f"{abs(middle):.1f} s "
                        f"{'old' if middle > 0 else 'ahead'} when they come: set the clocks of both "
                        "machines (chrony), or is /use_sim_time meant?")]
    return [Finding(OK, "stamps", f"{1000.0 * middle:.0f} ms old when they come")]


def judge_listeners(topics: Dict[str, Sequence[str]]) -> List[Finding]:
    """Who listens to the topics that the executor sends commands on."""
    if not topics:
        return [Finding(PROBLEM, "commands", "the executor advertises no topic for commands")]
    deaf = sorted(topic for topic, nodes in topics.items() if not nodes)
    if deaf:
        return [Finding(PROBLEM, "commands", f"nobody listens to {', '.join(deaf)}: start the "
                        "driver, or is command_interface another one?")]
    nodes = sorted(set(node for nodes in topics.values() for node in nodes))
    return [Finding(OK, "commands", f"{', '.join(nodes)} listens to {', '.join(sorted(topics))}")]


def judge_timers(timers: Dict[str, int]) -> List[Finding]:
    """The latency timers of USB serial adapters [ms]."""
    slow = sorted(name for name, ms in timers.items() if ms > FASTEST_TIMER_MS)
    return [Finding(WARNING, "usb", f"{name} waits {timers[name]} ms before it passes bytes on: "
                    f"echo {FASTEST_TIMER_MS} | sudo tee "
                    f"/sys/bus/usb-serial/devices/{name}/latency_timer") for name in slow]


def usb_timers(folder: pathlib.Path = pathlib.Path("/sys/bus/usb-serial/devices")) -> Dict[
        str, int]:
    """The latency timers that can be read on this machine."""
    timers = {}
    for file in folder.glob("*/latency_timer"):
        try:
            timers[file.parent.name] = int(file.read_text())
        except (OSError, ValueError):
            pass  # another kind of adapter
    return timers


class Ear:
    """Hears joint_states for a while."""

    def __init__(self, rospy: Any, message_type: Any) -> None:
        self._rospy = rospy
        self._lock = threading.Lock()
        self._readings: List[Reading] = []
        self._subscriber = rospy.Subscriber("joint_states", message_type, self._take,
                                            queue_size=200)

    def _take(self, message: Any) -> None:
        stamp = message.header.stamp
        age_s = (self._rospy.Time.now() - stamp).to_sec() if not stamp.is_zero() else math.nan
        publisher = message._connection_header.get("callerid", "?")  # pylint: disable=W0212
        with self._lock:
            self._readings.append(Reading(time.monotonic(), age_s, publisher, tuple(message.name),
                                          tuple(message.position)))

    def listen(self, duration_s: float) -> List[Reading]:
        """What comes within a time."""
        time.sleep(duration_s)
        with self._lock:
            return list(self._readings)


def table(findings: Iterable[Finding]) -> str:
    """The report, a line a finding."""
    return "\n".join(f"{finding.verdict:5}  {finding.subject:12} {finding.text}"
                     for finding in findings)


def first_problem(findings: Iterable[Finding]) -> Optional[Finding]:
    """The first finding that keeps the robot from being armed."""
    return next((finding for finding in findings if finding.verdict == PROBLEM), None)
