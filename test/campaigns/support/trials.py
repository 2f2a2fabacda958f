"""The frame of a campaign that tries one thing many times: options, counts, a table, an exit code."""
import argparse
import collections
import random
import sys


class Trials:
    """Numbered trials, drawn from one seed, and what became of them: an outcome for each."""

    def __init__(self, description, usual, short):
        """Reads the command line. `usual`, `short`: how many trials without options, with --short."""
        parser = argparse.ArgumentParser(description=description)
        parser.add_argument("--short", action="store_true", help="some seconds")
        parser.add_argument("--trials", type=int, default=usual)
        parser.add_argument("--seed", type=int, default=1)
        arguments = parser.parse_args()
        self.count = short if arguments.short else arguments.trials
        self.seed = arguments.seed
        self.dice = random.Random(arguments.seed)
        self._counts = collections.Counter()
        self._wrong = []

    def note(self, trial, kind, outcome, problem=""):
        """One trial's outcome, and what is wrong with it, if anything."""
        self._counts[kind, outcome] += 1
        if problem:
            self._wrong.append(f"trial {trial}, {problem}")

    def report(self, head, kinds, outcomes):
        """Prints a row for each kind, and what was wrong to standard error; returns the exit code.

        Args:
            head: of the column of kinds.
            outcomes: heads of the columns by outcome; that of None counts all others.
        """
        print(f"| {head} |", " | ".join(outcomes.values()), "|")
        print("|" + "---|" * (1 + len(outcomes)))
        for kind in kinds:
            all_others = sum(count for (other, outcome), count in self._counts.items()
                             if other == kind and outcome not in outcomes)
            cells = [all_others if outcome is None else self._counts[kind, outcome]
                     for outcome in outcomes]
            print(f"| {kind} |", " | ".join(map(str, cells)), "|")
        for line in self._wrong:
            print(line, file=sys.stderr)
        return 1 if self._wrong else 0
