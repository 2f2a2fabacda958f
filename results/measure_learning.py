#!/usr/bin/env python3
"""Learns with BR-Evolution and MAP-Elites for equal times: results/learning.md, by the clock.

    results/measure_learning.py --programs <folder of evolve and assess_repertoire>

A budget is processor time of the whole session, checks and file included, with one thread: twice
the seconds that two cores have. How many candidates that is, is found with a seed that is not
reported. Repertoires are kept below --work and are not learned again; delete them to start afresh.
"""
import argparse
import concurrent.futures
import dataclasses
import os
import pathlib
import re
import sqlite3
import statistics
import subprocess

from measure import machine, write_tables

PILOT_SEED = 101
LEARNERS = [("br_evolution", []), ("map_elites", ["--cell_m", "0.03"])]


@dataclasses.dataclass(frozen=True)
class Session:
    """A finished session: lengths in cm and mm, angles in degrees."""
    cpu_s: float
    evaluations: int
    entries: int
    sparseness_cm: float
    error_deg: float
    steady: tuple  # chained where learned, median and p90 [mm], median and p90 [deg]
    test: tuple    # the same in the test set, then behaviours and failures


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


def learn(arguments, learner, evaluations, seed):
    """The file of a session and its processor time."""
    name, options = learner
    file = arguments.work / f"{name}_{evaluations}_{seed}.db"
    cpu = file.with_suffix(".cpu")
    if not cpu.exists():
        _, cpu_s = run([arguments.programs / "evolve", "--file", file, "--overwrite", "--threads", 1,
                        "--algorithm", name, *options, "--evaluations", evaluations, "--seed",
                        seed])
        cpu.write_text(str(cpu_s), encoding="utf-8")
    return file, float(cpu.read_text(encoding="utf-8"))


def evaluations_for(arguments, learner, cpu_s):
    """Candidates that take so much processor time, to two digits, after so many pilots."""
    evaluations = arguments.pilot_evaluations
    for _ in range(arguments.pilots):
        _, took_s = learn(arguments, learner, evaluations, PILOT_SEED)
        evaluations = int(float(f"{evaluations * cpu_s / took_s:.2g}"))
        if abs(took_s / cpu_s - 1) < 0.05:
            break
    return evaluations


def chained(text, world):
    """The cells of a row of assess_repertoire's first table."""
    row = re.search(rf"^\| {world} \|(.*)\|$", text, re.MULTILINE)
    return tuple(float(cell) for cell in row.group(1).split("|"))


def session(arguments, learner, evaluations, seed):
    """Learns and assesses."""
    file, cpu_s = learn(arguments, learner, evaluations, seed)
    told = file.with_suffix(".assessment")
    if not told.exists():
        text, _ = run([arguments.programs / "assess_repertoire", file, "--threads", 1])
        told.write_text(text, encoding="utf-8")
    text = told.read_text(encoding="utf-8")
    database = sqlite3.connect(str(file))
    row = database.execute("SELECT archive_size, sparseness_m, median_orientation_error_rad FROM "
                           "history ORDER BY evaluations DESC").fetchone()
    database.close()
    return Session(cpu_s, evaluations, row[0], 100 * row[1], 57.29578 * row[2],
                   chained(text, "as learned"), chained(text, "test set"))


def line(budget_s, learner, sessions):
    """A row of medians; failures are a sum."""
    def median(value):
        return statistics.median(value(one) for one in sessions)

    def misses(of):
        values = [median(lambda one, i=i: of(one)[i]) for i in range(4)]
        return (f"{values[0]:.1f} mm, {values[2]:.2f} deg | {values[1]:.1f} mm, "
                f"{values[3]:.2f} deg")
    behaviors = sum(one.test[4] for one in sessions)
    return (f"| {budget_s} s, {len(sessions)} seeds | {learner} | {median(lambda one: one.cpu_s):.0f} | "
            f"{sessions[0].evaluations} | {median(lambda one: one.entries):.0f} | "
            f"{median(lambda one: one.sparseness_cm):.2f} | {median(lambda one: one.error_deg):.2f} | "
            f"{misses(lambda one: one.steady)} | {misses(lambda one: one.test)} | "
            f"{sum(one.test[5] for one in sessions):.0f} of {behaviors:.0f} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--programs", type=pathlib.Path, required=True)
    parser.add_argument("--work", type=pathlib.Path, default=pathlib.Path("/tmp/hexapod_learning"))
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--budgets", nargs="+", default=["15:10", "60:10"],
                        help="seconds on two cores, and how many seeds")
    parser.add_argument("--pilots", type=int, default=2)
    parser.add_argument("--pilot-evaluations", type=int, default=20000)
    parser.add_argument("--remark", default="", help="what else is to be known of the machine")
    arguments = parser.parse_args()
    arguments.work.mkdir(parents=True, exist_ok=True)
    lines = ["| budget | learner | CPU [s] | candidates | entries | sparseness [cm] | orientation "
             "error in the region [deg] | chained where learned: median | p90 | chained in the test "
             "set: median | p90 | failures there |", "|" + "---|" * 12]
    for budget in arguments.budgets:
        budget_s, seeds = map(int, budget.split(":"))
        for learner in LEARNERS:
            evaluations = evaluations_for(arguments, learner, 2.0 * budget_s)
            with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
                sessions = list(pool.map(
                    lambda seed, learner=learner, evaluations=evaluations:
                    session(arguments, learner, evaluations, seed), range(1, seeds + 1)))
            lines.append(line(budget_s, learner[0], sessions))
            print(lines[-1], flush=True)
    write_tables("By the clock", [*lines, "", machine(arguments)])


if __name__ == "__main__":
    main()
