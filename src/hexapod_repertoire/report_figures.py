"""The figures of a report, as SVG texts.

Seen from above, the robot at the origin heading upwards. Colours run from dark to light, so that
they can be told apart in grey and by colour-blind people: dark is bad.
"""
import html
import io
import math
from typing import Callable, List, Optional, Sequence

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend must be chosen first)
import numpy as np  # noqa: E402

from hexapod_repertoire.pictures import SHADES, WORST_SHOWN_ERROR_DEG  # noqa: E402
from hexapod_repertoire.repertoire_data import Stored  # noqa: E402
from hexapod_repertoire.study_style import styles  # noqa: E402

PIXELS = 460
GRID_M = 0.1
CELL_M = 0.05


def as_svg(figure: plt.Figure) -> str:
    """The SVG element of a figure, which is closed; the same bytes for the same figure."""
    text = io.StringIO()
    with plt.rc_context({"svg.hashsalt": "report", "svg.fonttype": "none"}):
        figure.savefig(text, format="svg", metadata={"Date": None})
    plt.close(figure)
    svg = text.getvalue()
    return svg[svg.index("<svg"):]


def reach_m(stored: Sequence[Stored]) -> float:
    """Half the side of a square around the origin that holds all entries."""
    farthest = [np.abs(one.positions_m).max() for one in stored if len(one.genomes)]
    return GRID_M * math.ceil(max(farthest, default=GRID_M) / GRID_M + 0.5)


def _color(error_deg: float) -> str:
    return matplotlib.colors.to_hex(SHADES(min(error_deg / WORST_SHOWN_ERROR_DEG, 1.0)))


def archive(stored: Stored, half_m: float) -> str:
    """Every entry as in figure 3 of the paper: disc coloured by orientation error, heading solid,
    tangent of its arc dashed. The mouse over a disc names the entry."""
    scale = PIXELS / (2.0 * half_m)

    def place(x_m: float, y_m: float) -> str:
        return f"{PIXELS / 2 - scale * y_m:.1f},{PIXELS / 2 - scale * x_m:.1f}"

    parts = [f'<svg viewBox="0 0 {PIXELS} {PIXELS}" role="img" xmlns="http://www.w3.org/2000/svg" '
             f'aria-label="End poses of {html.escape(stored.name)}">']
    for line in np.arange(-half_m, half_m + GRID_M / 2, GRID_M):
        for a, b in (((line, -half_m), (line, half_m)), ((-half_m, line), (half_m, line))):
            parts.append(f'<path class="grid" d="M{place(*a)} L{place(*b)}"/>')
    parts.append(f'<path class="robot" d="M{place(0.05, 0)} L{place(-0.03, 0.03)} '
                 f'L{place(-0.03, -0.03)} Z"><title>the robot, heading upwards</title></path>')
    e = stored.entries
    for i in range(len(stored.genomes)):
        x_m, y_m, yaw = e["x_m"][i], e["y_m"][i], e["yaw_rad"][i]
        tangent = 2.0 * math.atan2(y_m, x_m)
        for name, angle in (("tangent", tangent), ("heading", yaw)):
            tip = place(x_m + 0.03 * math.cos(angle), y_m + 0.03 * math.sin(angle))
            parts.append(f'<path class="{name}" d="M{place(x_m, y_m)} L{tip}"/>')
        across, down = place(x_m, y_m).split(",")
        parts.append(f'<circle cx="{across}" cy="{down}" r="3.2" '
                     f'fill="{_color(math.degrees(e["orientation_error_rad"][i]))}">'
                     f"<title>{html.escape(stored.describe(i))}</title></circle>")
    return "".join(parts) + "</svg>"


def color_scale() -> str:
    """The legend of the colours of archive()."""
    stops = "".join(f'<stop offset="{share:.1f}" stop-color="{_color(WORST_SHOWN_ERROR_DEG * share)}"/>'
                    for share in np.linspace(0.0, 1.0, 11))
    return ('<svg viewBox="0 0 300 34" class="scale" role="img" aria-label="scale of colours" '
            'xmlns="http://www.w3.org/2000/svg"><linearGradient id="scale">' + stops +
            '</linearGradient><rect x="4" width="292" height="12" fill="url(#scale)"/>'
            '<text x="4" y="28">0 deg</text><text x="296" y="28" text-anchor="end">'
            f"{WORST_SHOWN_ERROR_DEG:.0f} deg and more</text></svg>")


