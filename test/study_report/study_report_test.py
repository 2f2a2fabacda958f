"""The report of a study: what is in it, and what it says of studies that are not whole."""
import csv
import os
import pathlib
import random
import subprocess
import sys

import matplotlib.image
import numpy as np
import pytest
import scipy.stats

import made_study
from hexapod_repertoire import study_report
from hexapod_repertoire.study_report import main, seeds_text

ROOT = pathlib.Path(__file__).resolve().parents[2]
FIGURES = ("figure_3.png", "figure_4.png", "figure_5_left.png", "figure_5_right.png",
           "figure_6.png")
PAPER = [
    ("sparseness of BR-Evolution", "about 3"), ("sparseness of BR-Evolution", "near 2"),
    ("orientation error of BR-Evolution", "< 5"), ("orientation error of BR-Evolution", "< 1.7"),
    ("sparseness of nearest", "3"), ("orientation error of nearest", "> 15"),
    ("sparseness of orientation", "> 4"),
    ("orientation error of orientation below that of BR-Evolution by", "0.5"),
    ("from when on orientation has the smaller orientation error", "750,000"),
    ("largest distance reached by BR-Evolution", "80"),
    ("area covered by BR-Evolution over that of nearest", "about 2"),
    ("area covered by BR-Evolution over that of orientation", "about 2"),
    ("sparseness of orientation over that of BR-Evolution", "2"),
    ("BR-Evolution as dense as nearest at the end, faster by", "at least 5"),
    ("orientation error of nearest over that of BR-Evolution", "about 10"),
    ("sparseness of BR-Evolution v nearest", "p = 1.4e-14"),
    ("sparseness of BR-Evolution v orientation", "p = 1.4e-14"),
    ("orientation error of orientation v BR-Evolution", "p = 3.0e-07"),
    ("orientation error of BR-Evolution v nearest", "p = 1.4e-14"),
    ("theoretical sparseness of 100 targets", "3.14"),
    ("theoretical sparseness of 200 targets", "2.22"),
    ("theoretical sparseness of 400 targets", "1.57"),
    ("sparseness of nearest with 400 targets, extrapolated, over that of BR-Evolution", "> 1"),
]
MILLION = 1_000_000


def read_table(folder):
    with open(str(folder / "report" / "table.csv"), encoding="utf-8", newline="") as stream:
        return list(csv.DictReader(stream))


def row_of(table, quantity, paper):
    return next(row for row in table if (row["quantity"], row["paper"]) == (quantity, paper))


def report_of(folder):
    assert main([str(folder)]) == 0
    return (folder / "report" / "report.md").read_text(encoding="utf-8")


def last_values(folder, repertoire, column):
    """The column's last value in each run with the repertoire, from the raw rows."""
    values = []
    for path in sorted(folder.glob("*/history.csv")):
        with open(str(path), encoding="utf-8", newline="") as stream:
            rows = [row for row in csv.DictReader(stream) if row["repertoire"] == repertoire]
        values += [float(rows[-1][column])] if rows else []
    return values


@pytest.fixture
def without_figures(monkeypatch):
    """Drawing takes longest, and most tests look at the table."""
    monkeypatch.setattr(study_report, "FIGURES", ())


@pytest.fixture(scope="module", name="whole")
def fixture_whole(tmp_path_factory):
    """A study like the paper's, 40 runs of each algorithm, reported by the script itself."""
    folder = tmp_path_factory.mktemp("whole")
    made_study.write_study(folder, range(1, 41), MILLION)
    environment = dict(os.environ, PYTHONPATH=str(ROOT / "src"))
    result = subprocess.run(
        [sys.executable, str(ROOT / "src/tools/study_report.py"), str(folder)],
        env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True,
        check=False)
    assert (result.returncode, result.stderr) == (0, "")
    assert result.stdout.strip() == str(folder / "report" / "report.md")
    return folder


def test_the_table_has_every_number_of_the_paper_and_a_verdict(whole):
    table = read_table(whole)
    printed = [(row["quantity"], row["paper"]) for row in table if row["paper"]]
    assert printed == PAPER
    assert all(row["verdict"] for row in table)


def test_forty_runs_apart_from_forty_have_the_p_value_of_the_paper(whole):
    for quantity, paper in [PAPER[15], PAPER[16], PAPER[18]]:
        row = row_of(read_table(whole), quantity, paper)
        assert f"{float(row['p_value']):.1e}" == "1.4e-14"
        assert (row["runs"], float(row["a12"]), row["verdict"]) == ("40 v 40", 0.0, "holds")


