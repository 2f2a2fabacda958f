"""What a robot's wires and joints are judged to be, from made readings: each fault is named."""
import math
import pathlib
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "src"))
from hexapod_repertoire import joint_check, preflight  # noqa: E402

ROBOT = {"legs": [
    {"name": "left",
     "joints": [{"name": "hip_l", "signal": 1, "amplitude_rad": 0.4, "foot": "(-5 0 0) .. (5 0 0)"},
                {"name": "knee_l", "signal": 2, "amplitude_rad": -0.8,
                 "foot": "(0 0 -3) .. (0 0 3)"}]},
    {"name": "right",
     "joints": [{"name": "hip_r", "signal": 1, "amplitude_rad": 0.4, "foot": "(5 0 0) .. (-5 0 0)"},
                {"name": "knee_r", "signal": 2, "amplitude_rad": 0.0,
                 "foot": "(0 0 0) .. (0 0 0)"}]}]}
JOINTS = ("hip_l", "knee_l")


def swings(**changed):
    return {**dict.fromkeys(("hip_l", "knee_l", "hip_r", "knee_r"), 0.0), **changed}


def test_every_joint_that_takes_part_in_the_gait_is_moved_alone():
    tried = joint_check.movements(ROBOT)
    assert [(m.leg, m.joint) for m in tried] == [
        ("left", "hip_l"), ("left", "knee_l"), ("right", "hip_r")]
    assert [m.genome for m in tried] == [(2, 0, 0, 0, 0, 0, 0, 0), (0, 0, 2, 0, 0, 0, 0, 0),
                                         (0, 0, 0, 0, 2, 0, 0, 0)]
    assert tried[1].swings_rad == swings(knee_l=0.8)
    assert "left, knee_l alone: watch the foot go (0 0 -3) .. (0 0 3) cm" in (
        joint_check.sentence(tried[1]))


@pytest.mark.parametrize("measured, told", [
    (swings(hip_l=0.4), None),
    (swings(hip_l=0.36, knee_l=0.02), None),
    (swings(), "hip_l did not move (0 of 23 degrees)"),
    (swings(hip_l=0.2), "hip_l moved too little (11 of 23 degrees)"),
    (swings(hip_l=0.8), "hip_l moved too far (46 of 23 degrees)"),
    (swings(hip_l=math.nan), "hip_l is not read"),
    (swings(hip_l=0.4, hip_r=0.4), "hip_r moved by 23 degrees and should not have"),
    (swings(hip_l=0.4, hip_r=math.nan), None),
])
def test_a_joint_is_judged_by_how_far_every_joint_swung(measured, told):
    problems = joint_check.judge(joint_check.movements(ROBOT)[0], measured)
    assert problems == [] if told is None else told in "\n".join(problems)


def test_exchanged_servos_are_told_as_two_things():
    problems = joint_check.judge(joint_check.movements(ROBOT)[0], swings(hip_r=0.4))
    assert len(problems) == 2
    assert "hip_l did not move" in problems[0] and "hip_r moved" in problems[1]


GOOD, GIVING_WAY = swings(hip_l=0.4), swings(hip_l=0.4, knee_l=0.2)


@pytest.mark.parametrize("plays, number, is_wrong, is_read", [
    ([(True, GOOD)], 1, False, True),
    ([(True, GIVING_WAY), (True, GOOD)], 2, False, True),
    ([(False, GOOD), (False, GIVING_WAY), (True, GOOD)], 3, False, True),
    ([(True, GIVING_WAY)] * 3, 3, True, True),
    ([(False, GOOD)] * 3, 3, False, True),
    ([(False, {}), (True, {})], 2, False, False),
])
def test_only_what_is_wrong_in_every_try_is_a_fault(plays, number, is_wrong, is_read):
    left = iter(plays)
    problems, read = joint_check.try_out(joint_check.movements(ROBOT)[0], lambda: next(left))
    assert (bool(problems), read) == (is_wrong, is_read)
    assert len(list(left)) == len(plays) - number


