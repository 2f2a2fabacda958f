"""Damages repertoire files at random: a reader gives the entries as they were, or says no.

Bits are turned, blocks overwritten, pages exchanged, ends cut off or added. Reading must end with
the very entries of the intact file, or with a sentence that names the file, and leave the file as
it is; a learner told to resume must do the same. Nothing crashes, nothing hangs.
"""
import pathlib
import subprocess
import sys
import tempfile

from support import programs
from support.trials import Trials

PAGE = 4096
HANGS_S = 60


def noise(dice, size):
    return bytes(dice.randrange(256) for _ in range(size))


def turn_a_bit(data, dice):
    at = dice.randrange(len(data))
    data[at] ^= 1 << dice.randrange(8)


def overwrite_a_block(data, dice):
    at, size = dice.randrange(len(data)), dice.choice([1, 4, 16, 512, PAGE])
    end = min(len(data), at + size)
    data[at:end] = dice.choice([bytes(end - at), noise(dice, end - at), b"\xff" * (end - at)])


def exchange_two_pages(data, dice):
    pages = len(data) // PAGE
    a, b = (dice.randrange(pages) * PAGE for _ in range(2))
    data[a:a + PAGE], data[b:b + PAGE] = data[b:b + PAGE], data[a:a + PAGE]


def cut_the_end(data, dice):
    del data[dice.randrange(len(data)):]


def add_to_the_end(data, dice):
    data += noise(dice, dice.choice([1, 100, PAGE]))


def edit_a_text(data, dice):
    """Changes a byte of a text that stands in the file, as an editor would."""
    places = [at for at in range(len(data)) if 48 <= data[at] <= 122]
    data[dice.choice(places)] = dice.randrange(48, 122)


KINDS = [turn_a_bit, overwrite_a_block, exchange_two_pages, cut_the_end, add_to_the_end,
         edit_a_text]


def in_words(kind):
    return kind.__name__.replace("_", " ")


def outcome_of(command, file, expected):
    """"same", "refused" or what went wrong."""
    before = file.read_bytes()
    try:
        result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                check=False, timeout=HANGS_S)
    except subprocess.TimeoutExpired:
        return "hung"
    if result.returncode == 0:
        return "same" if result.stdout == expected else "read something else"
    if result.returncode < 0 or result.returncode > 2:
        return f"ended with {result.returncode}"
    if str(file).encode() not in result.stderr:
        return f"did not name the file: {result.stderr.decode(errors='replace')}"
    return "refused" if file.read_bytes() == before else "changed a file that it refused"


def main():
    trials = Trials(__doc__, usual=2000, short=60)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        intact = folder / "intact.db"
        programs.learn(intact)
        expected = programs.csv_of(intact)
        for trial in range(trials.count):
            kind = KINDS[trial % len(KINDS)]
            data = bytearray(intact.read_bytes())
            kind(data, trials.dice)
            file = folder / f"{trial}.db"
            file.write_bytes(data)
            outcome = outcome_of([programs.path("repertoire_csv"), str(file)], file, expected)
            if trial % 10 == 0 and outcome == "refused":
                # The learner's first words go to standard output, which it does not get to here.
                outcome = outcome_of(programs.learning(file, "--resume"), file, b"")
            problem = "" if outcome in ("same", "refused") else f"{kind.__name__}: {outcome}"
            trials.note(trial, in_words(kind), outcome, problem)
            file.unlink()
    print(f"{trials.count} damaged copies of a repertoire file, seed {trials.seed}.\n")
    return trials.report("damage", map(in_words, KINDS),
                         {"refused": "refused with a sentence", "same": "read as if undamaged",
                          None: "anything else"})


if __name__ == "__main__":
    sys.exit(main())
