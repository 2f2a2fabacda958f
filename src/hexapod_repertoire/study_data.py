"""What the program `study` leaves: runs, their histories and snapshots of their entries.

SI units and radians. A *repertoire* is what is measured; a run of one algorithm may yield several.
"""
import math
import pathlib
from dataclasses import dataclass
from typing import List, Mapping, Optional, Sequence, Tuple

import numpy as np

# The order in which repertoires are told of; others follow by name.
FIRST_REPERTOIRES = ("br_evolution", "nearest", "orientation", "map_elites")
LABELS = {"br_evolution": "BR-Evolution", "map_elites": "MAP-Elites",
          "cvt_map_elites": "CVT-MAP-Elites"}
# A run whose generations do not divide the budget may end this share short of it.
REACHED_SHARE = 0.99


def label_of(repertoire: str) -> str:
    """The repertoire's name for people."""
    return LABELS.get(repertoire, repertoire.replace("_", " "))


@dataclass(frozen=True)
class History:
    """The measures of one repertoire over one run.

    Attributes:
        columns: by the names of history.csv, arrays of shape (rows,), evaluations increasing;
            NaN where there was nothing to measure.
    """

    columns: Mapping[str, np.ndarray]

    @property
    def evaluations(self) -> np.ndarray:
        """Shape (rows,), increasing."""
        return self.columns["evaluations"]

    def reaches(self, evaluations: float) -> bool:
        """Whether the run went on until then (or REACHED_SHARE of it)."""
        return bool(self.evaluations[-1] >= REACHED_SHARE * evaluations)

    def at(self, column: str, evaluations) -> np.ndarray:
        """The column at the evaluations (a number or an array), linear between two rows.

        Returns:
            The shape of evaluations; NaN before the first value and where the run did not reach.
        """
        known = np.isfinite(self.columns[column])
        wanted = np.asarray(evaluations, dtype=float)
        if not known.any():
            return np.full(wanted.shape, np.nan)
        values = np.interp(wanted, self.evaluations[known], self.columns[column][known],
                           left=np.nan)
        return np.where(REACHED_SHARE * wanted <= self.evaluations[-1], values, np.nan)


@dataclass(frozen=True)
class Run:
    """One finished run.

    Attributes:
        info: run.csv, key to value.
        histories: by repertoire.
        snapshots: by repertoire, then by evaluations: entries, shape (entries, 4) of x [m], y [m],
            yaw [rad] and orientation error [rad].
    """

    name: str
    info: Mapping[str, str]
    histories: Mapping[str, History]
    snapshots: Mapping[str, Mapping[int, np.ndarray]]

    @property
    def algorithm(self) -> str:
        """What made the run."""
        return self.info["algorithm"]

    @property
    def seed(self) -> int:
        """Two runs of an algorithm with one seed are one run, cut at different lengths."""
        return int(float(self.info["seed"]))

    @property
    def evaluations(self) -> int:
        """The budget."""
        return int(float(self.info["evaluations"]))

    def snapshot(self, repertoire: str, evaluations: float) -> Optional[np.ndarray]:
        """The entries then, shape (entries, 4) as in snapshots; None without any."""
        taken = self.snapshots.get(repertoire, {})
        nearest = min(taken, key=lambda when: abs(when - evaluations), default=math.inf)
        near_enough = abs(nearest - evaluations) <= (1.0 - REACHED_SHARE) * evaluations
        return taken[nearest] if near_enough else None


@dataclass(frozen=True)
class Study:
    """All that a folder holds.

    Attributes:
        runs: by algorithm and seed, the longest of each.
        shorter: names of finished runs that are the beginning of one of the runs.
        failed: name of a run and why it failed.
        k_means: shape (rows, 2) of number of targets and sparseness [m]; None without the file.
    """

    folder: pathlib.Path
    runs: Sequence[Run]
    shorter: Sequence[str]
    failed: Sequence[Tuple[str, str]]
    k_means: Optional[np.ndarray]

    @property
    def repertoires(self) -> List[str]:
        """All that were measured, in the order of telling."""
        found = {name for run in self.runs for name in run.histories}
        first = [name for name in FIRST_REPERTOIRES if name in found]
        return first + sorted(found - set(first))

    def reaching(self, repertoire: str, evaluations: float) -> List[Run]:
        """The runs with this repertoire that went on until then."""
        return [run for run in self.runs if repertoire in run.histories
                and run.histories[repertoire].reaches(evaluations)]

    def end_of(self, repertoires: Sequence[str]) -> int:
        """The largest number of evaluations that some run of each of these repertoires reached."""
        return int(min(max(run.histories[name].evaluations[-1] for run in self.runs
                           if name in run.histories) for name in repertoires))

    def with_snapshot(self, repertoire: str, evaluations: float) -> List[Run]:
        """The runs whose entries of then are there."""
        return [run for run in self.runs if run.snapshot(repertoire, evaluations) is not None]

    def last_snapshot(self, repertoires: Sequence[str], limit: float) -> Optional[int]:
        """The latest evaluations, up to the limit, with a snapshot of each of the repertoires."""
        taken = {when for run in self.runs for name in repertoires
                 for when in run.snapshots.get(name, {}) if REACHED_SHARE * when <= limit}
        return max((when for when in taken
                    if all(self.with_snapshot(name, when) for name in repertoires)), default=None)

    def values(self, repertoire: str, column: str, evaluations: float) -> np.ndarray:
        """The column of each run that reached and had something to measure, shape (runs,)."""
        values = np.array([run.histories[repertoire].at(column, evaluations)
                           for run in self.reaching(repertoire, evaluations)])
        return values[np.isfinite(values)]
