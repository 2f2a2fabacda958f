"""What is said to a launch file: name:=value, checked, made absolute, explained."""
import difflib
import os
import pathlib
import textwrap
from typing import Dict, List, Optional, Tuple

from roslaunch.arg_dump import get_args

# Arguments that name a file end in one of these.
FILE_ENDINGS = ("_file", "config", "joint_map")
# Those that must be there before anything is started; a repertoire is looked for by its server.
READ_FILES = ("config", "robot_config", "urdf_file", "executor_config", "planner_config",
              "relay_config", "joint_map")
HELP_WORDS = ("--help", "-h", "--ros-args")
HELP_COLUMNS = 80


def known_arguments(launch_file: str) -> Dict[str, Tuple[str, Optional[str]]]:
    """(doc, default) of the arguments of a launch file by name; None: it must be given."""
    return {name: (doc or "", default) for name, (doc, default) in get_args([launch_file]).items()}


def problem_with(launch_file: str, arguments: List[str]) -> str:
    """What is wrong with arguments name:=value, which roslaunch would ignore in silence; or ""."""
    known = known_arguments(launch_file)
    verb = pathlib.Path(launch_file).stem
    for argument in arguments:
        name, assignment, _ = argument.partition(":=")
        if not assignment:
            return (f"'{argument}' is no argument of {verb}: expected name:=value; "
                    f"`./run {verb} --help` lists them.")
        if name not in known:
            near = difflib.get_close_matches(name, known, n=1)
            hint = f"did you mean '{near[0]}'?" if near else f"it has: {', '.join(sorted(known))}."
            return f"{verb} has no argument '{name}'; {hint}"
        path = os.path.abspath(os.path.expanduser(argument.partition(":=")[2]))
        if name in READ_FILES and argument != f"{name}:=" and not os.path.isfile(path):
            return f"{verb} reads {name}, and there is no file {path}."
        if name == "rviz" and "true" in argument.lower() and not os.environ.get("DISPLAY"):
            return ("rviz:=true needs a display, and DISPLAY is not set here. Leave it out, or run "
                    "rviz on a machine that has one, with ROS_MASTER_URI pointing here.")
    return ""


def with_absolute_paths(arguments: List[str]) -> List[str]:
    """The arguments, with relative paths of files taken from the caller's folder.

    Nodes run in another one, where a relative path would name something else.
    """
    absolute = []
    for argument in arguments:
        name, _, value = argument.partition(":=")
        if name.endswith(FILE_ENDINGS) and value:
            value = os.path.abspath(os.path.expanduser(value))
        absolute.append(f"{name}:={value}")
    return absolute


def help_text(launch_file: str) -> str:
    """What `./run <verb> --help` prints."""
    verb = pathlib.Path(launch_file).stem
    known = known_arguments(launch_file)
    width = max(map(len, known)) + 2
    lines = [f"usage: ./run {verb} [name:=value ...]", ""]
    for name, (doc, default) in known.items():
        meaning = " ".join(doc.split())
        if default:
            if os.path.isabs(default):
                default = os.path.normpath(default)
            meaning += f" [{default.replace(os.path.expanduser('~'), '~')}]"
        lines += textwrap.wrap(meaning, HELP_COLUMNS, initial_indent=f"  {name:<{width}}",
                               subsequent_indent=" " * (width + 2), break_on_hyphens=False)
    return "\n".join(lines)
