"""Who may include whom: the core knows no ROS, and one file knows the physics engine."""
import pathlib
import re

import pytest

SOURCE = pathlib.Path(__file__).resolve().parents[2] / "src"
ROS_STATIONS = {"ros_interface", "nodes"}
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)
ROS_HEADER = re.compile(
    r"(ros\w*|tf2?|tf2_\w+|actionlib|urdf|diagnostic_\w+|message_filters|\w+_msgs|\w+_srvs"
    r"|hexapod_repertoire)/")
# Station, and the stations it must never know.
STRANGERS = [
    ("geometry", {"robot", "gait", "simulation", "repertoire", "evolution", "planning"}),
    ("simulation", {"evolution", "evaluation", "learning", "study", "planning", "self_model",
                    "execution"}),
    ("repertoire", {"evolution", "simulation", "evaluation", "planning", "execution"}),
    ("evolution", {"simulation", "evaluation", "planning", "execution"}),
    ("transferability", {"evaluation", "learning", "study", "planning", "self_model", "execution"}),
    ("evaluation", {"learning", "study", "planning", "execution"}),
    ("learning", {"study"}),
    ("planning", {"evolution", "simulation", "evaluation", "learning", "study", "self_model"}),
    ("self_model", {"evolution", "evaluation", "learning", "study", "execution"}),
    ("calibration", {"evolution", "evaluation", "learning", "study", "execution"}),
    ("execution", {"evolution", "simulation", "evaluation", "learning", "study", "self_model"}),
    ("ros_interface/common", {"simulation", "evolution", "evaluation", "learning", "planning",
                              "execution"}),
    ("ros_interface/executor", {"simulation", "evolution", "evaluation", "learning", "planning"}),
]
# Rooms of ros_interface that every room may use.
SHARED_ROOMS = {"common", "display", "robot_client"}


def cpp_files(station):
    return [file for file in sorted((SOURCE / station).rglob("*")) if file.suffix in (".h", ".cpp")]


def includes(file):
    return INCLUDE.findall(file.read_text(encoding="utf-8"))


def core_stations():
    names = {folder.name for folder in SOURCE.iterdir() if cpp_files(folder.name)}
    return sorted(names - ROS_STATIONS)


def test_the_scan_sees_the_core():
    assert {"common", "geometry", "gait"} <= set(core_stations())


@pytest.mark.parametrize("station", core_stations())
def test_core_includes_no_ros_header(station):
    found = [f"{file.relative_to(SOURCE)}: {header}" for file in cpp_files(station)
             for header in includes(file) if ROS_HEADER.match(header)]
    assert not found, "only ros_interface and nodes may include ROS headers"


@pytest.mark.parametrize("station", core_stations())
def test_core_targets_do_not_link_catkin(station):
    text = (SOURCE / station / "CMakeLists.txt").read_text(encoding="utf-8")
    assert "catkin_LIBRARIES" not in text and "catkin_INCLUDE_DIRS" not in text


def test_one_source_file_includes_the_physics_engine():
    files = [str(file.relative_to(SOURCE)) for file in sorted(SOURCE.rglob("*"))
             if file.suffix in (".h", ".cpp") and "ode/ode.h" in includes(file)]
    assert len(files) == 1 and files[0].endswith(".cpp"), files


@pytest.mark.parametrize("station, strangers", STRANGERS)
def test_station_does_not_know_the_strangers_to_it(station, strangers):
    found = [f"{file.relative_to(SOURCE)}: {header}" for file in cpp_files(station)
             for header in includes(file) if header.split("/")[0] in strangers]
    assert not found


@pytest.mark.parametrize("room", sorted(f.name for f in (SOURCE / "ros_interface").iterdir()
                                        if f.is_dir()))
def test_a_room_of_ros_knows_no_other_but_the_shared_ones(room):
    allowed = SHARED_ROOMS | {room} if room != "common" else {room}
    found = [f"{file.relative_to(SOURCE)}: {header}" for file in cpp_files(f"ros_interface/{room}")
             for header in includes(file)
             if header.startswith("ros_interface/") and header.split("/")[1] not in allowed]
    assert not found
