"""What a study says of a number of the paper: rows of the table, and the rules of their verdicts.

Lengths in cm and angles in degrees here, as in the paper.
"""
import math
from dataclasses import dataclass
from typing import Callable, List, Optional, Sequence

import numpy as np

from hexapod_repertoire.study_data import REACHED_SHARE, Study, label_of
from hexapod_repertoire.study_statistics import (
    Comparison, Quartiles, compare, is_shown, quartiles)

EARLY, END = 100_000, 1_000_000
BR, NEAREST, ORIENTATION = "br_evolution", "nearest", "orientation"
SPARSENESS, ERROR, REACH = "sparseness_m", "orientation_error_rad", "reach_m"
UNIT_OF = {SPARSENESS: "cm", ERROR: "deg", REACH: "cm"}
NAME_OF = {SPARSENESS: "sparseness", ERROR: "orientation error"}
TOLERANCE = 0.2
EXACT_TOLERANCE = 0.05
LEVEL = 0.01

RULES = f"""Medians [first quartile, third quartile] over runs; p: Wilcoxon rank-sum test,
two-sided; A12: how probable the first is to be larger than the second (0: always smaller, 1: always larger).

*Verdicts.* A number that the paper gives as "about" *holds* when our median is within
{TOLERANCE:.0%} of it ({EXACT_TOLERANCE:.0%} for the theoretical sparseness); a bound holds when our
median keeps it. Where one direction is an advantage of BR-Evolution, a median that is
{TOLERANCE:.0%} beyond the number in that direction is *better than the paper*. A p-value holds when
the medians differ as in the paper and ours is as small. With fewer runs than the paper's 40 it
cannot be: then the smallest possible one (in brackets; "exact": by enumeration instead of the
normal approximation, which flatters few runs) is larger than the paper's, and the verdict is *too
few runs*. Otherwise a difference is shown when p < {LEVEL}. What needs more evaluations than were
made is *not reached*, and ours is what it was at the end.

*Measures.* Sparseness and orientation error are the paper's, the error over the controllers in the
region of interest. An area is covered where the disc of 1 dm² around a point holds an end point.
BR-Evolution is faster by the evaluations of the whole run over those after which a run of it was
as dense as the median of nearest at the end; other ratios are the control's median over each run of
BR-Evolution (areas: the other way round)."""


@dataclass(frozen=True)
class Row:
    """A row of the table.

    Attributes:
        evaluations: when ours was taken; None where that has no meaning.
        ours: of the first group, in the unit.
        other: of the second group, where two are compared.
        runs: how many of each.
    """

    quantity: str
    unit: str
    paper: str
    verdict: str
    evaluations: Optional[int] = None
    ours: Optional[Quartiles] = None
    other: Optional[Quartiles] = None
    runs: str = ""
    comparison: Optional[Comparison] = None


@dataclass(frozen=True)
class Number:
    """A number of the paper.

    Attributes:
        relation: "about", "below" or "above".
        better: "lower" or "higher" where that is an advantage of BR-Evolution, else "".
    """

    text: str
    relation: str
    value: float
    better: str = ""
    tolerance: float = TOLERANCE

    def verdict(self, ours: float) -> str:
        """What our median says of it."""
        if self.better == "lower" and ours < (1.0 - self.tolerance) * self.value:
            return "better than the paper"
        if self.better == "higher" and ours > (1.0 + self.tolerance) * self.value:
            return "better than the paper"
        holds = {"below": ours < self.value, "above": ours > self.value,
                 "about": abs(ours - self.value) <= self.tolerance * self.value}
        if holds[self.relation]:
            return "holds"
        return f"does not hold: ours is {'lower' if ours < self.value else 'higher'}"


@dataclass(frozen=True)
class Claim:
    """Something the paper measures.

    Attributes:
        repertoires: what has to be there.
        measure: our values at some evaluations, in the unit, one a run (or one for all runs).
    """

    quantity: str
    unit: str
    number: Number
    evaluations: int
    repertoires: Sequence[str]
    measure: Callable[[Study, int], Sequence[float]]


@dataclass(frozen=True)
class Test:
    """A difference at the end that the paper gives a p-value for: the first is the lower one."""

    column: str
    first: str
    second: str
    p_value: float


def in_unit(column: str, values: np.ndarray) -> np.ndarray:
    """From SI to the table's unit."""
    return np.degrees(values) if UNIT_OF[column] == "deg" else 100.0 * values


def values_of(study: Study, repertoire: str, column: str, evaluations: float) -> np.ndarray:
    """One value a run, in the table's unit."""
    return in_unit(column, study.values(repertoire, column, evaluations))


