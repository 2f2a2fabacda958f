#!/usr/bin/env python3
"""Learns repertoires with the programs evolve and assess_repertoire and writes tables of results.

    results/measure.py --programs <folder of the two> --jobs 2 paper default ablation

writes results/paper_preset.md, results/default_preset.md (a short budget and a long one) and
results/ablation.md. Repertoires are kept below --work and are not learned again; delete them to
start afresh.
"""
import argparse
import concurrent.futures
import dataclasses
import os
import pathlib
import platform
import re
import sqlite3
import statistics
import subprocess

HERE = pathlib.Path(__file__).resolve().parent
WORLDS = ["nominal", "5 ms step", "mu 0.7", "mu 1.1", "mass -10 %", "mass +10 %",
          "servo gain -20 %", "servo gain +20 %", "torque -20 %"]

# Name of each setting, what it changes in the default preset, and its share of the budget.
ABLATION = [
    ("default preset", [], 1),
    ("default preset, twice the candidates", [], 2),
    ("mutation rate 0.02", ["--mutation_rate", "0.02"], 1),
    ("mutation rate 0.10, the paper's", ["--mutation_rate", "0.10"], 1),
    ("without twins", ["--offer_twins", "false"], 1),
    ("parents from the population only", ["--archive_parents", "0"], 1),
    ("parents from the archive only", ["--archive_parents", "1"], 1),
    ("archive parents as drawn", ["--archive_tournament", "1"], 1),
    ("the best of 5 neighbours for archive parents", ["--archive_tournament", "5"], 1),
    ("novelty threshold stays at 0.10 m", ["--novelty_decay", "0"], 1),
    ("novelty threshold goes down with the square root", ["--novelty_decay", "0.5"], 1),
    ("one world, perfect starts", ["--perturbed_physics", "0", "--perturbed_start_states", "0"], 1),
    ("perturbed physics only", ["--perturbed_start_states", "0"], 1),
    ("start states only", ["--perturbed_physics", "0", "--screening_runs", "0"], 1),
    ("all perturbed runs at once", ["--screening_runs", "0"], 1),
    ("no handicap for first looks", ["--first_look_handicap_rad", "0"], 1),
    ("servo gains vary by 40 %", ["--servo_gain_variation", "0.4"], 1),
    ("spread counts half", ["--spread_weight_rad_per_m", "2"], 1),
    ("spread counts double", ["--spread_weight_rad_per_m", "8"], 1),
    ("swap = copy", ["--swap", "copy"], 1),
    ("diversity = crowding", ["--diversity", "crowding"], 1),
]


@dataclasses.dataclass(frozen=True)
class World:
    """A repertoire in one world: lengths in cm and mm, angles in degrees."""
    entries: float
    sparseness_cm: float
    error_deg: float
    reach_m: float
    shift_mm: float
    p90_mm: float
    failed: float


@dataclasses.dataclass(frozen=True)
class Run:
    """What came of one seed."""
    evaluations: int
    simulations: int
    seconds: float
    everything: dict  # World by name, all usable entries
    steady: dict      # of those that a planner uses
    chain: tuple      # of the steady: behaviours, failed, mm, degrees, both at p90; empty: none


def learn(programs, file, options):
    """Learns into `file` unless it holds a finished run; one thread."""
    if file.exists():
        return
    command = [programs / "evolve", "--file", file, "--threads", "1", *options]
    subprocess.run([str(word) for word in command], check=True, stdout=subprocess.DEVNULL)


def assess(programs, file, *options):
    """Runs assess_repertoire and reads its table and what it says of the chain."""
    text = subprocess.run([str(programs / "assess_repertoire"), str(file), "--threads", "1",
                           "--test_chain", "0", *options], check=True, stdout=subprocess.PIPE,
                          universal_newlines=True).stdout
    worlds, chain = {}, ()
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if cells[0] in WORLDS:
            worlds[cells[0]] = World(*(float(cell) for cell in cells[1:]))
        if cells[0] == "as learned":
            mm, p90_mm, degrees, p90_degrees, behaviors, failed = map(float, cells[1:])
            chain = (behaviors, failed, mm, degrees, p90_mm, p90_degrees)
    return worlds, chain


