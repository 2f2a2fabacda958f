"""What simulations and algorithms are given: robots from files, outcomes of one's own."""
import pathlib
from typing import Union

import numpy as np

from hexapod_repertoire import _core

Path = Union[str, pathlib.Path]


def shipped(name: str) -> str:
    """Path of a file that comes with the package, e.g. "urdf/hexapod.urdf"."""
    for folder in pathlib.Path(__file__).resolve().parents:
        for home in (folder, folder / "share" / "hexapod_repertoire"):
            if (home / name).is_file():
                return str(home / name)
    raise ValueError(f"{name} is not where hexapod_repertoire comes from: name the robot's files.")


def load_robot(urdf_file: Path = "", yaml_file: Path = "") -> "_core.Robot":
    """Reads a robot; without files the hexapod that is shipped.

    Args:
        urdf_file: Its URDF: bodies, joints, limits.
        yaml_file: Its YAML: legs, gait, servo, contact (config/hexapod.yaml explains it).

    Raises:
        ValueError: A sentence for each problem of the files.
    """
    return _core.load_robot(str(urdf_file or shipped("urdf/hexapod.urdf")),
                            str(yaml_file or shipped("config/hexapod.yaml")))


def outcomes(x_m: np.ndarray, y_m: np.ndarray, cost: np.ndarray = 0.0, yaw_rad: np.ndarray = 0.0,
             verdict: np.ndarray = _core.WALKED) -> np.ndarray:
    """Outcomes of a task of one's own, for Algorithm.tell().

    Args:
        x_m, y_m: Where a controller ends, or any two numbers that tell behaviours apart; (n,).
        cost: Its quality, 0 or more, lower is better; (n,) or one for all.
        yaw_rad: Its heading; (n,) or one for all.
        verdict: WALKED, or what became of it instead; (n,) or one for all.

    Returns:
        Structured array of shape (n,), of outcome_dtype.
    """
    rows = np.empty(np.shape(x_m), dtype=_core.outcome_dtype)
    for name, values in (("x_m", x_m), ("y_m", y_m), ("yaw_rad", yaw_rad), ("cost", cost),
                         ("verdict", verdict)):
        rows[name] = values
    return rows
