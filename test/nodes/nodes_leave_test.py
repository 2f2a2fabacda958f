"""The nodes leave in time, whatever time and master do."""
import contextlib
import os
import pathlib
import signal
import socketserver
import subprocess
import sys
import threading
import time
import xmlrpc.server

import pytest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import walking_session as ws  # noqa: E402

LEFT_S = 2.0


class HangingMaster(socketserver.ThreadingMixIn, xmlrpc.server.SimpleXMLRPCServer):
    """A master that answers until it is asked for a node's own parameters."""

    daemon_threads = True
    block_on_close = False

    def __init__(self):
        super().__init__(("127.0.0.1", 0), logRequests=False)
        self.asked = threading.Event()
        threading.Thread(target=self.serve_forever, daemon=True).start()

    def _dispatch(self, method, params):
        if method == "getParam" and params[1].startswith("/asking"):
            self.asked.set()
            threading.Event().wait()
        return [1, "", {"hasParam": False}.get(method, [])]



def test_where_simulated_time_never_begins_the_planner_says_so_and_leaves():
    with ws.WalkingSession(sim_time=True, nodes=("planner",)) as timeless:
        ws.wait_for(lambda: "no time comes on /clock" in timeless.log("planner"), 20.0,
                    "a sentence about /clock")
        assert timeless.leave("planner")[1] < LEFT_S
        timeless.start("planner")
        ws.wait_for(lambda: timeless.log("planner").count("no time comes on /clock") > 1, 20.0,
                    "the planner")
        timeless.send_signal("master", signal.SIGSTOP)  # one that hangs
        assert timeless.leave("planner", signal.SIGTERM)[1] < LEFT_S


def test_every_node_leaves_though_the_master_hangs():
    nodes = ("repertoire_server", "simulated_robot", "executor")
    with ws.WalkingSession(nodes=nodes) as session:
        for node in nodes:
            ws.wait_for(lambda node=node: session.knows(node), 20.0, node)
        session.send_signal("master", signal.SIGSTOP)
        for node in nodes:
            code, left_s = session.leave(node, signal.SIGTERM)
            assert code == 0, node
            assert left_s < LEFT_S, node


@contextlib.contextmanager
def asking(node, folder, *command):
    """A node, started by a command, that waits for a master to answer."""
    with HangingMaster() as master:
        environment = dict(os.environ, ROS_IP="127.0.0.1", ROS_LOG_DIR=str(folder),
                           ROS_MASTER_URI=f"http://127.0.0.1:{master.server_address[1]}")
        with subprocess.Popen([*command, str(ws.BINARIES / node), "__name:=asking"],
                              env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT) as process:
            try:
                assert master.asked.wait(20.0), node
                yield process
            finally:
                process.kill()
        master.shutdown()


@pytest.mark.parametrize("node, number", (
    ("repertoire_server", signal.SIGINT), ("simulated_robot", signal.SIGTERM),
    ("executor", signal.SIGTERM), ("planner", signal.SIGHUP), ("learner", signal.SIGINT),
    ("browser", signal.SIGTERM)))
def test_a_node_that_waits_for_the_master_s_answer_leaves_without_an_error(node, number, tmp_path):
    with asking(node, tmp_path) as process:
        begin = time.monotonic()
        process.send_signal(number)
        output = process.communicate(timeout=20.0)[0]
        assert time.monotonic() - begin < LEFT_S
        assert (process.returncode, b"FATAL" in output) == (0, False), output


def test_a_node_waits_for_a_hang_up_unless_started_to_ignore_it(tmp_path):
    def waits_for_hang_up(process):
        status = pathlib.Path(f"/proc/{process.pid}/status").read_text(encoding="ascii")
        blocked = int(status.split("SigBlk:")[1].split()[0], 16)
        return bool(blocked >> (signal.SIGHUP - 1) & 1)

    with asking("executor", tmp_path) as process:
        assert waits_for_hang_up(process)
    with asking("executor", tmp_path, "nohup") as process:
        assert not waits_for_hang_up(process)
