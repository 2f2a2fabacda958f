"""Pictures of a repertoire and of what was walked with it.

Poses are tuples (x [m], y [m], yaw [rad]); x forward, y left.
"""
import math
from dataclasses import dataclass
from typing import List, Sequence, Tuple

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend must be chosen first)
import numpy as np  # noqa: E402
from matplotlib import cm  # noqa: E402
from matplotlib.colors import ListedColormap  # noqa: E402

Pose = Tuple[float, float, float]

WORST_SHOWN_ERROR_DEG = 10.0
GOAL_ARROW_M = 0.15
PANEL_INCHES = 5.0  # height
MARGIN_INCHES = 3.2  # labels and the scale of colours, in width
# Of errors everywhere, rviz too: dark is bad, seen in grey as well, and light still shows on white.
SHADES = ListedColormap(cm.viridis_r(np.linspace(0.25, 1.0, 256)))


@dataclass(frozen=True)
class Walk:
    """One goal, the path planned for it and the positions the robot passed."""

    goal: Pose
    planned: Sequence[Pose]
    walked: Sequence[Pose]


def arc_heading(x_m: np.ndarray, y_m: np.ndarray) -> np.ndarray:
    """Heading [rad] of the arc from the origin through each point, tangent at the point."""
    return 2.0 * np.arctan2(y_m, x_m)


def orientation_errors_deg(poses: np.ndarray) -> np.ndarray:
    """Angle [deg], >= 0, between heading and arc tangent of poses, shape (n, 3) -> (n,)."""
    difference = poses[:, 2] - arc_heading(poses[:, 0], poses[:, 1])
    return np.degrees(np.abs(np.arctan2(np.sin(difference), np.cos(difference))))


def draw_ticks(axes, poses: np.ndarray, headings: np.ndarray, length_m: float, **style) -> None:
    """Draws a line from each pose, shape (n, 3) or (n, 2), along its heading, shape (n,) [rad]."""
    starts = poses[:, :2]
    ends = starts + length_m * np.stack([np.cos(headings), np.sin(headings)], axis=1)
    # One line with gaps at NaN; x forward is drawn upwards and y left to the left, as one looks
    # down on the robot.
    points = np.stack([starts, ends, np.full_like(starts, np.nan)], axis=1).reshape(-1, 2)
    axes.plot(-points[:, 1], points[:, 0], **style)


def draw_repertoire(axes, poses: np.ndarray) -> None:
    """Draws end poses, shape (n, 3), as figure 3 of the paper does: colour is the error."""
    poses = np.asarray(poses, dtype=float).reshape(-1, 3)
    draw_ticks(axes, poses, arc_heading(poses[:, 0], poses[:, 1]), 0.03, color="0.75", linewidth=0.8)
    draw_ticks(axes, poses, poses[:, 2], 0.03, color="tab:blue", linewidth=0.8)
    dots = axes.scatter(
        -poses[:, 1], poses[:, 0], c=orientation_errors_deg(poses), s=9, zorder=3,
        cmap=SHADES, vmin=0.0, vmax=WORST_SHOWN_ERROR_DEG,
    )
    axes.figure.colorbar(dots, ax=axes, label="orientation error [deg]", extend="max", shrink=0.8)
    axes.plot(0, 0, marker="^", color="black", markersize=9)
    axes.set_title(f"{len(poses)} behaviours: end pose after each")
    finish_top_view(axes)


def draw_walks(axes, walks: Sequence[Walk]) -> None:
    """Draws plans (dashed) and walked paths (solid) toward their goals (arrows)."""
    for number, walk in enumerate(walks):
        color = f"C{number}"
        for poses, style in ((walk.planned, "--"), (walk.walked, "-")):
            points = np.asarray(poses, dtype=float).reshape(-1, 3)
            axes.plot(-points[:, 1], points[:, 0], style, color=color, linewidth=1.3)
        x_m, y_m, yaw = walk.goal
        tip = (-y_m - GOAL_ARROW_M * math.sin(yaw), x_m + GOAL_ARROW_M * math.cos(yaw))
        axes.annotate(
            "", xytext=(-y_m, x_m), xy=tip, annotation_clip=False,
            arrowprops={"arrowstyle": "-|>", "color": color, "linewidth": 2},
        )
        axes.update_datalim([tip])  # an annotation makes no room for itself
        axes.plot(-y_m, x_m, "o", color=color, markersize=7, label=f"goal {number + 1}")
    axes.plot(0, 0, marker="^", color="black", markersize=9)
    axes.set_title("planned (dashed) and walked (solid)")
    if walks:
        axes.legend(loc="best", fontsize=8)
    finish_top_view(axes)


def finish_top_view(axes) -> None:
    """Labels axes of a plane seen from above, the robot heading upwards."""
    axes.set_aspect("equal")
    axes.set_xlabel("right [m]")
    axes.set_ylabel("forward [m]")
    axes.grid(True, linewidth=0.3)


def save_repertoire(path: str, poses: np.ndarray) -> None:
    """Writes a PNG with the end poses, shape (n, 3), of a repertoire."""
    figure, axes = plt.subplots(figsize=(7, 6), constrained_layout=True)
    draw_repertoire(axes, poses)
    figure.savefig(path, dpi=110, bbox_inches="tight")
    plt.close(figure)


def save_picture(path: str, repertoire: Sequence[Pose], walks: List[Walk]) -> None:
    """Writes a PNG with the repertoire on the left and the walks on the right."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(13, 6), constrained_layout=True)
    draw_repertoire(left, np.asarray(repertoire, dtype=float))
    draw_walks(right, walks)
    # As wide as what they show: with one scale along both axes the rest would stay blank.
    shares = [np.ptp(axes.get_xlim()) / np.ptp(axes.get_ylim()) for axes in (left, right)]
    left.get_subplotspec().get_gridspec().set_width_ratios(shares)
    figure.set_size_inches(PANEL_INCHES * sum(shares) + MARGIN_INCHES, PANEL_INCHES + 1.0)
    figure.savefig(path, dpi=110, bbox_inches="tight")
    plt.close(figure)
