"""Runs the commands of the tutorial and of how-to pages as they stand there, in order, each page in a
folder of its own; the arguments name some of the pages.

A block that is marked as a session goes on in the background until the end of its page. One that is
marked `long` or `robot` takes hours or a robot, and is not run. Each command must end with exit code 0.
In the folder is what is in a checkout, and but for the tutorial a repertoire a.db. Takes some minutes.
"""
import os
import pathlib
import re
import signal
import socket
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
BLOCK = re.compile(r"```sh( session)?\n(.*?)```", re.DOTALL)
READY_S, COMMAND_S = 180, 600
PAGES = ("tutorial", "using", "nodes", "own_robot", "calibration")
CHECKOUT = ("run", "config", "urdf", "launch")
PREPARE = "./run evolve --file a.db --evaluations 20000 --seed 1"


def commands(text):
    """(is it a session, command) of each command of a page; a quotation may span lines."""
    for session, body in BLOCK.findall(text):
        command = ""
        for line in body.splitlines():
            command += line + "\n"
            if command.count('"') % 2 == 0:
                yield bool(session), command.strip()
                command = ""


def free_port():
    """A port of this machine that nobody listens on."""
    with socket.socket() as a_socket:
        a_socket.bind(("127.0.0.1", 0))
        return a_socket.getsockname()[1]


class Terminal:
    """Runs commands in one folder, against one ROS master."""

    def __init__(self, folder):
        for name in CHECKOUT:
            os.symlink(ROOT / name, pathlib.Path(folder) / name)
        self._folder = folder
        self._environment = {**os.environ, "HOME": folder, "CI": os.environ.get("CI", "true"),
                             "ROS_MASTER_URI": f"http://127.0.0.1:{free_port()}",
                             "ROS_IP": "127.0.0.1"}
        self._sessions = []

    def _start(self, command, **how):
        setup = ROOT / "devel/setup.bash"
        return subprocess.Popen(["bash", "-c", f"[[ ! -e {setup} ]] || source {setup}\n{command}"],
                                cwd=self._folder, env=self._environment, start_new_session=True,
                                **how)

    def begin(self, command):
        """Starts a session; returns when an executor that it starts is ready."""
        self._sessions.append(self._start(command))
        deadline = time.monotonic() + READY_S
        while command.startswith("./run walk"):
            if self._sessions[-1].poll() is not None:
                raise RuntimeError(f"This ended by itself: {command}")
            info = self._start("./run info", stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                               universal_newlines=True)
            if "READY" in info.communicate()[0]:
                return
            if time.monotonic() > deadline:
                raise TimeoutError(f"Nothing was ready {READY_S} s after: {command}")

    def run(self, command):
        """Runs a command to its end; returns its exit code."""
        return self._start(command).wait(COMMAND_S)

    def end(self):
        """Ends the sessions as Ctrl-C does."""
        for session in reversed(self._sessions):
            os.killpg(session.pid, signal.SIGINT)
            session.wait()


def run_page(page):
    """Runs the commands of a page; returns the one that failed, or None."""
    with tempfile.TemporaryDirectory() as folder:
        terminal = Terminal(folder)
        try:
            if page != "tutorial" and terminal.run(PREPARE) != 0:
                return PREPARE
            for is_session, command in commands((ROOT / f"doc/{page}.md").read_text("utf-8")):
                print(f"$ {command}", flush=True)
                if is_session:
                    terminal.begin(command)
                elif terminal.run(command) != 0:
                    return command
        finally:
            terminal.end()
    return None


def main(pages):
    """Returns the exit code."""
    for page in pages or PAGES:
        failed = run_page(page)
        if failed:
            print(f"This failed, in doc/{page}.md: {failed}", file=sys.stderr)
            return 1
        print(f"Every command of doc/{page}.md does what it says.", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
