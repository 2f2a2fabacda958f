"""The program study: killed, hindered, two at a time; what is in its folder afterwards."""
import csv
import os
import pathlib
import subprocess
import time

import pytest

STUDY = os.environ["STUDY"]
NAMES = sorted(f"{algorithm}_{seed}_400" for algorithm in ("br_evolution", "targets", "map_elites")
               for seed in (1, 2))
TINY = ["--runs", "2", "--evaluations", "400", "--population_size", "20", "--targets", "3",
        "--gait_duration_s", "0.6"]


def study(folder, *options, **keywords):
    return subprocess.run([STUDY, "--folder", str(folder), *TINY, *options], check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True,
                          **keywords)


def runs(folder):
    return sorted(path.name for path in pathlib.Path(folder).iterdir()
                  if path.is_dir() and not path.name.startswith("."))


def entries(folder):
    return {name: (pathlib.Path(folder) / name / "entries.csv").read_text() for name in NAMES}


def test_every_run_has_its_files(tmp_path):
    done = study(tmp_path)
    assert done.returncode == 0, done.stderr
    assert runs(tmp_path) == NAMES
    history = rows(tmp_path / "targets_1_400" / "history.csv")
    assert {row["repertoire"] for row in history} == {"nearest", "orientation"}
    assert history[-1]["evaluations"] == "400"
    sparseness = [float(row["sparseness_m"]) for row in rows(tmp_path / "k_means.csv")]
    assert len(sparseness) == 8 and sparseness == sorted(sparseness, reverse=True)


def test_a_killed_study_goes_on_and_repeats_nothing(tmp_path):
    undisturbed, killed = tmp_path / "undisturbed", tmp_path / "killed"
    assert study(undisturbed).returncode == 0
    with subprocess.Popen([STUDY, "--folder", str(killed), "--jobs", "1", *TINY],
                          stdout=subprocess.DEVNULL) as process:
        while not (killed / NAMES[0]).exists():
            assert process.poll() is None
            time.sleep(0.001)
        process.kill()
    finished = {name: (killed / name / "run.csv").stat().st_mtime_ns for name in runs(killed)}
    assert 1 <= len(finished) < len(NAMES)
    assert study(killed).returncode == 0
    assert entries(killed) == entries(undisturbed)
    for name, written in finished.items():
        assert (killed / name / "run.csv").stat().st_mtime_ns == written


def test_a_run_that_fails_is_told_and_the_rest_goes_on(tmp_path):
    in_the_way = tmp_path / "map_elites_1_400"
    in_the_way.write_text("not a run")
    done = study(tmp_path)
    assert done.returncode == 1
    assert "map_elites_1_400 failed" in done.stderr and "1 run failed" in done.stderr
    assert runs(tmp_path) == [name for name in NAMES if name != "map_elites_1_400"]
    assert (tmp_path / "map_elites_1_400.failed").read_text()
    in_the_way.unlink()
    assert study(tmp_path).returncode == 0
    assert runs(tmp_path) == NAMES
    assert not (tmp_path / "map_elites_1_400.failed").exists()


def test_two_studies_share_a_folder(tmp_path):
    command = [STUDY, "--folder", str(tmp_path), "--jobs", "1", *TINY]
    with subprocess.Popen(command, stdout=subprocess.PIPE, universal_newlines=True) as one:
        other = subprocess.run(command, check=True, stdout=subprocess.PIPE,
                               universal_newlines=True)
        lines = one.communicate()[0] + other.stdout
    assert one.returncode == 0
    assert runs(tmp_path) == NAMES
    for name in NAMES:
        assert lines.count(name + ":") == 1


def test_other_options_are_refused(tmp_path):
    assert study(tmp_path).returncode == 0
    done = study(tmp_path, "--mutation_rate", "0.3")
    assert done.returncode == 2
    assert "option.mutation_rate: 0.1 there, 0.3 now" in done.stderr