def _map(stored: Stored, half_m: float, title: str, values: np.ndarray,
         of_cell: Callable[[np.ndarray], float], most: Optional[float] = None) -> str:
    """A map of cells, each of of_cell(values of the entries in it); darkest from `most` on."""
    count = int(round(2.0 * half_m / CELL_M))
    cells = np.full((count, count), np.nan)
    index = np.floor((stored.positions_m + half_m) / CELL_M).astype(int)
    for row, column in {tuple(pair) for pair in index}:
        inside = values[(index == (row, column)).all(axis=1)]
        cells[row, column] = of_cell(inside)
    figure, axes = plt.subplots(figsize=(4.2, 3.6), constrained_layout=True)
    image = axes.imshow(cells, origin="lower", extent=(-half_m, half_m, -half_m, half_m),
                        cmap=SHADES, vmin=0.0, vmax=most)
    axes.invert_xaxis()  # y points left
    axes.set(title=title, xlabel="left [m]", ylabel="forward [m]")
    axes.plot(0, 0, marker="^", color="black")
    figure.colorbar(image, ax=axes, shrink=0.85, extend="neither" if most is None else "max")
    return as_svg(figure)


def maps(stored: Stored, half_m: float) -> List[str]:
    """Density, orientation error, and, where it was validated, spread and shift."""
    if not stored.genomes:
        return []
    error_deg = np.degrees(stored.entries["orientation_error_rad"])
    figures = [_map(stored, half_m, f"entries per {100 * CELL_M:.0f} cm cell", error_deg, len),
               _map(stored, half_m, "orientation error [deg], median", error_deg, np.median,
                    WORST_SHOWN_ERROR_DEG)]
    for title, values_m in (("spread of trials [cm], median", stored.entries["spread_m"]),
                            ("shift of trials [cm], median", stored.shift_m)):
        if not np.isnan(values_m).all():
            figures.append(_map(stored, half_m, title, 100.0 * values_m, np.nanmedian))
    return figures


def curves(stored: Sequence[Stored]) -> List[str]:
    """Sparseness and orientation error against evaluations and against time."""
    figures = []
    for x, x_label in (("evaluations", "evaluations"), ("elapsed_s", "time [s]")):
        figure, axes = plt.subplots(1, 2, figsize=(8.4, 3.2), constrained_layout=True)
        for one, style in zip(stored, styles([s.name for s in stored])):
            history = one.history
            for panel, (measure, factor) in zip(axes, (
                    ("sparseness_m", 100.0),
                    ("median_orientation_error_rad", math.degrees(1.0)))):
                panel.plot(history[x], factor * history[measure], color=style.color,
                           linestyle=style.dashes, label=one.name)
        axes[0].set(xlabel=x_label, ylabel="sparseness [cm]")
        axes[1].set(xlabel=x_label, ylabel="orientation error [deg]")
        for panel in axes:
            panel.set_ylim(bottom=0)
            panel.grid(True, linewidth=0.3)
        axes[0].legend(fontsize=8)
        figures.append(as_svg(figure))
    return figures


def signals(stored: Stored, entry: int) -> str:
    """One period of the signals that an entry sends its legs (eq. 3 of the paper)."""
    time = np.linspace(0.0, 1.0, 200)
    rows = [amplitude * np.tanh(4.0 * np.sin(2.0 * np.pi * (time + phase)))
            for amplitude, phase in stored.signals(entry)]
    figure, axes = plt.subplots(figsize=(4.2, 2.6), constrained_layout=True)
    image = axes.imshow(rows, aspect="auto", cmap="cividis", vmin=-1.0, vmax=1.0,
                        extent=(0.0, 1.0, len(rows), 0.0), interpolation="nearest")
    axes.set(xlabel="time [periods]", ylabel="signal of the genome")
    axes.set_title(f"entry {stored.entries['id'][entry]:.0f}", fontsize=10)
    figure.colorbar(image, ax=axes, shrink=0.85)
    return as_svg(figure)
