#!/usr/bin/python3
"""The robot of a running session is calibrated, through executor and tf; simulated time."""
import os
import pathlib
import subprocess
import sys

import pytest
import yaml

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import walking_session as ws  # noqa: E402

GAIN_SCALE = 0.8
PATIENCE_S = 120.0


@pytest.fixture(scope="module")
def session():
    nodes = ("repertoire_server", "simulated_robot", "executor")
    with ws.WalkingSession(real_time_factor=2.0, sim_time=True, nodes=()) as a_session:
        a_session.set_param("/simulated_robot/servo_gain_scale", GAIN_SCALE)
        for node in nodes:
            a_session.start(node)
        yield a_session


def calibrate(*words):
    return subprocess.run(
        [sys.executable, "-m", "hexapod_repertoire.calibrate", str(ws.BINARIES / "calibrate"),
         *map(str, words)],
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True, check=False,
        timeout=PATIENCE_S)


def test_finds_the_servos_of_the_robot_that_walks(session, tmp_path):
    output = pathlib.Path(tmp_path) / "mine"
    file = session.folder / "small.db"
    for _ in range(3):
        result = calibrate("--file", file, "--output", output, "--behaviors", 6, "--checks", 1,
                           "--rounds", 10)
        assert result.returncode == 0, result.stdout
        # What a busy machine makes the executor skip does the fit no good.
        if "skipped commands" not in result.stdout:
            break
    found = yaml.safe_load(output.with_suffix(".yaml").read_text(encoding="utf-8"))["calibration"]
    assert found["servo_gain_scale"] == pytest.approx(GAIN_SCALE, abs=0.06), result.stdout
    assert len(output.with_suffix(".csv").read_text(encoding="utf-8").splitlines()) == 8
    assert "| 1 behaviours not fitted |" in output.with_suffix(".md").read_text(encoding="utf-8")
    assert output.with_suffix(".png").stat().st_size > 5000


def test_says_that_the_pose_is_not_told(session, tmp_path):
    result = calibrate("--file", session.folder / "small.db", "--output", tmp_path / "mine",
                       "--behaviors", 1, "--base_frame", "nobody")
    assert result.returncode == 1
    assert "No new transform from odom to nobody" in result.stdout
