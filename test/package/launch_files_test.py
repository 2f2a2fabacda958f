"""Every shipped launch file loads with its defaults, and says what its arguments mean."""
import pathlib
import sys
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


def learner_params(*arguments):
    """What the learner finds on the parameter server, by the names of its options."""
    config = pytest.importorskip("roslaunch.config")
    loaded = config.load_config_default([(str(ROOT / "launch/learn.launch"), list(arguments))],
                                        None, verbose=False)
    prefix = "/learner/"
    return {name[len(prefix):]: param.value for name, param in loaded.params.items()
            if name.startswith(prefix)}


def test_arguments_of_learn_left_empty_keep_the_values_of_the_file(tmp_path):
    values = {"evaluations": 250000, "seed": 7, "threads": 3, "engine": "ode", "overwrite": True,
              "resume": False, "exit_when_done": True, "time_budget_s": 9.5,
              "check_again": True, "repertoire_file": "/data/mine.db"}
    file = tmp_path / "mine.yaml"
    file.write_text("".join(f"{name}: {str(value).lower() if isinstance(value, bool) else value}\n"
                            for name, value in values.items()))
    found = learner_params(f"config:={file}")
    assert {name: found[name] for name in values} == values
    assert learner_params(f"config:={file}", "evaluations:=500")["evaluations"] == 500


def test_a_value_that_neither_file_nor_argument_gives_is_left_to_the_learner():
    found = learner_params()
    assert found["repertoire_file"].endswith("/.ros/hexapod_repertoire.db")
    assert not {"evaluations", "seed", "threads", "engine", "resume"} & set(found)


@pytest.mark.parametrize("file", ["walk.launch", "demo.launch"])
def test_whatever_is_wrong_with_the_simulated_robot_is_an_argument(file):
    config = pytest.importorskip("roslaunch.config")
    wrong = {"body": "left_middle: limp, right_rear: missing", "friction_scale": 0.7,
             "latency_s": 0.03}
    text = "{" + ", ".join(f"{name}: '{value}'" if isinstance(value, str) else f"{name}: {value}"
                           for name, value in wrong.items()) + "}"
    loaded = config.load_config_default([(str(ROOT / "launch" / file), [f"disturbance:={text}"])],
                                        None, verbose=False)
    found = {name: loaded.params[f"/simulated_robot/{name}"].value for name in wrong}
    assert found == wrong


def test_a_file_that_is_to_be_read_and_is_not_there_is_named_before_anything_is_started(tmp_path):
    pytest.importorskip("roslaunch.arg_dump")
    sys.path.insert(0, str(ROOT / "src"))
    from hexapod_repertoire.launch_arguments import problem_with
    learn = str(ROOT / "launch" / "learn.launch")
    missing = tmp_path / "none.yaml"
    assert problem_with(learn, [f"config:={missing}"]) == (
        f"learn reads config, and there is no file {missing}.")
    missing.touch()
    assert problem_with(learn, [f"config:={missing}", "repertoire_file:=new.db"]) == ""
