"""Gait diagrams: when each foot stands and when it swings."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend must be chosen first)
import numpy as np  # noqa: E402

from hexapod_repertoire.recordings import Played, Recording  # noqa: E402

STANCE = "0.15"


def spans(stands: np.ndarray, period_s: float):
    """(begin [s], duration [s]) of each stretch of True, shape (t,)."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], stands.astype(int), [0]])))
    return [(begin * period_s, (end - begin) * period_s) for begin, end in edges.reshape(-1, 2)]


def duty_factors(played: Played) -> np.ndarray:
    """Share of the time that each foot stands, shape (legs,)."""
    return played.stands.mean(axis=0)


def gait_diagram(recording: Recording, played: Played) -> plt.Figure:
    """A bar per leg, dark while its foot stands; its share of the time on the right."""
    figure, axes = plt.subplots(figsize=(4.2, 2.6), constrained_layout=True)
    for row, name in enumerate(recording.legs):
        axes.broken_barh(spans(played.stands[:, row], recording.period_s), (row - 0.4, 0.8),
                         facecolors=STANCE)
        axes.text(1.01, row, f"{100.0 * duty_factors(played)[row]:.0f} %", va="center", fontsize=8,
                  transform=axes.get_yaxis_transform())
    axes.set_yticks(range(len(recording.legs)))
    axes.set_yticklabels([name.replace("_", " ") for name in recording.legs], fontsize=8)
    axes.set_xlim(0.0, len(played.stands) * recording.period_s)
    axes.set_ylim(len(recording.legs) - 0.5, -0.5)
    axes.set(xlabel="time [s]; dark: the foot stands")
    axes.set_title(f"entry {played.entry_id}", fontsize=10)
    return figure
