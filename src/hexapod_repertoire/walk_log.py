"""Logs of walks: where each behaviour was predicted to end and where it was measured to end."""
import csv
import math
import pathlib
from dataclasses import astuple, dataclass
from typing import List, Sequence, Tuple

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend must be chosen first)
import numpy as np  # noqa: E402

from hexapod_repertoire.pictures import Pose, draw_ticks, finish_top_view  # noqa: E402

COLUMNS = ("entry_id", *(f"{name}_{unit}" for name in ("start", "predicted", "measured")
                         for unit in ("x_m", "y_m", "yaw_rad")))
TICK_M = 0.06


@dataclass(frozen=True)
class Step:
    """One behaviour of a walk; poses of base_footprint in the planner's frame."""

    entry_id: int
    start: Pose
    predicted: Pose
    measured: Pose

    def errors(self) -> Tuple[float, float]:
        """Distance [m] and angle [rad] of the measured end from the predicted one."""
        turn = self.predicted[2] - self.measured[2]
        return (math.hypot(self.predicted[0] - self.measured[0],
                           self.predicted[1] - self.measured[1]),
                abs(math.atan2(math.sin(turn), math.cos(turn))))


def write(path: str, steps: Sequence[Step]) -> None:
    """Writes a log, comma separated, a row per behaviour."""
    with open(path, "w", encoding="utf-8", newline="") as file:
        rows = csv.writer(file)
        rows.writerow(COLUMNS)
        for step in steps:
            entry_id, *poses = astuple(step)
            rows.writerow([entry_id, *(f"{number:.6f}" for pose in poses for number in pose)])


def read(path: str) -> List[Step]:
    """Reads a log; ValueError with a sentence when it is none."""
    try:
        with open(path, encoding="utf-8", newline="") as file:
            rows = list(csv.reader(file))
    except (OSError, UnicodeDecodeError) as problem:
        raise ValueError(f"The walk log {path} cannot be read: {problem}.") from problem
    if not rows or tuple(rows[0]) != COLUMNS:
        raise ValueError(f"{path} is no walk log: expected the columns {', '.join(COLUMNS)}. "
                         "./run go 1.0 0.5 45 --log walk.csv writes one.")
    steps = []
    for number, row in enumerate(rows[1:], start=2):
        try:
            entry_id, *values = row
            poses = np.array(values, dtype=float).reshape(3, 3)
            steps.append(Step(int(entry_id), *(tuple(pose) for pose in poses)))
        except ValueError as problem:
            raise ValueError(f"{path}, line {number}: expected {len(COLUMNS)} numbers.") from problem
    return steps


def draw(steps: Sequence[Step]) -> plt.Figure:
    """The walk from above, predicted ends beside measured ones, and the error of each behaviour."""
    figure, (above, errors) = plt.subplots(1, 2, figsize=(8.4, 3.6), constrained_layout=True)
    measured = np.array([steps[0].start, *(step.measured for step in steps)])
    predicted = np.array([step.predicted for step in steps])
    above.plot(-measured[:, 1], measured[:, 0], "o-", color="black", markersize=4, label="measured")
    draw_ticks(above, measured, measured[:, 2], TICK_M, color="black", linewidth=1.0)
    above.plot(-predicted[:, 1], predicted[:, 0], "s", color="#d99a1c", markersize=5,
               markerfacecolor="none", label="predicted")
    draw_ticks(above, predicted, predicted[:, 2], TICK_M, color="#d99a1c", linewidth=1.0)
    for number, pose in enumerate(measured):
        above.annotate(str(number), (-pose[1], pose[0]), textcoords="offset points", xytext=(5, 4),
                       fontsize=8)
    finish_top_view(above)
    above.legend(fontsize=8)
    numbers = np.arange(1, len(steps) + 1)
    of_steps = np.array([step.errors() for step in steps])
    errors.bar(numbers - 0.2, 100.0 * of_steps[:, 0], 0.4, color="0.3", label="position [cm]")
    errors.bar(numbers + 0.2, np.degrees(of_steps[:, 1]), 0.4, color="#d99a1c",
               label="heading [deg]")
    errors.set(xlabel="behaviour", title="measured from predicted", xticks=numbers)
    errors.legend(fontsize=8)
    return figure


def name_of(path: str) -> str:
    """What a log is called in a page."""
    return pathlib.Path(path).name
