"""What is clicked in rviz is played: the right entry, and to where it was predicted."""
import pathlib
import random

import pytest

rospy = pytest.importorskip("rospy")
# pylint: disable=wrong-import-position
from geometry_msgs.msg import PointStamped
from hexapod_repertoire.msg import ExecutorState, Repertoire, RepertoireFilter, StepReport
from hexapod_repertoire.srv import ChooseEntry, ExcludeEntry, LoadRepertoire
from sensor_msgs.msg import JointState
from visualization_msgs.msg import (InteractiveMarkerFeedback, InteractiveMarkerInit, MarkerArray)

from walking_session import ROOT, WalkingSession, wait_for

CLICKS = 20
TRIANGLES = 2  # of a disc
HANDLE_POINTS = 12  # of a hexagon of four triangles
WALL_TIMEOUT_S = 30.0


@pytest.fixture(scope="module", name="session")
def start_session():
    nodes = ("repertoire_server", "simulated_robot", "executor", "browser")
    with WalkingSession(real_time_factor=2.0, sim_time=True, nodes=nodes, validation_trials=25,
                        params={"/browser/robot_config": str(ROOT / "config/hexapod.yaml"),
                                "/browser/player": "robot"}) as session:
        rospy.init_node("browser_test", disable_signals=True)
        yield session


class Ear:
    """The messages of a topic."""

    def __init__(self, topic, message_type):
        self.messages = []
        self._subscriber = rospy.Subscriber(topic, message_type, self.messages.append,
                                            queue_size=100)

    def wait(self, condition, what):
        return wait_for(lambda: next((m for m in self.messages if condition(m)), None),
                        WALL_TIMEOUT_S, what)


def click(publisher, place, event=InteractiveMarkerFeedback.BUTTON_CLICK, menu_entry=0):
    feedback = InteractiveMarkerFeedback(
        client_id="test", marker_name="repertoire", control_name="repertoire", event_type=event,
        menu_entry_id=menu_entry, mouse_point_valid=True)
    feedback.header.frame_id = "repertoire_origin"
    feedback.mouse_point.x, feedback.mouse_point.y = place
    publisher.publish(feedback)


def expected(entry):
    return entry.executed_pose if entry.trials else entry.end_pose


@pytest.fixture(scope="module", name="clicks")
def clicks_publisher(session):
    publisher = rospy.Publisher("repertoire_handles/feedback", InteractiveMarkerFeedback,
                                queue_size=10)
    wait_for(publisher.get_num_connections, WALL_TIMEOUT_S, "the browser")
    state = Ear("executor/state", ExecutorState)
    state.wait(lambda s: s.state == ExecutorState.READY, "an executor that is ready")
    return publisher


def repertoire_of(session):
    return Ear("repertoire", Repertoire).wait(lambda _: True, "the repertoire").entries


def test_everything_is_drawn_and_can_be_clicked(session):
    entries = repertoire_of(session)
    handles = Ear("repertoire_handles/update_full", InteractiveMarkerInit).wait(
        lambda m: m.markers, "something to click")
    control = handles.markers[0].controls[0]
    assert len(control.markers[0].points) == HANDLE_POINTS * len(entries)
    assert [entry.title for entry in handles.markers[0].menu_entries] == [
        "Play it", "Look at it", "Show its gait", "Show its neighbours", "Do not use it"]
    drawn = Ear("repertoire_markers", MarkerArray).wait(lambda m: m.markers, "markers")
    assert len(drawn.markers[0].points) == TRIANGLES * 3 * len(entries)
    assert {"robot_outline", "region_of_interest", "legend", "figures"} <= {
        marker.ns for marker in drawn.markers}


def test_where_the_mouse_is_told_only_what_is_below_it_has_a_handle(session):
    entries = repertoire_of(session)
    handles = Ear("repertoire_handles/update_full", InteractiveMarkerInit)
    pointer = rospy.Publisher("repertoire_pointer", PointStamped, queue_size=10)
    wait_for(pointer.get_num_connections, WALL_TIMEOUT_S, "the browser")
    place = PointStamped()
    place.header.frame_id = "repertoire_origin"
    place.point.x, place.point.y = expected(entries[5]).x, expected(entries[5]).y
    pointer.publish(place)
    one = handles.wait(lambda m: m.markers and len(points_of(m)) == HANDLE_POINTS, "one handle")
    centre = [sum(getattr(point, axis) for point in points_of(one)[:HANDLE_POINTS]) / HANDLE_POINTS
              for axis in ("x", "y")]
    assert abs(centre[0] - place.point.x) < 0.02 and abs(centre[1] - place.point.y) < 0.02
    place.point.x = 9.0  # beside everything: the last one stays
    pointer.publish(place)
    pointer.unregister()
    handles.wait(lambda m: m.markers and len(points_of(m)) == HANDLE_POINTS * len(entries),
                 "all handles again")


def points_of(handles):
    return handles.markers[0].controls[0].markers[0].points


def test_looking_moves_nothing(session, clicks):
    commands = Ear("executor/state", ExecutorState)
    words = Ear("entry_markers", MarkerArray)
    entry = repertoire_of(session)[0]
    click(clicks, (expected(entry).x, expected(entry).y), InteractiveMarkerFeedback.MENU_SELECT, 2)
    words.wait(lambda array: any(f"entry {entry.id}\n" in marker.text for marker in array.markers),
               "the entry in words")
    assert ExecutorState.WALKING not in {state.state for state in commands.messages}


