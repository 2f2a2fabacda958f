"""How body and legs move while entries are played: what the program record_entries prints."""
import json
import pathlib
import subprocess
from dataclasses import dataclass
from typing import List, Optional, Sequence, Tuple

import numpy as np

Pose = Tuple[float, float, float]


@dataclass(frozen=True)
class Played:
    """One behaviour, one row per command."""

    entry_id: int
    start: Pose
    predicted: Pose
    end: Pose
    chains: np.ndarray  # joints of each leg from the body outwards, then its foot [m]; (t, legs, points, 3)
    stands: np.ndarray  # whether each foot does, (t, legs)


@dataclass(frozen=True)
class Recording:
    """Behaviours played one after another."""

    period_s: float
    legs: List[str]
    played: List[Played]


def _chains(frames: Sequence[dict]) -> np.ndarray:
    """Legs of fewer joints than others repeat their foot."""
    points = max(len(leg) for leg in frames[0]["legs"])
    return np.array([[leg + [leg[-1]] * (points - len(leg)) for leg in frame["legs"]]
                     for frame in frames])


def parse(text: str) -> Recording:
    """The recording of what record_entries printed."""
    data = json.loads(text)
    played = [Played(one["id"], tuple(one["start"]), tuple(one["predicted"]), tuple(one["end"]),
                     _chains(one["frames"]), np.array([f["stands"] for f in one["frames"]]))
              for one in data["behaviours"] if one["frames"]]
    return Recording(data["period_s"], data["legs"], played)


def record(program: str, file: str, entries: Sequence[int],
           robot: Optional[Sequence[str]] = None) -> Recording:
    """Plays entries of a repertoire file in simulation.

    Args:
        program: The program record_entries.
        robot: URDF and YAML of the robot; the shipped hexapod by default.

    Raises:
        ValueError: With the program's sentence, when it cannot.
    """
    command = [program, file, "--entries", ",".join(map(str, entries))]
    if robot:
        command += ["--urdf", robot[0], "--robot_config", robot[1]]
    ended = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                           universal_newlines=True, check=False)
    if ended.returncode != 0:
        raise ValueError(ended.stderr.strip() or f"{program} ended with {ended.returncode}.")
    return parse(ended.stdout)


def program_in(folder: pathlib.Path) -> Optional[str]:
    """The program record_entries of a build, or None."""
    path = folder / "record_entries"
    return str(path) if path.exists() else None
