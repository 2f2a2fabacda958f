"""A moving picture of entries that are played one after another, drawn without a display."""
import pathlib
from typing import Iterator, Tuple

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend must be chosen first)
import numpy as np  # noqa: E402
from matplotlib import animation  # noqa: E402
from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection  # noqa: E402

from hexapod_repertoire.recordings import Played, Recording  # noqa: E402

FRAMES_PER_S = 11.0
INCHES, DOTS_PER_INCH = (4.8, 3.6), 90
MARGIN_M = 0.05
LEG_COLORS = ("#1a5fb4", "#e66100")  # left, right
ENDINGS = (".gif", ".mp4")


def _leg_color(name: str) -> str:
    return LEG_COLORS["right" in name]


class Stage:
    """The axes, as wide as the whole walk, and what moves on them."""

    def __init__(self, recording: Recording) -> None:
        self.figure = plt.figure(figsize=INCHES, dpi=DOTS_PER_INCH)
        self.axes = self.figure.add_axes([0.0, 0.0, 1.0, 0.94], projection="3d")
        everything = np.concatenate([played.chains.reshape(-1, 3) for played in recording.played])
        low, high = everything.min(axis=0) - MARGIN_M, everything.max(axis=0) + MARGIN_M
        self.axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(0.0, high[2]))
        self.axes.set_box_aspect((high[0] - low[0], high[1] - low[1], high[2]), zoom=1.35)
        self.axes.view_init(elev=35, azim=-140)
        self.axes.set_axis_off()
        self._draw_floor(low, high)
        self._draw_stops(recording)
        self.colors = [_leg_color(name) for name in recording.legs]
        self.body = Poly3DCollection([np.zeros((3, 3))], facecolor="0.25", edgecolor="black")
        self.legs = Line3DCollection([np.zeros((2, 3))], linewidths=3)
        self.axes.add_collection3d(self.body)
        self.axes.add_collection3d(self.legs)
        self.feet = self.axes.plot([], [], [], "o", color="black", markersize=4)[0]
        self.title = self.figure.text(0.5, 0.95, "", ha="center", fontsize=10)

    def _draw_floor(self, low: np.ndarray, high: np.ndarray) -> None:
        """Lines every 10 cm."""
        for x_m in np.arange(np.ceil(10 * low[0]), 10 * high[0]) / 10:
            self.axes.plot([x_m, x_m], [low[1], high[1]], [0, 0], color="0.85", linewidth=0.6)
        for y_m in np.arange(np.ceil(10 * low[1]), 10 * high[1]) / 10:
            self.axes.plot([low[0], high[0]], [y_m, y_m], [0, 0], color="0.85", linewidth=0.6)

    def _draw_stops(self, recording: Recording) -> None:
        """Where each behaviour is predicted to end, with the heading there."""
        for played in recording.played:
            x_m, y_m, yaw = played.predicted
            self.axes.plot([x_m], [y_m], [0], "s", color="#2f8f83", markersize=5)
            self.axes.plot([x_m, x_m + 0.1 * np.cos(yaw)], [y_m, y_m + 0.1 * np.sin(yaw)], [0, 0],
                           color="#2f8f83", linewidth=2)

    def show(self, recording: Recording, played: Played, k: int) -> None:
        """Command k of a behaviour."""
        chains = played.chains[k]
        # Around the body: its hips, in the order of their directions.
        hips = chains[:, 0]
        around = hips - hips.mean(axis=0)
        order = np.argsort(np.arctan2(around[:, 1], around[:, 0]))
        self.body.set_verts([hips[order]])
        self.legs.set_segments(list(chains))
        self.legs.set_color(self.colors)
        feet = chains[played.stands[k], -1]
        self.feet.set_data_3d(feet[:, 0], feet[:, 1], feet[:, 2])
        self.title.set_text(f"entry {played.entry_id}, {k * recording.period_s:.1f} s")


def moments(recording: Recording) -> Iterator[Tuple[Played, int]]:
    """The commands that are shown."""
    every = max(1, round(1.0 / (FRAMES_PER_S * recording.period_s)))
    for played in recording.played:
        for k in range(0, len(played.chains), every):
            yield played, k


def save(path: str, recording: Recording) -> None:
    """Writes a .gif, or an .mp4 where there is ffmpeg. ValueError with a sentence otherwise."""
    ending = pathlib.Path(path).suffix
    if ending not in ENDINGS:
        raise ValueError(f"{path} should end in one of {', '.join(ENDINGS)}.")
    if ending == ".mp4" and not animation.FFMpegWriter.isAvailable():
        raise ValueError("An .mp4 needs the program ffmpeg (sudo apt-get install ffmpeg); "
                         "a .gif needs nothing.")
    if not recording.played:
        raise ValueError("Nothing was played that could be shown.")
    every = max(1, round(1.0 / (FRAMES_PER_S * recording.period_s)))
    rate = 1.0 / (every * recording.period_s)
    writer = (animation.FFMpegWriter(fps=rate, bitrate=600) if ending == ".mp4"
              else animation.PillowWriter(fps=rate))
    stage = Stage(recording)
    with writer.saving(stage.figure, path, DOTS_PER_INCH):
        for played, k in moments(recording):
            stage.show(recording, played, k)
            writer.grab_frame()
    plt.close(stage.figure)
