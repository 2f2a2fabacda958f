"""The check of joint limits finds what breaks them."""
import pathlib
import struct
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
CHECK = ROOT / "test" / "execution" / "joint_limit_check.py"
NAME = "body_leg_0"  # -pi/2 .. pi/2 rad, 6.28 rad/s: 0.1884 rad in a period
SESSION, START, COMMAND = 0, 1, 2


def verdict(*records, acceleration=0.0):
    """(exit code, last line) for records (kind, slot, angle) of one joint."""
    stream = NAME.encode() + b"\n" + b"".join(
        struct.pack("<qqdd", kind, slot, acceleration, angle)
        for kind, slot, angle in ((SESSION, 0, 0.0),) + records)
    result = subprocess.run([sys.executable, str(CHECK), str(ROOT / "urdf" / "hexapod.urdf"), "1"],
                            input=stream, stdout=subprocess.PIPE, check=False)
    return result.returncode, result.stdout.decode().splitlines()[-1]


def test_a_stream_within_the_limits_passes():
    code, line = verdict((COMMAND, 1, 0.18), (COMMAND, 2, 0.36), (START, 3, 1.0), (COMMAND, 3, 1.1))
    assert code == 0 and line.endswith("| 0 | 0 | 0 | 0 |")


@pytest.mark.parametrize("records, acceleration, counts", [
    (((START, 0, 1.5), (COMMAND, 1, 1.6)), 0.0, "| 1 | 0 | 0 | 0 |"),
    (((COMMAND, 1, 0.19),), 0.0, "| 0 | 1 | 0 | 0 |"),
    (((COMMAND, 1, 0.1), (COMMAND, 9, -0.1)), 0.0, "| 0 | 1 | 0 | 0 |"),
    (((COMMAND, 1, 0.05), (COMMAND, 2, 0.16)), 60.0, "| 0 | 0 | 1 | 0 |"),
    (((COMMAND, 1, 0.05), (COMMAND, 2, 0.05), (COMMAND, 3, 0.11)), 60.0, "| 0 | 0 | 1 | 0 |"),
    (((COMMAND, 1, float("nan")),), 0.0, "| 0 | 0 | 0 | 1 |"),
    ((), 0.0, "| 0 | 0 | 0 | 0 |")])
def test_what_breaks_a_limit_is_counted_and_fails(records, acceleration, counts):
    code, line = verdict(*records, acceleration=acceleration)
    assert code == 1 and line.endswith(counts), line
