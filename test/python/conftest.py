"""One robot and one simulation for all tests, a folder of the test's own, and a small repertoire."""
import os
import subprocess

import pytest

import hexapod_repertoire as hr

PAPER = {"end_pose": "after_gait", "limit_velocity": False}


@pytest.fixture(scope="session")
def robot():
    return hr.load_robot()


@pytest.fixture(scope="session")
def simulation(robot):
    return hr.Simulation(robot, **PAPER)


def evolved_by_program(file, *options):
    """A repertoire of the program evolve: the paper's preset, seed 3, neither verified nor tried."""
    subprocess.run([os.environ["EVOLVE"], "--file", str(file), "--preset", "paper", "--seed", "3",
                    "--resimulate", "false", "--verify_with_ode", "false", *options],
                   check=True, stdout=subprocess.DEVNULL)
    return file


@pytest.fixture(scope="session")
def gaits(tmp_path_factory):
    """550 candidates."""
    return evolved_by_program(tmp_path_factory.mktemp("gaits") / "gaits.db", "--evaluations", "550")


@pytest.fixture(scope="session")
def continuous_gaits(tmp_path_factory):
    """250 candidates of 253 levels."""
    return evolved_by_program(tmp_path_factory.mktemp("continuous") / "gaits.db",
                              "--evaluations", "250", "--gene_levels", "253")
