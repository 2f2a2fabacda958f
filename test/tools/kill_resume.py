#!/usr/bin/env python3
"""Kills the program evolve again and again, resumes it each time, and compares what is left.

The instants are drawn from a seed: after how many of its progress lines (one per generation, and
one per validated entry), and how much later, up to --delay_s.

Example:
    kill_resume.py --evolve devel/lib/hexapod_repertoire/evolve --kills 200 \
        --evaluations 100000
"""
import argparse
import dataclasses
import pathlib
import random
import sqlite3
import subprocess
import sys
import tempfile
import time
from typing import List


@dataclasses.dataclass(frozen=True)
class Plan:
    """What is run, and how it is disturbed."""
    evolve: str
    folder: pathlib.Path
    evaluations: int
    kills: int
    most_lines: int       # at most so many progress lines between a start and the kill
    delay_s: float        # and at most so much time after the last of them
    seed: int
    options: List[str]


@dataclasses.dataclass
class Outcome:
    """What came of it."""
    kills: int = 0
    while_writing: int = 0     # a journal was left behind
    while_verifying: int = 0
    while_validating: int = 0
    before_any_line: int = 0
    equal: bool = False
    entries: int = 0


def command(plan: Plan, file: pathlib.Path, *options: str) -> List[str]:
    """The command that learns into `file`, a line per generation, saved after each."""
    return [plan.evolve, "--file", str(file), "--evaluations", str(plan.evaluations),
            "--progress_period_s", "0.0", "--checkpoint_period_s", "0.0", *plan.options, *options]


def entries(file: pathlib.Path) -> List[tuple]:
    """All rows of the table entries."""
    with sqlite3.connect(str(file)) as database:
        return database.execute("SELECT * FROM entries ORDER BY id").fetchall()


def evaluations(file: pathlib.Path) -> int:
    """How many candidates the run in the file has evaluated."""
    with sqlite3.connect(str(file)) as database:
        row = database.execute("SELECT value FROM meta WHERE key = 'evaluations'").fetchone()
    return int(row[0])


def run_and_kill(plan: Plan, file: pathlib.Path, source: random.Random, outcome: Outcome) -> bool:
    """Resumes the run and kills it; returns False when it ended before that."""
    lines_wanted = source.randint(0, plan.most_lines)
    delay_s = source.uniform(0.0, plan.delay_s)
    with subprocess.Popen(command(plan, file, "--resume"), stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, universal_newlines=True) as process:
        last = ""
        lines = 0
        while lines < lines_wanted:
            last = process.stdout.readline()
            if not last:
                break
            lines += last.startswith(("Learning: ", "Verifying: ", "Validating: "))
        if delay_s:
            time.sleep(delay_s)
        ended = process.poll() is not None or not last and lines_wanted > 0
        process.kill()
        rest = process.stdout.read()
    if process.returncode not in (0, -9):
        raise RuntimeError(f"evolve ended with {process.returncode}: {last}{rest}")
    if ended or process.returncode == 0:
        return False
    outcome.kills += 1
    outcome.before_any_line += lines_wanted == 0
    outcome.while_verifying += "Verifying" in last + rest
    outcome.while_validating += "Validating" in last + rest
    journal = pathlib.Path(str(file) + "-journal")
    outcome.while_writing += journal.exists() and journal.stat().st_size > 0
    return True


def disturb(plan: Plan) -> Outcome:
    """Learns twice, undisturbed and killed plan.kills times, and compares the entries."""
    whole = plan.folder / "undisturbed.db"
    killed = plan.folder / "killed.db"
    subprocess.run(command(plan, whole), check=True, stdout=subprocess.DEVNULL)
    outcome = Outcome()
    source = random.Random(plan.seed)
    while outcome.kills < plan.kills and run_and_kill(plan, killed, source, outcome):
        pass
    subprocess.run(command(plan, killed, "--resume"), check=True, stdout=subprocess.DEVNULL)
    expected = entries(whole)
    outcome.entries = len(expected)
    outcome.equal = entries(killed) == expected
    return outcome


def main() -> int:
    """Runs with the options of the command line; those after -- go to evolve."""
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--evolve", required=True, help="path of the program evolve")
    parser.add_argument("--kills", type=int, default=200)
    parser.add_argument("--evaluations", type=int, default=100000)
    parser.add_argument("--most_lines", type=int, default=8)
    parser.add_argument("--delay_s", type=float, default=0.1)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("options", nargs="*", help="further options of evolve, after --")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        plan = Plan(given.evolve, pathlib.Path(folder), given.evaluations, given.kills,
                    given.most_lines, given.delay_s, given.seed, given.options)
        outcome = disturb(plan)
    print(outcome)
    return 0 if outcome.equal and outcome.kills == given.kills else 1


if __name__ == "__main__":
    sys.exit(main())