def test_quartiles_are_those_worked_out_by_hand(whole):
    # Values 3.2 cm * (1 + 1e-4 seed): the quartiles of the seeds 1 .. 40 are 10.75, 20.5, 30.25.
    row = row_of(read_table(whole), "sparseness of nearest", "3")
    for name, seed in (("first_quartile", 10.75), ("median", 20.5), ("third_quartile", 30.25)):
        assert float(row[name]) == pytest.approx(3.2 * (1.0 + 1e-4 * seed), rel=1e-12)
    assert (row["runs"], row["evaluations"], row["verdict"]) == ("40", "1000000", "holds")


def test_an_early_number_is_taken_early(whole):
    # Three times the 2 cm of the end, after a tenth of the evaluations.
    row = row_of(read_table(whole), "sparseness of BR-Evolution", "about 3")
    assert float(row["median"]) == pytest.approx(6.0 * (1.0 + 1e-4 * 20.5), rel=1e-12)
    assert (row["evaluations"], row["verdict"]) == ("100000", "does not hold: ours is higher")


def test_every_repertoire_is_compared_with_br_evolution(whole):
    compared = {(row["quantity"], row["evaluations"]): row["verdict"]
                for row in read_table(whole) if not row["paper"]}
    assert len(compared) == 3 * 2 * 2
    assert compared["sparseness of BR-Evolution v MAP-Elites", "1000000"] == "BR-Evolution is lower"


@pytest.mark.parametrize("file", FIGURES)
def test_figures_are_there_and_not_empty_even_in_grey(whole, file):
    picture = matplotlib.image.imread(str(whole / "report" / file))
    assert 600 < picture.shape[1] < 3000 and 400 < picture.shape[0] < 3000
    grey = picture[..., :3] @ [0.299, 0.587, 0.114]
    assert 0.01 < np.mean(grey < 0.9) < 0.9
    assert grey.min() < 0.3


def test_each_figure_stands_beside_a_sentence_with_numbers(whole):
    lines = (whole / "report" / "report.md").read_text(encoding="utf-8").splitlines()
    for file in FIGURES:
        place = next(slot for slot, line in enumerate(lines) if line.endswith(f"({file})"))
        sentence = lines[place + 2]
        assert sentence.endswith(".") and any(letter.isdigit() for letter in sentence)


def test_the_report_says_what_was_run_and_what_it_cost(whole):
    text = (whole / "report" / "report.md").read_text(encoding="utf-8")
    # 120 runs of half a million simulations and 60.5 s: 7260 s.
    assert "120 runs, 60,000,000 simulations, 2.0 h" in text
    assert "| BR-Evolution | 1,000,000 | 40 | 1-40 |" in text
    assert (f"study --folder {whole.name} --algorithms br_evolution,map_elites,targets "
            "--first_seed 1 --runs 40 --evaluations 1000000\n") in text
    assert "population_size 100" in text and "2 cores" in text


@pytest.mark.usefixtures("without_figures")
def test_p_values_and_effect_are_those_of_scipy_on_the_raw_rows(tmp_path):
    generator = random.Random(4)
    made_study.write_study(tmp_path, range(1, 8), MILLION, ["br_evolution", "targets"], rows=2)
    for path in tmp_path.glob("*/history.csv"):
        rows = list(csv.reader(open(str(path), encoding="utf-8", newline="")))
        for row in rows[1:]:
            row[6:8] = [generator.choice([0.02, 0.03, 0.04]), generator.uniform(0.0, 0.1)]
        made_study.write_csv(path, rows[0], rows[1:])
    report_of(tmp_path)
    table = read_table(tmp_path)
    for (quantity, paper), column, first, second in (
            (PAPER[15], "sparseness_m", "br_evolution", "nearest"),
            (PAPER[17], "orientation_error_rad", "orientation", "br_evolution")):
        row = row_of(table, quantity, paper)
        groups = [last_values(tmp_path, name, column) for name in (first, second)]
        assert float(row["p_value"]) == pytest.approx(scipy.stats.ranksums(*groups).pvalue)
        larger = scipy.stats.mannwhitneyu(*groups, alternative="two-sided").statistic / 49.0
        assert float(row["a12"]) == pytest.approx(larger)
        assert float(row["smallest_exact_p"]) == pytest.approx(2.0 / 3432.0)  # 14 over 7
        assert float(row["median"]) == pytest.approx(
            np.median(groups[0]) * (100.0 if column == "sparseness_m" else 180.0 / np.pi))


