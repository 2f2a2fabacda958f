"""What record_entries plays, and the moving pictures made of it."""
import os
import pathlib
import subprocess
import sys

import numpy as np
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "src"))
from hexapod_repertoire import moving_picture, recordings, report, show  # noqa: E402
from hexapod_repertoire.repertoire_data import load  # noqa: E402

EVOLVE = os.environ.get("EVOLVE", "")
RECORD = os.environ.get("RECORD_ENTRIES", "")
pytestmark = pytest.mark.skipif(not RECORD, reason="RECORD_ENTRIES does not name the program")


@pytest.fixture(scope="module", name="file")
def fixture_file(tmp_path_factory):
    """A small repertoire as the learner leaves it."""
    file = tmp_path_factory.mktemp("show") / "a.db"
    subprocess.run([EVOLVE, "--file", str(file), "--evaluations", "600", "--validation_trials", "2",
                    "--verify_with_ode", "false", "--resimulate", "false"], check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return str(file)


def farthest(file, count):
    stored = load(file)
    order = np.argsort(-np.linalg.norm(stored.positions_m, axis=1))
    return stored, [int(stored.entries["id"][i]) for i in order[:count]]


def test_behaviours_follow_each_other_and_end_about_where_they_are_predicted_to(file):
    stored, ids = farthest(file, 2)
    recording = recordings.record(RECORD, file, ids)
    first, second = recording.played
    assert [first.entry_id, second.entry_id] == ids
    assert second.start == first.end
    assert recording.legs and first.stands.shape == (len(first.chains), len(recording.legs))
    row = list(stored.entries["id"]).index(ids[0])
    learned = [stored.entries[name][row] for name in ("executed_x_m", "executed_y_m")]
    assert first.predicted[:2] == pytest.approx(learned, abs=1e-4)
    assert np.hypot(*np.subtract(first.end[:2], learned)) < 0.1
    # It begins standing, a first foot may be on its way up already, and walks by lifting them all.
    assert first.stands[0].sum() >= len(recording.legs) - 1
    assert first.stands.any(axis=0).all() and not first.stands.all(axis=0).any()
    assert np.abs(first.chains[:, :, -1, 2][first.stands]).max() < 0.05


def test_an_entry_that_is_not_there_is_told_in_a_sentence(file):
    with pytest.raises(ValueError, match="no entry '-4'"):
        recordings.record(RECORD, file, [-4])


def test_a_moving_picture_has_a_frame_for_each_moment(file, tmp_path, capsys):
    output = tmp_path / "a.gif"
    assert show.main(["--programs", os.path.dirname(RECORD), file, "--output", str(output)]) == 0
    shown = show.best_entry(load(file))
    assert f"entry {shown}: " in capsys.readouterr().out
    data = output.read_bytes()
    moments = list(moving_picture.moments(recordings.record(RECORD, file, [shown])))
    assert data[:6] == b"GIF89a"
    assert data.count(b"\x21\xf9\x04") == len(moments) > 20
    assert len(data) < 1000000


def test_a_picture_of_another_kind_is_refused(file, tmp_path, capsys):
    output = tmp_path / "a.bmp"
    assert show.main(["--programs", os.path.dirname(RECORD), file, "--output", str(output)]) == 1
    assert ".gif, .mp4" in capsys.readouterr().err


def test_the_report_has_a_gait_diagram_of_each_telling_entry(file, tmp_path):
    output = tmp_path / "a.html"
    assert report.main(["--programs", os.path.dirname(RECORD), file, "--output", str(output)]) == 0
    text = output.read_text(encoding="utf-8")
    assert text.count("the foot stands</text>") == len(report.telling_entries(load(file)))
