"""Every campaign, in its short form; some at a time, since they wait for robots that walk."""
import concurrent.futures
import os
import pathlib
import subprocess
import sys

import pytest

HERE = pathlib.Path(__file__).resolve().parent
BINARIES = pathlib.Path(os.environ.get("HEXAPOD_BINARIES", ""))
AT_A_TIME = 4


def commands():
    """The command that starts each campaign, by name."""
    found = {file.stem: [sys.executable, str(file)] for file in sorted(HERE.glob("*.py"))
             if not file.stem.endswith("_test")}
    found.update({file.stem: [str(BINARIES / f"campaign_{file.stem}")]
                  for file in sorted(HERE.glob("*.cpp"))})
    return found


def short_form(name):
    """The finished process of a campaign."""
    return subprocess.run(
        [*commands()[name], "--short"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        universal_newlines=True, check=False, timeout=400)


@pytest.fixture(scope="module", name="running")
def start_all(request):
    """The campaigns asked for, by name, as futures of their processes."""
    names = [item.callspec.params["name"] for item in request.session.items
             if item.module is request.module]
    with concurrent.futures.ThreadPoolExecutor(AT_A_TIME) as pool:
        yield {name: pool.submit(short_form, name) for name in names}


@pytest.mark.parametrize("name", sorted(commands()))
def test_short_campaign_succeeds(name, running):
    result = running[name].result()
    assert result.returncode == 0, result.stdout[-10000:]
