"""Walks to random goals and tells how far behaviours end from their prediction."""
import math
import random
import statistics
import threading
from typing import List, Tuple

import rospy
from hexapod_repertoire.demo import (Report, leave_last_words, validated_repertoire,
                                     wait_until_ready, walk_to)
from hexapod_repertoire.msg import StepReport
from hexapod_repertoire.pictures import Pose
from hexapod_repertoire.waiting import Silence, Walker

BINS_CM = (0.5, 1.0, 1.5, 2.0, 3.0, 5.0, math.inf)


class StepLog:
    """Position [cm] and heading [deg] errors of all behaviours walked so far."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._errors: List[Tuple[float, float]] = []
        self._subscriber = rospy.Subscriber("planner/step_report", StepReport, self._add)

    def _add(self, message: StepReport) -> None:
        with self._lock:
            self._errors.append((100.0 * message.xy_error_m, math.degrees(message.yaw_error_rad)))

    def errors(self) -> List[Tuple[float, float]]:
        """A copy, one (cm, deg) per behaviour."""
        with self._lock:
            return list(self._errors)


def random_goal(generator: random.Random, radius_m: float) -> Pose:
    """A goal uniform in the disc around the frame's origin, any heading."""
    distance = radius_m * math.sqrt(generator.random())
    direction = generator.uniform(-math.pi, math.pi)
    return (
        distance * math.cos(direction),
        distance * math.sin(direction),
        generator.uniform(-math.pi, math.pi),
    )


def percentile(values: List[float], share: float) -> float:
    """The value below which `share` (0..1) of the values lie."""
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))]


def distribution(errors: List[Tuple[float, float]]) -> str:
    """Median, p90, maximum and a histogram of position errors."""
    if not errors:
        return "No behaviour was walked."
    lines = [f"{len(errors)} behaviours, measured against predicted end pose:"]
    for name, values in (("position [cm]", [e[0] for e in errors]), ("heading [deg]", [e[1] for e in errors])):
        lines.append(
            f"  {name}: median {statistics.median(values):.2f}, p90 {percentile(values, 0.9):.2f}, "
            f"max {max(values):.2f}"
        )
    low = 0.0
    for high in BINS_CM:
        count = sum(low <= error[0] < high for error in errors)
        label = f"{low:.1f} to {high:.1f} cm" if math.isfinite(high) else f"over {low:.1f} cm"
        lines.append(f"  {label:>14}: {count:4d} {'#' * round(50 * count / len(errors))}")
        low = high
    return "\n".join(lines)


def summary(reports: List[Report], errors: List[Tuple[float, float]]) -> str:
    """One line a goal, then the distribution over all behaviours."""
    lines = []
    for report in reports:
        r = report.response
        lines.append(
            f"goal ({report.goal[0]:+.2f} m, {report.goal[1]:+.2f} m, "
            f"{math.degrees(report.goal[2]):+4.0f} deg): "
            f"{'reached' if report.reached else 'MISSED'}, {100 * r.final_xy_error_m:.1f} cm, "
            f"{math.degrees(r.final_yaw_error_rad):.1f} deg off, {r.steps} behaviours, "
            f"{report.seconds:.1f} s" + ("" if report.reached else f" ({r.message})")
        )
    reached = sum(report.reached for report in reports)
    lines.append(f"{reached} of {len(reports)} goals reached.")
    lines.append(distribution(errors))
    return "\n".join(lines)


def main() -> int:
    """Walks to ~goals random goals within ~radius_m of odom's origin; 0 if at most a tenth missed."""
    rospy.init_node("walk_trials")
    try:
        return walk_trials()
    except Silence as silence:
        rospy.logfatal(silence)
        leave_last_words(str(silence))
        return 1
    except rospy.ROSInterruptException:
        return 1  # the session ended


def walk_trials() -> int:
    """What main() runs, once there is a node."""
    generator = random.Random(rospy.get_param("~seed", 1))
    goals, radius_m = rospy.get_param("~goals", 20), rospy.get_param("~radius_m", 1.5)
    steps = StepLog()
    validated_repertoire()
    wait_until_ready()
    walker = Walker()
    reports = []
    for number in range(goals):
        reports.append(walk_to(walker, random_goal(generator, radius_m),
                               rospy.get_param("planner/global_frame", "odom")))
        rospy.loginfo("%d of %d: %s", number + 1, goals, reports[-1].response.message)
    print(summary(reports, steps.errors()), flush=True)
    return 0 if sum(not report.reached for report in reports) <= goals // 10 else 1
