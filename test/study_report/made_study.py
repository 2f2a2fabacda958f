"""A study folder with known numbers, written without the program that writes real ones."""
import csv
import math
import random

HISTORY = ("repertoire", "evaluations", "simulations", "wall_s", "entries", "entries_in_region",
           "sparseness_m", "orientation_error_rad", "orientation_error_of_all_rad",
           "density_per_dm2", "reach_m")
ENTRIES = ("repertoire", "evaluations", "x_m", "y_m", "yaw_rad", "orientation_error_rad", "genome")
K_MEANS_M = {50: 0.0443, 100: 0.0314, 150: 0.0256, 200: 0.0222, 250: 0.0199, 300: 0.0181,
             350: 0.0168, 400: 0.0157}
REPERTOIRES = {"br_evolution": ["br_evolution"], "targets": ["nearest", "orientation"],
               "map_elites": ["map_elites"]}
# By repertoire: sparseness [m] and orientation error [rad] at the end, entries at the end.
ENDS = {"br_evolution": (0.020, 0.010, 300), "nearest": (0.032, 0.300, 100),
        "orientation": (0.045, 0.005, 100), "map_elites": (0.024, 0.030, 250)}
STEP = 1e-4


def value_at_end(repertoire, column, seed):
    """What run `seed` (1, 2, ...) ends with: equal steps, so that groups never overlap."""
    return ENDS[repertoire][column] * (1.0 + STEP * seed)


def growth(evaluations, budget):
    """How many times its end a measure is after so many evaluations."""
    return 1.0 + 2.0 * math.log10(budget / evaluations)


def write_csv(path, header, rows):
    """Writes rows below a header."""
    with open(str(path), "w", newline="", encoding="utf-8") as stream:
        csv.writer(stream).writerows([header, *rows])


def _history(repertoire, seed, budget, rows):
    for row in range(1, rows + 1):
        evaluations = budget * row // rows
        factor = growth(evaluations, budget)
        count = max(1, int(ENDS[repertoire][2] * row / rows))
        error = value_at_end(repertoire, 1, seed) * factor
        yield (repertoire, evaluations, evaluations // 2, 0.001 * evaluations, count, count // 2,
               value_at_end(repertoire, 0, seed) * factor, error, 1.5 * error, count / 120.0, 0.8)


def _entries(repertoire, seed, evaluations, budget):
    generator = random.Random(f"{repertoire} {seed} {evaluations}")
    share = max(0.1, math.log10(10.0 * evaluations / budget))
    for _ in range(max(3, int(share * ENDS[repertoire][2]))):
        distance, direction = 0.8 * share * math.sqrt(generator.random()), generator.uniform(-3, 3)
        x_m, y_m = distance * math.cos(direction), distance * math.sin(direction)
        error = ENDS[repertoire][1] * generator.expovariate(0.7) * (1 + 4 * abs(y_m) * distance)
        yaw = 2.0 * math.atan2(y_m, x_m) + math.copysign(error, generator.random() - 0.5)
        yield (repertoire, evaluations, repr(x_m), repr(y_m), repr(yaw), error, "0" * 24)


def write_run(folder, algorithm, seed, budget, rows=10):
    """Writes a finished run; returns its folder."""
    run = folder / f"{algorithm}_{seed}_{budget}"
    run.mkdir(parents=True)
    write_csv(run / "run.csv", ("key", "value"), [
        ("algorithm", algorithm), ("seed", seed), ("evaluations", budget),
        ("simulations", budget // 2), ("wall_s", 60.5), ("engine", "reduced"),
        ("robot_id", "abc"), ("machine", "2 cores"), ("version", "0.1.0"),
        ("option.population_size", 100)])
    names = REPERTOIRES[algorithm]
    write_csv(run / "history.csv", HISTORY,
              [row for name in names for row in _history(name, seed, budget, rows)])
    whens = [when for when in (budget // 100, budget // 30, budget // 10, budget * 3 // 10, budget)
             if when]
    write_csv(run / "entries.csv", ENTRIES, [row for name in names for when in whens
                                             for row in _entries(name, seed, when, budget)])
    return run


def write_study(folder, seeds, budget, algorithms=tuple(REPERTOIRES), rows=10):
    """Writes a study with these runs of each algorithm."""
    for algorithm in algorithms:
        for seed in seeds:
            write_run(folder, algorithm, seed, budget, rows)
    write_csv(folder / "k_means.csv", ("targets", "sparseness_m"), K_MEANS_M.items())
