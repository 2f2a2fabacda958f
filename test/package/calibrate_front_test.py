"""The front of calibrate: what needs no robot goes to the program, and the picture is drawn."""
import json
import stat

import pytest

from hexapod_repertoire import calibrate

PARAMETERS = [{"name": name, "value": 0.9, "low": 0.8, "high": 1.0, "truth": truth}
              for name, truth in (("friction_scale", 0.85), ("mass_scale", None),
                                  ("slope_x_rad", None), ("slope_y_rad", None))]
DATA = {"robot": "r", "parameters": PARAMETERS,
        "trials": [{"check": False, "before": [0.01, 0.02, 0.03], "after": [0.001, 0.0, 0.0]},
                   {"check": True, "before": None, "after": [0.0, 0.002, -0.01]}]}


@pytest.fixture(name="program")
def fixture_program(tmp_path):
    """Leaves its arguments, and the data of a picture where --output says tmp_path/out."""
    (tmp_path / "data.json").write_text(json.dumps(DATA))
    path = tmp_path / "calibrate"
    path.write_text(f'#!/bin/sh\necho "$@" > {tmp_path}/said\n'
                    f'cp {tmp_path}/data.json {tmp_path}/out.json\n')
    path.chmod(path.stat().st_mode | stat.S_IEXEC)
    return str(path)


@pytest.mark.parametrize("words", [["--simulated", "gain: 0.9"], ["--draws=3"], ["--help"],
                                   ["trials:=a.csv"], ["--plan", "p.csv"]])
def test_what_needs_no_robot_goes_to_the_program(tmp_path, program, words):
    output = str(tmp_path / "out")
    assert calibrate.main([program, *words, "--output", output, "--base_frame", "base"]) == 0
    assert (tmp_path / "said").read_text().split() == " ".join([*words, "--output", output]).split()
    assert (tmp_path / "out.png").stat().st_size > 5000
    assert not (tmp_path / "out.json").exists()


def test_an_old_picture_is_not_drawn_again(tmp_path):
    (tmp_path / "out.json").write_text(json.dumps(DATA))
    assert calibrate.main(["false", "--draws", "3", "--output", str(tmp_path / "out")]) == 1
    assert not (tmp_path / "out.png").exists()


def test_without_a_session_it_says_what_to_do(tmp_path, program, monkeypatch, capsys):
    pytest.importorskip("rospy")
    monkeypatch.setenv("ROS_MASTER_URI", "http://127.0.0.1:1")
    pytest.importorskip("hexapod_repertoire.msg")
    assert calibrate.main([program, "--file", "a.db", "--output", str(tmp_path / "x")]) == 1
    assert "./run walk" in capsys.readouterr().err
