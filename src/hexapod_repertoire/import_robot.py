"""Imports a robot: expands xacro, calls the program import_robot, draws what came out."""
import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import typing

from hexapod_repertoire import import_picture, xacro_document, xacro_values

def is_xacro(urdf: pathlib.Path) -> bool:
    """Whether the file has to be expanded before it is URDF."""
    try:
        text = urdf.read_text(encoding="utf-8", errors="replace")
    except OSError:
        return False  # the program says what is wrong with it
    return "<xacro:" in text or "${" in text or "$(" in text


def expanded(xacro: pathlib.Path, folder: str, arguments: typing.Mapping[str, str],
             mesh_path: str) -> pathlib.Path:
    """Writes the URDF of a xacro file into a folder; by the program xacro where it is installed.

    Raises:
        RuntimeError: it cannot be expanded; the message says why.
    """
    urdf = pathlib.Path(folder) / (xacro.stem + ".urdf")
    if not shutil.which("xacro"):
        try:
            urdf.write_text(xacro_document.expand(xacro, arguments, mesh_path), encoding="utf-8")
        except xacro_values.XacroError as problem:
            raise RuntimeError(f"{xacro} cannot be expanded: {problem}") from None
        return urdf
    given = [f"{name}:={value}" for name, value in arguments.items()]
    result = subprocess.run(["xacro", str(xacro), "-o", str(urdf), *given], stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, universal_newlines=True, check=False)
    if result.returncode != 0:
        raise RuntimeError(f"xacro could not expand {xacro}:\n{result.stdout.strip()}")
    return urdf


def split_arguments(words: typing.Sequence[str]) -> typing.Tuple[typing.List[str],
                                                                 typing.Dict[str, str]]:
    """Takes the arguments of a xacro file, name:=value, out of a command line."""
    is_pair = re.compile(r"\w+:=")
    return ([word for word in words if not is_pair.match(word)],
            dict(word.split(":=", 1) for word in words if is_pair.match(word)))


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
    program = words[0]
    arguments, pairs = split_arguments(words[1:])
    parser = argparse.ArgumentParser(add_help=False, allow_abbrev=False)
    parser.add_argument("urdf", nargs="?", default="")
    parser.add_argument("--output", default=".")
    parser.add_argument("--mesh_path", default="")
    known, _ = parser.parse_known_args(arguments)
    output = pathlib.Path(known.output)
    with tempfile.TemporaryDirectory() as folder:
        marker = pathlib.Path(folder) / "now"
        marker.touch()
        urdf = pathlib.Path(known.urdf)
        if known.urdf and is_xacro(urdf):
            try:
                made = expanded(urdf, folder, pairs, known.mesh_path)
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