@pytest.mark.usefixtures("without_figures")
def test_three_runs_are_too_few_and_the_report_says_what_they_could_show(tmp_path):
    made_study.write_study(tmp_path, range(1, 4), MILLION)
    text = report_of(tmp_path)
    row = row_of(read_table(tmp_path), *PAPER[15])
    assert row["verdict"] == "too few runs for this p-value: the groups do not overlap"
    # Of the 20 ways to share out six ranks two are as extreme.
    assert float(row["smallest_exact_p"]) == pytest.approx(0.1)
    assert "0.050 (0.050, exact 0.100)" in text


@pytest.mark.usefixtures("without_figures")
def test_what_was_not_reached_is_no_verdict_on_the_paper(tmp_path):
    made_study.write_study(tmp_path, range(1, 3), 12_000)
    report_of(tmp_path)
    verdicts = {row["verdict"] for row in read_table(tmp_path)
                if row["paper"] and "theoretical" not in row["quantity"]}
    assert verdicts == {"not reached: only 12,000 evaluations"}


@pytest.mark.usefixtures("without_figures")
def test_at_a_mark_all_runs_count_that_reached_it(tmp_path):
    made_study.write_study(tmp_path, range(1, 4), MILLION)
    for seed in range(4, 10):
        made_study.write_run(tmp_path, "br_evolution", seed, 100_000)
    report_of(tmp_path)
    table = read_table(tmp_path)
    assert row_of(table, *PAPER[0])["runs"] == "9"
    assert row_of(table, *PAPER[1])["runs"] == "3"


@pytest.mark.usefixtures("without_figures")
def test_a_seed_that_ran_twice_counts_once(tmp_path):
    made_study.write_study(tmp_path, range(1, 4), MILLION)
    made_study.write_run(tmp_path, "br_evolution", 2, 100_000)
    assert "longer run with the same seed: br_evolution_2_100000." in report_of(tmp_path)
    assert row_of(read_table(tmp_path), *PAPER[0])["runs"] == "3"


@pytest.mark.usefixtures("without_figures")
def test_failed_runs_are_told_with_their_reasons_and_unfinished_ones_left_out(tmp_path):
    made_study.write_study(tmp_path, [1, 2], 12_000)
    (tmp_path / "targets_3_12000.failed").write_text("the disk\nis full\n", encoding="utf-8")
    (tmp_path / ".unfinished_map_elites_3_12000").mkdir()
    text = report_of(tmp_path)
    assert "- targets_3_12000: the disk is full\n" in text
    assert "6 runs" in text


def test_a_study_of_one_algorithm_has_a_report(tmp_path):
    made_study.write_study(tmp_path, [1], 100_000, ["br_evolution"])
    (tmp_path / "k_means.csv").unlink()
    text = report_of(tmp_path)
    assert text.count("Not drawn: the study has no data for it.") == 2
    table = read_table(tmp_path)
    assert row_of(table, *PAPER[4])["verdict"] == "no runs of nearest"
    assert row_of(table, *PAPER[15])["verdict"] == "no runs of nearest"
    assert row_of(table, *PAPER[21])["verdict"] == "not in k_means.csv"


@pytest.mark.usefixtures("without_figures")
def test_repertoires_of_any_name_are_taken(tmp_path, monkeypatch):
    monkeypatch.setitem(made_study.REPERTOIRES, "my_own", ["some_name"])
    monkeypatch.setitem(made_study.ENDS, "some_name", (0.03, 0.02, 50))
    made_study.write_study(tmp_path, range(1, 7), 50_000, ["br_evolution", "my_own"])
    assert "| some name | 50,000 | 6 |" in report_of(tmp_path)
    row = row_of(read_table(tmp_path), "sparseness of BR-Evolution v some name", "")
    assert row["verdict"] == "BR-Evolution is lower"


def test_an_empty_repertoire_is_no_error(tmp_path):
    made_study.write_study(tmp_path, [1, 2], 50_000, ["br_evolution", "targets"])
    for path in tmp_path.glob("targets_*/*.csv"):
        rows = list(csv.reader(open(str(path), encoding="utf-8", newline="")))
        if path.name == "history.csv":
            rows = [row[:4] + ["0", "0", "", "", "", "0", "0"] if row[0] == "orientation" else row
                    for row in rows]
        made_study.write_csv(path, rows[0], [row for row in rows[1:] if path.name != "entries.csv"
                                             or row[0] != "orientation"])
    report_of(tmp_path)
    assert row_of(read_table(tmp_path), *PAPER[6])["verdict"] == "nothing to measure"


