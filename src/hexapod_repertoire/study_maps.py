"""Figures 3 and 6 of the paper: end points of typical runs, and maps of one along its run."""
import pathlib
from typing import List, Optional, Tuple

import numpy as np
from scipy.spatial import cKDTree

from hexapod_repertoire.pictures import (
    SHADES, WORST_SHOWN_ERROR_DEG, arc_heading, draw_ticks, finish_top_view)
from hexapod_repertoire.study_claims import BR, EARLY, SPARSENESS
from hexapod_repertoire.study_data import Run, Study, label_of
from hexapod_repertoire.study_statistics import (
    DECIMETRE_DISC_RADIUS_M, controllers_per_dm2, most_typical, quartiles, square_grid)
from hexapod_repertoire.study_style import save, sheet

TICK_M = 0.05
SMALL_ERROR_DEG = 5.0
SNAPSHOTS_SHOWN = 5
# The region of interest of the paper's figure 2C.
REGION_HALF_ANGLE_RAD = np.pi / 3.0
REGION_ARC_LENGTH_M = 0.6


def region_outline() -> Tuple[np.ndarray, np.ndarray]:
    """x and y [m] of the outline of the region of interest, ahead of the robot.

    A point at the polar angle p ends an arc of the length l when it is l sin(p) / p away.
    """
    angles = np.linspace(-REGION_HALF_ANGLE_RAD, REGION_HALF_ANGLE_RAD, 121)
    radius_m = REGION_ARC_LENGTH_M * np.sinc(angles / np.pi)
    return (np.concatenate([[0.0], radius_m * np.cos(angles), [0.0]]),
            np.concatenate([[0.0], radius_m * np.sin(angles), [0.0]]))


def typical_run(study: Study, repertoire: str, evaluations: float) -> Optional[Run]:
    """The run with the median sparseness among those with a snapshot then; None without any."""
    runs = {run.name: run for run in study.with_snapshot(repertoire, evaluations)}
    values = {name: float(run.histories[repertoire].at(SPARSENESS, evaluations))
              for name, run in runs.items()}
    known = {name: value for name, value in values.items() if np.isfinite(value)}
    return runs[most_typical(known)] if known else None


def _draw_region(axes, **style) -> None:
    x_m, y_m = region_outline()
    for sign in (1.0, -1.0):
        axes.fill(-y_m, sign * x_m, **style)


def _draw_ends(axes, entries: np.ndarray) -> None:
    _draw_region(axes, facecolor="0.93", edgecolor="none", zorder=0)
    tangents = arc_heading(entries[:, 0], entries[:, 1])
    draw_ticks(axes, entries, entries[:, 2], TICK_M, color="#5b8fd6", linewidth=1.6, zorder=2)
    draw_ticks(axes, entries, tangents, TICK_M, color="black", linewidth=0.7,
               linestyle=(0, (2.5, 1.5)), zorder=3)
    axes.plot(-entries[:, 1], entries[:, 0], "o", color="black", markersize=2.0, zorder=4)
    axes.plot(0, 0, marker="^", color="black", markersize=8, markerfacecolor="white", zorder=5)
    finish_top_view(axes)


def _half_side_m(entries: List[np.ndarray]) -> float:
    farthest = max((float(np.abs(part[:, :2]).max()) for part in entries), default=0.0)
    return max(REGION_ARC_LENGTH_M, farthest) + TICK_M


def draw_typical_runs(study: Study, path: pathlib.Path) -> Optional[str]:
    """Figure 3: end points of typical runs, early and at the end.

    Returns:
        What to see in it; None when there are no snapshots to draw.
    """
    names = [name for name in study.repertoires if any(run.snapshots.get(name)
                                                       for run in study.runs)]
    whens = sorted({study.last_snapshot(names, limit) for limit in (EARLY, np.inf)} - {None})
    if not names or not whens:
        return None
    chosen = [[typical_run(study, name, when) for name in names] for when in whens]
    shown = [[run.snapshot(name, when) if run else np.empty((0, 4))
              for name, run in zip(names, runs)] for when, runs in zip(whens, chosen)]
    half_side_m = _half_side_m([part for row in shown for part in row if len(part)])
    figure, axes = sheet(len(whens), len(names), (4.1 * len(names), 4.2 * len(whens) + 0.6),
                         sharex=True, sharey=True)
    for row, (when, runs) in enumerate(zip(whens, chosen)):
        for column, (name, run) in enumerate(zip(names, runs)):
            panel, entries = axes[row, column], shown[row][column]
            _draw_ends(panel, entries)
            panel.set(xlim=(-half_side_m, half_side_m), ylim=(-half_side_m, half_side_m))
            seed = f", seed {run.seed}" if run else ": empty"
            panel.set_title(f"{label_of(name)}, {when:,} evaluations\n"
                            f"{len(entries)} controllers{seed}", fontsize=10)
            panel.label_outer()
    save(figure, path)
    return _what_typical_runs_show(names, whens[-1], shown[-1])


