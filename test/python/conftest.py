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


@pytest.fixture(scope="session")
def gaits(tmp_path_factory):
    """A repertoire of the program evolve: the paper's preset, 550 candidates, seed 3."""
    file = tmp_path_factory.mktemp("gaits") / "gaits.db"
    subprocess.run([os.environ["EVOLVE"], "--file", str(file), "--preset", "paper", "--seed", "3",
                    "--evaluations", "550", "--resimulate", "false", "--verify_with_ode", "false"],
                   check=True, stdout=subprocess.DEVNULL)
    return file
