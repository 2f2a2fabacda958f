"""The program assess_repertoire, from outside."""
import os
import re
import subprocess

import pytest

EVOLVE = os.environ.get("EVOLVE", "")
ASSESS = os.environ.get("ASSESS", "")

pytestmark = pytest.mark.skipif(not ASSESS, reason="ASSESS does not name the program")


def assess(*words):
    """Runs the program to its end."""
    return subprocess.run([ASSESS, *map(str, words)], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, universal_newlines=True, check=False)


@pytest.fixture(scope="module", name="repertoire")
def fixture_repertoire(tmp_path_factory):
    """Some hundred candidates of the default preset."""
    file = tmp_path_factory.mktemp("assess") / "a.db"
    subprocess.run([EVOLVE, "--file", str(file), "--evaluations", "400", "--verify_with_ode",
                    "false", "--resimulate", "false"], check=True, stdout=subprocess.DEVNULL)
    return file


def rows(text):
    """Cells of the tables' rows by the first one."""
    lines = [[cell.strip() for cell in line.strip("|").split("|")]
             for line in text.splitlines() if line.startswith("| ")]
    return {cells[0]: cells[1:] for cells in lines}


def test_it_chains_in_the_learned_world_and_in_those_of_the_test_set(repertoire):
    done = assess(repertoire, "--chain", 40, "--test_chain", 10)
    assert done.returncode == 0, done.stderr
    found = rows(done.stdout)
    learned, tests = found["as learned"], found["test set"]
    assert learned[4] == "40" and tests[4] == "200"
    assert float(learned[0]) < float(tests[0]) <= float(tests[1])
    worlds = [name for name in found if re.match(r"\d+: friction ", name)]
    assert len(worlds) == 20
    assert sum(int(found[name][5]) for name in worlds) == int(tests[5])


def test_it_plays_from_the_stand_where_one_thing_differs(repertoire):
    found = rows(assess(repertoire, "--chain", 1, "--test_chain", 0).stdout)
    assert "test set" not in found
    assert float(found["5 ms step"][4]) > 0.0
    assert float(found["torque -20 %"][1]) > 0.0
    assert int(found["as expected"][0]) == int(found["nominal"][0]) + int(found["nominal"][6])


def test_equal_calls_tell_the_same_and_wrong_ones_what_to_do(repertoire):
    words = [repertoire, "--chain", 20, "--test_chain", 10]
    assert assess(*words).stdout == assess(*words, "--threads", 1).stdout
    assert "usage:" in assess().stderr
    wrong = assess(repertoire, "--chains", 3)
    assert wrong.returncode == 1 and "chains" in wrong.stderr
    missing = assess(str(repertoire) + "x")
    assert missing.returncode == 1 and str(repertoire) in missing.stderr
