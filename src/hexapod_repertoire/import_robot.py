"""Imports a robot: expands xacro, calls the program import_robot, draws what came out."""
import argparse
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import typing

from hexapod_repertoire import import_picture

NO_XACRO = ("{0} is xacro, and no program xacro is here to expand it. Where ROS is, run\n"
            "xacro {0} > robot.urdf\nand import robot.urdf, with --source {0} where its meshes "
            "are named relative to it.")


def is_xacro(urdf: pathlib.Path) -> bool:
    """Whether the file has to be expanded before it is URDF."""
    try:
        return "<xacro:" in urdf.read_text(encoding="utf-8", errors="replace")
    except OSError:
        return False  # the program says what is wrong with it


def expanded(xacro: pathlib.Path, folder: str) -> pathlib.Path:
    """Writes the URDF of a xacro file into a folder.

    Raises:
        RuntimeError: no program xacro, or it failed; the message says so and what to do.
    """
    if not shutil.which("xacro"):
        raise RuntimeError(NO_XACRO.format(xacro))
    urdf = pathlib.Path(folder) / (xacro.stem + ".urdf")
    result = subprocess.run(["xacro", str(xacro), "-o", str(urdf)], stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, universal_newlines=True, check=False)
    if result.returncode != 0:
        raise RuntimeError(f"xacro could not expand {xacro}:\n{result.stdout.strip()}")
    return urdf


def draw(output: pathlib.Path, since: float) -> typing.Optional[pathlib.Path]:
    """Turns the picture's data that the program has just left into a picture beside it."""
    fresh = [file for file in output.glob("*.json") if file.stat().st_mtime >= since]
    picture = None
    for file in fresh:
        picture = file.with_suffix(".png")
        import_picture.draw(json.loads(file.read_text(encoding="utf-8")), picture)
        file.unlink()
    return picture


def main(words: typing.Sequence[str]) -> int:
    """`words`: the program's path, then its arguments. Returns the program's exit code."""
    program, arguments = words[0], list(words[1:])
    parser = argparse.ArgumentParser(add_help=False, allow_abbrev=False)
    parser.add_argument("urdf", nargs="?", default="")
    parser.add_argument("--output", default=".")
    known, _ = parser.parse_known_args(arguments)
    output = pathlib.Path(known.output)
    with tempfile.TemporaryDirectory() as folder:
        marker = pathlib.Path(folder) / "now"
        marker.touch()
        urdf = pathlib.Path(known.urdf)
        if known.urdf and is_xacro(urdf):
            try:
                made = expanded(urdf, folder)
            except RuntimeError as error:
                print(error, file=sys.stderr)
                return 1
            arguments = [str(made) if word == known.urdf else word for word in arguments]
            if not any(word.startswith("--source") for word in arguments):
                arguments += ["--source", str(urdf)]
        code = subprocess.run([program, *arguments], check=False).returncode
        picture = draw(output, marker.stat().st_mtime) if code in (0, 3) else None
    if picture:
        print(f"Drew {picture}.")
    return code


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
