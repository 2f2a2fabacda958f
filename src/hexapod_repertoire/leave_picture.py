"""Leaves a picture of a repertoire beside its file."""
import os
import pathlib
import sys
from typing import List

import numpy as np

from hexapod_repertoire.pictures import save_repertoire
from hexapod_repertoire.repertoire_data import Unreadable, load


def leave_picture(file: str) -> str:
    """Draws the entries as figure 3 of the paper into FILE.png; returns that path.

    Raises:
        Unreadable: The file is no repertoire.
        OSError: The picture cannot be written.
    """
    entries = load(file).entries
    output = os.path.abspath(file) + ".png"
    save_repertoire(output, np.stack([entries["x_m"], entries["y_m"], entries["yaw_rad"]], axis=1))
    return output


def newer_than(file: str, time_s: float) -> bool:
    """Was the file written since?"""
    path = pathlib.Path(file)
    return path.is_file() and path.stat().st_mtime >= time_s


def main(argv: List[str]) -> int:
    """Draws the files argv names; returns the exit code."""
    try:
        for file in argv:
            print("Picture: " + leave_picture(file))
    except (Unreadable, OSError) as problem:
        print(problem, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
