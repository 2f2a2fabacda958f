"""How a study's figures look: readable in grey print, one style for a repertoire everywhere."""
import pathlib
from dataclasses import dataclass
from typing import Sequence

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend must be chosen first)

DOTS_PER_INCH = 130
# Dark to light, so that print in grey keeps the order; dashes and markers differ as well.
_COLORS = ("#0b1d51", "#a3262a", "#2f8f83", "#d99a1c")
_DASHES = ("-", (0, (6, 1.6)), (0, (6, 1.5, 1.2, 1.5)), (0, (1.4, 1.2)))
_MARKERS = ("o", "s", "^", "D")


@dataclass(frozen=True)
class LineStyle:
    """Of the curves of one repertoire."""

    color: str
    dashes: object
    marker: str


def styles(repertoires: Sequence[str]) -> Sequence[LineStyle]:
    """One style for each; the fifth has the first's colour with other dashes and marker."""
    return [LineStyle(_COLORS[slot % 4], _DASHES[(slot + slot // 4) % 4],
                      _MARKERS[(slot + slot // 4) % 4]) for slot in range(len(repertoires))]


def sheet(rows: int, columns: int, size_inches: Sequence[float], **options):
    """A figure and its axes, shape (rows, columns)."""
    with plt.rc_context({"font.size": 10}):
        return plt.subplots(rows, columns, figsize=size_inches, constrained_layout=True,
                            squeeze=False, **options)


def tidy(axes) -> None:
    """No frame where no axis is, and a faint grid behind the data."""
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    axes.grid(True, linewidth=0.4, color="0.85")
    axes.set_axisbelow(True)


def save(figure, path: pathlib.Path) -> None:
    """Writes the PNG and forgets the figure."""
    figure.savefig(str(path), dpi=DOTS_PER_INCH)
    plt.close(figure)
