#!/usr/bin/env python3
"""Learns repertoires with the programs evolve and assess_repertoire and writes tables of results.

    results/measure.py --programs <folder of the two> --jobs 2 paper worlds ablation

writes results/paper_preset.md, and in results/learning.md the tables of the default preset world by
world (a short budget and a long one) and option by option. Repertoires are kept below --work and are
not learned again; delete them to start afresh.
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
    ("continuous amplitudes and phases", ["--gene_levels", "253"], 1),
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
class Assessed:
    """Some entries of a repertoire."""
    worlds: dict  # World by name
    chain: tuple  # behaviours, failed, mm, degrees, both at p90; empty: none


@dataclasses.dataclass(frozen=True)
class Run:
    """What came of one seed."""
    evaluations: int
    simulations: int
    seconds: float
    chosen: dict  # Assessed by name of the selection


# Which entries, and the words for it on assess_repertoire's command line.
EVERYTHING = {"all": ["--least_entries", "10000000"]}
PLANNED = {"planned with": []}
STEADIEST = {"the steadiest": ["--max_spread_m", "0.0025", "--max_spread_rad", "0.008",
                               "--least_entries", "0"]}


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
    return Assessed(worlds, chain)


def run(job):
    """Learns and assesses one (programs, file, options, selections, behaviours to chain)."""
    programs, file, options, selections, chain = job
    learn(programs, file, options)
    database = sqlite3.connect(str(file))
    meta = dict(database.execute("SELECT key, value FROM meta"))
    seconds = database.execute("SELECT max(elapsed_s) FROM history").fetchone()[0]
    database.close()
    return Run(int(meta["evaluations"]), int(meta["fact.simulations"]), seconds,
               {name: assess(programs, file, "--chain", str(chain), *words)
                for name, words in selections.items()})


def runs(arguments, name, seeds, options, selections, chain=10000):
    """One Run per seed."""
    jobs = [(arguments.programs, arguments.work / f"{name.replace(' ', '_')}_{seed}.db",
             [*options, "--seed", str(seed)], selections, chain) for seed in seeds]
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        return list(pool.map(run, jobs))


def median(all_runs, value):
    return statistics.median(value(one) for one in all_runs)


def world_table(all_runs, selections):
    """Medians over the runs, a row per world and a column per selection, then the chains."""
    def of(selection, world, field):
        return median(all_runs, lambda one: getattr(one.chosen[selection].worlds[world], field))

    def chained(selection):
        chains = [one.chosen[selection].chain for one in all_runs]
        if not all(chains):
            return "not validated"
        mm, degrees, p90_mm, p90_degrees = (statistics.median(chain[i] for chain in chains)
                                            for i in range(2, 6))
        return (f"{mm:.1f} mm, {degrees:.2f} deg; p90 {p90_mm:.1f} mm, {p90_degrees:.2f} deg; "
                f"{sum(chain[1] for chain in chains):.0f} failures")

    lines = ["| world | " + " | ".join(f"{name}: {of(name, 'nominal', 'entries'):.0f}"
                                       for name in selections) + " |",
             "|" + "---|" * (1 + len(selections))]
    for world in WORLDS:
        cells = [f"{of(name, world, 'sparseness_cm'):.2f} cm, {of(name, world, 'error_deg'):.2f} deg; "
                 f"{of(name, world, 'shift_mm'):.1f} mm, p90 {of(name, world, 'p90_mm'):.1f} mm; "
                 f"{of(name, world, 'failed'):.0f}" for name in selections]
        lines.append(f"| {world} | " + " | ".join(cells) + " |")
    return lines + ["| chained | " + " | ".join(map(chained, selections)) + " |"]


def seed_table(seeds, all_runs):
    """One row per seed, nominal."""
    lines = ["| seed | evaluations | simulations | time [s] | entries | sparseness [cm] | "
             "error [deg] | reach [m] |", "|---|---|---|---|---|---|---|---|"]
    for seed, one in zip(seeds, all_runs):
        world = one.chosen["all"].worlds["nominal"]
        lines.append(f"| {seed} | {one.evaluations} | {one.simulations} | {one.seconds:.0f} | "
                     f"{world.entries:.0f} | {world.sparseness_cm:.2f} | {world.error_deg:.2f} | "
                     f"{world.reach_m:.2f} |")
    return lines


def paper(arguments):
    """The whole page about the paper's preset."""
    seeds = range(1, (arguments.seeds or 5) + 1)
    options = ["--preset", "paper", "--evaluations", str(arguments.paper_evaluations),
               *arguments.option]
    all_runs = runs(arguments, "paper", seeds, options, EVERYTHING)
    return ["# The paper's algorithm", "",
            f"`evolve {' '.join(options)} --seed S --threads 1`, then `assess_repertoire`; "
            f"seeds {seeds[0]} .. {seeds[-1]}, medians over them. {machine(arguments)}", "",
            *world_table(all_runs, EVERYTHING), "", *seed_table(seeds, all_runs)]


