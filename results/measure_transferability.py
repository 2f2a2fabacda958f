#!/usr/bin/env python3
"""Learns beside a robot that simulation is wrong about, and after calibrating it with as many trials.

    results/measure_transferability.py --programs <folder of evolve, assess_repertoire and calibrate>

prints the tables of results/transferability.md. Repertoires are kept below --work and are not learned
again; delete them to start afresh.
"""
import argparse
import concurrent.futures
import dataclasses
import pathlib
import statistics
import subprocess

from measure import machine

BODY = {"friction": 0.6, "gain": 0.7}
# The words of a body, and of the section that calibrate writes.
SCALES = {"friction": "friction_scale", "gain": "servo_gain_scale", "torque": "torque_scale",
          "mass": "mass_scale"}
TRIALS = 40


@dataclasses.dataclass(frozen=True)
class Found:
    """Entries planned with: sparseness [cm] and orientation error [deg] as they are expected to
    end, and how far from there the robot ends [mm], median and p90."""
    entries: float
    sparseness_cm: float
    error_deg: float
    shift_mm: float
    p90_mm: float


def text_of(body):
    """As evolve and assess_repertoire read it."""
    return ", ".join(f"{name}: {value:.6g}" for name, value in body.items())


def run(*command):
    """What a program prints."""
    return subprocess.run([str(word) for word in command], check=True, stdout=subprocess.PIPE,
                          universal_newlines=True).stdout


def learn(arguments, file, seed, *options):
    """Learns into `file` unless it is there."""
    if not file.exists():
        run(arguments.programs / "evolve", "--file", file, "--threads", 1, "--evaluations",
            arguments.evaluations, "--seed", seed, "--resimulate", "false", *options)
    return file


def assess(arguments, file, body, *options):
    """Plays the entries planned with on the robot."""
    text = run(arguments.programs / "assess_repertoire", file, "--threads", 1, "--chain", 10,
               "--test_chain", 0, "--body", text_of(body), *options)
    rows = {cells[0]: cells for cells in ([cell.strip() for cell in line.strip("|").split("|")]
                                          for line in text.splitlines())}
    expected, robot = rows["as expected"], rows[text_of(body)]
    return Found(*(float(cell) for cell in expected[1:4]), float(robot[5]), float(robot[6]))


def calibrated(arguments, file, output):
    """The robot's YAML of a calibration, and the robot's body seen from there."""
    if not output.with_suffix(".yaml").exists():
        run(arguments.programs / "calibrate", "--file", file, "--simulated", text_of(BODY),
            "--engine", "ode", "--behaviors", TRIALS, "--checks", 0, "--threads", 1, "--output",
            output)
    yaml = output.with_suffix(".yaml").read_text(encoding="utf-8")
    section = dict(line.split(": ") for line in yaml[yaml.index("\ncalibration:"):].splitlines()
                   if ": " in line)
    found = {name: float(section[f"  {key}"]) for name, key in SCALES.items()}
    return output.with_suffix(".yaml"), {name: BODY.get(name, 1.0) / found[name] for name in SCALES}


def session(arguments, seed):
    """Without trials, with them, and calibrated with as many."""
    plain = learn(arguments, arguments.work / f"plain_{seed}.db", seed)
    beside = learn(arguments, arguments.work / f"beside_{seed}.db", seed, "--transferability",
                   "--transferability_trials", TRIALS, "--robot_body", text_of(BODY))
    yaml, left = calibrated(arguments, plain, arguments.work / f"calibrated_{seed}")
    after = learn(arguments, arguments.work / f"after_{seed}.db", seed, "--robot_config", yaml)
    return [assess(arguments, plain, BODY), assess(arguments, beside, BODY),
            assess(arguments, after, left, "--robot_config", yaml)]


def line(name, found):
    """A row of the table."""
    return (f"| {name} | {found.entries:.0f} | {found.sparseness_cm:.2f} cm | "
            f"{found.error_deg:.2f} deg | {found.shift_mm:.1f} mm | {found.p90_mm:.1f} mm |")


def main():
    """Prints a row per seed and kind, then medians."""
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--programs", type=pathlib.Path, required=True)
    parser.add_argument("--work", type=pathlib.Path, default=pathlib.Path("/tmp/hexapod_transfer"))
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--seeds", type=int, default=5)
    parser.add_argument("--evaluations", type=int, default=20000)
    parser.add_argument("--remark", default="")
    arguments = parser.parse_args()
    arguments.work.mkdir(parents=True, exist_ok=True)
    seeds = range(1, arguments.seeds + 1)
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        sessions = list(pool.map(lambda seed: session(arguments, seed), seeds))
    kinds = ["in simulation only", f"beside the robot, {TRIALS} trials",
             f"calibrated with {TRIALS}, then in simulation"]
    print(f"{machine(arguments)} {arguments.evaluations} candidates.\n")
    print("| | entries planned with | sparseness | orientation error | shift, median | p90 |\n"
          "|---|---|---|---|---|---|")
    for number, kind in enumerate(kinds):
        found = [one[number] for one in sessions]
        print(line(f"{kind}, medians", Found(*(
            statistics.median(getattr(one, field.name) for one in found)
            for field in dataclasses.fields(Found)))))
    for seed, one in zip(seeds, sessions):
        for kind, found in zip(kinds, one):
            print(line(f"seed {seed}: {kind}", found))
    ratios = [one[1].shift_mm / one[0].shift_mm for one in sessions]
    print(f"\nShift beside the robot over that without: {statistics.median(ratios):.2f} in the "
          f"median, {min(ratios):.2f} to {max(ratios):.2f}.")


if __name__ == "__main__":
    main()
