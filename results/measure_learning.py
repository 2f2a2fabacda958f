#!/usr/bin/env python3
"""Learns with BR-Evolution and MAP-Elites for equal times: results/learning.md, by the clock.

    results/measure_learning.py --programs <folder of evolve and assess_repertoire>

A budget is processor time of the whole session, checks and file included, with one thread: twice
the seconds that two cores have. How many candidates that is, is found with seeds that are not
reported. Every session is a line of results/learning_sessions.csv and is not learned again: more
seeds add to those that are there. Delete the file where a change moves what is learned.
"""
import argparse
import concurrent.futures
import csv
import dataclasses
import os
import pathlib
import re
import sqlite3
import statistics
import subprocess
import tempfile
import threading

from measure import HERE, machine, write_tables

SESSIONS = HERE / "learning_sessions.csv"
PILOT_SEED = 101
STEADIEST = ["--max_spread_m", "0.000001", "--max_spread_rad", "0.000001",
             "--least_entries", "500", "--test_chain", "0"]
LEARNERS = [("br_evolution", []), ("map_elites", ["--cell_m", "0.03"])]


@dataclasses.dataclass(frozen=True)
class Session:
    """A finished session; its fields are the columns of SESSIONS. Lengths in cm and mm, angles in
    degrees. *Chained*: one after another, from the expected end pose, median and p90."""
    budget_s: int
    learner: str
    candidates: int
    seed: int
    cpu_s: float
    entries: int
    sparseness_cm: float
    error_deg: float
    steadiest_mm: float  # the 500 steadiest entries chained where they were learned
    steadiest_p90_mm: float
    steadiest_deg: float
    steadiest_p90_deg: float
    learned_mm: float  # those that a planner uses, chained where they were learned
    learned_p90_mm: float
    learned_deg: float
    learned_p90_deg: float
    test_mm: float  # the same in the test set
    test_p90_mm: float
    test_deg: float
    test_p90_deg: float
    test_behaviors: int
    test_failures: int


COLUMNS = [field.name for field in dataclasses.fields(Session)]
# Medians over the seeds of these make the table.
CHAINED = ["steadiest", "learned", "test"]


class Sessions:
    """Those of SESSIONS, and what is added to them."""

    def __init__(self):
        self._lock = threading.Lock()
        self.all = []
        if SESSIONS.exists():
            with open(SESSIONS, encoding="utf-8", newline="") as file:
                for row in csv.DictReader(file):
                    self.all.append(Session(**{field.name: field.type(row[field.name])
                                               for field in dataclasses.fields(Session)}))

    def of(self, budget_s, learner):
        """The sessions of a budget and a learner."""
        return [one for one in self.all if (one.budget_s, one.learner) == (budget_s, learner)]

    def add(self, one):
        """Keeps a session."""
        with self._lock:
            self.all.append(one)
            self.all.sort(key=lambda each: (each.budget_s, each.learner, each.seed))
            with open(SESSIONS, "w", encoding="utf-8", newline="") as file:
                writer = csv.writer(file, lineterminator="\n")
                writer.writerow(COLUMNS)
                writer.writerows(dataclasses.astuple(each) for each in self.all)


def run(command):
    """Output and processor time [s] of a program."""
    with subprocess.Popen([str(word) for word in command], stdout=subprocess.PIPE,
                          universal_newlines=True) as process:
        text = process.stdout.read()
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = status
    if status != 0:
        raise RuntimeError(f"{command[0]} failed: {text}")
    return text, used.ru_utime + used.ru_stime


def learn(arguments, learner, candidates, seed, file):
    """Processor time of a session."""
    name, options = learner
    _, cpu_s = run([arguments.programs / "evolve", "--file", file, "--overwrite", "--threads", 1,
                    "--algorithm", name, *options, "--evaluations", candidates, "--seed", seed])
    return round(cpu_s, 1)


def pilot(arguments, learner, candidates):
    """Processor time of sessions that are not reported, as many at a time as of those that are."""
    def one(seed):
        with tempfile.TemporaryDirectory() as folder:
            return learn(arguments, learner, candidates, seed, pathlib.Path(folder) / "pilot.db")
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        return statistics.mean(pool.map(one, range(PILOT_SEED, PILOT_SEED + arguments.jobs)))


