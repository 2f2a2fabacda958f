"""The front of import_robot: xacro is expanded or refused, the picture is drawn."""
import json
import os
import stat

import pytest

from hexapod_repertoire import import_robot

XACRO = '<robot name="r" xmlns:xacro="http://ros.org/wiki/xacro"><xacro:leg/></robot>'
BAR = {"kind": "capsule", "radius_m": 0.02, "points": [[0, 0, 0.1], [0.1, 0, 0.02]]}
BOX = {"kind": "box", "radius_m": 0.0,
       "points": [[x, y, z] for z in (0.1, 0.2) for y in (-0.1, 0.1) for x in (-0.1, 0.1)]}
DATA = {"name": "r", "height_m": 0.15, "ready": True, "shapes": [BOX, BAR], "on_floor": ["foot"],
        "looks": [[[0, 0, 0.1], [0.1, 0, 0.1], [0, 0.1, 0.1]]]}


def program(folder, name, lines):
    """A stand-in for a program: a shell script."""
    path = folder / name
    path.write_text("#!/bin/sh\n" + lines)
    path.chmod(path.stat().st_mode | stat.S_IEXEC)
    return str(path)


@pytest.fixture(name="importer")
def fixture_importer(tmp_path):
    """Leaves its arguments, and the data of a picture where --output says ./out."""
    (tmp_path / "data.json").write_text(json.dumps(DATA))
    (tmp_path / "out").mkdir()
    return program(tmp_path, "importer",
                   f'echo "$@" > {tmp_path}/said\ncp {tmp_path}/data.json {tmp_path}/out/r.json\n')


def test_picture_is_drawn_and_its_data_gone(tmp_path, importer):
    urdf = tmp_path / "r.urdf"
    urdf.write_text("<robot/>")
    assert import_robot.main([importer, str(urdf), "--output", str(tmp_path / "out")]) == 0
    assert (tmp_path / "out" / "r.png").stat().st_size > 5000
    assert not (tmp_path / "out" / "r.json").exists()
    assert (tmp_path / "said").read_text().split()[0] == str(urdf)


def test_xacro_is_expanded_and_named_as_the_source(tmp_path, importer, monkeypatch):
    urdf = tmp_path / "r.urdf.xacro"
    urdf.write_text(XACRO)
    program(tmp_path, "xacro", 'echo "<robot/>" > "$3"\n')
    monkeypatch.setenv("PATH", str(tmp_path) + os.pathsep + os.environ["PATH"])
    assert import_robot.main([importer, str(urdf), "--output", str(tmp_path / "out")]) == 0
    said = (tmp_path / "said").read_text().split()
    assert said[0].endswith(".urdf") and said[0] != str(urdf)
    assert said[-2:] == ["--source", str(urdf)]


def test_xacro_is_expanded_without_the_program(tmp_path, importer, monkeypatch, capsys):
    urdf = tmp_path / "r.urdf.xacro"
    urdf.write_text(XACRO.replace("<xacro:leg/>", "<link name='$(arg base)'/>"))
    keep = tmp_path / "kept.urdf"
    importer = program(tmp_path, "keeper", f'/bin/cp "$1" {keep}\n')
    monkeypatch.setenv("PATH", str(tmp_path / "nowhere"))
    assert import_robot.main([importer, str(urdf), "base:=trunk"]) == 0
    assert '<link name="trunk"/>' in keep.read_text()
    urdf.write_text(XACRO)
    assert import_robot.main([importer, str(urdf)]) == 1
    assert f"{urdf} cannot be expanded: <xacro:leg" in capsys.readouterr().err


def test_xacro_that_fails_tells_its_own_words(tmp_path, importer, monkeypatch, capsys):
    urdf = tmp_path / "r.urdf.xacro"
    urdf.write_text(XACRO)
    program(tmp_path, "xacro", 'echo "unknown macro name: xacro:leg"; exit 2\n')
    monkeypatch.setenv("PATH", str(tmp_path) + os.pathsep + os.environ["PATH"])
    assert import_robot.main([importer, str(urdf)]) == 1
    assert "unknown macro name: xacro:leg" in capsys.readouterr().err
