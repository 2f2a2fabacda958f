"""A simulated robot that loses a leg while it walks, and what it makes of that."""
import threading
from dataclasses import dataclass
from typing import Optional

import rospy

from hexapod_repertoire.msg import BodyBelief, ExecutorState
from hexapod_repertoire.srv import Disturb, DisturbRequest

STATES = {"locked": DisturbRequest.LOCKED, "lifted": DisturbRequest.LIFTED,
          "limp": DisturbRequest.LIMP, "missing": DisturbRequest.MISSING}


@dataclass(frozen=True)
class Damage:
    """A leg and what becomes of it, one of STATES."""

    leg: str
    state: str

    @staticmethod
    def from_param(name: str) -> "Damage":
        """The parameter `name`: {leg: .., state: ..}; ValueError when it is not."""
        value = rospy.get_param(name)
        if not isinstance(value, dict) or value.get("state") not in STATES or "leg" not in value:
            raise ValueError(f"{name}: expected {{leg: NAME, state: {' or '.join(STATES)}}}, "
                             f"found {value}.")
        return Damage(str(value["leg"]), str(value["state"]))


class Injury:
    """Breaks a leg in the middle of the next behaviour, and follows what the robot believes."""

    def __init__(self, damage: Damage) -> None:
        self._damage = damage
        self._lock = threading.Lock()
        self._wanted = False
        self._behaviors_before: Optional[int] = None  # walked when the leg broke
        self._behaviors_until: Optional[int] = None  # and when it was believed to be dead
        self._walked = 0
        self._states = rospy.Subscriber("executor/state", ExecutorState, self._on_state)
        self._beliefs = rospy.Subscriber("body_belief", BodyBelief, self._on_belief)

    def strike(self) -> None:
        """From now on: as soon as the robot walks."""
        with self._lock:
            self._wanted = True

    def _on_state(self, message: ExecutorState) -> None:
        with self._lock:
            if not self._wanted or message.state != ExecutorState.WALKING:
                return
            self._wanted = False
            self._behaviors_before = self._walked
        answer = rospy.ServiceProxy("simulated_robot/disturb", Disturb)(DisturbRequest(
            legs=[self._damage.leg], states=[STATES[self._damage.state]]))
        if not answer.success:
            rospy.logerr("The leg could not be broken: %s", answer.message)
            return
        rospy.loginfo("The leg %s breaks: %s from now on.", self._damage.leg, self._damage.state)

    def _on_belief(self, message: BodyBelief) -> None:
        with self._lock:
            self._walked = message.behaviors
            broken = self._behaviors_before is not None
            if broken and message.dead_joints and self._behaviors_until is None:
                self._behaviors_until = message.behaviors

    def summary(self) -> str:
        """One sentence."""
        name = f"{self._damage.leg} ({self._damage.state})"
        with self._lock:
            if self._behaviors_before is None:
                return f"{name} did not break: the robot did not walk."
            if self._behaviors_until is None:
                return f"{name} broke and was not noticed."
            count = self._behaviors_until - self._behaviors_before
        return f"{name} broke in mid-walk and was given up after {count} behaviours."
