"""Writes one page about one repertoire or several, side by side: figures, measures, worlds.

The page needs no other file and no network.
"""
import argparse
import html
import math
import pathlib
import sys
from typing import Callable, Dict, List, Optional, Sequence, Tuple

import numpy as np

from hexapod_repertoire import gait_diagram, recordings, walk_log
from hexapod_repertoire import report_figures as figures
from hexapod_repertoire.repertoire_data import Stored, Unreadable, load

STYLE = """
body { font: 16px/1.45 sans-serif; margin: 0 auto; max-width: 72rem; padding: 0 1rem; color: #222; }
h1 { font-size: 1.5rem; } h2 { font-size: 1.2rem; margin-top: 2.2rem; }
.side { display: flex; flex-wrap: wrap; gap: 1rem; }
.side > figure { flex: 1 1 20rem; margin: 0; min-width: 0; max-width: 34rem; }
.side.small > figure { flex-basis: 15rem; max-width: 17rem; }
svg { width: 100%; height: auto; } .scale { max-width: 20rem; display: block; font-size: 12px; }
figcaption { font-weight: bold; overflow-wrap: anywhere; }
.grid { stroke: #e4e4e4; stroke-width: 0.6; } .robot { fill: #444; }
.heading { stroke: #1a5fb4; stroke-width: 1; } .tangent { stroke: #999; stroke-dasharray: 2 2; }
circle { stroke: #333; stroke-width: 0.3; } circle:hover { stroke: #e01b24; stroke-width: 2.5; }
.wide { overflow-x: auto; } table { border-collapse: collapse; }
td { overflow-wrap: anywhere; } th, td { padding: 0.2rem 0.5rem; border-bottom: 1px solid #ddd; text-align: right; }
th:first-child, td:first-child { text-align: left; }
"""


def _median(values: np.ndarray, factor: float, unit: str) -> str:
    known = values[~np.isnan(values)]
    return f"{factor * np.median(known):.2f} {unit}" if len(known) else "not known"


def _last(stored: Stored, column: str, factor: float, unit: str) -> str:
    values = stored.history[column]
    return f"{factor * values[-1]:.2f} {unit}" if len(values) else "not known"


DEGREES = math.degrees(1.0)
# What is said of every file: label and value.
MEASURES: Sequence[Tuple[str, Callable[[Stored], str]]] = (
    ("entries", lambda s: str(len(s.genomes))),
    ("evaluations", lambda s: s.meta.get("evaluations", "not known")),
    ("seed", lambda s: s.meta.get("seed", "not known")),
    ("time", lambda s: _last(s, "elapsed_s", 1.0, "s")),
    ("sparseness where it learned", lambda s: _last(s, "sparseness_m", 100.0, "cm")),
    ("orientation error there, in the region of interest",
     lambda s: _last(s, "median_orientation_error_rad", DEGREES, "deg")),
    ("farthest entry", lambda s: f"{np.linalg.norm(s.positions_m, axis=1).max(initial=0):.2f} m"),
    ("spread of trials, median", lambda s: _median(s.entries["spread_m"], 100.0, "cm")),
    ("shift of trials, median", lambda s: _median(s.shift_m, 100.0, "cm")),
    ("entries that fell in a trial", lambda s: str(int((s.entries["falls"] > 0).sum()))),
    ("robot", lambda s: s.meta.get("robot_id", "not known")),
    ("body it learned for", lambda s: s.meta.get("option.body", "as described")),
    ("run", lambda s: s.meta.get("run_id", "not known")),
)
WORLD_MEASURES = (("sparseness_m", 100.0, "cm"), ("median_orientation_error_rad", DEGREES, "deg"),
                  ("median_shift_m", 100.0, "cm"))