def test_the_metrics_are_those_of_scipy(tmp_path):
    """Sparseness, errors, density and reach of the last row, from entries.csv by other means."""
    numpy = pytest.importorskip("numpy")
    spatial = pytest.importorskip("scipy.spatial")
    assert study(tmp_path).returncode == 0
    x, y = (values.ravel() for values in numpy.meshgrid(*[0.01 * numpy.arange(-60, 61)] * 2))
    grid = numpy.stack([x, y], axis=1)[in_region(numpy, x, y)]
    for name in NAMES:
        entry_rows = rows(tmp_path / name / "entries.csv")
        history = rows(tmp_path / name / "history.csv")
        for repertoire in {row["repertoire"] for row in history}:
            last = [row for row in history if row["repertoire"] == repertoire][-1]
            poses = numpy.array([[float(row[key]) for key in ("x_m", "y_m", "yaw_rad")]
                                 for row in entry_rows if row["repertoire"] == repertoire])
            if len(poses) == 0:
                assert last["sparseness_m"] == ""
                continue
            check(numpy, spatial, last, poses, grid)


def check(numpy, spatial, row, poses, grid):
    distances, _ = spatial.cKDTree(poses[:, :2]).query(grid)
    off = poses[:, 2] - 2.0 * numpy.arctan2(poses[:, 1], poses[:, 0])
    errors = numpy.abs(numpy.angle(numpy.exp(1j * off)))
    inside = in_region(numpy, poses[:, 0], poses[:, 1])
    assert float(row["sparseness_m"]) == pytest.approx(numpy.median(distances), abs=1e-12)
    assert float(row["orientation_error_of_all_rad"]) == pytest.approx(
        numpy.median(errors), abs=1e-9)
    if inside.any():
        assert float(row["orientation_error_rad"]) == pytest.approx(
            numpy.median(errors[inside]), abs=1e-9)
    assert int(row["entries_in_region"]) == inside.sum()
    assert float(row["density_per_dm2"]) == pytest.approx(inside.sum() / (0.01 * len(grid)))
    assert float(row["reach_m"]) == pytest.approx(numpy.hypot(poses[:, 0], poses[:, 1]).max())


def in_region(numpy, x, y):
    """Within 60 degrees of the x axis and less than 0.6 m along the arc, as in figure 2C."""
    polar = numpy.arctan2(numpy.abs(y), numpy.abs(x))
    with numpy.errstate(divide="ignore", invalid="ignore"):
        # The chord of an arc that turns by twice the polar angle.
        arc = numpy.hypot(x, y) * numpy.where(polar > 1e-12, polar / numpy.sin(polar), 1.0)
    return (polar <= numpy.pi / 3.0 + 1e-15) & (arc < 0.6)


def rows(file):
    with open(str(file), encoding="utf-8") as stream:
        return list(csv.DictReader(stream))


def test_the_report_of_a_study_has_its_statistics(tmp_path):
    """The table of study_report.py against SciPy on the rows that the program wrote."""
    stats = pytest.importorskip("scipy.stats")
    assert study(tmp_path, "--novelty_threshold_m", "0.01").returncode == 0
    script = pathlib.Path(__file__).resolve().parents[2] / "src" / "tools" / "study_report.py"
    subprocess.run(["/usr/bin/python3", str(script), str(tmp_path)], check=True,
                   env=dict(os.environ, PYTHONPATH=str(script.parents[1])))
    table = rows(tmp_path / "report" / "table.csv")
    assert {"quantity", "paper", "evaluations", "median", "p_value", "verdict"} <= set(table[0])
    assert all(row["verdict"] for row in table if row["paper"])
    row = [row for row in table if row["quantity"] == "sparseness of BR-Evolution v nearest"][0]
    ours, others = ([1e2 * last_sparseness_m(tmp_path / f"{algorithm}_{seed}_400", repertoire)
                     for seed in (1, 2)]
                    for algorithm, repertoire in (("br_evolution",) * 2, ("targets", "nearest")))
    assert float(row["median"]) == pytest.approx(sum(ours) / 2.0)
    assert float(row["other_median"]) == pytest.approx(sum(others) / 2.0)
    assert float(row["p_value"]) == pytest.approx(stats.ranksums(ours, others).pvalue)


def last_sparseness_m(folder, repertoire):
    return float([row["sparseness_m"] for row in rows(folder / "history.csv")
                  if row["repertoire"] == repertoire][-1])
