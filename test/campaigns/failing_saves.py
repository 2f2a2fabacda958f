"""Lets system calls of a learner fail while it saves: it tells so, and the file stays whole.

A library in front of the system's makes a call on the repertoire's files fail, or some calls, or
all later ones, or kills the process there. A run that ends with 0 has all that it learned in its file;
any other says at last that it has not, or was killed; and the file it leaves is a checkpoint from
which the run goes on to the entries of an undisturbed one.
"""
import dataclasses
import os
import pathlib
import subprocess
import sys
import tempfile

from support import programs
from support.trials import Trials

HERE = pathlib.Path(__file__).resolve().parent
HANGS_S = 120
# The calls that SQLite writes with, and about half as many as one run makes of each.
CALLS = {"pwrite64": 60, "pread64": 15, "fdatasync": 12, "open": 6, "unlink": 5}
ERRORS = {"EIO": 5, "ENOSPC": 28, "EACCES": 13, "EDQUOT": 122}


@dataclasses.dataclass(frozen=True)
class Fault:
    """Calls that fail: from number `first` of its kind on, `count` of them."""
    call: str
    first: int
    count: int
    error: str   # a name of ERRORS, or "kill"

    def environment(self, library, mark):
        number = 0 if self.error == "kill" else ERRORS[self.error]
        return {**os.environ, "LD_PRELOAD": str(library), "FAIL_CALL": self.call,
                "FAIL_FIRST": str(self.first), "FAIL_COUNT": str(self.count),
                "FAIL_ERROR": str(number), "FAIL_NAME": "gaits.db", "FAIL_MARK": str(mark)}


def draw(dice):
    call = dice.choice(list(CALLS))
    error = dice.choice([*ERRORS, "kill"])
    count = 1 if error == "kill" else dice.choice([1, 3, 1000000])
    return Fault(call, dice.randrange(2 * CALLS[call]), count, error)


def build(folder):
    """The library that lets calls fail."""
    library = folder / "failing_calls.so"
    subprocess.run(["cc", "-shared", "-fPIC", "-O1", "-o", str(library),
                    str(HERE / "support" / "failing_calls.c"), "-ldl"], check=True)
    return library


def problem_after(fault, library, file, expected):
    """(what became of the run, what is wrong with that or "")."""
    mark = file.with_name("struck")
    run = subprocess.run(programs.learning(file), env=fault.environment(library, mark),
                         stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True,
                         check=False, timeout=HANGS_S)
    said = (run.stdout + run.stderr).strip().splitlines()
    killed = run.returncode == -9
    if run.returncode < 0 and not killed:
        return "crashed", f"ended with {run.returncode}"
    if run.returncode == 0:
        saved = programs.csv_of(file) == expected
        state = "succeeded" if mark.exists() else "never called so often"
        return state, "" if saved else "succeeded, but the file does not hold what it learned"
    if not killed and (not said or str(file) not in said[-1]):
        return "failed", f"did not say why: {said[-1:]}"
    again = subprocess.run(programs.learning(file, "--resume"), stdout=subprocess.PIPE,
                           stderr=subprocess.STDOUT, universal_newlines=True, check=False,
                           timeout=HANGS_S)
    state = "killed" if killed else "failed"
    if again.returncode != 0:
        return state, f"cannot be resumed: {again.stdout[-500:]}"
    return state, "" if programs.csv_of(file) == expected else "resumed to other entries"


def main():
    trials = Trials(__doc__, usual=300, short=6)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        library = build(folder)
        programs.learn(folder / "undisturbed.db")
        expected = programs.csv_of(folder / "undisturbed.db")
        for trial in range(trials.count):
            fault = draw(trials.dice)
            (folder / str(trial)).mkdir()
            state, problem = problem_after(fault, library, folder / str(trial) / "gaits.db",
                                           expected)
            trials.note(trial, fault.call, state, f"{fault}: {problem}" if problem else "")
    print(f"{trials.count} runs of evolve with failing system calls, seed {trials.seed}; each file "
          "was whole, or resumed to the entries of an undisturbed run.\n")
    states = ["never called so often", "succeeded", "failed", "killed", "crashed"]
    return trials.report("call", CALLS, {state: state for state in states})


if __name__ == "__main__":
    sys.exit(main())
