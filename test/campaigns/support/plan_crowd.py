#!/usr/bin/python3
"""Calls make_plan so many times at once, again and again, until standard input ends.

A process of its own: what these callers wait for each other is no time of the planner's. Prints a
line of JSON: calls, seconds that the answered ones took, and what the failed ones said.
"""
import json
import random
import sys
import threading
import time

import rospy
from geometry_msgs.msg import PoseStamped
from nav_msgs.srv import GetPlan, GetPlanRequest

CROWD, PERIOD_S = 50, 15.0
ANSWER_TIMEOUT_S = 120.0
AWAY_M = 15.0  # from where the robot stood at first


class Crowd:
    """What the callers have in common."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.took_s, self.failed, self.called = [], [], 0

    def ask(self, goal):
        begin = time.monotonic()
        try:
            rospy.ServiceProxy("make_plan", GetPlan)(GetPlanRequest(goal=goal, tolerance=0.1))
            self.took_s.append(time.monotonic() - begin)
        except rospy.ServiceException as error:
            self.failed.append(str(error))

    def goal(self):
        message = PoseStamped()
        message.header.frame_id = "odom"
        message.pose.position.x = self.random.uniform(-AWAY_M, AWAY_M)
        message.pose.position.y = self.random.uniform(-AWAY_M, AWAY_M)
        message.pose.orientation.w = 1.0
        return message

    def call(self):
        """All at once; comes back when every one is answered, or not within ANSWER_TIMEOUT_S."""
        threads = [threading.Thread(target=self.ask, args=(self.goal(),), daemon=True)
                   for _ in range(CROWD)]
        self.called += CROWD
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join(ANSWER_TIMEOUT_S)


def main():
    """Until standard input ends."""
    rospy.init_node("crowd", disable_signals=True, disable_rostime=True)
    over = threading.Event()
    threading.Thread(target=lambda: (sys.stdin.read(), over.set()), daemon=True).start()
    crowd = Crowd(int(sys.argv[1]))
    while not over.is_set():
        begin = time.monotonic()
        crowd.call()
        over.wait(max(0.0, begin + PERIOD_S - time.monotonic()))
    print(json.dumps({"called": crowd.called, "took_s": crowd.took_s, "failed": crowd.failed}))


if __name__ == "__main__":
    main()
