"""Calibrates a robot: has behaviours played, calls the program calibrate, draws what came out."""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile
import typing

from hexapod_repertoire import calibration_picture

# With one of these the program needs no robot that is there.
ALONE = ("help", "simulated", "draws", "plan", "trials")


def is_alone(arguments: typing.Sequence[str]) -> bool:
    """Whether the program's arguments say all."""
    names = {word.lstrip("-").split("=")[0].split(":")[0] for word in arguments
             if word.startswith("--") or ":=" in word}
    return bool(names & set(ALONE))


def call(program: str, arguments: typing.Sequence[str], output: pathlib.Path) -> int:
    """Calls the program; turns what it leaves for a picture into one."""
    data = output.with_name(output.name + ".json")
    if data.exists():
        data.unlink()
    code = subprocess.run([program, *arguments], check=False).returncode
    if data.exists():
        picture = output.with_name(output.name + ".png")
        calibration_picture.draw(json.loads(data.read_text(encoding="utf-8")), picture)
        data.unlink()
        print(f"Drew {picture}.")
    return code


def with_robot(program: str, arguments: typing.Sequence[str], known: argparse.Namespace) -> int:
    """Has the robot of the running session play what the program plans; fits to that."""
    # Only here ROS is needed.
    from hexapod_repertoire import calibration_robot  # pylint: disable=import-outside-toplevel
    output = pathlib.Path(known.output)
    trials = output.with_name(output.name + ".csv")
    with tempfile.TemporaryDirectory() as folder:
        plan = pathlib.Path(folder) / "plan.csv"
        code = subprocess.run([program, *arguments, "--plan", str(plan)], check=False).returncode
        if code != 0:
            return code
        code = calibration_robot.main(plan, trials, known.global_frame, known.base_frame)
    return code or call(program, [*arguments, "--trials", str(trials)], output)


def main(words: typing.Sequence[str]) -> int:
    """`words`: the program's path, then its arguments. Returns the exit code."""
    parser = argparse.ArgumentParser(add_help=False, allow_abbrev=False)
    parser.add_argument("--global_frame", default="odom")
    parser.add_argument("--base_frame", default="base_footprint")
    frames, arguments = parser.parse_known_args(list(words[1:]))
    parser.add_argument("--output", default="calibrated")
    known, _ = parser.parse_known_args(list(words[1:]), frames)
    if is_alone(arguments):
        return call(words[0], arguments, pathlib.Path(known.output))
    return with_robot(words[0], arguments, known)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
