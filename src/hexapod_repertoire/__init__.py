"""Repertoires of gaits from Python: load them, simulate genomes, evolve. doc/python.md shows how.

    import hexapod_repertoire as hr
    simulation = hr.Simulation(hr.load_robot())

Most names come from the C++ part of the package. It is loaded when the first of them is used, so
that what needs none of them works without a build.
"""
import importlib
from pkgutil import extend_path
from typing import Any, List

# The C++ part is built elsewhere.
__path__ = extend_path(__path__, __name__)

_HOMES = {"load_robot": "inputs", "outcomes": "inputs",
          **dict.fromkeys(("Algorithm", "Physics", "Repertoire", "Robot", "Simulation",
                           "algorithm_names", "commands", "load", "outcome_dtype",
                           "WALKED", "FELL", "SELF_COLLIDED", "DIVERGED"), "_core")}
__all__ = sorted(_HOMES)


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module '{__name__}' has no attribute '{name}'")
    try:
        return getattr(importlib.import_module(f"{__name__}.{_HOMES[name]}"), name)
    except ImportError as problem:
        raise ImportError(
            f"hexapod_repertoire.{name} needs the C++ part of the package, which cannot be loaded "
            f"({problem}): build it (./run test builds all; the package pybind11-dev must be there) "
            "and source devel/setup.bash.") from problem


def __dir__() -> List[str]:
    return sorted([*globals(), *__all__])
