"""rviz, on a display of its own, with the shipped files: no complaint, markers seen, goals walked to."""
import itertools
import math
import os
import pathlib
import shutil
import subprocess

import numpy as np
import pytest

rospy = pytest.importorskip("rospy")
# pylint: disable=wrong-import-position
import rosgraph
from geometry_msgs.msg import PointStamped, PoseStamped
from hexapod_repertoire.msg import Repertoire, StepReport, WalkSummary
from hexapod_repertoire.srv import GoToResponse
from visualization_msgs.msg import MarkerArray

from walking_session import BINARIES, ROOT, WalkingSession, wait_for

PATIENCE_S = 60.0
MOVE_S = 0.5  # for rviz to notice where the mouse is
CLOSE_M = 0.012
WIDTH, HEIGHT = 1280, 800
# What rviz's own package of Debian says at every start, and what has no meaning here.
NOT_OURS = ("no such package media_export", "librospack", "XDG_RUNTIME_DIR")
MISSING = [name for name in ("rviz", "Xvfb", "xdotool") if not shutil.which(name)]
# Continuous integration installs them.
pytestmark = pytest.mark.skipif(bool(MISSING) and os.environ.get("CI") != "true",
                                reason=f"not installed: {', '.join(MISSING)}")
HAS_PANEL = (BINARIES.parent / "libhexapod_panel.so").exists()
# Displays of each file, by the topics they listen to.
TOPICS = {
    "browse": {"/repertoire_markers", "/entry_markers", "/repertoire_handles/update"},
    "walk": {"/repertoire_markers", "/entry_markers", "/repertoire_handles/update",
             "/plan_markers", "/body_markers"},
}


class Screen:
    """A virtual display whose pixels can be read."""

    def __init__(self, folder):
        self._folder = pathlib.Path(folder)
        read_end, write_end = os.pipe()
        self._server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write_end), "-screen", "0", f"{WIDTH}x{HEIGHT}x24",
             "-fbdir", str(folder), "-nolisten", "tcp"], pass_fds=[write_end],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write_end)
        with os.fdopen(read_end) as number:
            self.name = ":" + number.readline().strip()

    def pixels(self):
        """Red, green and blue of each pixel, shape (height, width, 3)."""
        data = (self._folder / "Xvfb_screen0").read_bytes()
        header = np.frombuffer(data[:100], ">u4")
        begin, line = int(header[0]) + 12 * int(header[19]), int(header[12])
        rows = np.frombuffer(data, np.uint8, line * HEIGHT, begin).reshape(HEIGHT, -1, 4)
        return rows[:, :WIDTH, 2::-1].astype(int)

    def do(self, *words):
        """Moves the mouse and the keys: words for xdotool."""
        subprocess.run(["xdotool", *map(str, words)], check=True,
                       env={**os.environ, "DISPLAY": self.name})

    def close(self):
        self._server.kill()
        self._server.wait()


@pytest.fixture(scope="module", name="session")
def start_session():
    with WalkingSession(nodes=("repertoire_server", "simulated_robot", "executor", "planner",
                               "browser"), real_time_factor=4.0, sim_time=True,
                        params={"/browser/robot_config": str(ROOT / "config/hexapod.yaml"),
                                "/browser/player": "robot"}) as session:
        rospy.init_node("rviz_test", disable_signals=True)
        yield session


@pytest.fixture(name="screen")
def open_screen(tmp_path):
    screen = Screen(tmp_path)
    yield screen
    screen.close()


def with_file(name):
    """The command that starts rviz with a shipped file."""
    return ["rviz", "-d", str(ROOT / "rviz" / name)]


class Rviz:
    """rviz, started by a command, as a context."""

    def __init__(self, screen, command, folder):
        self.log = pathlib.Path(folder) / "rviz.log"
        environment = {**os.environ, "DISPLAY": screen.name, "LIBGL_ALWAYS_SOFTWARE": "1",
                       "ROS_PACKAGE_PATH": f"{ROOT}:/usr/share",
                       "CMAKE_PREFIX_PATH": str(BINARIES.parents[1])}
        with open(self.log, "wb") as log:
            self._process = subprocess.Popen(command, env=environment, stdout=log,
                                             stderr=subprocess.STDOUT)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._process.kill()
        self._process.wait()

    def complaints(self):
        """Lines of its log that say that something is wrong."""
        lines = self.log.read_text(encoding="utf-8", errors="replace").splitlines()
        return [line for line in lines if ("ERROR" in line or "Error" in line or "rror:" in line)
                and not any(words in line for words in NOT_OURS)]


def topics_of_rviz():
    """What rviz has subscribed to."""
    _, subscribers, _ = rosgraph.Master("/rviz_test").getSystemState()
    return {topic for topic, nodes in subscribers if any(node.startswith("/rviz_1") or
            node == "/rviz" for node in nodes)}


def is_green(screen):
    """Which pixels have the colour of well aligned entries, by row and column."""
    red, green, blue = np.moveaxis(screen.pixels(), 2, 0)
    return (green > red + 60) & (green > blue + 60)


def green_pixels(screen):
    """How many they are."""
    return int(is_green(screen).sum())


