"""rviz's configurations in other frames."""
import pathlib

import pytest
import yaml

pytest.importorskip("rospy")
# pylint: disable=wrong-import-position
from hexapod_repertoire import rviz_config

FILES = sorted((pathlib.Path(__file__).resolve().parents[2] / "rviz").glob("*.rviz"))


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.name)
def test_no_frame_of_a_shipped_file_is_left_when_all_are_given(file):
    config = yaml.safe_load(file.read_text(encoding="utf-8"))
    other = rviz_config.in_frames(config, "a/odom", "a/feet", "a")
    manager = other["Visualization Manager"]
    assert manager["Global Options"]["Fixed Frame"] == "a/odom"
    models = [display for display in manager["Displays"] if display["Class"] == "rviz/RobotModel"]
    assert models and all(model["TF Prefix"] == "a" for model in models)
    assert manager["Views"]["Current"]["Target Frame"] in ("a/feet", rviz_config.FIXED)
    frames = [value for display in manager["Displays"] for key, value in display.items()
              if key.endswith("Frame")]
    assert set(frames) <= {rviz_config.FIXED}


def test_what_is_not_given_stays_and_the_file_is_written_where_the_node_is_named(tmp_path,
                                                                                 monkeypatch):
    monkeypatch.setenv("ROS_HOME", str(tmp_path / "home"))
    config = yaml.safe_load(FILES[-1].read_text(encoding="utf-8"))
    assert rviz_config.in_frames(config, "", "", "") == config
    file = rviz_config.written(config, "/left/rviz")
    assert file == tmp_path / "home" / "hexapod_left_rviz.rviz"
    assert yaml.safe_load(file.read_text(encoding="utf-8")) == config