def _what_typical_runs_show(names: List[str], when: int, shown: List[np.ndarray]) -> str:
    shares = []
    for name, entries in zip(names, shown):
        if len(entries):
            share = np.mean(np.degrees(entries[:, 3]) < SMALL_ERROR_DEG)
            shares.append(f"{share:.0%} of the {len(entries)} of {label_of(name)}")
    return ("Each dot is where a controller ends, the solid line its heading there, the dashed one "
            "the heading it should have (the tangent of its arc), grey the region of interest; "
            "shown is the run with the median sparseness. After "
            f"{when:,} evaluations solid lies on dashed (within {SMALL_ERROR_DEG:.0f} degrees) for "
            f"{', '.join(shares)}.")


def _maps(entries: np.ndarray, half_side_m: float) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Grid (n, n, 2) [m], density (n, n) [1/dm^2] and error of the nearest (n, n) [deg].

    The density is 0 -> NaN and the error NaN where the disc of 1 dm^2 holds no end point.
    """
    grid = square_grid(half_side_m)
    points = grid.reshape(-1, 2)
    density = controllers_per_dm2(points, entries[:, :2])
    distances, nearest = cKDTree(entries[:, :2]).query(points)
    errors = np.degrees(entries[nearest, 3])
    covered = distances <= DECIMETRE_DISC_RADIUS_M
    shape = grid.shape[:2]
    return (grid, np.where(covered, density, np.nan).reshape(shape),
            np.where(covered, errors, np.nan).reshape(shape))


def _draw_map(axes, values: np.ndarray, half_side_m: float, **options):
    # Rows of the picture are x, columns y; left is to the left, hence columns from right to left.
    image = axes.imshow(values[:, ::-1], origin="lower", interpolation="nearest",
                        extent=(-half_side_m, half_side_m, -half_side_m, half_side_m), **options)
    _draw_region(axes, facecolor="none", edgecolor="black", linewidth=0.9, linestyle="--")
    axes.plot(0, 0, marker="^", color="black", markersize=6, markerfacecolor="white")
    finish_top_view(axes)
    axes.grid(False)
    axes.set_facecolor("white")
    return image


def draw_maps_along_run(study: Study, path: pathlib.Path) -> Optional[str]:
    """Figure 6: density and orientation error over the plane, along a typical BR-Evolution run.

    Returns:
        What to see in it; None without a snapshot of BR-Evolution.
    """
    end = study.last_snapshot([BR], np.inf)
    run = typical_run(study, BR, end) if end else None
    if run is None:
        return None
    whens = sorted(run.snapshots[BR])[-SNAPSHOTS_SHOWN:]
    half_side_m = _half_side_m([run.snapshots[BR][when] for when in whens])
    maps = [_maps(run.snapshots[BR][when], half_side_m) for when in whens]
    densest = max(2.0, float(np.nanpercentile(maps[-1][1], 99.0)))
    figure, axes = sheet(2, len(whens), (3.0 * len(whens) + 1.2, 6.4), sharex=True, sharey=True)
    for column, (when, (_, density, errors)) in enumerate(zip(whens, maps)):
        top = _draw_map(axes[0, column], density, half_side_m, cmap=SHADES, vmin=0.0,
                        vmax=densest)
        bottom = _draw_map(axes[1, column], errors, half_side_m, cmap=SHADES, vmin=0.0,
                           vmax=WORST_SHOWN_ERROR_DEG)
        axes[0, column].set_title(f"{when:,} evaluations\n"
                                  f"{len(run.snapshots[BR][when])} controllers", fontsize=10)
        axes[0, column].label_outer()
        axes[1, column].label_outer()
    figure.colorbar(top, ax=list(axes[0]), label="controllers per dm²", extend="max")
    figure.colorbar(bottom, ax=list(axes[1]), label="orientation error of the\n"
                    "nearest controller [deg]", extend="max")
    save(figure, path)
    return _what_maps_show(run, whens, maps)


def _what_maps_show(run: Run, whens: List[int], maps: List[tuple]) -> str:
    grid, density, errors = maps[-1]
    far = np.hypot(grid[..., 0], grid[..., 1]) > REGION_ARC_LENGTH_M
    beside = (np.arctan2(np.abs(grid[..., 1]), np.abs(grid[..., 0])) > REGION_HALF_ANGLE_RAD) & ~far
    parts = []
    for text, where in (("ahead and behind", ~far & ~beside), ("beside the robot", beside),
                        (f"farther than {REGION_ARC_LENGTH_M} m", far)):
        found = quartiles(errors[where & np.isfinite(errors)])
        if found:
            dense = np.median(density[where & np.isfinite(density)])
            parts.append(f"{found.median:.1f} degrees {text} ({dense:.0f} controllers per dm²)")
    areas = [f"{np.isfinite(part).sum() / 100.0:.0f}" for part in (maps[0][1], density)]
    return (f"Seed {run.seed}, the run with the median sparseness; dark is dense above and badly "
            "aligned below, white has no controller within a disc of 1 dm², dashed is the region "
            f"of interest. Between {whens[0]:,} and {whens[-1]:,} evaluations the area that is "
            f"covered goes from {areas[0]} to {areas[1]} dm²; at the end the median error is "
            f"{', '.join(parts)}.")
