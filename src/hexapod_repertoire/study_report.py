"""Writes the report of a study: a table of the paper's numbers and ours, and the figures."""
import argparse
import csv
import math
import pathlib
import sys
from collections import Counter
from typing import Counter as CounterType, Dict, List, Optional, Sequence

import numpy as np

from hexapod_repertoire.study_claims import (
    EARLY, END, ERROR, RULES, SPARSENESS, Row, other_rows, reached, row_of_claim, row_of_test,
    row_of_theory, values_of)
from hexapod_repertoire.study_curves import (
    EXTRAPOLATION, draw_extrapolation, draw_theory, draw_variation)
from hexapod_repertoire.study_data import Run, Study, label_of
from hexapod_repertoire.study_files import StudyError, read_study
from hexapod_repertoire.study_maps import draw_maps_along_run, draw_typical_runs
from hexapod_repertoire.study_paper import CLAIMS, TESTS, THEORETICAL_SPARSENESS_CM
from hexapod_repertoire.study_statistics import Comparison, Quartiles, quartiles

FIGURES = (
    ("figure_3.png", "Figure 3: typical repertoires", draw_typical_runs),
    ("figure_4.png", "Figure 4: variation of sparseness and orientation error", draw_variation),
    ("figure_5_left.png", "Figure 5, left: theoretical sparseness", draw_theory),
    ("figure_5_right.png", "Figure 5, right: extrapolation to other numbers of targets",
     draw_extrapolation),
    ("figure_6.png", "Figure 6: density and orientation error along a run", draw_maps_along_run),
)
CSV_COLUMNS = (
    "quantity", "unit", "paper", "evaluations", "first_quartile", "median", "third_quartile",
    "other_first_quartile", "other_median", "other_third_quartile", "runs", "p_value",
    "smallest_p", "smallest_exact_p", "a12", "verdict")
TOLD_ELSEWHERE = {"seed", "evaluations", "simulations", "wall_s", "algorithm", "option.engine"}


def _ranges(seeds: Sequence[int]) -> List[List[int]]:
    """First and last of each range without a gap."""
    ranges: List[List[int]] = []
    for seed in sorted(seeds):
        if ranges and seed == ranges[-1][1] + 1:
            ranges[-1][1] = seed
        else:
            ranges.append([seed, seed])
    return ranges


def seeds_text(seeds: Sequence[int]) -> str:
    """Numbers as ranges: 1-3, 7."""
    return ", ".join(f"{first}" if first == last else f"{first}-{last}"
                     for first, last in _ranges(seeds))


def _number(value: float) -> str:
    """Three digits that matter, whole numbers with thousands separators."""
    if math.isinf(value):
        return "never"
    if abs(value) >= 1000.0:
        return f"{value:,.0f}"
    return f"{value:.2f}" if abs(value) < 100.0 else f"{value:.0f}"


def _ours(values: Optional[Quartiles], unit: str) -> str:
    if values is None:
        return "-"
    unit = "" if unit in ("", "evaluations") or math.isinf(values.median) else f" {unit}"
    spread = (f" [{_number(values.lower)}, {_number(values.upper)}]" if values.count > 1 else "")
    return f"{_number(values.median)}{unit}{spread}"


def _p(value: float) -> str:
    return f"{value:.1e}" if value < 0.001 else f"{value:.3f}"


def _test(comparison: Optional[Comparison]) -> str:
    if comparison is None:
        return ""
    smallest = _p(comparison.smallest_p)
    if comparison.smallest_exact_p > comparison.smallest_p:
        smallest += f", exact {_p(comparison.smallest_exact_p)}"
    return f"{_p(comparison.p_value)} ({smallest})"


def _markdown(header: Sequence[str], rows: Sequence[Sequence[str]]) -> List[str]:
    return [f"| {' | '.join(cells)} |" for cells in [header, ["---"] * len(header), *rows]] + [""]


