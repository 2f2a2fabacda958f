"""Reads the folder that the program `study` leaves."""
import csv
import math
import pathlib
import re
from typing import Dict, Iterator, List, Optional, Sequence, Tuple

import numpy as np

from hexapod_repertoire.study_data import History, Run, Study

NAME_OF_A_RUN = re.compile(r"^(?P<algorithm>[^.].*)_(?P<seed>\d+)_(?P<evaluations>\d+)$")
KEYS_OF_A_RUN = ("algorithm", "seed", "evaluations", "simulations", "wall_s")
# Columns of history.csv, and whether a cell may be empty (an empty repertoire has no sparseness).
HISTORY_COLUMNS = {
    "evaluations": False, "simulations": False, "wall_s": False, "entries": False,
    "entries_in_region": False, "sparseness_m": True, "orientation_error_rad": True,
    "orientation_error_of_all_rad": True, "density_per_dm2": True, "reach_m": True,
}
ENTRY_COLUMNS = ("x_m", "y_m", "yaw_rad", "orientation_error_rad")


class StudyError(Exception):
    """A study that cannot be read; its text is one sentence: what, expected, found."""


def read_study(folder: pathlib.Path) -> Study:
    """Reads all finished runs below the folder.

    Raises:
        StudyError: there is no finished run, or a file of one is missing or damaged.
    """
    if not folder.is_dir():
        raise StudyError(f"{folder}: expected the folder of a study, found no such folder.")
    failed = [(file.stem, file.read_text(encoding="utf-8", errors="replace").strip())
              for file in sorted(folder.glob("*.failed"))]
    folders = [path for path in sorted(folder.iterdir())
               if path.is_dir() and NAME_OF_A_RUN.match(path.name)]
    if not folders:
        reasons = "".join(f"; {name} failed: {reason}" for name, reason in failed)
        raise StudyError(f"{folder}: expected at least one finished run (a folder named "
                         f"<algorithm>_<seed>_<evaluations>), found none{reasons}.")
    runs, shorter = _longest([_read_run(path) for path in folders])
    finished = {path.name for path in folders}
    return Study(folder, runs, shorter, [item for item in failed if item[0] not in finished],
                 _read_k_means(folder / "k_means.csv"))


def _longest(runs: Sequence[Run]) -> Tuple[List[Run], List[str]]:
    kept: Dict[Tuple[str, int], Run] = {}
    shorter = []
    for run in sorted(runs, key=lambda run: -run.evaluations):
        if kept.setdefault((run.algorithm, run.seed), run) is not run:
            shorter.append(run.name)
    return sorted(kept.values(), key=lambda run: (run.algorithm, run.seed)), sorted(shorter)


def _read_run(folder: pathlib.Path) -> Run:
    histories = _read_histories(folder / "history.csv")
    if not histories:
        raise StudyError(f"{folder / 'history.csv'}: expected a row at least, found only the "
                         "header.")
    return Run(folder.name, _read_info(folder / "run.csv"), histories,
               _read_snapshots(folder / "entries.csv"))


def _read_info(path: pathlib.Path) -> Dict[str, str]:
    info = {row["key"]: row["value"] for _, row in _rows(path, ("key", "value"))}
    for key in KEYS_OF_A_RUN:
        if key not in info:
            raise StudyError(f"{path}: expected the key '{key}', found {', '.join(info)}.")
    for key in KEYS_OF_A_RUN[1:]:
        number = _number(info[key], f"{path}, key {key}")
        if key in ("seed", "evaluations") and number != int(number):
            raise StudyError(f"{path}, key {key}: expected a whole number, found '{info[key]}'.")
    return info


def _read_histories(path: pathlib.Path) -> Dict[str, History]:
    cells: Dict[str, List[List[float]]] = {}
    for where, row in _rows(path, ("repertoire", *HISTORY_COLUMNS)):
        numbers = [_number(row[name], f"{where}, column {name}", may_be_empty)
                   for name, may_be_empty in HISTORY_COLUMNS.items()]
        earlier = cells.setdefault(row["repertoire"], [])
        if earlier and numbers[0] <= earlier[-1][0]:
            raise StudyError(f"{where}: expected more evaluations than {earlier[-1][0]:.0f}, those "
                             f"of the row before, found {numbers[0]:.0f}.")
        earlier.append(numbers)
    return {name: History(dict(zip(HISTORY_COLUMNS, np.array(rows).T)))
            for name, rows in cells.items()}


def _read_snapshots(path: pathlib.Path) -> Dict[str, Dict[int, np.ndarray]]:
    cells: Dict[str, Dict[int, List[List[float]]]] = {}
    for where, row in _rows(path, ("repertoire", "evaluations", *ENTRY_COLUMNS)):
        evaluations = int(_number(row["evaluations"], f"{where}, column evaluations"))
        cells.setdefault(row["repertoire"], {}).setdefault(evaluations, []).append(
            [_number(row[name], f"{where}, column {name}") for name in ENTRY_COLUMNS])
    return {name: {evaluations: np.array(rows) for evaluations, rows in sorted(snapshots.items())}
            for name, snapshots in cells.items()}


def _read_k_means(path: pathlib.Path) -> Optional[np.ndarray]:
    if not path.exists():
        return None
    rows = [[_number(row[name], f"{where}, column {name}") for name in ("targets", "sparseness_m")]
            for where, row in _rows(path, ("targets", "sparseness_m"))]
    return np.array(sorted(rows)).reshape(-1, 2)


def _rows(path: pathlib.Path, columns: Sequence[str]) -> Iterator[Tuple[str, Dict[str, str]]]:
    """Yields file and line, and the cells by column, of a CSV file with at least these columns."""
    reader = csv.reader(_text(path, columns).splitlines())
    header = next(reader, [])
    if not set(columns) <= set(header):
        raise StudyError(f"{path}: expected the columns {','.join(columns)}, found "
                         f"'{','.join(header)}'.")
    for cells in reader:
        where = f"{path}, line {reader.line_num}"
        if len(cells) != len(header):
            raise StudyError(f"{where}: expected {len(header)} cells, found {len(cells)}.")
        yield where, dict(zip(header, cells))


def _text(path: pathlib.Path, columns: Sequence[str]) -> str:
    try:
        text = path.read_text(encoding="utf-8")
    except OSError as error:
        raise StudyError(f"{path}: expected a file with the columns {','.join(columns)}, found: "
                         f"{error.strerror}. Remove its folder, and the study makes the run anew."
                         ) from error
    except UnicodeDecodeError as error:
        raise StudyError(f"{path}: expected text, found the byte {error.object[error.start]:#04x} "
                         f"at {error.start}.") from error
    if "\0" in text:
        raise StudyError(f"{path}: expected text, found the byte 0x00 at {text.index(chr(0))}.")
    return text


def _number(text: str, where: str, may_be_empty: bool = False) -> float:
    if may_be_empty and not text:
        return math.nan
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if not math.isfinite(number):
        raise StudyError(f"{where}: expected a number, found '{text}'.")
    return number
