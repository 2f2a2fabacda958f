"""Kernels for one kind of processor run only where it has all that they were compiled for."""
import pathlib
import re

SIMULATION = pathlib.Path(__file__).resolve().parents[2] / "src" / "simulation"


def test_every_instruction_set_that_kernels_are_compiled_for_is_asked_for():
    compiled = set(re.findall(r"-m(avx\w+|fma|bmi\w*|sse[\w.]+)", (SIMULATION / "CMakeLists.txt").read_text()))
    asked = set(re.findall(r'__builtin_cpu_supports\("([\w.]+)"\)',
                           (SIMULATION / "reduced" / "batch_stepper.cpp").read_text()))
    assert compiled == asked
    assert "avx512f" in compiled
