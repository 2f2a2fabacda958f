"""Waiting for others, never for ever: on steady time, as long as there is a sign of life."""
import threading
import time
from typing import Any, Callable, Optional

import actionlib
import rospy
from actionlib_msgs.msg import GoalStatusArray

from hexapod_repertoire.msg import WalkToAction, WalkToGoal, WalkToResult

STEP_S = 0.2  # how soon the end of the session is noticed
ACTION_PATIENCE_S = 10.0  # an action server tells its status five times a second


class Silence(RuntimeError):
    """Nothing came for longer than was to be expected; the text says what, and what to do."""


class Latest:
    """The newest message of a topic, and how long ago anything came."""

    def __init__(self, topic: str, message_type: Any) -> None:
        self._changed = threading.Condition()
        self._message: Optional[Any] = None
        self._heard_s = time.monotonic()
        self._subscriber = rospy.Subscriber(topic, message_type, self._take, queue_size=1)

    def _take(self, message: Any) -> None:
        with self._changed:
            self._message = message
            self._heard_s = time.monotonic()
            self._changed.notify_all()

    def silent_s(self) -> float:
        """Seconds since a message came; since the start before the first one."""
        with self._changed:
            return time.monotonic() - self._heard_s

    def wait(self, wanted: Callable[[Any], bool], patience_s: float, problem: str,
             also: Optional["Latest"] = None) -> Any:
        """The first message that is `wanted`.

        Raises Silence(problem) when neither this topic nor `also` has said anything for
        patience_s, and ROSInterruptException when the session ends.
        """
        with self._changed:
            while self._message is None or not wanted(self._message):
                self._changed.wait(STEP_S)
                if rospy.is_shutdown():
                    raise rospy.ROSInterruptException("The session ended.")
                silent_s = time.monotonic() - self._heard_s
                if min(silent_s, also.silent_s() if also else silent_s) > patience_s:
                    raise Silence(problem)
            return self._message


class Asker:
    """An action of this package, one goal at a time."""

    def __init__(self, name: str, action_type: Any, server: str) -> None:
        self._server = server
        self._client = actionlib.ActionClient(name, action_type)
        self._handle: Any = None
        self._status = Latest(name + "/status", GoalStatusArray)
        # A goal that is sent before all topics are connected is lost.
        end_s = time.monotonic() + ACTION_PATIENCE_S
        while not self._is_connected():
            if rospy.is_shutdown():
                raise rospy.ROSInterruptException("The session ended.")
            if time.monotonic() > end_s:
                raise Silence(f"No {server} answers on the action {name}; start it.")
            time.sleep(STEP_S)

    def _is_connected(self) -> bool:
        client = self._client
        topics = (client.pub_goal, client.pub_cancel, client.status_sub, client.result_sub)
        return all(topic.get_num_connections() > 0 for topic in topics)

    def ask(self, goal: Any) -> Any:
        """Sends the goal and waits for its result; Silence when the server falls silent."""
        ended = threading.Event()

        def on_change(handle: Any) -> None:
            if handle.get_comm_state() == actionlib.CommState.DONE:
                ended.set()

        self._handle = handle = self._client.send_goal(goal, on_change)
        sent_s = time.monotonic()
        while not ended.wait(STEP_S):
            if rospy.is_shutdown():
                raise rospy.ROSInterruptException("The session ended.")
            if self._status.silent_s() > ACTION_PATIENCE_S:
                raise Silence(f"The {self._server} fell silent in the middle of a goal; see its "
                              "log.")
            unheard = handle.get_comm_state() == actionlib.CommState.WAITING_FOR_GOAL_ACK
            if unheard and time.monotonic() - sent_s > ACTION_PATIENCE_S:
                raise Silence(f"The {self._server} says nothing of the goal it was sent; see its "
                              "log.")
        result = handle.get_result()
        if result is None:
            raise Silence(f"The {self._server} forgot the goal it was sent: it was started anew.")
        return result

    def cancel(self) -> None:
        """Cancels the goal sent last, if any."""
        if self._handle is not None:
            self._handle.cancel()


class Walker(Asker):
    """The planner's action walk_to."""

    def __init__(self) -> None:
        super().__init__("walk_to", WalkToAction, "planner")

    def walk(self, goal: WalkToGoal) -> WalkToResult:
        """Walks there; Silence when the planner falls silent."""
        return self.ask(goal)
