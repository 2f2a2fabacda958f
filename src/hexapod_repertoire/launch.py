"""Runs a launch file like roslaunch does, and ends with the exit code of what ended it.

roslaunch itself returns 0 even when a required node died with an error, so a script cannot tell a
failed session from a good one.
"""
import difflib
import sys
from typing import List

from roslaunch.arg_dump import dump_args, get_args
from roslaunch.core import RLException
from roslaunch.parent import ROSLaunchParent
from roslaunch.pmon import ProcessListener
from roslaunch.rlutil import get_or_generate_uuid


WRONG_OPTIONS = 2  # exit code of our nodes


class Session(ROSLaunchParent, ProcessListener):
    """A session of roslaunch that remembers how the node ended that ended it.

    A required node ends the session, and so does one that finds its options wrong: started again
    it would find the same. What becomes of the others is no failure of the session: rviz may be
    closed, planner and executor come back when they crash.
    """

    exit_code = 0

    def _start_pm(self) -> None:
        # Here, not in start(): a node may die while others are being started.
        super()._start_pm()
        self.pm.add_process_listener(self)

    def process_died(self, process_name: str, exit_code: int) -> None:
        """Called by roslaunch; exit_code is negative for a signal and None when unknown."""
        process = self.pm.get_process(process_name)
        if process.required:
            code = 1 if exit_code is None else exit_code
            self.exit_code = code if code >= 0 else 128 - code
        elif process.respawn and exit_code == WRONG_OPTIONS:
            self.exit_code = WRONG_OPTIONS
            self.pm.is_shutdown = True


def problem_with(launch_file: str, arguments: List[str]) -> str:
    """What is wrong with arguments name:=value, which roslaunch would ignore in silence; or ""."""
    known = get_args([launch_file])
    for argument in arguments:
        name, assignment, _ = argument.partition(":=")
        if not assignment:
            return f"'{argument}' is no argument of a launch file: expected name:=value."
        if name not in known:
            near = difflib.get_close_matches(name, known, n=1)
            hint = f"did you mean '{near[0]}'?" if near else f"it has: {', '.join(sorted(known))}."
            return f"{launch_file} has no argument '{name}'; {hint}"
    return ""


def main(argv: List[str]) -> int:
    """Launches argv[0] with the arguments argv[1:] (name:=value) and returns the exit code.

    With --ros-args it lists the arguments of the launch file instead, as roslaunch does.
    """
    if "--ros-args" in argv:
        dump_args([argv[0]])
        return 0
    problem = problem_with(argv[0], argv[1:])
    if problem:
        print(problem, file=sys.stderr)
        return 2
    session = Session(
        get_or_generate_uuid(None, False),
        [(argv[0], argv[1:])],
        sigint_timeout=15,
        sigterm_timeout=2,
    )
    try:
        session.start()
    except RLException as error:
        print(error, file=sys.stderr)
        return 2
    session.spin()
    return session.exit_code


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
