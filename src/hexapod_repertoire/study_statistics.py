"""Quartiles, rank-sum tests and effect sizes over the runs of a study."""
import math
from dataclasses import dataclass
from typing import Mapping, Optional, Sequence

import numpy as np
from scipy.spatial import cKDTree
from scipy.stats import ranksums

# A disc of this radius [m] has an area of 1 dm^2.
DECIMETRE_DISC_RADIUS_M = 0.1 / math.sqrt(math.pi)
GRID_STEP_M = 0.01


@dataclass(frozen=True)
class Quartiles:
    """First, second and third quartile of `count` values, linear between two values."""

    lower: float
    median: float
    upper: float
    count: int


@dataclass(frozen=True)
class Comparison:
    """Two groups of runs.

    Attributes:
        p_value: Wilcoxon rank-sum test, two-sided, by the normal approximation (as in the paper).
        smallest_p: what that test gives when the two groups do not overlap.
        smallest_exact_p: what the test by enumeration would give then.
        a12: Vargha and Delaney's effect size: how probable a value of the first group is to be
            larger than one of the second, ties counted half. 0: always smaller; 0.5: no effect.
    """

    p_value: float
    smallest_p: float
    smallest_exact_p: float
    a12: float
    first_count: int
    second_count: int


def quartiles(values: Sequence[float]) -> Optional[Quartiles]:
    """Quartiles of values of any order, infinite ones among them; None without values."""
    if len(values) == 0:
        return None
    ordered = sorted(float(value) for value in values)
    return Quartiles(*(_quantile(ordered, share) for share in (0.25, 0.5, 0.75)), len(ordered))


def _quantile(ordered: Sequence[float], share: float) -> float:
    position = share * (len(ordered) - 1)
    below, above = ordered[math.floor(position)], ordered[math.ceil(position)]
    if below == above:
        return below
    return below + (position - math.floor(position)) * (above - below)


def quartile_lines(values: np.ndarray) -> np.ndarray:
    """Quartiles of the known values of each column, shape (runs, n) -> (3, n); NaN without any."""
    lines = np.full((3, values.shape[1]), np.nan)
    for slot, column in enumerate(values.T):
        found = quartiles(column[np.isfinite(column)])
        if found:
            lines[:, slot] = found.lower, found.median, found.upper
    return lines


def compare(first: Sequence[float], second: Sequence[float]) -> Optional[Comparison]:
    """Compares two groups; None when one is empty."""
    count, other = len(first), len(second)
    if count == 0 or other == 0:
        return None
    a, b = np.asarray(first, dtype=float), np.asarray(second, dtype=float)
    larger = np.mean((a[:, None] > b) + 0.5 * (a[:, None] == b))
    return Comparison(
        p_value=float(ranksums(a, b).pvalue),
        smallest_p=float(ranksums(np.arange(count), count + np.arange(other)).pvalue),
        smallest_exact_p=min(1.0, 2.0 / math.comb(count + other, count)),
        a12=float(larger), first_count=count, second_count=other)


def is_shown(comparison: Comparison, level: float) -> bool:
    """Whether the groups differ at this level, be it by the exact test's best possible p-value."""
    return comparison.p_value < level and comparison.smallest_exact_p < level


def most_typical(values: Mapping[str, float]) -> str:
    """The key whose value is nearest to the median of all; the first of several."""
    median = np.median(list(values.values()))
    return min(values, key=lambda name: (abs(values[name] - median), list(values).index(name)))


def controllers_per_dm2(points: np.ndarray, ends: np.ndarray) -> np.ndarray:
    """How many end points lie in the disc of 1 dm^2 around each point.

    Args:
        points: shape (n, 2) [m].
        ends: shape (m, 2) [m].

    Returns:
        Shape (n,).
    """
    if len(ends) == 0:
        return np.zeros(len(points))
    found = cKDTree(ends).query_ball_point(points, DECIMETRE_DISC_RADIUS_M)
    return np.array([len(slots) for slots in found], dtype=float)


def square_grid(half_side_m: float) -> np.ndarray:
    """Points GRID_STEP_M apart within a square around the origin, shape (n, n, 2) [m].

    The first index is x, the second y.
    """
    steps = int(math.ceil(half_side_m / GRID_STEP_M))
    ticks = GRID_STEP_M * np.arange(-steps, steps + 1)
    return np.stack(np.meshgrid(ticks, ticks, indexing="ij"), axis=-1)


def covered_area_dm2(ends: np.ndarray) -> float:
    """Area [dm^2] in which the disc of 1 dm^2 around a point holds an end point, shape (m, 2)."""
    if len(ends) == 0:
        return 0.0
    half_side_m = float(np.abs(ends).max()) + DECIMETRE_DISC_RADIUS_M
    points = square_grid(half_side_m).reshape(-1, 2)
    distances, _ = cKDTree(ends).query(points)
    return 100.0 * GRID_STEP_M ** 2 * float(np.sum(distances <= DECIMETRE_DISC_RADIUS_M))
