#!/usr/bin/python3
"""A learner tries entries on the robot of a running session; simulated time."""
import math
import os
import sqlite3
import subprocess
import sys

import pytest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import walking_session as ws  # noqa: E402

PATIENCE_S = 120.0
TRIALS = 3
OPTIONS = {"evaluations": 900, "candidates": 100, "seed": 1, "threads": 1, "validation_trials": 2,
           "verify_with_ode": False, "resimulate": False, "exit_when_done": True,
           "transferability": True, "transferability_trials": TRIALS, "transferability_period": 2,
           "transferability_series": 2, "robot_config": str(ws.ROOT / "config/hexapod.yaml")}


@pytest.fixture(scope="module")
def session():
    nodes = ("repertoire_server", "simulated_robot", "executor")
    with ws.WalkingSession(real_time_factor=2.0, sim_time=True, nodes=()) as a_session:
        a_session.set_param("/simulated_robot/servo_gain_scale", 0.6)
        for node in nodes:
            a_session.start(node)
        ws.wait_for(is_ready, PATIENCE_S, "a robot that stands")
        yield a_session


def is_ready():
    """Whether a behaviour may be played."""
    from hexapod_repertoire.msg import ExecutorState
    told = subprocess.run(["rostopic", "echo", "-n", "1", "/executor/state/state"],
                          stdout=subprocess.PIPE, universal_newlines=True, check=True,
                          timeout=PATIENCE_S).stdout
    return told.split()[0] == str(ExecutorState.READY)


def learn(session, name):
    """Learns beside the session; (what the learner said, rows of the trials)."""
    file = session.folder / f"{name}.db"
    session.set_param(f"/{name}", {**OPTIONS, "repertoire_file": str(file)})
    result = subprocess.run(
        [str(ws.BINARIES / "learner"), f"__name:={name}"], stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT, universal_newlines=True, check=False, timeout=PATIENCE_S)
    assert result.returncode == 0, result.stdout
    with sqlite3.connect(file) as database:
        rows = database.execute(
            "SELECT evaluation, x_m, y_m, measured_x_m, measured_y_m FROM trials").fetchall()
    return result.stdout, rows


def call(service):
    answer = subprocess.run(["rosservice", "call", service], stdout=subprocess.PIPE,
                            universal_newlines=True, check=True, timeout=PATIENCE_S).stdout
    assert "success: True" in answer, answer


def test_every_trial_is_in_the_file_with_what_the_robot_did(session):
    said, rows = learn(session, "beside")
    # A series every 200 candidates.
    assert len(rows) == TRIALS and all(row[0] % 200 == 0 for row in rows), said
    shifts_m = [math.hypot(x - mx, y - my) for _, x, y, mx, my in rows]
    ways_m = [math.hypot(mx, my) for _, _, _, mx, my in rows]
    # The farthest go first, and slow servos fall short of them, but do walk.
    assert max(shifts_m) > 0.01 and min(ways_m) > 0.05, (rows, said)
    assert f"Trial {TRIALS}: entry " in said


def test_a_robot_that_is_not_armed_is_not_moved(session):
    call("/executor/disarm")
    said, rows = learn(session, "without")
    call("/executor/arm")
    assert rows == []
    assert "could not be tried on the robot: The executor is disarmed" in said, said
    assert "Done: 900 evaluations" in said