def _table(rows: Sequence[Row]) -> List[str]:
    cells = []
    for row in rows:
        ours = _ours(row.ours, row.unit)
        if row.other is not None:
            ours = f"{ours} v {_ours(row.other, row.unit)}"
        when = "" if row.evaluations is None else f"{row.evaluations:,}"
        a12 = "" if row.comparison is None else f"{row.comparison.a12:.2f}"
        paper = row.paper + (f" {row.unit}" if row.unit in ("cm", "deg", "times")
                             and row.paper and row.comparison is None
                             and not row.paper.startswith("p =") else "")
        cells.append([row.quantity, when, paper, ours, row.runs, _test(row.comparison), a12,
                      row.verdict])
    return _markdown(["quantity", "evaluations", "paper", "ours", "runs", "p (smallest possible)",
                      "A12", "verdict"], cells)


def _exact(number: float) -> str:
    return repr(float(number))


def _csv_row(row: Row) -> List[str]:
    cells = [row.quantity, row.unit, row.paper, row.evaluations or ""]
    for values in (row.ours, row.other):
        cells += ([""] * 3 if values is None else
                  [_exact(values.lower), _exact(values.median), _exact(values.upper)])
    cells.append(row.runs)
    comparison = row.comparison
    cells += ([""] * 4 if comparison is None else
              [_exact(comparison.p_value), _exact(comparison.smallest_p),
               _exact(comparison.smallest_exact_p), _exact(comparison.a12)])
    return [str(cell) for cell in (*cells, row.verdict)]


