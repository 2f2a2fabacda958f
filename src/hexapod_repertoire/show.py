"""Draws entries of a repertoire, or a walk, as a moving picture; tells the entries in words."""
import argparse
import math
import pathlib
import sys
from typing import List

import numpy as np

from hexapod_repertoire import gait_diagram, moving_picture, walk_log
from hexapod_repertoire.recordings import record
from hexapod_repertoire.repertoire_data import Stored, Unreadable, load


def parser() -> argparse.ArgumentParser:
    """Of the words after ./run show."""
    top = argparse.ArgumentParser(prog="./run show", description=__doc__)
    top.add_argument("file", metavar="FILE.db", help="a repertoire")
    top.add_argument("entries", type=int, nargs="*", metavar="ID",
                     help="entries, played one after another; none: the best one that goes far ahead")
    top.add_argument("--walk", metavar="LOG.csv", help="the entries of a walk: ./run go .. --log")
    top.add_argument("--output", help=".gif or .mp4 [beside the file]")
    top.add_argument("--gait", metavar="FILE.png", help="the gait diagram of the first entry, too")
    top.add_argument("--robot", nargs=2, metavar=("URDF", "YAML"), help="another robot's files")
    top.add_argument("--programs", required=True, help=argparse.SUPPRESS)
    return top


def best_entry(stored: Stored) -> int:
    """The id of the one farthest ahead among the better aligned half of those that never fell."""
    usable = np.flatnonzero(~(stored.entries["falls"] > 0))
    if not len(usable):
        raise ValueError(f"{stored.name} has no entry that never fell; name one.")
    errors = stored.entries["orientation_error_rad"][usable]
    better = usable[errors <= np.median(errors)]
    return int(stored.entries["id"][better[stored.entries["x_m"][better].argmax()]])


def in_words(stored: Stored, entry_id: int) -> str:
    """Where an entry leads and how reliably."""
    found = np.flatnonzero(stored.entries["id"] == entry_id)
    if not len(found):
        raise ValueError(f"{stored.name} has no entry {entry_id}; it has {len(stored.genomes)} "
                         f"with ids up to {max(stored.entries['id'], default=0):.0f}.")
    return stored.describe(int(found[0]))


def main(argv: List[str]) -> int:
    """Draws what argv asks for; returns the exit code."""
    arguments = parser().parse_args(argv)
    try:
        stored = load(arguments.file)
        if arguments.walk:
            entries = [step.entry_id for step in walk_log.read(arguments.walk)]
        else:
            entries = arguments.entries or [best_entry(stored)]
        for entry in dict.fromkeys(entries):
            print(in_words(stored, entry))
        recording = record(f"{arguments.programs}/record_entries", arguments.file, entries,
                           arguments.robot)
        output = arguments.output or str(pathlib.Path(arguments.file).with_suffix(".gif"))
        moving_picture.save(output, recording)
        written = [output]
        if arguments.gait:
            gait_diagram.gait_diagram(recording, recording.played[0]).savefig(arguments.gait,
                                                                              dpi=130)
            written.append(arguments.gait)
    except (Unreadable, ValueError, OSError) as problem:
        print(problem, file=sys.stderr)
        return 1
    x_m, y_m, yaw = recording.played[-1].end
    print(f"It ends at {x_m:+.2f} m, {y_m:+.2f} m, {math.degrees(yaw):+.0f} deg.")
    print("Written: " + ", ".join(str(pathlib.Path(path).absolute()) for path in written))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
