"""The code of doc/python.md runs, block after block."""
import pathlib
import re
import shutil

PAGE = pathlib.Path(__file__).resolve().parents[2] / "doc" / "python.md"
BLOCK = re.compile(r"```python\n(.*?)```", re.DOTALL)


def test_the_tutorial_runs(tmp_path, monkeypatch, capsys, gaits):
    monkeypatch.chdir(tmp_path)
    shutil.copy(gaits, tmp_path / "gaits.db")
    blocks = BLOCK.findall(PAGE.read_text(encoding="utf-8"))
    assert len(blocks) == 5
    names = {}
    for block in blocks:
        exec(compile(block, str(PAGE), "exec"), names)  # pylint: disable=exec-used
    assert (tmp_path / "archive.png").stat().st_size > 10000
    printed = capsys.readouterr().out
    assert "fall on ice" in printed and "(130, 18)" in printed
    assert len(names["entries"]) > 100
    assert names["least"] < 0.1
