"""What the campaigns share: the programs they disturb."""
import os
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[3]
BINARIES = pathlib.Path(
    os.environ.get("HEXAPOD_BINARIES", ROOT / "devel/lib/hexapod_repertoire"))
# A run of a second, saved after every generation.
SMALL = ["--evaluations", "200", "--population_size", "20", "--seed", "1", "--threads", "1",
         "--validation_trials", "1", "--verify_with_ode", "false", "--resimulate", "false",
         "--checkpoint_period_s", "0.0"]


def path(program):
    """Where a program is that was built."""
    return str(BINARIES / program)


def learning(file, *options):
    """The command that learns a small repertoire into a file."""
    return [path("evolve"), "--file", str(file), *SMALL, *options]


def learn(file, *options, **how):
    """Learns it; `how` as subprocess.run has it."""
    return subprocess.run(learning(file, *options), check=True, stdout=subprocess.DEVNULL, **how)


def csv_of(file):
    """The entries of a repertoire file as the program repertoire_csv prints them."""
    return subprocess.run([path("repertoire_csv"), str(file)], check=True,
                          stdout=subprocess.PIPE).stdout
