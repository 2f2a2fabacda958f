"""A client that sends the planner goals through all its doors and keeps what it hears."""
import math
import threading
import time

import actionlib
import rospy
from actionlib_msgs.msg import GoalID, GoalStatus
from geometry_msgs.msg import PoseStamped
from hexapod_repertoire.msg import (ExecutorState, WalkToAction, WalkToActionResult, WalkToGoal)
from hexapod_repertoire.srv import GoTo, GoToRequest, GoToResponse
from nav_msgs.msg import Odometry
from std_srvs.srv import Trigger

from walking_session import wait_for

ENDED = {GoalStatus.PREEMPTED, GoalStatus.SUCCEEDED, GoalStatus.ABORTED, GoalStatus.REJECTED,
         GoalStatus.RECALLED}


# What the goals of walk_to and go_to ask for: few behaviours.
XY_TOLERANCE_M = 0.06
ANY_HEADING = -1.0


def goal_message(x_m, y_m, yaw_rad, frame="odom"):
    message = PoseStamped()
    message.header.frame_id = frame
    message.pose.position.x, message.pose.position.y = x_m, y_m
    message.pose.orientation.z = math.sin(yaw_rad / 2.0)
    message.pose.orientation.w = math.cos(yaw_rad / 2.0)
    return message


class Asked:
    """A goal that was sent, and its answers; times are steady.

    Those with `stamp` are wall time: when it was cancelled, and when the planner stamped its answer.
    Their difference is the planner's own time, however late a busy machine lets this process hear.
    """

    def __init__(self, door, target):
        self.door, self.target = door, target
        self.sent_s = time.monotonic()
        self.cancelled_s = None
        self.answered_s = None
        self.cancelled_stamp_s = None
        self.answered_stamp_s = None  # of walk_to
        self.answers = []      # results; exactly one in the end
        self.true_pose = None  # where the robot was when the answer came
        self.handle = None

    def take(self, answer, pose):
        self.answers.append(answer)
        self.answered_s = time.monotonic()
        self.true_pose = pose

    def error(self):
        """(metres, radians) between the goal and where the robot was when the answer came."""
        goal = self.target.pose
        yaw = 2.0 * math.atan2(goal.orientation.z, goal.orientation.w)
        x, y, robot_yaw = self.true_pose
        return (math.hypot(goal.position.x - x, goal.position.y - y),
                abs(math.remainder(yaw - robot_yaw, 2.0 * math.pi)))


class WalkingClient:
    """To be made once, after the session; initialises rospy."""

    def __init__(self):
        # Its own time is the machine's, whatever the session's clock does.
        rospy.init_node("client", disable_signals=True, disable_rostime=True)
        self._lock = threading.Lock()
        self._pose = None
        self.state = None
        self.clock_offset_s = 0.0  # of the executor's time from this process's
        self.asked = []
        self._by_id = {}
        self._subscribers = [
            rospy.Subscriber("odom", Odometry, self._on_odometry, queue_size=1, tcp_nodelay=True),
            rospy.Subscriber("executor/state", ExecutorState, self._on_state, queue_size=10),
            rospy.Subscriber("walk_to/result", WalkToActionResult, self._on_result,
                             queue_size=1000, tcp_nodelay=True)]
        self._action = actionlib.ActionClient("walk_to", WalkToAction)
        self._simple = rospy.Publisher("move_base_simple/goal", PoseStamped, queue_size=10)
        self.threads = []

    def wait_ready(self, timeout_s=40.0):
        """Until the robot can be sent somewhere."""
        wait_for(self._is_ready, timeout_s, "the executor to be READY")
        wait_for(lambda: self._pose, timeout_s, "odometry")
        rospy.wait_for_service("go_to", timeout_s)
        wait_for(lambda: self._simple.get_num_connections() > 0, timeout_s, "the planner's doors")
        wait_for(lambda: self._action.pub_goal.get_num_connections() > 0, timeout_s, "walk_to")
        wait_for(lambda: self._action.pub_cancel.get_num_connections() > 0, timeout_s,
                 "walk_to/cancel")

    def _is_ready(self):
        self.arm_after_a_fault()  # on a busy machine the first feedback may come late
        return self.state == ExecutorState.READY

    def arm_after_a_fault(self):
        """Arms the executor if it is in FAULT."""
        if self.state == ExecutorState.FAULT:
            self.call("executor/arm")

    def pose(self):
        with self._lock:
            return self._pose

    def _on_odometry(self, message):
        pose = message.pose.pose
        with self._lock:
            self._pose = (pose.position.x, pose.position.y,
                          2.0 * math.atan2(pose.orientation.z, pose.orientation.w))

    def _on_state(self, message):
        self.state = message.state
        self.clock_offset_s = message.header.stamp.to_sec() - time.time()

    def _on_result(self, message):
        with self._lock:
            asked = self._by_id.get(message.status.goal_id.id)
            if asked:
                asked.answered_stamp_s = message.header.stamp.to_sec()
                asked.take(message.result, self._pose)

    def walk_to(self, target, plan_only=False):
        """By the action. What it hears comes straight from the topic, each message counted."""
        asked = Asked("walk_to", target)
        self.asked.append(asked)
        with self._lock:
            asked.handle = self._action.send_goal(WalkToGoal(
                target_pose=target, plan_only=plan_only, xy_tolerance_m=XY_TOLERANCE_M,
                yaw_tolerance_rad=ANY_HEADING))
            self._by_id[asked.handle.comm_state_machine.action_goal.goal_id.id] = asked
        return asked

    def cancel(self, asked):
        """One goal of the action."""
        asked.cancelled_s, asked.cancelled_stamp_s = time.monotonic(), time.time()
        asked.handle.cancel()

    def cancel_all_actions(self):
        self._action.pub_cancel.publish(GoalID())

    def go_to(self, target, wait):
        """By the service, in a thread of its own."""
        asked = Asked("go_to", target)
        self.asked.append(asked)

        def call():
            try:
                answer = rospy.ServiceProxy("go_to", GoTo)(
                    GoToRequest(target_pose=target, wait=wait, xy_tolerance_m=XY_TOLERANCE_M,
                                yaw_tolerance_rad=ANY_HEADING))
            except rospy.ServiceException as error:
                answer = GoToResponse(code=255, message=str(error))
            asked.take(answer, self.pose())

        thread = threading.Thread(target=call, daemon=True)
        thread.start()
        self.threads.append(thread)
        return asked

    def simple_goal(self, target):
        self._simple.publish(target)

    def cancel_everything(self):
        """By ~cancel; (answer, seconds that took)."""
        begin = time.monotonic()
        for asked in self.asked:
            if not asked.answers and asked.cancelled_s is None:
                asked.cancelled_s = begin
        answer = rospy.ServiceProxy("planner/cancel", Trigger)()
        return answer, time.monotonic() - begin

    def call(self, service):
        return rospy.ServiceProxy(service, Trigger)()