def reached(study: Study, repertoires: Sequence[str], wanted: int) -> int:
    """The wanted evaluations, or the most that some run of each repertoire reached."""
    end = study.end_of(repertoires)
    return wanted if end >= REACHED_SHARE * wanted else end


def _runs(study: Study, repertoires: Sequence[str], evaluations: float) -> str:
    return " v ".join(str(len(study.reaching(name, evaluations))) for name in repertoires)


def _missing(study: Study, repertoires: Sequence[str]) -> str:
    names = [label_of(name) for name in repertoires if name not in study.repertoires]
    return f"no runs of {' and '.join(names)}" if names else ""


def row_of_claim(study: Study, claim: Claim) -> Row:
    """Our number beside the paper's."""
    missing = _missing(study, claim.repertoires)
    if missing:
        return Row(claim.quantity, claim.unit, claim.number.text, missing)
    when = reached(study, claim.repertoires, claim.evaluations)
    ours = quartiles([value for value in claim.measure(study, when) if not math.isnan(value)])
    if ours is None:
        verdict = "nothing to measure"
    elif when < claim.evaluations:
        verdict = f"not reached: only {when:,} evaluations"
    else:
        verdict = claim.number.verdict(ours.median)
    return Row(claim.quantity, claim.unit, claim.number.text, verdict, when, ours,
               runs=_runs(study, claim.repertoires, when))


def verdict_of_test(comparison: Comparison, paper_p: float) -> str:
    """What a comparison whose first group is the lower one in the paper says of its p-value."""
    if comparison.a12 >= 0.5:
        return "does not hold: the first is not the lower one"
    if float(f"{comparison.p_value:.1e}") <= paper_p:
        return "holds"
    if float(f"{comparison.smallest_p:.1e}") > paper_p:
        what = ("the groups do not overlap" if comparison.a12 == 0.0 else
                f"p < {LEVEL}" if is_shown(comparison, LEVEL) else "same direction only")
        return f"too few runs for this p-value: {what}"
    return "holds, less clearly" if is_shown(comparison, LEVEL) else "does not hold: p is too large"


def row_of_test(study: Study, test: Test) -> Row:
    """Our p-value beside the paper's."""
    quantity = f"{NAME_OF[test.column]} of {label_of(test.first)} v {label_of(test.second)}"
    paper, unit = f"p = {test.p_value:.1e}", UNIT_OF[test.column]
    missing = _missing(study, [test.first, test.second])
    if missing:
        return Row(quantity, unit, paper, missing)
    when = reached(study, [test.first, test.second], END)
    row = compared(study, test.column, test.first, test.second, when)
    if row.comparison is None:
        verdict = "nothing to measure"
    elif when < END:
        verdict = f"not reached: only {when:,} evaluations"
    else:
        verdict = verdict_of_test(row.comparison, test.p_value)
    return Row(quantity, unit, paper, verdict, when, row.ours, row.other, row.runs, row.comparison)


def compared(study: Study, column: str, first: str, second: str, when: int) -> Row:
    """Two repertoires, without a number of the paper."""
    groups = [values_of(study, name, column, when) for name in (first, second)]
    comparison = compare(*groups)
    if comparison is None:
        verdict = "nothing to measure"
    elif comparison.smallest_exact_p >= LEVEL:
        verdict = "too few runs to show a difference"
    elif is_shown(comparison, LEVEL):
        verdict = f"{label_of(first)} is {'lower' if comparison.a12 < 0.5 else 'higher'}"
    else:
        verdict = "no difference shown"
    return Row(f"{NAME_OF[column]} of {label_of(first)} v {label_of(second)}", UNIT_OF[column], "",
               verdict, when, quartiles(groups[0]), quartiles(groups[1]),
               _runs(study, [first, second], when), comparison)


def row_of_theory(study: Study, targets: int, number_cm: float) -> Row:
    """The sparseness that so many K-means targets have, beside the paper's [cm]."""
    quantity, paper = f"theoretical sparseness of {targets} targets", f"{number_cm:.2f}"
    found = [] if study.k_means is None else study.k_means[study.k_means[:, 0] == targets, 1]
    if len(found) == 0:
        return Row(quantity, "cm", paper, "not in k_means.csv")
    ours = 100.0 * float(found[0])
    number = Number(paper, "about", number_cm, tolerance=EXACT_TOLERANCE)
    return Row(quantity, "cm", paper, number.verdict(ours), ours=quartiles([ours]))


def other_rows(study: Study) -> List[Row]:
    """BR-Evolution against every other repertoire, early and at the end."""
    rows = []
    if BR in study.repertoires:
        for name in study.repertoires:
            whens = sorted({reached(study, [BR, name], wanted) for wanted in (EARLY, END)})
            rows += [compared(study, column, BR, name, when) for when in whens
                     for column in (SPARSENESS, ERROR) if name != BR]
    return rows
