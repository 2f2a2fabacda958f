"""Adds up where the behaviours of a repertoire should lead, and how sure that is."""
import math
from typing import Dict, NamedTuple, Optional, Tuple

Pose = Tuple[float, float, float]  # x [m], y [m], yaw [rad]

# Of what is not known at all: a bare genome, a behaviour that was broken off [share of its way].
UNKNOWN_M, UNKNOWN_RAD = 0.5, 1.0
BROKEN_OFF = 0.5


class Promise(NamedTuple):
    """Where a behaviour should end, in the frame of its start, and how far that scatters."""
    pose: Pose
    spread_m: float
    spread_rad: float


class Variance(NamedTuple):
    """Of the position along each axis [m^2] and of the heading [rad^2]."""
    position: float
    heading: float

    def plus(self, spread_m: float, spread_rad: float, way_m: float) -> "Variance":
        """After one more way, which an error of the heading has led aside."""
        return Variance(self.position + spread_m ** 2 / 2.0 + self.heading * way_m ** 2,
                        self.heading + spread_rad ** 2)


def compose(start: Pose, then: Pose) -> Pose:
    """The pose `then`, seen from `start`, in the frame of `start`'s frame."""
    cos, sin = math.cos(start[2]), math.sin(start[2])
    yaw = start[2] + then[2]
    return (start[0] + cos * then[0] - sin * then[1], start[1] + sin * then[0] + cos * then[1],
            math.atan2(math.sin(yaw), math.cos(yaw)))


def part_of_way(end: Pose, share: float) -> Pose:
    """A part of the way to an end pose: along its arc, the heading in proportion."""
    x_m, y_m, yaw = end
    # The chord of the part of an arc that turns by 2 * angle in all.
    angle = math.atan2(y_m, x_m) if x_m >= 0.0 else math.atan2(-y_m, -x_m)
    chord_m = math.hypot(x_m, y_m) * (1.0 if x_m >= 0.0 else -1.0)
    if abs(angle) > 1e-6:
        chord_m *= math.sin(share * angle) / math.sin(angle)
    else:
        chord_m *= share
    return (chord_m * math.cos(share * angle), chord_m * math.sin(share * angle), share * yaw)


class DeadReckoner:
    """Adds up what the executor plays. Times are those of one steady clock [s]."""

    def __init__(self) -> None:
        self._promises: Dict[int, Promise] = {}
        self._duration_s = 1.0
        self._start: Pose = (0.0, 0.0, 0.0)
        self._variance = Variance(0.0, 0.0)
        self._playing: Optional[Promise] = None
        self._began_s = 0.0

    def learn(self, promises: Dict[int, Promise], duration_s: float) -> None:
        """Takes over a repertoire."""
        self._promises, self._duration_s = promises, duration_s

    def begin(self, entry_id: int, now_s: float) -> None:
        """A behaviour begins; one whose end was not told has come to it."""
        self.end(True, now_s)
        unknown = Promise((0.0, 0.0, 0.0), UNKNOWN_M, UNKNOWN_RAD)
        self._playing = self._promises.get(entry_id, unknown)
        self._began_s = now_s

    def _share(self, now_s: float) -> float:
        return min(1.0, max(0.0, (now_s - self._began_s) / self._duration_s))

    def end(self, is_whole: bool, now_s: float) -> None:
        """The behaviour under way, if any, ends: as it should, or broken off."""
        promise = self._playing
        if not promise:
            return
        share = 1.0 if is_whole else self._share(now_s)
        way = part_of_way(promise.pose, share)
        way_m = math.hypot(way[0], way[1])
        doubt_m = 0.0 if is_whole else BROKEN_OFF * math.hypot(promise.pose[0], promise.pose[1])
        doubt_rad = 0.0 if is_whole else BROKEN_OFF * abs(promise.pose[2])
        self._start = compose(self._start, way)
        self._variance = self._variance.plus(math.hypot(promise.spread_m, doubt_m),
                                             math.hypot(promise.spread_rad, doubt_rad), way_m)
        self._playing = None

    def pose(self, now_s: float) -> Pose:
        """Where the robot should be."""
        if not self._playing:
            return self._start
        return compose(self._start, part_of_way(self._playing.pose, self._share(now_s)))

    def variance(self) -> Variance:
        """How sure that is, as of the last behaviour that ended."""
        return self._variance
