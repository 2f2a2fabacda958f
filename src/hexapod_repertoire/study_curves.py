"""Figures 4 and 5 of the paper: sparseness and orientation error over the evaluations."""
import pathlib
from typing import Iterable, List, Optional

import numpy as np
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter, StrMethodFormatter

from hexapod_repertoire.study_claims import (
    BR, END, ERROR, NEAREST, SPARSENESS, Claim, Number, in_unit, values_of)
from hexapod_repertoire.study_data import Study, label_of
from hexapod_repertoire.study_paper import THEORETICAL_SPARSENESS_CM
from hexapod_repertoire.study_statistics import quartile_lines, quartiles
from hexapod_repertoire.study_style import save, sheet, styles, tidy

POINTS = 400
# Errors below this are drawn as this [deg]: the axis is logarithmic.
SMALLEST_ERROR_DEG = 0.01
DEFAULT_TARGETS = 100
MOST_TARGETS = 400


def curve(study: Study, repertoire: str, column: str, whens: np.ndarray,
          until: float = 0.0) -> np.ndarray:
    """Quartiles over the runs, in cm or degrees, at each of the evaluations over those there yet.

    Args:
        whens: evaluations, shape (n,).
        until: leave out runs that end before.

    Returns:
        Shape (3, n): first quartile, median, third; NaN where no run has a value.
    """
    histories = [run.histories[repertoire] for run in study.reaching(repertoire, until)]
    values = np.array([history.at(column, whens) for history in histories])
    return quartile_lines(in_unit(column, values))


def _whens(study: Study, repertoire: str) -> np.ndarray:
    return np.linspace(0.0, study.end_of([repertoire]), POINTS + 1)[1:]


def _fewer_runs_from(study: Study) -> List[int]:
    """Where some runs end before the others: there the quartiles are those of other runs."""
    ends = {int(run.histories[name].evaluations[-1]) for run in study.runs
            for name in run.histories}
    last = study.end_of(study.repertoires)
    return sorted(end for end in ends if end < 0.9 * last)


def _thousands(axis) -> None:
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:,.0f}"))


def draw_variation(study: Study, path: pathlib.Path) -> str:
    """Figure 4: quartiles of sparseness and orientation error over the evaluations.

    Returns:
        What to see in it.
    """
    figure, axes = sheet(2, 1, (8.4, 8.2), sharex=True)
    names = study.repertoires
    for panel, column in zip(axes[:, 0], (SPARSENESS, ERROR)):
        for name, style in zip(names, styles(names)):
            whens = _whens(study, name)
            least = SMALLEST_ERROR_DEG if column == ERROR else 0.0
            lower, median, upper = curve(study, name, column, whens).clip(min=least)
            panel.fill_between(whens, lower, upper, color=style.color, alpha=0.18, linewidth=0)
            for edge in (lower, upper):
                panel.plot(whens, edge, color=style.color, linewidth=0.6)
            panel.plot(whens, median, color=style.color, linewidth=2.2, linestyle=style.dashes,
                       marker=style.marker, markevery=POINTS // 8, markersize=6,
                       markeredgecolor="white", label=label_of(name))
        for end in _fewer_runs_from(study):
            panel.axvline(end, color="0.45", linewidth=0.9, linestyle=":")
        tidy(panel)
    top, bottom = axes[:, 0]
    top.set(ylabel="sparseness [cm]", ylim=_sparseness_range(study))
    top.legend(frameon=False, handlelength=4.5)
    bottom.set_yscale("log")
    bottom.yaxis.set_major_locator(LogLocator(10.0, subs=(1.0, 3.0)))
    bottom.yaxis.set_major_formatter(StrMethodFormatter("{x:g}"))
    bottom.yaxis.set_minor_formatter(NullFormatter())
    bottom.set(ylabel="orientation error [deg]", xlabel="evaluations", xlim=(0, None))
    _thousands(bottom.xaxis)
    save(figure, path)
    return _what_variation_shows(study)