def candidates_for(arguments, learner, cpu_s, guess):
    """How many take so much processor time, to two digits: on the line through two pilots."""
    took_s = pilot(arguments, learner, guess)
    better = int(guess * cpu_s / took_s)
    better_s = pilot(arguments, learner, better)
    per_s = (better - guess) / (better_s - took_s) if better_s != took_s else 0.0
    return int(float(f"{better + per_s * (cpu_s - better_s):.2g}"))


def chained(text, world):
    """The cells of a row of assess_repertoire's first table."""
    row = re.search(rf"^\| {world} \|(.*)\|$", text, re.MULTILINE)
    return [float(cell) for cell in row.group(1).split("|")]


def session(arguments, budget_s, learner, candidates, seed):
    """Learns and assesses."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "repertoire.db"
        cpu_s = learn(arguments, learner, candidates, seed, file)
        assess = [arguments.programs / "assess_repertoire", file, "--threads", 1]
        used, _ = run(assess)
        steadiest, _ = run([*assess, *STEADIEST])
        database = sqlite3.connect(str(file))
        entries, sparseness_m, error_rad = database.execute(
            "SELECT archive_size, sparseness_m, median_orientation_error_rad FROM history "
            "ORDER BY evaluations DESC").fetchone()
        database.close()
    test = chained(used, "test set")
    return Session(budget_s, learner[0], candidates, seed, cpu_s, entries,
                   round(100 * sparseness_m, 3), round(57.29578 * error_rad, 3),
                   *chained(steadiest, "as learned")[:4], *chained(used, "as learned")[:4],
                   *test[:4], int(test[4]), int(test[5]))


def line(sessions):
    """A row of medians; failures are a sum."""
    def median(name):
        return statistics.median(getattr(one, name) for one in sessions)

    def misses(of):
        return (f"{median(of + '_mm'):.1f} mm, {median(of + '_deg'):.2f} deg | "
                f"{median(of + '_p90_mm'):.1f} mm, {median(of + '_p90_deg'):.2f} deg")
    one = sessions[0]
    return (f"| {one.budget_s} s, {len(sessions)} seeds | {one.learner} | {median('cpu_s'):.0f} | "
            f"{one.candidates} | {median('entries'):.0f} | {median('sparseness_cm'):.2f} | "
            f"{median('error_deg'):.2f} | " + " | ".join(misses(of) for of in CHAINED) +
            f" | {sum(each.test_failures for each in sessions)} of "
            f"{sum(each.test_behaviors for each in sessions)} |")


def measure(arguments, sessions, budget_s, seeds, learner):
    """Adds the sessions that are missing."""
    known = sessions.of(budget_s, learner[0])
    candidates = known[0].candidates if known else None
    if not candidates:
        shorter = [one for one in sessions.all
                   if one.learner == learner[0] and one.budget_s < budget_s]
        guess = (int(shorter[-1].candidates * budget_s / shorter[-1].budget_s) if shorter
                 else arguments.pilot_candidates)
        candidates = candidates_for(arguments, learner, 2.0 * budget_s, guess)
    missing = set(range(1, seeds + 1)) - {one.seed for one in known}

    def add(seed):
        one = session(arguments, budget_s, learner, candidates, seed)
        sessions.add(one)
        print(line([one]), flush=True)

    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        list(pool.map(add, sorted(missing)))


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--programs", type=pathlib.Path, required=True)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--budgets", nargs="+", default=["15:10", "60:10"],
                        help="seconds on two cores, and how many seeds")
    parser.add_argument("--pilot-candidates", type=int, default=20000)
    parser.add_argument("--remark", default="", help="what else is to be known of the machine")
    arguments = parser.parse_args()
    sessions = Sessions()
    for budget in arguments.budgets:
        for learner in LEARNERS:
            measure(arguments, sessions, *map(int, budget.split(":")), learner)
    lines = ["| budget | learner | CPU [s] | candidates | entries | sparseness [cm] | orientation "
             "error in the region [deg] | the 500 steadiest chained where learned: median | p90 | "
             "those that a planner uses: median | p90 | these in the test set: median | p90 | "
             "failures there |", "|" + "---|" * 14]
    for budget_s in sorted({one.budget_s for one in sessions.all}):
        lines += [line(sessions.of(budget_s, name)) for name, _ in LEARNERS
                  if sessions.of(budget_s, name)]
    write_tables("By the clock", [*lines, "", machine(arguments)])


if __name__ == "__main__":
    main()
