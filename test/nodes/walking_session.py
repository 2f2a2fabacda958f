"""A master and the nodes that walk, as processes of one test: to be signalled, killed, lied to."""
import os
import pathlib
import signal
import socket
import struct
import subprocess
import tempfile
import time
import xmlrpc.client

ROOT = pathlib.Path(__file__).resolve().parents[2]
BINARIES = pathlib.Path(os.environ.get("HEXAPOD_BINARIES",
                                       ROOT / "devel/lib/hexapod_repertoire"))
NODES = ("repertoire_server", "simulated_robot", "executor", "planner")


def wait_for(condition, timeout_s, what):
    """Waits until condition() is truthy and returns it; fails after timeout_s of steady time."""
    deadline = time.monotonic() + timeout_s
    while time.monotonic() < deadline:
        value = condition()
        if value:
            return value
        time.sleep(0.01)
    raise AssertionError(f"Waited {timeout_s} s in vain for {what}.")


def free_port():
    with socket.socket() as a_socket:
        a_socket.bind(("127.0.0.1", 0))
        return a_socket.getsockname()[1]


def small_repertoire(folder, validation_trials):
    """A repertoire file that covers half a metre around the robot; some seconds."""
    file = pathlib.Path(folder) / "small.db"
    subprocess.run(
        [str(BINARIES / "evolve"), "--file", str(file), "--evaluations", "2000", "--seed", "1",
         "--verify_with_ode", "false", "--resimulate", "false", "--validation_trials",
         str(validation_trials)],
        check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return file


class WalkingSession:
    """Master, simulated robot, executor, planner and repertoire server on a port of their own.

    Use it as a context: in the end nothing is left running. This process becomes a client of its
    master: its ROS_MASTER_URI is set, so start it before rospy.
    """

    def __init__(self, real_time_factor=1.0, sim_time=False, settable_clock=False, nodes=NODES,
                 params=None, validation_trials=4):
        self._folder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self._folder.name)
        self._port = free_port()
        self.uri = f"http://127.0.0.1:{self._port}"
        self._processes = {}
        self._sim_time, self._factor, self._nodes = sim_time, real_time_factor, nodes
        self._params = params or {}
        self._validation_trials = validation_trials
        self._clock_file = self.folder / "clock" if settable_clock else None
        if self._clock_file:
            self._clock_file.write_bytes(bytes(8))

    def __enter__(self):
        self._environment = dict(os.environ)
        os.environ.update(ROS_MASTER_URI=self.uri, ROS_IP="127.0.0.1", ROS_HOME=self._folder.name,
                          ROS_LOG_DIR=self._folder.name)
        try:
            self.start_master()
            self._set_params()
            for node in self._nodes:
                self.start(node)
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        for name in sorted(self._processes, key=lambda name: name == "master"):
            self.kill(name)
        self._folder.cleanup()
        os.environ.clear()
        os.environ.update(self._environment)

    def start_master(self):
        """Starts the master, the same port again when it was killed."""
        self._popen("master", ["/usr/bin/rosmaster", "--core", "-p", str(self._port)])
        wait_for(self._master_answers, 20.0, "the master")

    def _master_answers(self):
        try:
            return xmlrpc.client.ServerProxy(self.uri).getPid("/test")[0] == 1
        except OSError:
            return False

    def _set_params(self):
        repertoire = small_repertoire(self.folder, self._validation_trials)
        robot_config = str(ROOT / "config/hexapod.yaml")
        values = {
            "/robot_description": (ROOT / "urdf/hexapod.urdf").read_text(encoding="utf-8"),
            "/use_sim_time": self._sim_time,
            "/actionlib_client_pub_queue_size": 10000,  # a client that drops no goals
            "/repertoire_server/repertoire_file": str(repertoire),
            "/simulated_robot/robot_config": robot_config,
            "/simulated_robot/engine": "reduced",
            "/simulated_robot/publish_clock": self._sim_time,
            "/simulated_robot/real_time_factor": self._factor,
            "/executor/robot_config": robot_config,
            "/executor/auto_arm": True,
            "/executor/ramp_time_s": 0.3,
            # A busy machine is no fault of the robot.
            "/executor/feedback_timeout_s": 1.5,
            "/executor/tracking_timeout_s": 1.5,
            "/planner/robot_config": robot_config,
            "/planner/cmd_vel": True,
            "/planner/cmd_vel_timeout_s": 1.0,
            **self._params,
        }
        for key, value in values.items():
            self.set_param(key, value)

    def set_param(self, key, value):
        xmlrpc.client.ServerProxy(self.uri).setParam("/test", key, value)

    def start(self, node, name=None, remappings=()):
        """Starts a node; under another name, beside the one of that name."""
        name = name or node
        self._popen(name, [str(BINARIES / node), f"__name:={name}", *remappings])

    def _popen(self, name, command):
        environment = dict(os.environ)
        if self._clock_file and name != "master":
            environment.update(
                LD_PRELOAD=str(BINARIES.parent / "libsettable_clock.so"),
                SETTABLE_CLOCK=str(self._clock_file))
        with open(self.folder / f"{name}.log", "ab") as log:
            self._processes[name] = subprocess.Popen(command, env=environment, stdout=log,
                                                     stderr=subprocess.STDOUT)

    def set_clock(self, offset_s):
        """Sets the wall clock of all nodes, as somebody does with date; this process keeps its own."""
        # The nodes have this very file in their memory.
        with open(self._clock_file, "r+b") as file:
            file.write(struct.pack("=q", round(1e9 * offset_s)))

    def is_running(self, name):
        return self._processes[name].poll() is None

    def knows(self, name):
        """True when the master knows a node."""
        return xmlrpc.client.ServerProxy(self.uri).lookupNode("/test", f"/{name}")[0] == 1

    def process(self, name):
        return self._processes[name]

    def send_signal(self, name, number):
        self._processes[name].send_signal(number)

    def kill(self, name):
        """kill -9, and waits for the end."""
        self._processes[name].send_signal(signal.SIGCONT)
        self._processes[name].kill()
        self._processes[name].wait()

    def leave(self, name, number=signal.SIGINT, timeout_s=20.0):
        """Asks a node to leave; (exit code, seconds that took)."""
        begin = time.monotonic()
        self.send_signal(name, number)
        code = self._processes[name].wait(timeout_s)
        return code, time.monotonic() - begin

    def log(self, name):
        return (self.folder / f"{name}.log").read_text(encoding="utf-8", errors="replace")

    def resident_kib(self, name):
        """Memory in use by a node [KiB]."""
        status = pathlib.Path(f"/proc/{self._processes[name].pid}/status").read_text()
        return int(status.split("VmRSS:")[1].split()[0])
