"""A launched session ends with the exit code of the required node that ended it."""
import os
import pathlib
import signal
import socket
import subprocess
import sys
import time

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
# The nodes are shell commands: what roslaunch takes for the program only has to be there.
LAUNCH = """<launch>
  <arg name="other"/>
  <arg name="required"/>
  <node name="other" pkg="rosout" type="rosout" launch-prefix="{script} $(arg other)"/>
  <node name="required" pkg="rosout" type="rosout" {fate}
        launch-prefix="{script} $(arg required)"/>
</launch>"""


def free_port():
    with socket.socket() as a_socket:
        a_socket.bind(("127.0.0.1", 0))
        return a_socket.getsockname()[1]


@pytest.mark.parametrize("other, required, expected", [
    ("exit-3", "exit-0", 0), ("exit-0", "exit-4", 4), ("exit-3", "kill-9", 128 + 9)])
def test_only_the_required_node_counts(tmp_path, other, required, expected):
    assert exit_code(tmp_path, 'required="true"', other, required) == expected


def test_a_node_that_finds_its_options_wrong_is_not_started_again(tmp_path):
    assert exit_code(tmp_path, 'respawn="true"', "exit-3", "exit-2") == 2


def test_a_session_that_is_interrupted_says_so(tmp_path):
    """As after Ctrl-C; the required node waits for the other one for ever."""
    pytest.importorskip("roslaunch.parent")
    process = launch(tmp_path, 'required="true"', "wait", "wait")
    while not (tmp_path / "started").exists():
        assert process.poll() is None
        time.sleep(0.05)
    process.send_signal(signal.SIGINT)
    output, _ = process.communicate(timeout=30)
    assert process.returncode == 130, output
    assert "Traceback" not in output


def is_alive(process_id):
    try:
        os.kill(process_id, 0)
    except ProcessLookupError:
        return False
    return True


def test_a_node_that_ends_the_session_while_others_are_started_leaves_none_of_them(tmp_path):
    pytest.importorskip("roslaunch.parent")
    script = tmp_path / "node.sh"
    script.write_text(f"""#!/bin/sh
echo $$ >>{tmp_path}/ids
case $1 in exit-*) exit ${{1#exit-}} ;; esac
exec sleep 60
""")
    script.chmod(0o755)
    node = '<node name="{0}" pkg="rosout" type="rosout" launch-prefix="' + f'{script} {{1}}" {{2}}/>'
    nodes = [node.format(f"waits{i}", "wait", "") for i in range(25)]
    nodes.insert(3, node.format("required", "exit-3", 'required="true"'))
    process = launch_text(tmp_path, "<launch>" + "".join(nodes) + "</launch>")
    output, _ = process.communicate(timeout=60)
    assert process.returncode == 3, output
    started = [int(line) for line in (tmp_path / "ids").read_text().split()]
    assert len(started) > 3
    assert [one for one in started if is_alive(one)] == []


def exit_code(tmp_path, fate, other, required):
    pytest.importorskip("roslaunch.parent")
    process = launch(tmp_path, fate, other, required)
    print(process.communicate()[0])
    return process.returncode


def launch(tmp_path, fate, other, required):
    """The running launch of the two nodes."""
    script = tmp_path / "node.sh"
    # The required one waits until the other has ended.
    script.write_text(f"""#!/bin/sh
touch {tmp_path}/started
case $1 in wait) exec sleep 60 ;; esac
case $* in *__name:=required*) until [ -e {tmp_path}/ended ]; do sleep 0.05; done ;; esac
touch {tmp_path}/ended
case $1 in exit-*) exit ${{1#exit-}} ;; kill-*) kill -${{1#kill-}} $$ ;; esac
""")
    script.chmod(0o755)
    return launch_text(tmp_path, LAUNCH.format(script=script, fate=fate),
                       f"other:={other}", f"required:={required}")


def launch_text(tmp_path, text, *arguments):
    """The running launch of a launch file of this text."""
    launch_file = tmp_path / "some.launch"
    launch_file.write_text(text)
    environment = dict(os.environ, ROS_MASTER_URI=f"http://127.0.0.1:{free_port()}",
                       ROS_IP="127.0.0.1", ROS_HOME=str(tmp_path))
    # That of these sources: the package may be that of another build.
    environment["PYTHONPATH"] = os.pathsep.join([str(ROOT / "src"), *sys.path])
    return subprocess.Popen(
        [sys.executable, "-m", "hexapod_repertoire.launch", str(launch_file), *arguments],
        env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        universal_newlines=True)