def table(header: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """An HTML table of texts."""
    def line(cells: Sequence[str], tag: str) -> str:
        return "<tr>" + "".join(f"<{tag}>{html.escape(c)}</{tag}>" for c in cells) + "</tr>"
    return ('<div class="wide"><table>' + line(header, "th") +
            "".join(line(row, "td") for row in rows) + "</table></div>")


def side_by_side(captions: Sequence[str], contents: Sequence[str], size: str = "") -> str:
    """Figures beside each other, below each other where there is no room. size: "" or small."""
    return f'<div class="side {size}">' + "".join(
        f"<figure>{content}<figcaption>{html.escape(caption)}</figcaption></figure>"
        for caption, content in zip(captions, contents)) + "</div>"


def worlds_table(stored: Sequence[Stored]) -> str:
    """Sparseness, orientation error and shift in worlds that learning does not use."""
    all_worlds: Dict[str, None] = {}
    for one in stored:
        all_worlds.update(dict.fromkeys(one.worlds()))
    rows = []
    for world in all_worlds:
        cells = [world]
        for one in stored:
            found = one.worlds().get(world, {})
            cells.append(", ".join(f"{factor * found[name]:.2f} {unit}"
                                   for name, factor, unit in WORLD_MEASURES if name in found) or "-")
        rows.append(cells)
    if not rows:
        return "<p>None was tried (option resimulate).</p>"
    return table(["world", *(one.name for one in stored)], rows)


def telling_entries(stored: Stored) -> List[int]:
    """Those that go farthest forward, backward, left and right, and the one that turns most."""
    if not stored.genomes:
        return []
    x_m, y_m = stored.positions_m.T
    turn = np.abs(np.angle(np.exp(1j * stored.entries["yaw_rad"])))
    return list(dict.fromkeys(int(i) for i in (x_m.argmax(), x_m.argmin(), y_m.argmax(),
                                               y_m.argmin(), turn.argmax())))


def gaits(stored: Stored, file: str, program: str) -> str:
    """Gait diagrams of telling entries, played in simulation; a sentence where they cannot be."""
    chosen = telling_entries(stored)
    if not chosen:
        return ""
    try:
        recording = recordings.record(program, file, [int(stored.entries["id"][i]) for i in chosen])
    except ValueError as problem:
        return f"<p>{html.escape(stored.name)}: not drawn. {html.escape(str(problem))}</p>"
    drawn = [figures.as_svg(gait_diagram.gait_diagram(recording, played))
             for played in recording.played]
    return side_by_side([stored.name] * len(drawn), drawn, "small")


def walks(logs: Sequence[str]) -> str:
    """Each log's walk, predicted against measured."""
    parts = ["<h2>Walks</h2><p>Squares: where each behaviour was predicted to end; dots: where it was "
             "measured to.</p>"]
    for log in logs:
        steps = walk_log.read(log)
        drawn = figures.as_svg(walk_log.draw(steps)) if steps else "<p>Nothing was walked.</p>"
        parts.append(f"<figure>{drawn}<figcaption>{html.escape(walk_log.name_of(log))}</figcaption>"
                     "</figure>")
    return "".join(parts)


def page(stored: Sequence[Stored], more: Sequence[str] = ()) -> str:
    """The whole page; `more`: further chapters."""
    names = [one.name for one in stored]
    half_m = figures.reach_m(stored)
    parts = [f"<h1>{html.escape(' and '.join(names))}</h1>",
             table(["", *names], [[label, *(value(one) for one in stored)]
                                  for label, value in MEASURES]),
             "<h2>Where each behaviour ends</h2><p>Seen from above, the robot at the origin heading "
             "upwards, lines every 10 cm. Solid: the heading at the end; dashed: the tangent of the "
             "circular arc that leads there; colour: the angle between them. The mouse over a disc "
             "names the entry.</p>", figures.color_scale(),
             side_by_side(names, [figures.archive(one, half_m) for one in stored]),
             "<h2>Maps</h2><p>Spread and shift: of the positions at which validation, after random "
             "other behaviours, ended.</p>"]
    for one in stored:
        found = figures.maps(one, half_m)
        parts.append(side_by_side([one.name] * len(found), found, "small"))
    parts.append("<h2>While it learned</h2><p>Over the world it learns in.</p>")
    parts += figures.curves(stored)
    parts += ["<h2>What is left in other worlds</h2><p>Sparseness, median orientation error and "
              "median shift of the entries replayed there.</p>", worlds_table(stored),
              "<h2>Signals of telling entries</h2><p>One period of what is sent to the legs by those "
              "that go farthest forward, backward, left, right, and by the one that turns most.</p>"]
    for one in stored:
        chosen = telling_entries(one)
        parts.append(side_by_side([one.name] * len(chosen),
                                  [figures.signals(one, i) for i in chosen], "small"))
    parts += more
    return ("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
            '<meta name="viewport" content="width=device-width, initial-scale=1">'
            f"<link rel=\"icon\" href=\"data:,\"><title>{html.escape(' and '.join(names))}</title>"
            f"<style>{STYLE}</style></head><body>{''.join(parts)}</body></html>\n")


def gait_chapter(stored: Sequence[Stored], files: Sequence[str], program: Optional[str]) -> str:
    """Stance and swing of telling entries; "" where nothing is built that could play them."""
    if not program:
        return ""
    return ("<h2>Gaits of telling entries</h2><p>Dark while the foot of a leg stands; on the right "
            "the share of the time that it does. The behaviour ends in the neutral pose.</p>" +
            "".join(gaits(one, file, program) for one, file in zip(stored, files)))


def compared(stored: Sequence[Stored]) -> str:
    """The measures of files beside each other, as lines of a terminal."""
    rows = [["", *(one.name for one in stored)],
            *([label, *(value(one) for one in stored)] for label, value in MEASURES)]
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    return "\n".join("  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip()
                     for row in rows)


def main(argv: List[str]) -> int:
    """Writes the page about the files argv names; returns the exit code."""
    verb = "compare" if "--compare" in argv else "report"
    parser = argparse.ArgumentParser(prog=f"./run {verb}", description=__doc__)
    parser.add_argument("files", nargs="+", metavar="FILE.db", help="repertoires")
    parser.add_argument("--output", help="the page [the first file with .html instead of .db]")
    parser.add_argument("--walk", action="append", default=[], metavar="LOG.csv",
                        help="a walk to tell of, too: ./run go 1.0 0.5 45 --log LOG.csv")
    parser.add_argument("--compare", action="store_true",
                        help="print the measures as well; what the verb compare does")
    parser.add_argument("--programs", type=pathlib.Path, help=argparse.SUPPRESS)
    arguments = parser.parse_args(argv)
    try:
        stored = [load(path) for path in arguments.files]
        program = arguments.programs and recordings.program_in(arguments.programs)
        more = [gait_chapter(stored, arguments.files, program)]
        if arguments.walk:
            more.append(walks(arguments.walk))
        if arguments.compare:
            print(compared(stored))
        output = pathlib.Path(arguments.output or pathlib.Path(arguments.files[0]).with_suffix(".html"))
        output.write_text(page(stored, more), encoding="utf-8")
    except (Unreadable, ValueError, OSError) as problem:
        print(problem, file=sys.stderr)
        return 1
    print(f"Written: {output.absolute()}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
