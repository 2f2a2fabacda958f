"""The page about repertoires: whole, self-contained, the same each time, and true."""
import html.parser
import math
import pathlib
import sqlite3
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "src"))
from hexapod_repertoire import (gait_diagram, recordings, repertoire_data, report,  # noqa: E402
                                report_figures, walk_log)

VOID = {"meta", "link", "br", "img", "path", "circle", "rect", "stop", "use"}


def write(path, entries, version="2", worlds=()):
    """A repertoire file; entries are (x, y, yaw, error)."""
    database = sqlite3.connect(path)
    database.executescript("""
        CREATE TABLE entries(id INTEGER PRIMARY KEY, genome TEXT, x_m REAL, y_m REAL, yaw_rad REAL,
          orientation_error_rad REAL, executed_x_m REAL, executed_y_m REAL, spread_m REAL,
          trials INTEGER, falls INTEGER);
        CREATE TABLE meta(key TEXT PRIMARY KEY, value TEXT);
        CREATE TABLE history(evaluations INTEGER, archive_size INTEGER, sparseness_m REAL,
          median_orientation_error_rad REAL, elapsed_s REAL);
        INSERT INTO history VALUES (100, 1, 0.05, 0.2, 1.0), (200, 2, 0.04, 0.1, 2.0);""")
    database.executemany(
        "INSERT INTO entries VALUES (?, '210000302100', ?, ?, ?, ?, ?, ?, 0.004, 8, 0)",
        [(i + 1, x, y, yaw, error, x + 0.01, y) for i, (x, y, yaw, error) in enumerate(entries)])
    database.executemany("INSERT INTO meta VALUES (?, ?)", [
        ("format_version", version), ("evaluations", "200"), ("seed", "7"), *worlds])
    database.commit()
    database.close()
    return str(path)


@pytest.fixture(name="file")
def fixture_file(tmp_path):
    return write(tmp_path / "a <b>.db", [(0.5, 0.1, 0.4, 0.02), (-0.3, 0.0, 0.0, 0.5)],
                 worlds=[("fact.resimulated.mu 0.7.sparseness_m", "0.023")])


class Page(html.parser.HTMLParser):
    """Checks that elements are closed in order; collects texts, titles and references."""

    def __init__(self, text):
        super().__init__()
        self.open, self.texts, self.references = [], [], []
        self.feed(text)
        assert not self.open

    def handle_starttag(self, tag, attrs):
        self.references += [value for name, value in attrs
                            if name in ("src", "href", "xlink:href") and value]
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        if tag not in VOID:
            assert self.open.pop() == tag

    def handle_data(self, data):
        self.texts.append(data)


def test_page_is_whole_and_needs_nothing_else(file, tmp_path):
    assert report.main([file]) == 0
    text = (tmp_path / "a <b>.html").read_text(encoding="utf-8")
    page = Page(text)
    assert "a <b>.db" in page.texts  # the name is shown, not taken for markup
    assert all(reference.startswith(("#", "data:")) for reference in page.references)


def test_hover_names_the_entry_and_what_trials_made_of_it(file):
    stored = repertoire_data.load(file)
    titles = Page(report_figures.archive(stored, 0.6)).texts
    assert any("entry 1: +0.500 m, +0.100 m, +23 deg" in title and "error 1.15 deg" in title
               and "shift 1.00 cm" in title for title in titles)


def test_the_same_files_make_the_same_page(file):
    stored = [repertoire_data.load(file)]
    assert report.page(stored) == report.page(stored)


def test_two_files_stand_side_by_side_on_one_scale(file, tmp_path):
    other = write(tmp_path / "other.db", [(1.0, 0.0, 0.0, 0.0)])
    stored = [repertoire_data.load(file), repertoire_data.load(other)]
    page = report.page(stored)
    assert page.count('aria-label="End poses of') == 2
    assert report_figures.reach_m(stored) == pytest.approx(1.1)
    assert "mu 0.7" in page


def test_colour_is_the_orientation_error_dark_is_bad(file):
    def brightness(error_deg):
        red, green, blue = report_figures.matplotlib.colors.to_rgb(
            report_figures._color(error_deg))
        return 0.3 * red + 0.6 * green + 0.1 * blue
    levels = [brightness(error_deg) for error_deg in range(0, 12)]
    assert all(a > b for a, b in zip(levels, levels[1:11]))
    assert levels[10] == levels[11]


