"""The program evolve, from outside."""
import os
import shutil
import signal
import subprocess

import pytest

import kill_resume

EVOLVE = os.environ.get("EVOLVE", "")
SMALL = ["--population_size", "20", "--validation_trials", "2", "--verify_with_ode", "false"]
ENDLESS = ["--evaluations", "100000000", "--progress_period_s", "0.0", *SMALL]
HANGS_S = 60

pytestmark = pytest.mark.skipif(not EVOLVE, reason="EVOLVE does not name the program")


def evolve(*options):
    """Runs the program to its end."""
    return subprocess.run([EVOLVE, *map(str, options)], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, universal_newlines=True, timeout=HANGS_S,
                          check=False)


@pytest.fixture(name="endless")
def fixture_endless(tmp_path):
    """A run without end into tmp_path/a.db that has finished its first generations."""
    with subprocess.Popen([EVOLVE, "--file", str(tmp_path / "a.db"), *ENDLESS],
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          universal_newlines=True) as process:
        for line in process.stdout:
            if line.startswith("Learning: 6"):
                break
        yield process
        process.kill()


def test_killed_at_random_instants_it_ends_with_the_entries_of_an_undisturbed_run(tmp_path):
    plan = kill_resume.Plan(EVOLVE, tmp_path, evaluations=600, kills=8, most_lines=6, delay_s=0.0,
                            seed=1, options=SMALL)
    outcome = kill_resume.disturb(plan)
    assert outcome.kills == 8
    assert outcome.entries > 10
    assert outcome.equal


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_a_signal_ends_it_in_order_and_resumable(endless, tmp_path, number):
    endless.send_signal(number)
    out, err = endless.communicate(timeout=HANGS_S)
    assert endless.returncode == 0, err
    assert "Stopped and saved" in out
    again = evolve("--file", tmp_path / "a.db", "--resume", "--evaluations", 1, *SMALL)
    assert again.returncode == 2
    assert "evaluations: " in again.stderr


def test_stopped_for_a_while_it_goes_on(endless):
    endless.send_signal(signal.SIGSTOP)
    endless.send_signal(signal.SIGCONT)
    assert endless.stdout.readline().startswith("Learning: ")


def test_a_second_learner_is_refused_naming_the_first(endless, tmp_path):
    second = evolve("--file", tmp_path / "a.db", "--resume", *SMALL)
    assert second.returncode == 1
    assert f"process {endless.pid} " in second.stderr


