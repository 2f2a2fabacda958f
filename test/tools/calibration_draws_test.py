"""The program calibrate with robots that it draws."""
import os
import subprocess

import pytest

EVOLVE = os.environ.get("EVOLVE", "")
CALIBRATE = os.environ.get("CALIBRATE", "")

pytestmark = pytest.mark.skipif(not CALIBRATE, reason="CALIBRATE does not name the program")


@pytest.fixture(scope="module", name="repertoire")
def fixture_repertoire(tmp_path_factory):
    """Some hundred candidates of the default preset."""
    file = tmp_path_factory.mktemp("draws") / "a.db"
    subprocess.run([EVOLVE, "--file", str(file), "--evaluations", "400", "--verify_with_ode",
                    "false", "--resimulate", "false"], check=True, stdout=subprocess.DEVNULL)
    return file


def draw(repertoire, *words):
    """The rows of the table and the sentences below it."""
    command = [CALIBRATE, "--file", repertoire, "--draws", 1, "--behaviors", 5, "--checks", 4,
               "--rounds", 6]
    done = subprocess.run(list(map(str, [*command, *words])), stdout=subprocess.PIPE, check=True,
                          universal_newlines=True)
    table, sentences = done.stdout.split("\n\n")
    rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in table.splitlines()]
    return rows, sentences


def test_a_drawn_robot_is_predicted_better_once_calibrated(repertoire):
    rows, sentences = draw(repertoire)
    assert len(rows) == 3 and all(len(row) == 5 for row in rows)
    assert float(rows[2][4]) < 1.0
    assert "Chained" not in sentences


def test_what_was_learned_for_it_is_chained_in_its_world_whatever_the_threads(repertoire):
    rows, sentences = draw(repertoire, "--learn", 400)
    assert len(rows[2]) == len(rows[0]) == 8
    nominal_mm, learned_mm = (float(cell.split()[0]) for cell in rows[2][5:7])
    assert nominal_mm > 0.0 and learned_mm > 0.0
    own_mm = float(sentences.split("misses by ")[1].split()[0])
    assert float(rows[2][7]) == pytest.approx(learned_mm / own_mm, rel=0.05)
    assert draw(repertoire, "--learn", 400, "--threads", 1) == (rows, sentences)
