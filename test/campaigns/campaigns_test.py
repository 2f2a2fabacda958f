"""Every campaign, in its short form."""
import os
import pathlib
import subprocess
import sys

import pytest

HERE = pathlib.Path(__file__).resolve().parent
BINARIES = pathlib.Path(os.environ.get("HEXAPOD_BINARIES", ""))


def commands():
    """The command that starts each campaign, by name."""
    found = {file.stem: [sys.executable, str(file)] for file in sorted(HERE.glob("*.py"))
             if not file.stem.endswith("_test")}
    found.update({file.stem: [str(BINARIES / f"campaign_{file.stem}")]
                  for file in sorted(HERE.glob("*.cpp"))})
    return found


@pytest.mark.parametrize("name", sorted(commands()))
def test_short_campaign_succeeds(name):
    result = subprocess.run(
        [*commands()[name], "--short"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        universal_newlines=True, check=False, timeout=300)
    assert result.returncode == 0, result.stdout[-10000:]
