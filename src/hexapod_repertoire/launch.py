"""Runs a launch file like roslaunch does, and ends as what ended it did.

roslaunch itself returns 0 even when a required node died with an error, so a script cannot tell a
failed session from a good one; and it tells of a node that has done its work in the same red words
as of one that crashed.
"""
import os
import pathlib
import signal
import sys
import time
import xmlrpc.client
from typing import Any, List

from roslaunch.config import load_config_default
from roslaunch.core import RLException
from roslaunch.parent import ROSLaunchParent
from roslaunch.pmon import ProcessListener
from roslaunch.rlutil import get_or_generate_uuid

from hexapod_repertoire.launch_arguments import (HELP_WORDS, help_text, problem_with,
                                                 with_absolute_paths)
from hexapod_repertoire.leave_picture import leave_picture, newer_than
from hexapod_repertoire.repertoire_data import Unreadable

WRONG_OPTIONS = 2  # exit code of our nodes
INTERRUPTED = 128 + signal.SIGINT
CALLER_ID = "/launch"
# Private parameter in which a node leaves what is to be said when it has ended.
LAST_WORDS = "last_words"


class Impatient(xmlrpc.client.Transport):
    """Waits for an answer for two seconds."""

    def make_connection(self, host: Any) -> Any:
        """As the base class, with a timeout."""
        connection = super().make_connection(host)
        connection.timeout = 2.0
        return connection


def answer_of(uri: str, method: str, *arguments: Any) -> Any:
    """What the ROS master or a node says; None when it is nothing, or nobody is there."""
    try:
        server = xmlrpc.client.ServerProxy(uri, transport=Impatient())
        code, _, value = getattr(server, method)(CALLER_ID, *arguments)
    except (OSError, xmlrpc.client.Error):
        return None
    return value if code == 1 else None


def master_uri() -> str:
    """Where the ROS master is."""
    return os.environ.get("ROS_MASTER_URI", "http://localhost:11311")


def is_running(node: str) -> bool:
    """Does a node of this name answer? A crashed one stays known to the master."""
    uri = answer_of(master_uri(), "lookupNode", node)
    return uri is not None and answer_of(uri, "getPid") is not None


def nodes_in_the_way(launch_file: str, arguments: List[str]) -> List[str]:
    """Names of the nodes of this session that run already: starting them would end those."""
    if answer_of(master_uri(), "getPid") is None:
        return []
    config = load_config_default([(launch_file, arguments)], None, verbose=False)
    names = [node.namespace + node.name for node in config.nodes]
    return [name for name in names if is_running(name)]


class Session(ROSLaunchParent, ProcessListener):
    """A session of roslaunch that remembers how the node ended that ended it.

    A required node ends the session, and so does one that finds its options wrong: started again
    it would find the same. What becomes of the others is no failure of the session: rviz may be
    closed, planner and executor come back when they crash.
    """

    exit_code = INTERRUPTED  # unless a node ends it
    is_ended_by_node = False
    last_words = ""

    def _start_pm(self) -> None:
        # Here, not in start(): a node may die while others are being started.
        super()._start_pm()
        self.pm.add_process_listener(self)
        self._required = set()
        register = self.pm.register

        def register_unrequired(process: Any) -> None:
            """What roslaunch takes for required ends in red; here the session ends it."""
            if process.required and process.package == "hexapod_repertoire":
                process.required = False
                self._required.add(process.name)
            register(process)

        self.pm.register = register_unrequired

    def process_died(self, process_name: str, exit_code: int) -> None:
        """Called by roslaunch; exit_code is negative for a signal and None when unknown."""
        process = self.pm.get_process(process_name)
        ends = process_name in self._required or process.required
        if ends:
            code = 1 if exit_code is None else exit_code
            self.exit_code = code if code >= 0 else 128 - code
        elif process.respawn and exit_code == WRONG_OPTIONS:
            ends = True
            self.exit_code = WRONG_OPTIONS
        if not ends:
            return
        name = process_name.rpartition("-")[0]  # without roslaunch's number
        said = answer_of(master_uri(), "getParam", f"/{name}/{LAST_WORDS}") or ""
        if self.exit_code != 0 and not said:
            said = f"{name} ended with exit code {self.exit_code}; its own words are above."
        self.last_words = said
        self.is_ended_by_node = True
        self.pm.is_shutdown = True

    def end_start(self) -> None:
        """Ends what was started already, and waits for it."""
        if self.pm is not None:
            self.pm.shutdown()
            self.pm.join()
        self.shutdown()


def colored(text: str, is_good: bool) -> str:
    """Green or red on a terminal."""
    if not sys.stdout.isatty():
        return text
    return f"\033[{32 if is_good else 31}m{text}\033[0m"


def run_session(launch_file: str, arguments: List[str]) -> int:
    """Launches, waits for the end, tells how it ended; returns the exit code."""
    session = Session(
        get_or_generate_uuid(None, False),
        [(launch_file, arguments)],
        show_summary=False,
        sigint_timeout=15,
        sigterm_timeout=2,
    )
    try:
        session.start()
        session.spin()
    except RLException as error:
        session.end_start()
        if not session.is_ended_by_node:
            print(error, file=sys.stderr)
            return 2
    if session.last_words:
        print(colored(session.last_words, session.exit_code == 0), flush=True)
    return session.exit_code


def learned_file(launch_file: str, arguments: List[str]) -> str:
    """The file that the learner of a launch file writes; "" when it has none."""
    if pathlib.Path(launch_file).stem != "learn":
        return ""
    config = load_config_default([(launch_file, arguments)], None, verbose=False)
    param = config.params.get("/learner/repertoire_file")
    return os.path.expanduser(param.value) if param else ""


def tell_learned(file: str, since_s: float, code: int) -> None:
    """Leaves a picture beside what was learned since then, and after Ctrl-C says where it is. It is no
    failure of the session when there is no picture."""
    if not file or not newer_than(file, since_s):
        return
    try:
        print("Picture: " + leave_picture(file), flush=True)
    except (Unreadable, OSError) as problem:
        print(f"No picture was drawn: {problem}", file=sys.stderr)
    if code == INTERRUPTED:
        print(f"Saved in {file}. To walk with it: ./run walk repertoire_file:={file}; to go on with a run "
              f"that was not done: ./run learn resume:=true repertoire_file:={file}", flush=True)


def main(argv: List[str]) -> int:
    """Launches argv[0] with the arguments argv[1:] (name:=value) and returns the exit code.

    With --help it lists the arguments of the launch file instead. Relative paths are relative to
    the folder it is called in. 130 after Ctrl-C.
    """
    launch_file, arguments = argv[0], argv[1:]
    if any(word in arguments for word in HELP_WORDS):
        print(help_text(launch_file))
        return 0
    problem = problem_with(launch_file, arguments)
    if problem:
        print(problem, file=sys.stderr)
        return 2
    arguments = with_absolute_paths(arguments)
    try:
        in_the_way = nodes_in_the_way(launch_file, arguments)
    except RLException as error:
        print(error, file=sys.stderr)
        return 2
    if in_the_way:
        verb = pathlib.Path(launch_file).stem
        print(f"At the ROS master {master_uri()} there are already: {', '.join(in_the_way)}. End that "
              "session first (Ctrl-C in its terminal), or use a master of your own: "
              f"ROS_MASTER_URI=http://127.0.0.1:11312 ./run {verb}", file=sys.stderr)
        return 2
    begun_s = time.time()
    code = run_session(launch_file, arguments)
    tell_learned(learned_file(launch_file, arguments), begun_s, code)
    return code


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
