#!/usr/bin/env python3
"""Evolves from Python and with the program evolve, in turn, and writes results/python.md.

    PYTHONPATH=src:<devel>/lib/python3/dist-packages \
        results/measure_python.py --evolve <devel>/lib/hexapod_repertoire/evolve

The runs are the same, the paper's preset on one thread; each pair has a seed of its own.
"""
import argparse
import dataclasses
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import time
from typing import List

import numpy as np

import hexapod_repertoire as hr
from measure import machine

HERE = pathlib.Path(__file__).resolve().parent
RATE = re.compile(r"Done: \d+ evaluations, (\d+)/s")


@dataclasses.dataclass(frozen=True)
class Run:
    """Evaluations per second, by the clock and by the processor, and the entries' genomes by id."""

    per_wall_s: float
    per_cpu_s: float
    genomes: np.ndarray


def with_the_program(evolve: str, evaluations: int, seed: int) -> Run:
    """Its own rate is over the time spent evolving; its processor time includes its start."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "gaits.db"
        before = os.times()
        printed = subprocess.run(
            [evolve, "--file", str(file), "--preset", "paper", "--seed", str(seed), "--threads", "1",
             "--evaluations", str(evaluations), "--verify_with_ode", "false", "--resimulate",
             "false"], check=True, stdout=subprocess.PIPE, universal_newlines=True).stdout
        after = os.times()
        cpu_s = (after.children_user + after.children_system - before.children_user
                 - before.children_system)
        return Run(float(RATE.search(printed).group(1)), evaluations / cpu_s,
                   hr.load(file).genomes)


def from_python(evaluations: int, seed: int) -> Run:
    """The loop of doc/python.md, all that it takes included."""
    wall_s, cpu_s = time.perf_counter(), time.process_time()
    robot = hr.load_robot()
    simulation = hr.Simulation(robot, threads=1, end_pose="after_gait", limit_velocity=False)
    algorithm = hr.Algorithm("br_evolution", robot, seed=seed)
    while algorithm.evaluations < evaluations:
        algorithm.tell(simulation.play(algorithm.ask(evaluations - algorithm.evaluations)))
    wall_s, cpu_s = time.perf_counter() - wall_s, time.process_time() - cpu_s
    return Run(evaluations / wall_s, evaluations / cpu_s,
               algorithm.genomes[np.argsort(algorithm.entries["id"])])


def row(name: str, runs: List[Run], base: List[Run]) -> str:
    """A line of the table; ratios are medians over the pairs."""
    cells = [name]
    for rate in ("per_wall_s", "per_cpu_s"):
        ratio = statistics.median(getattr(run, rate) / getattr(other, rate)
                                  for run, other in zip(runs, base))
        cells.append(f"{statistics.median(getattr(run, rate) for run in runs):.0f}")
        cells.append(f"{ratio:.3f}")
    return "| " + " | ".join(cells) + " |"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--evolve", required=True, help="path of the program evolve")
    parser.add_argument("--evaluations", type=int, default=20000)
    parser.add_argument("--runs", type=int, default=7, help="pairs; their seeds are 1, 2 ..")
    parser.add_argument("--remark", default="", help="what else is to be said of the machine")
    arguments = parser.parse_args()
    where = machine(argparse.Namespace(jobs=1, remark=arguments.remark))
    program, python = [], []
    for seed in range(1, arguments.runs + 1):
        program.append(with_the_program(arguments.evolve, arguments.evaluations, seed))
        python.append(from_python(arguments.evaluations, seed))
        if not np.array_equal(program[-1].genomes, python[-1].genomes):
            sys.exit(f"Seed {seed}: Python found other entries than evolve.")
    (HERE / "python.md").write_text(f"""# Python beside C++

`results/measure_python.py --evaluations {arguments.evaluations} --runs {arguments.runs}`, {where}
The paper's preset on one thread, in turn with the program `evolve` and with the loop of
[doc/python.md](../doc/python.md); seeds 1 to {arguments.runs}; medians, of the ratios over the pairs. Every pair
found the same entries, to the last bit. `evolve` keeps a history and saves its file meanwhile, Python
does not.

| | evaluations per second | beside evolve | evaluations per second of CPU | beside evolve |
|---|---|---|---|---|
{row("evolve", program, program)}
{row("Python", python, program)}
""", encoding="utf-8")


if __name__ == "__main__":
    main()
