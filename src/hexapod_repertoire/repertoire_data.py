"""A stored repertoire as arrays, read with nothing but SQLite."""
import math
import pathlib
import sqlite3
from dataclasses import dataclass
from typing import Dict, List, Tuple

import numpy as np

PAPER_GENE_LEVELS = 5  # a gene is one of 0, 1/4 .. 1
WORLD_PREFIX = "fact.resimulated."
_COLUMNS = ("id", "x_m", "y_m", "yaw_rad", "orientation_error_rad", "executed_x_m", "executed_y_m",
            "spread_m", "trials", "falls")
_HISTORY = ("evaluations", "archive_size", "sparseness_m", "median_orientation_error_rad",
            "elapsed_s")


def genes_of(genome: str) -> List[int]:
    """The levels of a genome's text: a digit each, or after an x two hexadecimal digits each."""
    return list(bytes.fromhex(genome[1:])) if genome.startswith("x") else [int(c) for c in genome]


class Unreadable(ValueError):
    """No repertoire can be read from the file; the text says which, why and what to do."""


@dataclass(frozen=True)
class Stored:
    """What a file holds. Arrays by column name, one value per entry or row; unknown: NaN."""

    name: str
    meta: Dict[str, str]
    entries: Dict[str, np.ndarray]
    genomes: List[str]
    history: Dict[str, np.ndarray]

    @property
    def positions_m(self) -> np.ndarray:
        """End positions, shape (n, 2)."""
        return np.stack([self.entries["x_m"], self.entries["y_m"]], axis=1)

    @property
    def shift_m(self) -> np.ndarray:
        """How far validation ended from the end pose that was learned, shape (n,)."""
        executed = np.stack([self.entries["executed_x_m"], self.entries["executed_y_m"]], axis=1)
        return np.linalg.norm(executed - self.positions_m, axis=1)

    def describe(self, i: int) -> str:
        """Row i of the entries in words: where it leads and how reliably."""
        e = self.entries
        text = (f"entry {e['id'][i]:.0f}: {e['x_m'][i]:+.3f} m, {e['y_m'][i]:+.3f} m, "
                f"{math.degrees(e['yaw_rad'][i]):+.0f} deg\n"
                f"orientation error {math.degrees(e['orientation_error_rad'][i]):.2f} deg")
        if e["trials"][i] > 0:
            text += (f"\nin {e['trials'][i]:.0f} trials: spread {100 * e['spread_m'][i]:.2f} cm, "
                     f"shift {100 * self.shift_m[i]:.2f} cm, {e['falls'][i]:.0f} falls")
        return text

    def worlds(self) -> Dict[str, Dict[str, float]]:
        """What is left of it in other worlds: name of the world -> measure -> value."""
        found: Dict[str, Dict[str, float]] = {}
        for key, value in self.meta.items():
            if key.startswith(WORLD_PREFIX):
                world, _, measure = key[len(WORLD_PREFIX):].rpartition(".")
                found.setdefault(world, {})[measure] = float(value)
        return found

    def signals(self, entry: int) -> List[Tuple[float, float]]:
        """(amplitude, phase [periods]) of each signal of an entry, from its genes."""
        highest = int(self.meta.get("option.gene_levels", PAPER_GENE_LEVELS)) - 1
        genes = [level / highest for level in genes_of(self.genomes[entry])]
        return list(zip(genes[0::2], genes[1::2]))


def _table(database: sqlite3.Connection, table: str, columns: Tuple[str, ...]
           ) -> Dict[str, np.ndarray]:
    rows = database.execute(f"SELECT {', '.join(columns)} FROM {table} ORDER BY 1").fetchall()
    values = np.array([[math.nan if value is None else value for value in row] for row in rows],
                      dtype=float).reshape(-1, len(columns))
    return {column: values[:, i] for i, column in enumerate(columns)}


def load(path: str) -> Stored:
    """Reads a repertoire file of version 2; Unreadable when it is none."""
    file = pathlib.Path(path)
    if not file.is_file():
        raise Unreadable(f"There is no file {path}; expected a repertoire, written by ./run learn, "
                         "evolve or demo.")
    try:
        database = sqlite3.connect(f"{file.absolute().as_uri()}?mode=ro", uri=True)
        try:
            meta = dict(database.execute("SELECT key, value FROM meta"))
            if meta.get("format_version") not in ("2", "3"):  # entries and history are alike
                raise Unreadable(f"{path} has the format version {meta.get('format_version')}; "
                                 "expected 2 or 3. A run that begins with its entries writes it "
                                 f"anew: ./run evolve --file new.db --from {path}")
            genomes = [row[0] for row in database.execute("SELECT genome FROM entries ORDER BY id")]
            return Stored(file.name, meta, _table(database, "entries", _COLUMNS), genomes,
                          _table(database, "history", _HISTORY))
        finally:
            database.close()
    except (sqlite3.Error, ValueError) as problem:
        if isinstance(problem, Unreadable):
            raise
        raise Unreadable(f"{path} is no repertoire file: {problem}.") from problem
