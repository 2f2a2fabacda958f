"""Prints which station of src/ includes which others: the table in house.md."""
import pathlib
import re

SOURCE = pathlib.Path(__file__).resolve().parents[1] / "src"
INCLUDE = re.compile(r'^#include "(\w+)/', re.MULTILINE)


def stations():
    """Names of the folders of src/ that hold C++."""
    return {folder.name for folder in SOURCE.iterdir() if any(folder.rglob("*.cpp"))}


def used_by(station):
    """Names of the other stations that the C++ files of one include."""
    files = [file for file in (SOURCE / station).rglob("*") if file.suffix in (".h", ".cpp")]
    found = {name for file in files for name in INCLUDE.findall(file.read_text(encoding="utf-8"))}
    return found & stations() - {station}


def floors():
    """(floor of each station, what each uses); a station stands above all that it uses."""
    uses = {name: used_by(name) for name in stations()}
    placed, floor = {}, 0
    while len(placed) < len(uses):
        here = sorted(name for name in uses if name not in placed and uses[name] <= set(placed))
        if not here:
            raise ValueError(f"These use each other in a circle: {sorted(set(uses) - set(placed))}")
        placed.update(dict.fromkeys(here, floor))
        floor += 1
    return placed, uses


def table():
    """A row per station, from the ground up."""
    placed, uses = floors()
    rows = ["| floor | station | uses |", "|---|---|---|"]
    rows += [f"| {floor} | [{name}](../src/{name}) | {', '.join(sorted(uses[name])) or '-'} |"
             for name, floor in placed.items()]
    return "\n".join(rows)


if __name__ == "__main__":
    print(table())