def test_goes_on_when_nobody_reads_what_it_prints(tmp_path):
    with subprocess.Popen([EVOLVE, "--file", str(tmp_path / "a.db"), "--evaluations", "200",
                           "--progress_period_s", "0.0", *SMALL],
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        process.stdout.close()
        assert process.wait(timeout=HANGS_S) == 0


def test_exports_the_entries(tmp_path):
    result = evolve("--file", tmp_path / "a.db", "--csv", tmp_path / "a.csv", "--evaluations", 200,
                    *SMALL)
    assert result.returncode == 0, result.stderr
    lines = (tmp_path / "a.csv").read_text().splitlines()
    assert len(lines) == 1 + len(kill_resume.entries(tmp_path / "a.db"))


def test_a_last_save_that_fails_is_no_success_and_is_the_last_that_is_said(tmp_path):
    file = tmp_path / "a.db"
    # No file may grow beyond 4 KiB: to the program that is a full disk.
    result = subprocess.run(
        ["prlimit", "--fsize=4096", EVOLVE, "--file", str(file), "--evaluations", "40", *SMALL],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True,
        timeout=HANGS_S, check=False, preexec_fn=lambda: signal.signal(signal.SIGXFSZ,
                                                                       signal.SIG_IGN))
    assert result.returncode == 1
    last = result.stdout.splitlines()[-1]
    assert last.startswith("ERROR: ") and str(file) in last and "lost" in last
    assert "Stopped and saved" not in result.stdout


def test_entries_are_not_written_over_the_repertoire(tmp_path):
    file = tmp_path / "a.db"
    assert evolve("--file", file, "--evaluations", 40, *SMALL).returncode == 0
    before = file.read_bytes()
    (tmp_path / "link.csv").symlink_to(file)
    result = evolve("--file", file, "--csv", tmp_path / "link.csv", "--resume", "--evaluations", 60,
                    *SMALL)
    assert result.returncode == 2 and "same file" in result.stderr
    assert file.read_bytes() == before


def test_help_has_a_line_for_every_option():
    result = evolve("--help")
    assert result.returncode == 0
    for name in ("seed", "resume", "csv", "novelty_threshold_m", "gait_duration_s"):
        assert f"\n  --{name}  [" in result.stdout
    assert max(map(len, result.stdout.splitlines())) <= 80
    assert "\n  --archive_parents  [0.8]" in result.stdout  # as in the preset


def test_begins_with_the_entries_of_another_file_in_another_body(tmp_path):
    assert evolve("--file", tmp_path / "old.db", "--evaluations", 200, *SMALL).returncode == 0
    again = ["--file", tmp_path / "new.db", "--from", tmp_path / "old.db", "--evaluations", 300]
    result = evolve(*again, "--body", "left_middle: locked, friction: 0.8", *SMALL)
    assert result.returncode == 0, result.stderr
    assert "for this body: left_middle: locked, friction: 0.8." in result.stdout
    assert f"Beginning with the entries of {tmp_path / 'old.db'}: " in result.stdout
    assert len(kill_resume.entries(tmp_path / "new.db")) > 0


@pytest.mark.parametrize("options, words", [
    (("--body", "tail: limp"), "'tail' is nothing of a body; expected a leg (left_rear"),
    (("--body", "friction: low"), "has no number after the colon"),
    (("--from", "/nowhere/old.db"), "/nowhere/old.db"),
])
def test_says_what_is_wrong_with_a_body_or_a_beginning(tmp_path, options, words):
    result = evolve("--file", tmp_path / "a.db", *options, *SMALL)
    assert result.returncode in (1, 2)
    assert words in result.stderr
    assert not (tmp_path / "a.db").exists()


def test_an_unknown_option_is_refused_with_the_nearest_name(tmp_path):
    result = evolve("--file", tmp_path / "a.db", "--evalutions", 100)
    assert result.returncode == 2
    assert "evaluations" in result.stderr
    assert not (tmp_path / "a.db").exists()


def mpirun(processes, *options):
    """The command that runs the program in several processes of this machine."""
    return ["mpirun", "--mca", "plm", "isolated", "--allow-run-as-root", "--oversubscribe",
            "-n", str(processes), EVOLVE, *map(str, options)]


def has_mpi():
    """True when there is mpirun and the program was built with MPI."""
    if not EVOLVE or not shutil.which("mpirun"):
        return False
    libraries = subprocess.run(["ldd", EVOLVE], stdout=subprocess.PIPE, universal_newlines=True,
                               check=False).stdout
    return "libmpi" in libraries


needs_mpi = pytest.mark.skipif(not has_mpi(), reason="evolve was built without MPI, or no mpirun")


@needs_mpi
def test_several_processes_learn_what_one_does(tmp_path):
    options = ["--evaluations", "300", *SMALL]
    assert evolve("--file", tmp_path / "one.db", *options).returncode == 0
    subprocess.run(mpirun(3, "--file", tmp_path / "three.db", *options), check=True,
                   timeout=HANGS_S, stdout=subprocess.DEVNULL)
    assert (kill_resume.entries(tmp_path / "three.db")
            == kill_resume.entries(tmp_path / "one.db"))


@needs_mpi
def test_wrong_options_are_told_once_and_end_all_processes(tmp_path):
    result = subprocess.run(mpirun(3, "--file", tmp_path / "a.db", "--sed", 3), check=False,
                            timeout=HANGS_S, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                            universal_newlines=True)
    assert result.returncode == 2
    assert result.stderr.count("did you mean 'seed'") == 1


def children(pid):
    """The processes that `pid` started, by what the system says of them."""
    found = subprocess.run(["ps", "-o", "pid=", "--ppid", str(pid)], stdout=subprocess.PIPE,
                           universal_newlines=True, check=True).stdout
    return [int(word) for word in found.split()]


@needs_mpi
@pytest.mark.parametrize("who", ["mpirun", "learner", "worker"])
def test_asked_to_stop_several_processes_save_and_lose_nobody(tmp_path, who):
    file = tmp_path / "a.db"
    with subprocess.Popen(mpirun(2, "--file", file, *ENDLESS), stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, universal_newlines=True) as process:
        for line in process.stdout:
            if line.startswith("Learning: 6"):
                break
        ranks = sorted(children(process.pid))
        os.kill({"mpirun": process.pid, "learner": ranks[0], "worker": ranks[1]}[who],
                signal.SIGTERM)
        rest, _ = process.communicate(timeout=HANGS_S)
    assert "Stopped and saved" in rest, rest
    assert "No answer" not in rest
    assert kill_resume.evaluations(file) > 0


@needs_mpi
def test_a_process_that_hangs_is_given_up_and_the_others_do_its_part(tmp_path):
    options = ["--evaluations", "1000", *SMALL]
    assert evolve("--file", tmp_path / "one.db", *options).returncode == 0
    with subprocess.Popen(
            mpirun(3, "--file", tmp_path / "three.db", *options, "--progress_period_s", "0.0",
                   "--worker_patience_s", "1.0"),
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True) as process:
        for line in process.stdout:
            if line.startswith("Learning: "):
                break
        os.kill(max(children(process.pid)), signal.SIGSTOP)
        rest, _ = process.communicate(timeout=HANGS_S)
    assert "No answer any more from process" in rest, rest
    assert (kill_resume.entries(tmp_path / "three.db")
            == kill_resume.entries(tmp_path / "one.db"))


@needs_mpi
def test_a_process_that_dies_ends_all_and_leaves_a_file_to_go_on_with(tmp_path):
    file = tmp_path / "a.db"
    with subprocess.Popen(mpirun(2, "--file", file, *ENDLESS, "--checkpoint_period_s", "0.0"),
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          universal_newlines=True) as process:
        for line in process.stdout:
            if line.startswith("Learning: 6"):
                break
        os.kill(max(children(process.pid)), signal.SIGKILL)
        rest, _ = process.communicate(timeout=HANGS_S)
    assert process.returncode != 0
    assert "exited on signal 9" in rest
    evaluations = max(1000, 2 * kill_resume.evaluations(file))
    again = evolve("--file", file, "--resume", "--evaluations", evaluations, *SMALL)
    assert again.returncode == 0, again.stderr
    assert "Going on" in again.stdout
