"""Dead reckoning over behaviours: ends add up, doubts grow, what was broken off is not whole."""
import math

import pytest

from hexapod_repertoire import dead_reckoning


@pytest.fixture(name="reckoner")
def make_reckoner():
    reckoner = dead_reckoning.DeadReckoner()
    reckoner.learn({1: dead_reckoning.Promise((0.4, 0.0, 0.0), 0.01, 0.02),
                    2: dead_reckoning.Promise((0.3, 0.3, math.pi / 2), 0.01, 0.02)}, 4.0)
    return reckoner


def play(reckoner, entry, begin_s, is_whole=True, duration_s=4.0):
    reckoner.begin(entry, begin_s)
    reckoner.end(is_whole, begin_s + duration_s)


def test_ends_add_up(reckoner):
    play(reckoner, 2, 0.0)
    play(reckoner, 1, 10.0)
    assert reckoner.pose(20.0) == pytest.approx((0.3, 0.7, math.pi / 2))


def test_the_way_follows_the_arc(reckoner):
    reckoner.begin(2, 0.0)
    x_m, y_m, yaw = reckoner.pose(2.0)
    # A quarter of a circle of radius 0.3 m around (0, 0.3).
    assert math.hypot(x_m, y_m - 0.3) == pytest.approx(0.3)
    assert yaw == pytest.approx(math.pi / 4)
    assert reckoner.pose(1e9) == pytest.approx((0.3, 0.3, math.pi / 2))


@pytest.mark.parametrize("end", [(-0.4, 0.1, 0.2), (0.5, 0.0, 0.0), (0.0, 0.2, math.pi), (0, 0, 1)])
def test_all_of_a_way_is_its_end_and_none_of_it_its_start(end):
    assert dead_reckoning.part_of_way(end, 1.0) == pytest.approx(end)
    assert dead_reckoning.part_of_way(end, 0.0) == pytest.approx((0.0, 0.0, 0.0))


def test_backward_arcs_go_backward():
    x_m, _, _ = dead_reckoning.part_of_way((-0.4, 0.1, -0.4), 0.5)
    assert -0.4 < x_m < -0.1


def test_what_is_broken_off_counts_in_part_and_leaves_doubt(reckoner):
    play(reckoner, 1, 0.0)
    sure = reckoner.variance()
    assert sure.position == pytest.approx(0.01 ** 2 / 2.0)
    play(reckoner, 1, 10.0, is_whole=False, duration_s=1.0)
    assert reckoner.pose(20.0) == pytest.approx((0.5, 0.0, 0.0))
    assert reckoner.variance().position > 0.01


def test_doubt_of_the_heading_becomes_doubt_of_the_position(reckoner):
    growth = []
    for number in range(3):
        before = reckoner.variance().position
        play(reckoner, 1, 10.0 * number)
        growth.append(reckoner.variance().position - before)
    assert growth[0] < growth[1] < growth[2]


def test_what_nobody_knows_moves_nothing_and_makes_unsure(reckoner):
    play(reckoner, -1, 0.0)
    assert reckoner.pose(10.0) == pytest.approx((0.0, 0.0, 0.0))
    assert reckoner.variance().heading >= 1.0


def test_a_behaviour_whose_end_was_not_heard_is_whole_when_the_next_begins(reckoner):
    reckoner.begin(1, 0.0)
    reckoner.begin(2, 4.1)
    reckoner.end(True, 8.2)
    assert reckoner.pose(9.0) == pytest.approx((0.7, 0.3, math.pi / 2))
