"""Macros and blocks of xacro files, and where packages are."""
import pathlib
import re
from typing import Callable, List, NamedTuple, Optional
from xml.dom import minidom

from hexapod_repertoire.xacro_values import Scope, XacroError

PARAMETER = re.compile(
    r"""\s*(\*{0,2})([\w.]+)(?:\s*:?=\s*('[^']*'|"[^"]*"|(?:\$\{[^}]*\}|[^\s'"])+))?(?=\s|$)""")
LEVELS_UP = 5


class Parameter(NamedTuple):
    """One of a macro's: stars 1 is a block, 2 its content; a default is a text."""
    stars: int
    name: str
    default: Optional[str]


class Macro(NamedTuple):
    """A macro and where it was written."""
    parameters: List[Parameter]
    body: List[minidom.Node]
    scope: Scope
    folder: pathlib.Path


def parameters_of(text: str) -> List[Parameter]:
    """The parameters of a macro: "a b:=1 c:='x y' d:=^|2 *block **content"."""
    found, at = [], 0
    while text[at:].strip():
        match = PARAMETER.match(text, at)
        if not match:
            raise XacroError(f"'{text[at:].strip()}' is no list of parameters of a macro")
        default = match.group(3)
        if default and len(default) > 1 and default[0] == default[-1] and default[0] in "'\"":
            default = default[1:-1]
        found.append(Parameter(len(match.group(1)), match.group(2), default))
        at = match.end()
    return found


class Block(NamedTuple):
    """Nodes that are inserted elsewhere, with the names of where they were written."""
    nodes: List[minidom.Node]
    scope: Scope


def package_finder(folder: pathlib.Path, mesh_path: str) -> Callable[[str], pathlib.Path]:
    """Finds packages as the import finds those of meshes: by the folder's name or package.xml."""
    def is_package(candidate: pathlib.Path, name: str) -> bool:
        if candidate.name == name:
            return candidate.is_dir()
        try:
            return f"<name>{name}</name>" in (candidate / "package.xml").read_text(encoding="utf-8")
        except (OSError, UnicodeError):
            return False

    def find(name: str) -> pathlib.Path:
        tops = ([pathlib.Path(mesh_path).resolve()] if mesh_path else []) + \
            list((folder.resolve() / "file").parents)[:LEVELS_UP]
        for top in tops:
            for candidate in (top, top / name):
                if is_package(candidate, name):
                    return candidate
        raise XacroError(f"the package {name} is not found above {folder}; --mesh_path names the "
                         "folder that it is in")
    return find
