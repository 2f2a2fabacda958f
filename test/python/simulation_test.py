"""Simulations and repertoires from Python."""
import os
import signal
import threading

import numpy as np
import pytest

import hexapod_repertoire as hr
from conftest import PAPER


def some_genomes(count, seed=1):
    return np.random.default_rng(seed).integers(0, 5, (count, 24))


def test_outcomes_depend_on_the_genome_alone(robot, simulation):
    genomes = some_genomes(40)
    outcomes = simulation.play(genomes)
    other = hr.Simulation(robot, threads=1, cached_genomes=0, **PAPER)
    assert np.array_equal(other.play(genomes[::-1].astype(np.uint8))[::-1], outcomes)
    assert other.simulations == 40
    assert {*outcomes["verdict"]} <= {hr.WALKED, hr.FELL, hr.SELF_COLLIDED, hr.DIVERGED}
    walked = outcomes["verdict"] == hr.WALKED
    assert np.count_nonzero(walked) > 20
    assert np.all(np.hypot(outcomes["x_m"], outcomes["y_m"])[walked] > 0.0)


def test_no_genomes_have_no_outcomes(simulation):
    assert simulation.play(some_genomes(0)).shape == (0,)


def test_known_gaits_are_not_simulated_again(robot):
    simulation = hr.Simulation(robot, **PAPER)
    genomes = some_genomes(10)
    simulation.play(genomes)
    simulation.play(np.concatenate([genomes, genomes]))
    assert simulation.simulations == 10


def test_other_physics_other_outcomes(robot, simulation):
    genomes = some_genomes(10)
    physics = hr.Physics(friction_scale=0.5)
    physics.mass_scale = 1.1
    other = hr.Simulation(robot, physics, **PAPER)
    assert not np.array_equal(other.play(genomes), simulation.play(genomes))


@pytest.mark.parametrize("genomes, words", [
    (np.zeros((3, 24)), "of integers"),
    (np.zeros(24, int), "1 dimensions"),
    (np.zeros((3, 20), int), "20 genes does not fit robot hexapod"),
    (np.full((1, 24), 7), "Gene 0 is 7"),
    (np.full((1, 24), -1), "Gene 0 of genome 0 is -1"),
    (np.full((1, 24), 260), "Gene 0 of genome 0 is 260"),
])
def test_genomes_that_cannot_be_are_value_errors(simulation, genomes, words):
    with pytest.raises(ValueError, match=words):
        simulation.play(genomes)


@pytest.mark.parametrize("made, words", [
    (lambda robot: hr.Simulation(robot, treads=1), "did you mean 'threads'"),
    (lambda robot: hr.Simulation(robot, threads="2"), "a whole number"),
    (lambda robot: hr.Simulation(robot, hr.Physics(step_s=0.5)), "step_s"),
    (lambda robot: hr.Physics(weight=1.0), "no 'weight'"),
    (lambda robot: hr.load_robot("/no.urdf"), "/no.urdf"),
    (lambda robot: hr.load("/no.db"), "no such file"),
    (lambda robot: hr.commands(robot, np.zeros(20, int)), "20 genes does not fit"),
])
def test_mistakes_are_value_errors_with_the_programs_sentence(robot, made, words):
    with pytest.raises(ValueError, match=words):
        made(robot)


def test_ctrl_c_ends_it_and_other_threads_go_on_meanwhile(robot):
    simulation = hr.Simulation(robot, threads=1, **PAPER)
    begun = threading.Event()

    def press_after_a_while():
        begun.wait()
        for _ in range(1000000):  # only if play() lets other threads go on
            pass
        os.kill(os.getpid(), signal.SIGINT)

    other = threading.Thread(target=press_after_a_while)
    other.start()
    with pytest.raises(KeyboardInterrupt):
        begun.set()
        simulation.play(some_genomes(100000))
    other.join()
    assert simulation.simulations < 100000
    assert simulation.play(some_genomes(3)).shape == (3,)


def test_threads_take_turns(robot, simulation):
    genomes = some_genomes(60, seed=5)
    shared = hr.Simulation(robot, **PAPER)
    found = {}

    def play(part):
        found[part] = shared.play(genomes[part::3])

    threads = [threading.Thread(target=play, args=(part,)) for part in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    expected = simulation.play(genomes)
    for part in range(3):
        assert np.array_equal(found[part], expected[part::3])


def test_commands_begin_and_end_in_the_neutral_pose(robot):
    commands = hr.commands(robot, np.full(24, 2))
    assert commands.shape == (130, 18)  # 3 s of gait, 0.6 s back, 0.3 s of rest, each 30 ms
    assert np.array_equal(commands[-1], robot.neutral_pose)
    assert np.abs(commands - robot.neutral_pose).max() > 0.1


def test_a_repertoire_is_what_its_file_says(robot, gaits):
    repertoire = hr.load(gaits)
    assert repertoire.robot_id == robot.digest
    assert repertoire.joint_names == robot.joint_names
    assert repertoire.evaluations == 550 and repertoire.options["mutation_rate"] == "0.1"
    assert repertoire.genomes.shape == (len(repertoire), 24)
    assert np.all(np.diff(repertoire.entries["id"]) > 0)
    assert np.all(np.isnan(repertoire.entries["spread_m"]))  # it was not validated
    assert repertoire.history["archive_size"][-1] == len(repertoire)


def test_unknown_names_are_attribute_errors():
    with pytest.raises(AttributeError, match="nothing"):
        getattr(hr, "nothing")
    assert {"Simulation", "Algorithm", "load"} <= {*dir(hr)}
