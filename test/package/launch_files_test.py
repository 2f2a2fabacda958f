"""Every shipped launch file loads with its defaults, and says what its arguments mean."""
import pathlib
import xml.etree.ElementTree as ElementTree

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
FILES = sorted((ROOT / "launch").glob("*.launch"))
GLOBAL_BY_NATURE = {"/use_sim_time"}
each_launch_file = pytest.mark.parametrize("file", FILES, ids=lambda file: file.name)


def test_there_is_a_launch_file_for_every_verb_that_launches():
    assert {"demo.launch", "learn.launch", "walk.launch", "view.launch"} <= {
        file.name for file in FILES}


@each_launch_file
def test_every_argument_has_a_doc(file):
    arguments = ElementTree.parse(file).getroot().findall("arg")
    undocumented = [arg.get("name") for arg in arguments if not arg.get("doc")]
    assert not undocumented, f"{file.name}: <arg> without doc"


@each_launch_file
@pytest.mark.parametrize("rviz", ["false", "true"])
def test_launch_file_loads_and_its_nodes_have_unique_names(file, rviz):
    config = pytest.importorskip("roslaunch.config")
    names = [arg.get("name") for arg in ElementTree.parse(file).getroot().findall("arg")]
    arguments = [f"rviz:={rviz}"] if "rviz" in names else []
    # Throws on unknown arguments, missing files, broken YAML and names used twice.
    loaded = config.load_config_default([(str(file), arguments)], None, verbose=False)
    assert not loaded.config_errors
    assert loaded.nodes


@each_launch_file
def test_names_are_relative_so_that_a_namespace_works(file):
    absolute = [f"{element.tag} {value}" for element in ElementTree.parse(file).iter()
                for key in ("name", "to", "ns") for value in [element.get(key, "")]
                if value.startswith("/") and value not in GLOBAL_BY_NATURE]
    assert not absolute