def run(job):
    """Learns and assesses one (programs, file, options, behaviours to chain)."""
    programs, file, options, chain = job
    learn(programs, file, options)
    database = sqlite3.connect(str(file))
    meta = dict(database.execute("SELECT key, value FROM meta"))
    seconds = database.execute("SELECT max(elapsed_s) FROM history").fetchone()[0]
    database.close()
    everything, _ = assess(programs, file, "--least_entries", "10000000", "--chain", "1")
    return Run(int(meta["evaluations"]), int(meta["fact.simulations"]), seconds, everything,
               *assess(programs, file, "--chain", str(chain)))


def runs(arguments, name, seeds, options, chain=10000):
    """One Run per seed."""
    jobs = [(arguments.programs, arguments.work / f"{name.replace(' ', '_')}_{seed}.db",
             [*options, "--seed", str(seed)], chain) for seed in seeds]
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        return list(pool.map(run, jobs))


def median(all_runs, value):
    return statistics.median(value(one) for one in all_runs)


def world_table(runs_worlds):
    """Medians over the runs, one row per world."""
    lines = ["| world | entries that walk | sparseness [cm] | orientation error in the region "
             "[deg] | shift of end poses, median [mm] | p90 [mm] | entries that fail |",
             "|---|---|---|---|---|---|---|"]
    for name in WORLDS:
        def of(field, name=name):
            return median(runs_worlds, lambda worlds: getattr(worlds[name], field))
        lines.append(f"| {name} | {of('entries'):.0f} | {of('sparseness_cm'):.2f} | "
                     f"{of('error_deg'):.2f} | {of('shift_mm'):.1f} | {of('p90_mm'):.1f} | "
                     f"{of('failed'):.0f} |")
    return lines


def seed_table(seeds, all_runs):
    """One row per seed, nominal."""
    lines = ["| seed | evaluations | simulations | time [s] | entries | sparseness [cm] | "
             "error [deg] | reach [m] |", "|---|---|---|---|---|---|---|---|"]
    for seed, one in zip(seeds, all_runs):
        world = one.everything["nominal"]
        lines.append(f"| {seed} | {one.evaluations} | {one.simulations} | {one.seconds:.0f} | "
                     f"{world.entries:.0f} | {world.sparseness_cm:.2f} | {world.error_deg:.2f} | "
                     f"{world.reach_m:.2f} |")
    return lines


def chain_line(all_runs):
    """The chained test in one sentence, medians over the runs."""
    values = [median(all_runs, lambda one, i=i: one.chain[i]) for i in range(6)]
    worst = max(one.chain[1] for one in all_runs)
    return (f"Chained at random, {values[0]:.0f} behaviours in one simulation: "
            f"{worst:.0f} falls in the worst run; from the expected end pose {values[2]:.1f} mm "
            f"and {values[3]:.2f} degrees in the median, {values[4]:.1f} mm and {values[5]:.2f} "
            "degrees at p90.")


def preset(arguments, name, options, seeds):
    """Command, a table per choice of entries, table per seed."""
    all_runs = runs(arguments, name, seeds, options)
    lines = [f"`evolve {' '.join(options)} --seed S --threads 1`, then `assess_repertoire`; "
             f"seeds {seeds[0]} .. {seeds[-1]}, medians over them. {machine(arguments)}", ""]
    if all_runs[0].chain:
        lines += ["The entries that a planner uses, those of small validated spread:", ""]
        lines += world_table([one.steady for one in all_runs]) + ["", chain_line(all_runs), ""]
    lines += ["All entries:", ""] + world_table([one.everything for one in all_runs]) + [""]
    return lines + seed_table(seeds, all_runs)