def is_handle(screen, x, y):
    """Has much of what is around a place the colour of a handle over the floor?"""
    red, green, blue = np.moveaxis(screen.pixels()[y - 8:y + 8, x - 8:x + 8], 2, 0)
    return ((red > 200) & (red > green + 15) & (green > blue + 8) & (blue > 120)).mean() > 0.3


def test_every_shipped_file_is_tried():
    assert {file.stem for file in (ROOT / "rviz").glob("*.rviz")} == set(TOPICS)


@pytest.mark.parametrize("name", sorted(TOPICS))
def test_a_shipped_file_starts_without_a_complaint_and_shows_the_repertoire(
        session, screen, tmp_path, name):
    assert session
    with Rviz(screen, with_file(f"{name}.rviz"), tmp_path) as rviz:
        wait_for(lambda: TOPICS[name] <= topics_of_rviz(), PATIENCE_S, f"topics of {name}")
        wait_for(lambda: green_pixels(screen) > 500, PATIENCE_S, "the repertoire on the screen")
        # The panel is one of those who listen, where it is built.
        if HAS_PANEL:
            assert "/planner/walk_summary" in topics_of_rviz()
        assert rviz.complaints() == []


def test_a_nav_goal_drawn_with_the_mouse_ends_in_a_walk(session, screen, tmp_path):
    assert session
    goals, walks = [], []
    _goals = rospy.Subscriber("move_base_simple/goal", PoseStamped, goals.append)
    _walks = rospy.Subscriber("planner/walk_summary", WalkSummary, walks.append)
    with Rviz(screen, with_file("walk.rviz"), tmp_path):
        wait_for(lambda: green_pixels(screen) > 500, PATIENCE_S, "the repertoire on the screen")
        screen.do("mousemove", 560, 42, "click", 1)  # the tool 2D Nav Goal
        screen.do("mousemove", 900, 400, "mousedown", 1, "mousemove", 905, 380,
                  "mousemove", 915, 350, "mouseup", 1)
        wait_for(lambda: goals, PATIENCE_S, "the goal")
        wait_for(lambda: walks, PATIENCE_S, "the end of the walk")
    assert walks[0].code == GoToResponse.SUCCEEDED, walks[0].message
    assert walks[0].steps > 0


def test_frames_are_parameters_of_rviz(session, screen, tmp_path, monkeypatch):
    assert session
    monkeypatch.setenv("ROS_HOME", str(tmp_path))
    rospy.set_param("/rviz_1", {"config": str(ROOT / "rviz/walk.rviz"), "fixed_frame": "odom",
                                "robot_frame": "base_link", "tf_prefix": ""})
    command = [str(BINARIES / "rviz_in_frames.py"), "__name:=rviz_1"]
    with Rviz(screen, command, tmp_path) as rviz:
        wait_for(lambda: green_pixels(screen) > 500, PATIENCE_S, "the repertoire on the screen")
        assert rviz.complaints() == []
    assert "Target Frame: base_link" in (tmp_path / "hexapod_rviz_1.rviz").read_text()


def point_at_an_entry(screen, pointed, entries):
    """Moves the mouse over the repertoire until it is close to an entry that can be played."""
    green = is_green(screen)
    places = itertools.product(range(720, 900, 3), range(200, 420, 3))
    # Most is green around there first.
    best = sorted(places, key=lambda p: -green[p[1] - 4:p[1] + 5, p[0] - 4:p[0] + 5].sum())
    for x, y in best[:400]:
        pointed.clear()
        screen.do("mousemove", x, y)
        try:
            place = wait_for(lambda: pointed, MOVE_S, "the mouse over an entry")[-1].point
        except AssertionError:
            continue
        away_m = {math.hypot(entry.executed_pose.x - place.x, entry.executed_pose.y - place.y):
                  entry.falls for entry in entries}
        if min(away_m) < CLOSE_M and away_m[min(away_m)] == 0:
            return x, y
    raise AssertionError("There is no entry below the mouse.")


@pytest.mark.skipif(not HAS_PANEL, reason="the panel is not built")
def test_the_mouse_over_an_entry_gives_it_a_handle_and_a_click_plays_it(session, screen, tmp_path):
    assert session
    repertoires, pointed, words, reports = [], [], [], []
    _repertoires = rospy.Subscriber("repertoire", Repertoire, repertoires.append)
    _pointed = rospy.Subscriber("repertoire_pointer", PointStamped, pointed.append)
    _words = rospy.Subscriber("entry_markers", MarkerArray, words.append)
    _reports = rospy.Subscriber("browser/step_report", StepReport, reports.append)
    with Rviz(screen, with_file("browse.rviz"), tmp_path):
        wait_for(lambda: green_pixels(screen) > 500, PATIENCE_S, "the repertoire on the screen")
        wait_for(lambda: repertoires, PATIENCE_S, "the repertoire")
        mouse = point_at_an_entry(screen, pointed, repertoires[0].entries)
        wait_for(lambda: is_handle(screen, *mouse), PATIENCE_S, "the handle")
        screen.do("click", 1)
        wait_for(lambda: reports, PATIENCE_S, "the end of the behaviour")
    assert any(f"entry {reports[0].entry_id}\n" in marker.text
               for array in words for marker in array.markers)