def drop_a_cell(path):
    lines = path.read_text(encoding="utf-8").splitlines()
    lines[3] = lines[3].rsplit(",", 1)[0]
    path.write_text("\n".join(lines), encoding="utf-8")


def spoil_a_number(path):
    text = path.read_text(encoding="utf-8")
    last = text.rsplit("\n", 2)[1].split(",")
    path.write_text(text.replace(",".join(last), ",".join([*last[:2], "much", *last[3:]])),
                    encoding="utf-8")


def rename_a_column(path):
    text = path.read_text(encoding="utf-8")
    path.write_text(text.replace("evaluations", "generations", 1), encoding="utf-8")


def swap_two_rows(path):
    lines = path.read_text(encoding="utf-8").splitlines()
    lines[2], lines[3] = lines[3], lines[2]
    path.write_text("\n".join(lines), encoding="utf-8")


def keep_the_header(path):
    path.write_text(path.read_text(encoding="utf-8").splitlines()[0] + "\n", encoding="utf-8")


@pytest.mark.parametrize("file, damage, words", [
    ("history.csv", drop_a_cell, ["line 4", "expected 11 cells", "found 10"]),
    ("history.csv", spoil_a_number, ["line 11", "column simulations", "found 'much'"]),
    ("history.csv", rename_a_column, ["expected the columns", "found 'repertoire,generations"]),
    ("history.csv", swap_two_rows, ["line 4", "expected more evaluations", "found 2000"]),
    ("history.csv", keep_the_header, ["expected a row", "found only the header"]),
    ("history.csv", pathlib.Path.unlink, ["expected a file", "found: No such file"]),
    ("entries.csv", spoil_a_number, ["column x_m", "expected a number", "found 'much'"]),
    ("entries.csv", lambda path: path.write_bytes(b""), ["expected the columns", "found ''"]),
    ("entries.csv", lambda path: path.write_bytes(b"\xff\xfe\x00"), ["expected text", "found"]),
    ("run.csv", keep_the_header, ["expected the key 'algorithm'", "found"]),
])
def test_a_damaged_file_ends_it_with_one_sentence(tmp_path, capsys, file, damage, words):
    made_study.write_study(tmp_path, [1, 2], 10_000, ["br_evolution"])
    path = tmp_path / "br_evolution_2_10000" / file
    damage(path)
    assert main([str(tmp_path)]) == 2
    error = capsys.readouterr().err
    assert str(path) in error and error.count("\n") == 1 and error.endswith(".\n")
    assert [word for word in words if word not in error] == []
    assert not (tmp_path / "report").exists()


def test_a_folder_that_is_not_there_or_has_no_finished_run_ends_it_with_one_sentence(
        tmp_path, capsys):
    assert main([str(tmp_path / "nowhere")]) == 2
    assert "expected the folder of a study, found" in capsys.readouterr().err
    (tmp_path / "targets_1_1000.failed").write_text("no memory", encoding="utf-8")
    assert main([str(tmp_path)]) == 2
    error = capsys.readouterr().err
    assert str(tmp_path) in error and "expected at least one finished run" in error
    assert "targets_1_1000 failed: no memory" in error


@pytest.mark.usefixtures("without_figures")
def test_the_report_can_be_written_elsewhere(tmp_path):
    made_study.write_study(tmp_path / "study", [1], 10_000, ["br_evolution"])
    assert main([str(tmp_path / "study"), "--output", str(tmp_path / "a" / "b")]) == 0
    assert (tmp_path / "a" / "b" / "report.md").exists()
    assert not (tmp_path / "study" / "report").exists()


def test_it_knows_no_ros():
    command = "import sys, hexapod_repertoire.study_report; print(*sys.modules)"
    names = subprocess.run([sys.executable, "-c", command], stdout=subprocess.PIPE, check=True,
                           env=dict(os.environ, PYTHONPATH=str(ROOT / "src")),
                           universal_newlines=True).stdout.split()
    assert "scipy" in names and not {"rospy", "roslib", "roslaunch"} & set(names)


def test_seeds_are_told_as_ranges():
    assert seeds_text([5, 1, 2, 3, 9, 10]) == "1-3, 5, 9-10"