def ablation(arguments):
    """One row per setting."""
    seeds = range(1, arguments.ablation_seeds + 1)
    def budget(share):
        return ["--evaluations", str(share * arguments.ablation_evaluations), *arguments.option]

    lines = ["# What each option of the default preset brings", "",
             f"`evolve {' '.join(budget(1))} --seed S --threads 1` with the named option changed, then "
             f"`assess_repertoire`; seeds 1 .. {seeds[-1]}, medians over them. {machine(arguments)}", "",
             "All entries. Held out: medians over the worlds that were not used in learning, "
             "without the torque loss, which has a column of its own. Chained: median and p90 "
             "distance from the expected end pose over 2,000 behaviours, those that a planner "
             "uses. Settings that simulate more per candidate are to be compared with the row of "
             "twice the candidates.", "",
             "| setting | simulations | entries | nominal: sparseness [cm], error [deg] | held out: "
             "error [deg], shift [mm] | torque -20 %: error [deg], failures | chained [mm] | "
             "chained [deg] | falls |", "|---|---|---|---|---|---|---|---|---|"]
    for name, options, share in ABLATION:
        all_runs = runs(arguments, "ablation " + re.sub(r"\W+", "_", name), seeds,
                        [*budget(share), *options], chain=2000)
        nominal = [one.everything["nominal"] for one in all_runs]
        torque = [one.everything["torque -20 %"] for one in all_runs]
        held_out = [[one.everything[world] for world in WORLDS[1:-1]] for one in all_runs]
        error = median(held_out, lambda ws: statistics.median(w.error_deg for w in ws))
        shift = median(held_out, lambda ws: statistics.median(w.shift_mm for w in ws))
        chain = [median(all_runs, lambda one, i=i: one.chain[i]) for i in range(6)]
        lines.append(
            f"| {name} | {median(all_runs, lambda one: one.simulations):.0f} | "
            f"{median(nominal, lambda w: w.entries):.0f} | "
            f"{median(nominal, lambda w: w.sparseness_cm):.2f}, "
            f"{median(nominal, lambda w: w.error_deg):.2f} | {error:.2f}, {shift:.1f} | "
            f"{median(torque, lambda w: w.error_deg):.2f}, "
            f"{median(torque, lambda w: w.failed):.0f} | {chain[2]:.1f}, {chain[4]:.1f} | "
            f"{chain[3]:.2f}, {chain[5]:.2f} | {chain[1]:.0f} |")
    return lines


def machine(arguments):
    """Processor and share of it, in a sentence."""
    model = platform.machine()
    for line in pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
        if line.startswith("model name"):
            model = line.split(":", 1)[1].strip()
            break
    return (f"{os.cpu_count()} cores of {model}, {arguments.jobs} runs at a time"
            f"{'; ' + arguments.remark if arguments.remark else ''}.")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", nargs="+", choices=["paper", "default", "ablation"])
    parser.add_argument("--programs", type=pathlib.Path, required=True)
    parser.add_argument("--work", type=pathlib.Path, default=pathlib.Path("/tmp/hexapod_results"))
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--seeds", type=int, help="default: 5 for paper, 10 for default")
    parser.add_argument("--default-evaluations", type=int, default=250000)
    parser.add_argument("--long-evaluations", type=int, default=1500000)
    parser.add_argument("--long-seeds", type=int, default=3)
    parser.add_argument("--paper-evaluations", type=int, default=100000)
    parser.add_argument("--ablation-evaluations", type=int, default=50000)
    parser.add_argument("--ablation-seeds", type=int, default=2)
    parser.add_argument("--option", nargs="*", default=[],
                        help="more words for evolve's command line, without their dashes: "
                        "verify_with_ode=false")
    parser.add_argument("--remark", default="", help="what else is to be known of the machine")
    arguments = parser.parse_args()
    arguments.option = ["--" + word for word in arguments.option]
    arguments.work.mkdir(parents=True, exist_ok=True)
    for what in arguments.what:
        if what == "paper":
            lines = ["# The paper's algorithm", ""] + preset(
                arguments, "paper", ["--preset", "paper", "--evaluations",
                                     str(arguments.paper_evaluations), *arguments.option],
                range(1, (arguments.seeds or 5) + 1))
            file = "paper_preset.md"
        elif what == "default":
            lines = ["# The default preset", "", "## A short budget", ""] + preset(
                arguments, "default", ["--evaluations", str(arguments.default_evaluations),
                                       *arguments.option],
                range(1, (arguments.seeds or 10) + 1))
            lines += ["", "## A long budget", ""] + preset(
                arguments, "default_long", ["--evaluations", str(arguments.long_evaluations),
                                            *arguments.option],
                range(1, arguments.long_seeds + 1))
            file = "default_preset.md"
        else:
            lines = ablation(arguments)
            file = "ablation.md"
        (HERE / file).write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
