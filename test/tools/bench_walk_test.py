"""The program bench_walk, from outside."""
import os
import subprocess

import pytest

EVOLVE = os.environ.get("EVOLVE", "")
BENCH_WALK = os.environ.get("BENCH_WALK", "")

pytestmark = pytest.mark.skipif(not BENCH_WALK, reason="BENCH_WALK does not name the program")


@pytest.fixture(scope="module", name="repertoire")
def fixture_repertoire(tmp_path_factory):
    """Some thousand candidates of the default preset."""
    file = tmp_path_factory.mktemp("walk") / "a.db"
    subprocess.run([EVOLVE, "--file", str(file), "--evaluations", "4000", "--verify_with_ode",
                    "false", "--resimulate", "false"], check=True, stdout=subprocess.DEVNULL)
    return file


def walked(repertoire, *words):
    """Arrived and median distance from the predictions [mm], of each adaptation."""
    done = subprocess.run([BENCH_WALK, "--file", str(repertoire), "--goals", "3", "--bodies",
                           "gain: 0.8", *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          universal_newlines=True, check=False)
    assert done.returncode == 0, done.stderr
    rows = [[cell.strip() for cell in line.strip("|").split("|")]
            for line in done.stdout.splitlines() if line.startswith("| gain")]
    return {cells[1]: (cells[2], float(cells[8])) for cells in rows}


def test_who_is_told_the_body_knows_what_it_does_and_who_is_told_another_does_not(repertoire):
    exact = walked(repertoire, "--adaptations", "none, told")
    assert exact["told"] == ("3 of 3", 0.0)
    assert exact["none"][1] > 1.0
    about = walked(repertoire, "--adaptations", "told", "--told_error", "0.05")["told"]
    assert about[0] == "3 of 3" and about[1] > 1.0