def worlds(arguments):
    """A table per budget."""
    lines = []
    selections = {**PLANNED, **STEADIEST, **EVERYTHING}
    for budget in arguments.budgets:
        evaluations, seeds = budget.split(":")
        options = ["--evaluations", evaluations, *arguments.option]
        all_runs = runs(arguments, "worlds_" + evaluations, range(1, int(seeds) + 1), options,
                        selections)
        lines += [*world_table(all_runs, selections), "",
                  f"`evolve {' '.join(options)} --seed S --threads 1`, seeds 1 .. {seeds}. "
                  f"{machine(arguments)}", ""]
    return lines


def ablation(arguments):
    """One row per setting."""
    seeds = range(1, arguments.ablation_seeds + 1)
    def budget(share):
        return ["--evaluations", str(share * arguments.ablation_evaluations), *arguments.option]

    selections = {**PLANNED, **EVERYTHING}
    lines = ["| setting | simulations | entries | nominal: sparseness [cm], error [deg] | held out: "
             "error [deg], shift [mm] | torque -20 %: error [deg], failures | chained [mm] | "
             "chained [deg] | falls |", "|---|---|---|---|---|---|---|---|---|"]
    for name, options, share in ABLATION:
        all_runs = runs(arguments, "ablation " + re.sub(r"\W+", "_", name), seeds,
                        [*budget(share), *options], selections, chain=2000)
        everything = [one.chosen["all"].worlds for one in all_runs]
        nominal = [of["nominal"] for of in everything]
        torque = [of["torque -20 %"] for of in everything]
        held_out = [[of[world] for world in WORLDS[1:-1]] for of in everything]
        error = median(held_out, lambda ws: statistics.median(w.error_deg for w in ws))
        shift = median(held_out, lambda ws: statistics.median(w.shift_mm for w in ws))
        chain = [median(all_runs, lambda one, i=i: one.chosen["planned with"].chain[i])
                 for i in range(6)]
        lines.append(
            f"| {name} | {median(all_runs, lambda one: one.simulations):.0f} | "
            f"{median(nominal, lambda w: w.entries):.0f} | "
            f"{median(nominal, lambda w: w.sparseness_cm):.2f}, "
            f"{median(nominal, lambda w: w.error_deg):.2f} | {error:.2f}, {shift:.1f} | "
            f"{median(torque, lambda w: w.error_deg):.2f}, "
            f"{median(torque, lambda w: w.failed):.0f} | {chain[2]:.1f}, {chain[4]:.1f} | "
            f"{chain[3]:.2f}, {chain[5]:.2f} | {chain[1]:.0f} |")
    return lines + ["", f"`evolve {' '.join(budget(1))} --seed S --threads 1` with the named option "
                    f"changed, seeds 1 .. {seeds[-1]}. {machine(arguments)}"]


def write_tables(heading, lines):
    """Replaces what follows the words of a section of results/learning.md: its tables."""
    file = HERE / "learning.md"
    before, _, rest = file.read_text(encoding="utf-8").partition(f"## {heading}\n")
    section, separator, after = rest.partition("\n## ")
    words = section.split("\n|", maxsplit=1)[0].rstrip("\n")
    table = "\n".join(lines).rstrip("\n")
    file.write_text(f"{before}## {heading}\n{words}\n\n{table}\n{separator}{after}",
                    encoding="utf-8")


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
    parser.add_argument("what", nargs="+", choices=["paper", "worlds", "ablation"])
    parser.add_argument("--programs", type=pathlib.Path, required=True)
    parser.add_argument("--work", type=pathlib.Path, default=pathlib.Path("/tmp/hexapod_results"))
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--seeds", type=int, help="of paper, 5 by default")
    parser.add_argument("--paper-evaluations", type=int, default=100000)
    parser.add_argument("--budgets", nargs="+", default=["62000:4", "470000:2"],
                        help="of worlds: candidates, and how many seeds")
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
            (HERE / "paper_preset.md").write_text("\n".join(paper(arguments)) + "\n",
                                                  encoding="utf-8")
        elif what == "worlds":
            write_tables("World by world", worlds(arguments))
        else:
            write_tables("What each option brings", ablation(arguments))


if __name__ == "__main__":
    main()