def _write_csv(path: pathlib.Path, rows: Sequence[Row]) -> None:
    with open(path, "w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(CSV_COLUMNS)
        writer.writerows(_csv_row(row) for row in rows)


def _duration(seconds: float) -> str:
    if seconds < 120.0:
        return f"{seconds:.0f} s"
    return f"{seconds / 60.0:.0f} min" if seconds < 7200.0 else f"{seconds / 3600.0:.1f} h"


def _runs_made(study: Study) -> List[str]:
    """Which runs there are, what they cost, on what and with what options."""
    groups: Dict[tuple, List[Run]] = {}
    for run in study.runs:
        groups.setdefault((run.algorithm, run.evaluations), []).append(run)
    cells = []
    for (algorithm, evaluations), runs in sorted(groups.items()):
        wall_s = [float(run.info["wall_s"]) for run in runs]
        others = sorted({name for run in runs for name in run.histories} - {algorithm})
        which = f" ({', '.join(label_of(name) for name in others)})" if others else ""
        cells.append([label_of(algorithm) + which, f"{evaluations:,}", str(len(runs)),
                      seeds_text([run.seed for run in runs]),
                      f"{sum(float(run.info['simulations']) for run in runs):,.0f}",
                      _duration(sum(wall_s)), _duration(float(np.median(wall_s)))])
    total_s = sum(float(run.info["wall_s"]) for run in study.runs)
    simulations = sum(float(run.info["simulations"]) for run in study.runs)
    return (_markdown(["algorithm", "evaluations", "runs", "seeds", "simulations", "time of all",
                       "median time of a run"], cells)
            + [f"All together: {len(study.runs)} runs, {simulations:,.0f} simulations, "
               f"{_duration(total_s)} of run time.", ""] + _made_with(study))


def command_lines(study: Study) -> List[str]:
    """What makes these runs again, given the options that the report names."""
    seeds: Dict[tuple, List[int]] = {}
    for run in study.runs:
        seeds.setdefault((run.evaluations, run.algorithm), []).append(run.seed)
    together: Dict[tuple, List[str]] = {}
    for (evaluations, algorithm), made in sorted(seeds.items()):
        for first, last in _ranges(made):
            together.setdefault((evaluations, first, last), []).append(algorithm)
    return [f"study --folder {study.folder.name} --algorithms {','.join(algorithms)} "
            f"--first_seed {first} --runs {last - first + 1} --evaluations {evaluations}"
            for (evaluations, first, last), algorithms in sorted(together.items())]


def _made_with(study: Study) -> List[str]:
    """Command lines, then what all runs share, then what they do not."""
    lines = ["```sh", *command_lines(study), "```", ""]
    values: Dict[str, CounterType[str]] = {}
    for run in study.runs:
        for key, value in run.info.items():
            if key not in TOLD_ELSEWHERE:
                values.setdefault(key, Counter())[value] += 1
    shared = [f"{key.replace('option.', '')} {next(iter(found))}"
              for key, found in sorted(values.items()) if len(found) == 1]
    if shared:
        lines += [f"All runs: {'; '.join(shared)}.", ""]
    for key, found in sorted(values.items()):
        if len(found) > 1:
            told = ", ".join(f"{value} ({count} runs)" for value, count in sorted(found.items()))
            lines += [f"Not the same in all runs: {key.replace('option.', '')}: {told}.", ""]
    return lines


def _exceptions(study: Study) -> List[str]:
    lines = []
    if study.failed:
        lines += ["Failed runs, which are not part of this:", ""]
        lines += [f"- {name}: {' '.join(reason.split())}" for name, reason in study.failed] + [""]
    if study.shorter:
        lines += ["Left out, as they are the beginning of a longer run with the same seed: "
                  f"{', '.join(study.shorter)}.", ""]
    return lines


def _measures(study: Study) -> List[str]:
    """Quartiles of what was measured of each repertoire."""
    cells = []
    for wanted in (EARLY, END):
        for name in study.repertoires:
            when = reached(study, [name], wanted)
            runs = study.reaching(name, when)
            if wanted == END and when <= EARLY:
                continue
            plain = [quartiles(study.values(name, column, when)) for column in
                     ("entries", "density_per_dm2")]
            both = [quartiles(values_of(study, name, column, when)) for column in
                    (SPARSENESS, ERROR)]
            cells.append([label_of(name), f"{when:,}", str(len(runs)), _ours(plain[0], ""),
                          _ours(both[0], "cm"), _ours(both[1], "deg"), _ours(plain[1], "")])
    return _markdown(["repertoire", "evaluations", "runs", "controllers", "sparseness",
                      "orientation error", "controllers per dm²"], cells) if cells else []


def write_report(study: Study, output: pathlib.Path) -> None:
    """Writes report.md, table.csv and the figures into the folder, which is made if need be."""
    output.mkdir(parents=True, exist_ok=True)
    of_the_paper = ([row_of_claim(study, claim) for claim in CLAIMS]
                    + [row_of_test(study, test) for test in TESTS]
                    + [row_of_theory(study, *item) for item in THEORETICAL_SPARSENESS_CM.items()]
                    + [row_of_claim(study, EXTRAPOLATION)])
    others = other_rows(study)
    _write_csv(output / "table.csv", of_the_paper + others)
    lines = ["# The paper's study, reproduced", "",
             "The experiments of Cully and Mouret, *Behavioral Repertoire Learning in Robotics*, "
             "GECCO 2013, section 4, beside what the paper prints of them.", "",
             "## Runs", "", *_runs_made(study), *_exceptions(study),
             "## The paper's numbers and ours", "", *_table(of_the_paper), RULES, ""]
    lines += ["## All repertoires", "", *_measures(study)]
    if others:
        lines += ["The paper compares only at the end, and only two; here is BR-Evolution against "
                  "each other repertoire.", "", *_table(others)]
    lines += _figures(study, output)
    (output / "report.md").write_text("\n".join(lines).rstrip() + "\n", encoding="utf-8")


def _figures(study: Study, output: pathlib.Path) -> List[str]:
    lines = ["## Figures", ""]
    for file, title, draw in FIGURES:
        sentence = draw(study, output / file)
        lines += [f"### {title}", ""]
        lines += ([f"![{title}]({file})", "", sentence, ""] if sentence else
                  ["Not drawn: the study has no data for it.", ""])
    return lines


def main(argv: Optional[Sequence[str]] = None) -> int:
    """Writes the report of the study that the command line names; 2 when it cannot be read."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=pathlib.Path, help="what the program study left")
    parser.add_argument("--output", type=pathlib.Path, help="default: FOLDER/report")
    arguments = parser.parse_args(argv)
    output = arguments.output or arguments.folder / "report"
    try:
        write_report(read_study(arguments.folder), output)
    except StudyError as error:
        print(error, file=sys.stderr)
        return 2
    print(output / "report.md")
    return 0


if __name__ == "__main__":
    sys.exit(main())