def _sparseness_range(study: Study) -> tuple:
    """From 0 to a little over what every repertoire has after a tenth of its evaluations."""
    tenth = [curve(study, name, SPARSENESS, _whens(study, name)[POINTS // 10:])
             for name in study.repertoires]
    known = [np.nanmax(lines) for lines in tenth if np.isfinite(lines).any()]
    return 0.0, 1.1 * max(known, default=10.0)


def _what_variation_shows(study: Study) -> str:
    parts = []
    for name in study.repertoires:
        end = study.end_of([name])
        medians = [quartiles(values_of(study, name, column, end)) for column in (SPARSENESS, ERROR)]
        if all(medians):
            parts.append(f"{label_of(name)} {medians[0].median:.2f} cm and "
                         f"{medians[1].median:.2f} degrees after {end:,} evaluations")
    ends = _fewer_runs_from(study)
    fewer = (f" Dotted uprights (at {', '.join(f'{end:,}' for end in ends)}): shorter runs end, "
             "beyond are the longer ones only.") if ends else ""
    return ("Medians (thick) and quartiles (thin) over the runs; lower is better. Medians at the "
            f"end: {'; '.join(parts)}.{fewer}")


def draw_theory(study: Study, path: pathlib.Path) -> Optional[str]:
    """Figure 5, left: the least sparseness that a number of targets can have.

    Returns:
        What to see in it; None without k_means.csv.
    """
    if study.k_means is None or len(study.k_means) == 0:
        return None
    targets, ours_cm = study.k_means[:, 0], 100.0 * study.k_means[:, 1]
    figure, axes = sheet(1, 1, (6.0, 4.4))
    panel = axes[0, 0]
    panel.plot(targets, ours_cm, color="#0b1d51", linewidth=1.8, marker="o", markersize=6,
               label="our K-means")
    panel.plot(list(THEORETICAL_SPARSENESS_CM), list(THEORETICAL_SPARSENESS_CM.values()), "x",
               color="#d9761c", markersize=11, markeredgewidth=2.4, label="the paper's")
    panel.set(xlabel="number of targets", ylabel="theoretical sparseness [cm]", ylim=(0, None))
    panel.legend(frameon=False)
    tidy(panel)
    save(figure, path)
    pairs = [f"{100.0 * study.k_means[targets == count, 1][0]:.2f} cm with {count} targets "
             f"(the paper's: {number:.2f})" for count, number in THEORETICAL_SPARSENESS_CM.items()
             if count in targets]
    slope = np.polyfit(np.log(targets), np.log(ours_cm), 1)[0] if len(targets) > 1 else np.nan
    return (f"{'; '.join(pairs) or 'None of the numbers of the paper is among ours'}. It falls "
            f"with the number of targets to the power {slope:.2f}: the root, as for points spread "
            "evenly, would be -0.50.")


def extrapolate(study: Study) -> Optional[dict]:
    """The nearest variant's median curve as it would be with other numbers of targets.

    As in the paper: the sparseness is scaled so that the curve ends at the theoretical value, the
    evaluations are stretched in proportion to the targets.

    Returns:
        By number of targets: evaluations and sparseness [cm], shape (n,) each; None without runs of
        nearest or without k_means.csv.
    """
    if NEAREST not in study.repertoires or study.k_means is None:
        return None
    whens = _whens(study, NEAREST)
    median_cm = curve(study, NEAREST, SPARSENESS, whens, whens[-1])[1]
    options = [run.info.get("option.targets", "") for run in study.runs if NEAREST in run.histories]
    of_the_runs = int(options[0]) if options[0].isdigit() else DEFAULT_TARGETS
    return {int(targets): (whens * targets / of_the_runs,
                           median_cm * 100.0 * sparseness_m / median_cm[-1])
            for targets, sparseness_m in study.k_means}


def _times_of_br_with_most_targets(study: Study, evaluations: int) -> np.ndarray:
    """The extrapolated sparseness over that of each run of BR-Evolution."""
    curves = extrapolate(study) or {}
    if MOST_TARGETS not in curves:
        return np.empty(0)
    whens, sparseness_cm = curves[MOST_TARGETS]
    return (np.interp(evaluations, whens, sparseness_cm)
            / values_of(study, BR, SPARSENESS, evaluations))


# What figure 5, right, shows: no number of targets is denser than BR-Evolution at the end.
EXTRAPOLATION = Claim(
    f"sparseness of nearest with {MOST_TARGETS} targets, extrapolated, over that of BR-Evolution",
    "times", Number("> 1", "above", 1.0), END, [BR, NEAREST], _times_of_br_with_most_targets)


def draw_extrapolation(study: Study, path: pathlib.Path) -> Optional[str]:
    """Figure 5, right: BR-Evolution beside the nearest variant with 50 to 400 targets.

    Returns:
        What to see in it; None when something for it is missing.
    """
    curves = extrapolate(study)
    if not curves or BR not in study.repertoires:
        return None
    whens = _whens(study, BR)
    ours_cm = curve(study, BR, SPARSENESS, whens, whens[-1])[1]
    figure, axes = sheet(1, 1, (7.6, 5.2))
    panel = axes[0, 0]
    _draw_extrapolated(panel, curves)
    panel.plot(whens, ours_cm, color="#0b1d51", linewidth=3.0, marker="o", markersize=7,
               markeredgecolor="white", markevery=POINTS // 6, label="BR-Evolution")
    panel.plot([], [], color="0.4", label="nearest, number of targets at its end")
    begin, end = whens[-1] / 30.0, max(times[-1] for times, _ in curves.values())
    highest_cm = max(np.nanmax(np.where(times >= begin, sparseness_cm, 0.0))
                     for times, sparseness_cm in [(whens, ours_cm), *curves.values()])
    panel.set_xscale("log")
    panel.set(xlabel="evaluations", ylabel="sparseness [cm]", ylim=(0.0, 1.05 * highest_cm),
              xlim=(begin, 1.5 * max(end, whens[-1])))
    panel.xaxis.set_major_locator(LogLocator(10.0, subs=(1.0, 3.0)))
    panel.xaxis.set_minor_formatter(NullFormatter())
    _thousands(panel.xaxis)
    panel.legend(frameon=False)
    tidy(panel)
    save(figure, path)
    return _what_extrapolation_shows(study, curves)


def _draw_extrapolated(axes, curves: dict) -> None:
    """Darker with more targets, neighbours told apart by dashes."""
    for slot, (targets, (whens, sparseness_cm)) in enumerate(sorted(curves.items())):
        shade = str(0.74 - 0.5 * slot / max(1, len(curves) - 1))
        axes.plot(whens, sparseness_cm, color=shade, linewidth=1.3,
                  linestyle="--" if slot % 2 else "-", marker=".", markevery=[len(whens) - 1])
        if targets in _labelled(curves):
            axes.annotate(f"{targets}", (whens[-1], sparseness_cm[-1]), xytext=(4, 0),
                          textcoords="offset points", va="bottom", fontsize=9)


def _labelled(numbers: Iterable[int]) -> List[int]:
    """The largest number and those that are half of the one before or less: they have room."""
    chosen: List[int] = []
    for number in sorted(numbers, reverse=True):
        if not chosen or 2 * number <= chosen[-1]:
            chosen.append(number)
    return chosen


def _what_extrapolation_shows(study: Study, curves: dict) -> str:
    end = study.end_of([BR])
    ours_cm = float(np.median(values_of(study, BR, SPARSENESS, end)))
    at_end = {targets: float(np.interp(end, whens, sparseness_cm, right=sparseness_cm[-1]))
              for targets, (whens, sparseness_cm) in curves.items()}
    best = min(at_end, key=at_end.get)
    largest = max(curves)
    return (f"Median sparseness; nearest with {min(curves)} to {largest} targets is extrapolated "
            f"as in the paper. After the {end:,} evaluations of BR-Evolution, which then has "
            f"{ours_cm:.2f} cm, the best of them would have {at_end[best]:.2f} cm (with {best} "
            f"targets); {largest} targets would end at {curves[largest][1][-1]:.2f} cm, after "
            f"{curves[largest][0][-1]:,.0f} evaluations.")