def choose(entry_id, play=False):
    rospy.wait_for_service("browser/choose", WALL_TIMEOUT_S)
    return rospy.ServiceProxy("browser/choose", ChooseEntry)(entry_id=entry_id, play=play)


def test_an_entry_is_shown_by_its_id_and_an_unknown_one_is_not(session, clicks):
    words = Ear("entry_markers", MarkerArray)
    entry = repertoire_of(session)[2]
    answer = choose(entry.id)
    assert answer.success and f"entry {entry.id}\n" in answer.message
    words.wait(lambda array: any(f"entry {entry.id}\n" in marker.text for marker in array.markers),
               "the entry in words")
    assert not choose(-5).success


def test_what_the_filter_leaves_out_is_neither_drawn_nor_clicked(session):
    drawn = Ear("repertoire_markers", MarkerArray)
    publisher = rospy.Publisher("repertoire_filter", RepertoireFilter, queue_size=1, latch=True)
    spread_m = sorted(entry.spread_m for entry in repertoire_of(session))[5]
    steady = sum(entry.spread_m <= spread_m for entry in repertoire_of(session))
    publisher.publish(max_orientation_error_rad=-1.0, max_spread_m=spread_m)
    drawn.wait(lambda array: len(array.markers[0].colors) == TRIANGLES * steady, "fewer markers")
    handles = Ear("repertoire_handles/update_full", InteractiveMarkerInit)
    handles.wait(lambda m: len(points_of(m)) == HANDLE_POINTS * steady,
                 "fewer handles")
    publisher.publish(max_orientation_error_rad=-1.0, max_spread_m=-1.0)
    everything = len(repertoire_of(session))
    drawn.wait(lambda array: len(array.markers[0].colors) == TRIANGLES * everything, "all markers again")


def right_click(clicks, entry, item):
    click(clicks, (expected(entry).x, expected(entry).y), InteractiveMarkerFeedback.MENU_SELECT, item)


def test_the_menu_shows_the_gait_and_the_neighbours(session, clicks):
    drawn = Ear("entry_markers", MarkerArray)
    entry = repertoire_of(session)[3]
    right_click(clicks, entry, 3)
    drawn.wait(lambda array: any(marker.ns == "gait" and f"entry {entry.id}:" in marker.text
                                 for marker in array.markers), "the gait")
    right_click(clicks, entry, 4)
    drawn.wait(lambda array: any("neighbours" in marker.text for marker in array.markers),
               "the neighbours")


def test_an_entry_that_is_not_to_be_used_is_gone_and_the_file_remembers(session, clicks):
    repertoire = Ear("repertoire", Repertoire)
    before = repertoire.wait(lambda _: True, "the repertoire").entries
    entry = before[4]
    right_click(clicks, entry, 5)
    repertoire.wait(lambda m: {e.id for e in before} - {e.id for e in m.entries} == {entry.id},
                    "a repertoire without the entry")
    words = rospy.ServiceProxy("repertoire_server/load", LoadRepertoire)(
        file=str(session.folder / "small.db"))
    assert "without 1" in words.message
    exclude = rospy.ServiceProxy("repertoire_server/exclude", ExcludeEntry)
    assert exclude(entry_id=entry.id, exclude=False).success
    assert len(Ear("repertoire", Repertoire).wait(
        lambda m: len(m.entries) == len(before), "all entries again").entries) == len(before)
    assert not exclude(entry_id=-7, exclude=True).success


def test_another_file_is_published_and_one_that_cannot_be_changes_nothing(session):
    rospy.wait_for_service("repertoire_server/load", WALL_TIMEOUT_S)
    load = rospy.ServiceProxy("repertoire_server/load", LoadRepertoire)
    refused = load(file="/nowhere/a.db")
    assert not refused.success and "/nowhere/a.db" in refused.message
    before = repertoire_of(session)
    answer = load(file=str(session.folder / "small.db"))
    assert answer.success and f"{len(before)} entries" in answer.message


def test_the_entry_that_was_clicked_is_executed_and_ends_as_predicted(session, clicks):
    reports = Ear("browser/step_report", StepReport)
    # What scatters by millimetres in many trials of validation is no promise of a centimetre.
    steady = sorted((entry for entry in repertoire_of(session) if entry.falls == 0),
                    key=lambda entry: entry.spread_m)[:6]
    for number, entry in enumerate(random.Random(1).choices(steady, k=CLICKS), start=1):
        click(clicks, (expected(entry).x + 0.002, expected(entry).y - 0.002))
        report = reports.wait(lambda r, n=number: r.step == n, f"the end of behaviour {number}")
        assert report.entry_id == entry.id
        assert report.xy_error_m < 0.01, f"{number}: entry {entry.id}, spread {entry.spread_m}"


def test_a_click_beside_everything_plays_nothing(session, clicks):
    words = Ear("entry_markers", MarkerArray)
    words.wait(lambda _: True, "the latched markers")
    before = len(words.messages)
    click(clicks, (5.0, 5.0))
    entry = repertoire_of(session)[1]
    click(clicks, (expected(entry).x, expected(entry).y), InteractiveMarkerFeedback.MENU_SELECT, 2)
    wait_for(lambda: len(words.messages) > before, WALL_TIMEOUT_S, "the answer to the later click")
    assert any(f"entry {entry.id}\n" in marker.text for marker in words.messages[before].markers)