def test_signals_are_those_of_the_genes(file):
    stored = repertoire_data.load(file)
    assert stored.signals(0)[:2] == [(0.5, 0.25), (0.0, 0.0)]
    assert len(stored.signals(0)) == 6


def test_signals_of_more_levels(file):
    with sqlite3.connect(file) as database:
        database.execute("INSERT INTO meta VALUES ('option.gene_levels', '253')")
        database.execute("UPDATE entries SET genome = 'x7e3ffc04' WHERE id = 1")
    database.close()
    assert repertoire_data.load(file).signals(0) == [(0.5, 63 / 252), (1.0, 4 / 252)]


def test_measures_of_known_entries(file):
    values = {label: value(repertoire_data.load(file)) for label, value in report.MEASURES}
    assert values["entries"] == "2" and values["seed"] == "7"
    assert values["farthest entry"] == f"{math.hypot(0.5, 0.1):.2f} m"
    assert values["sparseness where it learned"] == "4.00 cm"
    assert values["shift of trials, median"] == "1.00 cm"


def test_an_empty_repertoire_has_a_page_too(tmp_path):
    Page(report.page([repertoire_data.load(write(tmp_path / "empty.db", []))]))


def test_a_bar_for_each_time_that_a_foot_stands():
    stands = recordings.np.array([True, True, False, False, True])
    assert gait_diagram.spans(stands, 0.5) == [(0.0, 1.0), (2.0, 0.5)]
    frame = '{"legs": [[[0, 0, 0.1], [0.1, 0, 0]]], "stands": [%s]}'
    text = ('{"period_s": 0.5, "legs": ["left"], "behaviours": [{"id": 3, "start": [0, 0, 0], '
            '"predicted": [1, 0, 0], "end": [1, 0, 0], "frames": [' +
            ", ".join(frame % str(bool(one)).lower() for one in stands) + "]}]}")
    played = recordings.parse(text).played[0]
    assert played.entry_id == 3 and played.chains.shape == (5, 1, 2, 3)
    assert gait_diagram.duty_factors(played).tolist() == [0.6]


def test_a_walk_log_is_read_as_it_was_written_and_told_in_the_page(file, tmp_path):
    steps = [walk_log.Step(7, (0.0, 0.0, 0.0), (0.5, 0.0, 3.1), (0.46, 0.03, -3.1))]
    log = str(tmp_path / "walk.csv")
    walk_log.write(log, steps)
    assert walk_log.read(log) == steps
    apart_m, turn_rad = steps[0].errors()
    assert apart_m == pytest.approx(0.05) and turn_rad == pytest.approx(2.0 * math.pi - 6.2)
    assert report.main([file, "--walk", log]) == 0
    assert "walk.csv" in Page((tmp_path / "a <b>.html").read_text(encoding="utf-8")).texts


def test_what_is_no_walk_log_is_told_in_a_sentence(tmp_path):
    log = tmp_path / "walk.csv"
    for text, says in (("a,b\n", "no walk log"), (",".join(walk_log.COLUMNS) + "\n1,2\n", "line 2")):
        log.write_text(text)
        with pytest.raises(ValueError, match=says):
            walk_log.read(str(log))


def test_measures_of_two_files_are_compared_in_columns(file, tmp_path):
    other = write(tmp_path / "other.db", [(1.0, 0.0, 0.0, 0.0)])
    lines = report.compared([repertoire_data.load(file), repertoire_data.load(other)]).splitlines()
    assert lines[0].split() == ["a", "<b>.db", "other.db"]
    assert lines[1].split() == ["entries", "2", "1"]


@pytest.mark.parametrize("make, says", [
    (lambda path: None, "There is no file"),
    (lambda path: path.write_text("a letter"), "is no repertoire file"),
    (lambda path: write(path, [], version="1"), "expected 2"),
])
def test_what_is_no_repertoire_is_told_in_a_sentence(tmp_path, capsys, make, says):
    path = tmp_path / "bad.db"
    make(path)
    assert report.main([str(path)]) == 1
    assert says in capsys.readouterr().err
    assert not (tmp_path / "bad.html").exists()
