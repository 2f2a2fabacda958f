"""Ask and tell from Python."""
import numpy as np
import pytest

import hexapod_repertoire as hr
from conftest import PAPER


def evolved(robot, simulation, name, evaluations, **options):
    algorithm = hr.Algorithm(name, robot, **options)
    while algorithm.evaluations < evaluations:
        algorithm.tell(simulation.play(algorithm.ask(evaluations - algorithm.evaluations)))
    return algorithm


def test_the_same_run_as_the_programs(robot, simulation, gaits):
    repertoire = hr.load(gaits)
    algorithm = evolved(robot, simulation, "br_evolution", 550, seed=3)
    by_id = np.argsort(algorithm.entries["id"])
    assert len(algorithm) == len(repertoire) > 40
    assert np.array_equal(algorithm.genomes[by_id], repertoire.genomes)
    for field in ("id", "x_m", "y_m", "yaw_rad", "orientation_error_rad", "cost", "evaluation"):
        assert np.array_equal(algorithm.entries[field][by_id], repertoire.entries[field]), field


def test_the_same_run_as_the_programs_with_continuous_gaits(robot, continuous_gaits):
    repertoire = hr.load(continuous_gaits)
    assert repertoire.gene_levels == 253 and repertoire.genomes.max() > 9
    simulation = hr.Simulation(robot, gene_levels=253, **PAPER)
    algorithm = evolved(robot, simulation, "br_evolution", 250, seed=3, gene_levels=253)
    by_id = np.argsort(algorithm.entries["id"])
    assert np.array_equal(algorithm.genomes[by_id], repertoire.genomes)
    assert np.array_equal(algorithm.entries["x_m"][by_id], repertoire.entries["x_m"])
    with pytest.raises(ValueError, match="gene_levels is 6"):
        hr.Algorithm("map_elites", robot, gene_levels=6)


def test_continuous_gaits_have_the_five_levels_among_them(robot):
    five = np.arange(24) % 5
    assert np.array_equal(hr.commands(robot, 63 * five, gene_levels=253), hr.commands(robot, five))


@pytest.mark.parametrize("name", hr.algorithm_names())
def test_every_algorithm_keeps_what_it_was_told(robot, simulation, name):
    algorithm = evolved(robot, simulation, name, 250, seed=2, cvt_cells=100)
    assert (algorithm.evaluations, algorithm.generations) == (250, 3)
    assert len(algorithm) > 10
    outcomes = simulation.play(algorithm.genomes)
    for field in ("x_m", "y_m", "yaw_rad", "cost"):
        assert np.array_equal(algorithm.entries[field], outcomes[field])


def test_twins_are_kept_where_they_are_asked_for(robot, simulation):
    algorithm = evolved(robot, simulation, "map_elites", 100, offer_twins=True)
    candidates = len(np.unique(algorithm.entries["evaluation"]))
    assert candidates < len(algorithm)


def test_asks_the_same_until_it_is_told(robot):
    algorithm = hr.Algorithm("map_elites", robot)
    genomes = algorithm.ask(7)
    assert (genomes.shape, genomes.dtype) == ((7, 24), np.uint8)
    assert np.array_equal(algorithm.ask(), genomes)


@pytest.mark.parametrize("made, words", [
    (lambda robot: hr.Algorithm("annealing", robot), "there are br_evolution, map_elites"),
    (lambda robot: hr.Algorithm("map_elites", robot, cel_m=0.1), "did you mean 'cell_m'"),
    (lambda robot: hr.Algorithm("map_elites", robot, cell_m=-1), "found -1"),
    (lambda robot: hr.Algorithm("map_elites", robot, cell_m=[1]), "expected a number, a text"),
    (lambda robot: hr.Algorithm("map_elites", genes=8, levels=300), "300 levels"),
    (lambda robot: hr.Algorithm("map_elites", robot).tell(hr.outcomes([0], [0])), "ask first"),
])
def test_mistakes_are_value_errors_with_the_programs_sentence(robot, made, words):
    with pytest.raises(ValueError, match=words):
        made(robot)


@pytest.mark.parametrize("told, words", [
    (hr.outcomes([0.1], [0.1]), "1 outcomes for 2 genomes"),
    (np.zeros(2), "outcome_dtype.*float64"),
    (hr.outcomes([[0.1], [0.2]], [[0.1], [0.2]]), "2 dimensions"),
    (hr.outcomes([0.1, 0.2], [0.1, 0.2], verdict=9), "verdict of outcome 0 is 9"),
])
def test_wrong_answers_are_refused_and_waited_for(robot, told, words):
    algorithm = hr.Algorithm("map_elites", robot)
    algorithm.ask(2)
    with pytest.raises(ValueError, match=words):
        algorithm.tell(told)
    algorithm.tell(hr.outcomes([0.1, 0.2], [0.1, 0.2]))
    assert algorithm.evaluations == 2