def test_results_of_nobody_who_looked_are_no_swings():
    assert not joint_check.swings(JOINTS, [], [])
    assert joint_check.swings(JOINTS, [-0.1, 0.0], [0.3, 0.0]) == pytest.approx(
        {"hip_l": 0.4, "knee_l": 0.0})


def readings(rate_hz=20.0, publisher="/driver", names=JOINTS, age_s=0.002, positions=(0.1, 0.2)):
    return [preflight.Reading(i / rate_hz, age_s, publisher, tuple(names), tuple(positions))
            for i in range(int(2.0 * rate_hz))]


def verdicts(findings):
    return {finding.subject: (finding.verdict, finding.text) for finding in findings}


def test_a_good_driver_has_nothing_wrong():
    findings = preflight.judge_joints(readings(), JOINTS, 2.0, 0.5)
    assert preflight.first_problem(findings) is None
    assert verdicts(findings)["rate"] == (preflight.OK, "20 Hz for hip_l, the slowest")


def test_drivers_per_leg_are_one_robot():
    per_leg = readings(names=("hip_l",), positions=(0.1,), publisher="/a") + readings(
        names=("knee_l",), positions=(0.1,), publisher="/b")
    assert preflight.first_problem(preflight.judge_joints(per_leg, JOINTS, 2.0, 0.5)) is None


@pytest.mark.parametrize("heard, subject, told", [
    ([], "joint_states", "nothing came"),
    (readings(names=("hip_l", "other")), "names", "nobody tells knee_l; told are also other"),
    (readings() + readings(publisher="/gui"), "publishers", "/driver, /gui all tell hip_l, knee_l"),
    (readings(rate_hz=1.0), "rate", "1 Hz for hip_l, the slowest: too seldom for "
     "feedback_timeout_s: 0.5"),
    (readings(positions=(0.1,)), "positions", "2 names and 1 positions"),
    (readings(positions=(0.1, math.nan)), "positions", "knee_l is at nan"),
    (readings(age_s=3600.0), "stamps", "3600.0 s old"),
    (readings(age_s=-7.0), "stamps", "7.0 s ahead"),
])
def test_what_is_wrong_is_named(heard, subject, told):
    findings = preflight.judge_joints(heard, JOINTS, 2.0, 0.5)
    assert verdicts(findings)[subject][0] == preflight.PROBLEM
    assert told in verdicts(findings)[subject][1]
    assert preflight.first_problem(findings) is not None


def test_a_robot_without_feedback_is_told_what_that_means():
    finding, = preflight.judge_joints([], JOINTS, 2.0, 0.0)
    assert finding.verdict == preflight.WARNING and "feedback_timeout_s: 0" in finding.text


def test_no_stamps_are_worth_a_look():
    findings = preflight.judge_joints(readings(age_s=math.nan), JOINTS, 2.0, 0.5)
    assert verdicts(findings)["stamps"][0] == preflight.WARNING


@pytest.mark.parametrize("topics, verdict, told", [
    ({"/joint_command": ["/driver"]}, preflight.OK, "/driver listens to /joint_command"),
    ({"/joint_command": []}, preflight.PROBLEM, "nobody listens to /joint_command"),
    ({"/leg_1": ["/a"], "/leg_2": []}, preflight.PROBLEM, "nobody listens to /leg_2"),
    ({}, preflight.PROBLEM, "no topic"),
])
def test_commands_need_a_listener_each(topics, verdict, told):
    finding, = preflight.judge_listeners(topics)
    assert finding.verdict == verdict
    assert told in finding.text


def test_a_slow_usb_timer_is_told_with_its_cure(tmp_path):
    for name, ms in (("ttyUSB0", 16), ("ttyUSB1", 1)):
        (tmp_path / name).mkdir()
        (tmp_path / name / "latency_timer").write_text(f"{ms}\n")
    timers = preflight.usb_timers(tmp_path)
    assert timers == {"ttyUSB0": 16, "ttyUSB1": 1}
    finding, = preflight.judge_timers(timers)
    assert "ttyUSB0 waits 16 ms" in finding.text and "latency_timer" in finding.text
