"""Many goals and cancels of an action at once, on its topics.

What actionlib's client in Python has not sent yet it keeps in queues of 10, and drops the oldest of
more. rospy shares the queue among all publishers of a topic in a process, and it is as long as the
first of them says: where there is a client, actionlib_client_pub_queue_size has to be LARGEST.
"""
import threading

import rospy
from actionlib_msgs.msg import GoalID

LARGEST = 10000


class ActionBurst:
    """A client of one action that counts the answers to each of its goals."""

    def __init__(self, name, action):
        """Args: the action's name, and its type, as WalkToAction."""
        parts = action()
        self._goal_type = type(parts.action_goal)
        self._name, self._sent = name, 0
        self._lock = threading.Lock()
        self._answers = {}  # lists of results by goal id
        self._subscriber = rospy.Subscriber(name + "/result", type(parts.action_result),
                                            self._on_result)
        self._goals = rospy.Publisher(name + "/goal", self._goal_type, queue_size=LARGEST)
        self._cancels = rospy.Publisher(name + "/cancel", GoalID, queue_size=LARGEST)

    def is_connected(self):
        """True when the server hears and is heard."""
        return all(topic.get_num_connections() > 0
                   for topic in (self._subscriber, self._goals, self._cancels))

    def _on_result(self, message):
        with self._lock:
            answers = self._answers.get(message.status.goal_id.id)
            if answers is not None:
                answers.append(message)

    def send(self, goal, count):
        """Sends a goal `count` times; their ids."""
        ids = ["%s_%d" % (rospy.get_name(), self._sent + i) for i in range(count)]
        self._sent += count
        with self._lock:
            self._answers.update((goal_id, []) for goal_id in ids)
        for goal_id in ids:
            message = self._goal_type(goal=goal)
            message.goal_id.id = goal_id
            self._goals.publish(message)
        return ids

    def cancel(self, ids):
        """Cancels goals one by one."""
        for goal_id in ids:
            self._cancels.publish(GoalID(id=goal_id))

    def unanswered(self):
        """How many goals have no answer yet."""
        with self._lock:
            return sum(not answers for answers in self._answers.values())

    def answers(self):
        """{goal id: its results}."""
        with self._lock:
            return {goal_id: list(answers) for goal_id, answers in self._answers.items()}
