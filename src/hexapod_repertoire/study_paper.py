"""The numbers of Cully and Mouret 2013, sections 4.3 and 5, and how a study measures them.

Lengths in cm and angles in degrees here, as in the paper.
"""
import math
from typing import Callable, List, Sequence

import numpy as np

from hexapod_repertoire.study_claims import (
    BR, EARLY, END, ERROR, NEAREST, ORIENTATION, REACH, SPARSENESS, Claim, Number, Test, values_of)
from hexapod_repertoire.study_data import Study
from hexapod_repertoire.study_statistics import covered_area_dm2, quartile_lines, quartiles

CROSSING_STEPS = 1000

def median_of(values: Sequence[float]) -> float:
    """The median; NaN without values."""
    found = quartiles(values)
    return found.median if found else math.nan


def _of(repertoire: str, column: str) -> Callable[[Study, int], np.ndarray]:
    return lambda study, evaluations: values_of(study, repertoire, column, evaluations)


def _error_under_br(study: Study, evaluations: int) -> np.ndarray:
    return (median_of(values_of(study, BR, ERROR, evaluations))
            - values_of(study, ORIENTATION, ERROR, evaluations))


def _times_of_br(repertoire: str, column: str) -> Callable[[Study, int], np.ndarray]:
    """The repertoire's median over the value of each run of BR-Evolution."""
    def measure(study: Study, evaluations: int) -> np.ndarray:
        median = median_of(values_of(study, repertoire, column, evaluations))
        with np.errstate(divide="ignore"):
            return median / values_of(study, BR, column, evaluations)
    return measure


def _median_errors(study: Study, repertoire: str, whens: np.ndarray) -> np.ndarray:
    """Median over the runs that reach the last of the evaluations, shape (n,); NaN: none yet."""
    errors = np.array([run.histories[repertoire].at(ERROR, whens)
                       for run in study.reaching(repertoire, whens[-1])])
    return quartile_lines(errors)[1]


def _crossing(study: Study, evaluations: int) -> List[float]:
    """From when on the orientation variant's median error is below BR-Evolution's; inf: never."""
    whens = np.linspace(0.0, evaluations, CROSSING_STEPS + 1)[1:]
    with np.errstate(invalid="ignore"):
        below = _median_errors(study, ORIENTATION, whens) < _median_errors(study, BR, whens)
    if not below[-1]:
        return [math.inf]
    not_below = np.flatnonzero(~below)
    return [float(whens[not_below[-1] + 1 if len(not_below) else 0])]


def _times_faster(study: Study, evaluations: int) -> List[float]:
    """The end over when each run of BR-Evolution was as dense as "nearest" is at the end."""
    level = median_of(study.values(NEAREST, SPARSENESS, evaluations))
    factors = []
    for run in study.reaching(BR, evaluations):
        history = run.histories[BR]
        with np.errstate(invalid="ignore"):
            dense = history.evaluations[history.columns[SPARSENESS] <= level]
        factors.append(evaluations / dense[0] if len(dense) else 0.0)
    return factors


def _times_area(repertoire: str) -> Callable[[Study, int], np.ndarray]:
    """Area covered by each run of BR-Evolution over the repertoire's median."""
    def measure(study: Study, limit: int) -> np.ndarray:
        when = study.last_snapshot([BR, repertoire], limit)
        if when is None:
            return np.empty(0)
        areas = [[covered_area_dm2(run.snapshot(name, when)[:, :2])
                  for run in study.with_snapshot(name, when)] for name in (BR, repertoire)]
        return np.array(areas[0]) / np.median(areas[1])
    return measure


CLAIMS = (
    Claim("sparseness of BR-Evolution", "cm", Number("about 3", "about", 3.0, "lower"), EARLY,
          [BR], _of(BR, SPARSENESS)),
    Claim("sparseness of BR-Evolution", "cm", Number("near 2", "about", 2.0, "lower"), END,
          [BR], _of(BR, SPARSENESS)),
    Claim("orientation error of BR-Evolution", "deg", Number("< 5", "below", 5.0, "lower"), EARLY,
          [BR], _of(BR, ERROR)),
    Claim("orientation error of BR-Evolution", "deg", Number("< 1.7", "below", 1.7, "lower"), END,
          [BR], _of(BR, ERROR)),
    Claim("sparseness of nearest", "cm", Number("3", "about", 3.0), END, [NEAREST],
          _of(NEAREST, SPARSENESS)),
    Claim("orientation error of nearest", "deg", Number("> 15", "above", 15.0), END, [NEAREST],
          _of(NEAREST, ERROR)),
    Claim("sparseness of orientation", "cm", Number("> 4", "above", 4.0), END, [ORIENTATION],
          _of(ORIENTATION, SPARSENESS)),
    Claim("orientation error of orientation below that of BR-Evolution by", "deg",
          Number("0.5", "about", 0.5, "lower"), END, [BR, ORIENTATION], _error_under_br),
    Claim("from when on orientation has the smaller orientation error", "evaluations",
          Number("750,000", "about", 750_000, "higher"), END, [BR, ORIENTATION], _crossing),
    Claim("largest distance reached by BR-Evolution", "cm", Number("80", "about", 80.0), END, [BR],
          _of(BR, REACH)),
    Claim("area covered by BR-Evolution over that of nearest", "times",
          Number("about 2", "about", 2.0, "higher"), EARLY, [BR, NEAREST], _times_area(NEAREST)),
    Claim("area covered by BR-Evolution over that of orientation", "times",
          Number("about 2", "about", 2.0, "higher"), EARLY, [BR, ORIENTATION],
          _times_area(ORIENTATION)),
    Claim("sparseness of orientation over that of BR-Evolution", "times",
          Number("2", "about", 2.0, "higher"), END, [BR, ORIENTATION],
          _times_of_br(ORIENTATION, SPARSENESS)),
    Claim("BR-Evolution as dense as nearest at the end, faster by", "times",
          Number("at least 5", "above", 5.0, "higher"), END, [BR, NEAREST], _times_faster),
    Claim("orientation error of nearest over that of BR-Evolution", "times",
          Number("about 10", "about", 10.0, "higher"), END, [BR, NEAREST],
          _times_of_br(NEAREST, ERROR)),
)
TESTS = (
    Test(SPARSENESS, BR, NEAREST, 1.4e-14), Test(SPARSENESS, BR, ORIENTATION, 1.4e-14),
    Test(ERROR, ORIENTATION, BR, 3.0e-7), Test(ERROR, BR, NEAREST, 1.4e-14))
THEORETICAL_SPARSENESS_CM = {100: 3.14, 200: 2.22, 400: 1.57}
