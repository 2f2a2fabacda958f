"""The script `run` at the root, with the commands it calls replaced by shell functions."""
import os
import pathlib
import shlex
import shutil
import subprocess

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
NOTHING_INSTALLED = "dpkg-query() { return 1; }; "
EVERYTHING_INSTALLED = "dpkg-query() { printf '%s installed\\n' \"${@:4}\"; }; "
NO_ROOT = "id() { echo 1000; }; sudo() { return 1; }; "
AS_ROOT = 'id() { echo 0; }; env() { echo "env $*"; }; tee() { echo "tee $* <<< $(cat)" >&2; }; '
NO_LOCALHOST = "getent() { return 2; }; "
NO_BUILD = "cmake() { :; }; "


@pytest.fixture(name="checkout")
def fixture_checkout(tmp_path):
    """A checkout with the front door and a stand-in for what a build leaves behind."""
    shutil.copy(str(ROOT / "run"), str(tmp_path))
    shutil.copy(str(ROOT / "packages.txt"), str(tmp_path))
    stand_in = tmp_path / "python" / "hexapod_repertoire"
    stand_in.mkdir(parents=True)
    (stand_in / "__init__.py").touch()
    (stand_in / "launch.py").write_text("import sys\nprint(sys.argv[1:])\nsys.exit(7)\n")
    setup = tmp_path / "devel" / "setup.bash"
    setup.parent.mkdir(parents=True)
    (tmp_path / "build").mkdir()
    (tmp_path / "build" / "CMakeCache.txt").write_text(
        f"CMAKE_HOME_DIRECTORY:INTERNAL={tmp_path}\n")
    setup.write_text('echo "arguments: $#"; : "$unset_variable"\n/usr/bin/env\n'
                     f"export PYTHONPATH={tmp_path}/python\n")
    return tmp_path


def run(checkout, *arguments, functions="", **variables):
    """Runs the front door with shell functions in place of the commands of the same names."""
    environment = {key: value for key, value in os.environ.items()
                   if key not in ("DISPLAY", "CI") and not key.startswith("ROS")}
    environment.update(variables)
    script = f"{functions} export -f {names_of(functions)}; exec {shlex.quote(str(checkout))}/run"
    return subprocess.run(
        ["bash", "-c", script + ' "$@"', "bash", *arguments], env=environment, check=False,
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)


def names_of(functions):
    return " ".join(part.split("()")[0].split()[-1] for part in functions.split("; ")
                    if "()" in part) or ":"


@pytest.mark.parametrize("arguments", [[], ["help"], ["--help"]])
def test_help_names_every_verb(arguments):
    result = run(ROOT, *arguments)
    assert result.returncode == 0
    for verb in ("demo", "learn", "evolve", "walk", "go", "stop", "arm", "info", "view", "report",
                 "reproduce", "test", "bench",
                 "campaign", "check", "import_robot", "setup", "help"):
        assert f"\n  {verb} " in result.stdout


@pytest.mark.parametrize("verb", ["test", "campaign", "check", "setup"])
def test_help_on_a_verb_starts_nothing(checkout, verb):
    result = run(checkout, verb, "--help", functions=NOTHING_INSTALLED + NO_ROOT)
    assert result.returncode == 0 and result.stderr == ""
    lines = result.stdout.splitlines()
    assert lines[0] == f"usage: ./run {verb} [arguments]"
    assert lines[1].startswith(f"  {verb} ")
    assert all(line.startswith("      ") for line in lines[2:])


def test_unknown_verb_is_refused_with_the_help():
    result = run(ROOT, "fly")
    assert result.returncode == 2
    assert "'fly'" in result.stderr and "usage:" in result.stderr
    assert result.stdout == ""
    assert run(ROOT, "lern").stderr.endswith("there is no verb 'lern'; did you mean 'learn'?\n")


@pytest.mark.parametrize("verb", ["setup", "demo", "evolve", "reproduce", "test", "bench"])
def test_without_root_it_prints_the_one_line_to_ask_for(checkout, verb):
    result = run(checkout, verb, functions=NOTHING_INSTALLED + NO_ROOT)
    assert result.returncode == 1
    line = result.stderr.splitlines()[-1]
    assert line.startswith("sudo apt-get install --no-install-recommends ")
    assert {"catkin", "cmake", "libode-dev", "python3-geometry-msgs"} <= set(line.split())
    assert "rviz" not in line.split()


def test_a_missing_package_is_the_only_one_asked_for(checkout):
    functions = "dpkg-query() { printf '%s installed\\n' \"${@:4}\" | grep -v libode-dev; }; "
    result = run(checkout, "setup", functions=functions + NO_ROOT)
    assert result.stderr.splitlines()[-1].endswith("--no-install-recommends libode-dev")


def test_a_removed_but_not_purged_package_is_missing(checkout):
    functions = "dpkg-query() { printf '%s config-files\\n' \"${@:4}\"; }; "
    assert run(checkout, "setup", functions=functions + NO_ROOT).returncode == 1


def test_with_root_it_updates_the_lists_and_installs_everything_at_once(checkout):
    result = run(checkout, "setup", functions=NOTHING_INSTALLED + AS_ROOT)
    assert result.returncode == 0
    update, install = result.stdout.splitlines()
    assert update.endswith(" update")
    assert "DEBIAN_FRONTEND=noninteractive" in install
    assert " install --no-install-recommends build-essential " in install


def test_with_nothing_missing_it_neither_asks_nor_installs(checkout):
    functions = EVERYTHING_INSTALLED + AS_ROOT
    result = run(checkout, "setup", functions=functions)
    assert (result.returncode, result.stdout, result.stderr) == (0, "", "")


def test_without_the_name_localhost_root_gets_it_and_others_ask_for_it(checkout):
    functions = EVERYTHING_INSTALLED + NO_LOCALHOST
    result = run(checkout, "setup", functions=functions + AS_ROOT)
    assert result.returncode == 0
    assert result.stderr.splitlines()[-1] == "tee -a /etc/hosts <<< 127.0.0.1 localhost"
    result = run(checkout, "setup", functions=functions + NO_ROOT)
    assert result.returncode == 1
    assert result.stderr.splitlines()[-1] == "echo '127.0.0.1 localhost' | sudo tee -a /etc/hosts"


@pytest.mark.parametrize("arguments, display, wanted", [
    (["setup"], "", False), (["setup"], ":0", True),
    (["demo"], "", False), (["demo"], ":0", True), (["demo", "rviz:=false"], ":0", False),
    (["learn"], ":0", False), (["learn", "rviz:=true"], "", True),
])
def test_rviz_is_installed_only_where_it_will_be_shown(checkout, arguments, display, wanted):
    result = run(checkout, *arguments, functions=NOTHING_INSTALLED + NO_ROOT, DISPLAY=display)
    assert ("rviz" in result.stderr.splitlines()[-1].split()) == wanted


@pytest.mark.parametrize("arguments, display, told", [
    (["walk"], "", True), (["walk"], ":0", False), (["view"], "", True),
    (["walk", "rviz:=false"], "", False), (["learn"], "", False),
])
def test_where_rviz_would_open_a_missing_display_is_told(checkout, arguments, display, told):
    result = run(checkout, *arguments, functions=EVERYTHING_INSTALLED + NO_BUILD, DISPLAY=display)
    assert ("DISPLAY is not set" in result.stderr) == told


def test_arguments_and_exit_code_pass_through_unchanged(checkout):
    result = run(checkout, "learn", "seed:=3", "repertoire_file:=/data/a b.db",
                 functions=EVERYTHING_INSTALLED + NO_BUILD)
    assert result.returncode == 7
    assert result.stdout.splitlines()[-1] == str(
        [f"{checkout}/launch/learn.launch", "seed:=3", "repertoire_file:=/data/a b.db"])


def environment_of_the_launch(checkout, **variables):
    result = run(checkout, "learn", "seed:=3", functions=EVERYTHING_INSTALLED + NO_BUILD,
                 **variables)
    lines = result.stdout.splitlines()
    assert lines[0] == "arguments: 0"
    return dict(line.partition("=")[::2] for line in lines)


def test_a_foreign_python_and_a_foreign_ros_are_left_behind(checkout):
    foreign = {name: "/elsewhere" for name in (
        "PYTHONPATH", "ROS_PACKAGE_PATH", "CMAKE_PREFIX_PATH", "ROS_ROOT", "LD_LIBRARY_PATH")}
    environment = environment_of_the_launch(
        checkout, PATH="/elsewhere:" + os.environ["PATH"], **foreign)
    assert environment["PATH"].startswith("/usr/bin:/bin:")
    assert not set(foreign) & set(environment)


def test_ros_stays_on_this_machine_by_default(checkout):
    environment = environment_of_the_launch(checkout)
    assert environment["ROS_MASTER_URI"] == "http://127.0.0.1:11311"
    assert environment["ROS_IP"] == "127.0.0.1"
    assert environment["ROS_HOME"] == f"{checkout}/build/ros_home"


def test_master_and_address_set_by_the_user_are_kept(checkout):
    environment = environment_of_the_launch(
        checkout, ROS_MASTER_URI="http://robot:11311", ROS_IP="10.0.0.2")
    assert environment["ROS_MASTER_URI"] == "http://robot:11311"
    assert environment["ROS_IP"] == "10.0.0.2"


def test_a_build_folder_that_was_moved_here_is_configured_afresh(checkout):
    cache = checkout / "build" / "CMakeCache.txt"
    cache.write_text("CMAKE_HOME_DIRECTORY:INTERNAL=/elsewhere\n")
    run(checkout, "learn", functions=EVERYTHING_INSTALLED + NO_BUILD)
    assert not cache.exists()


SAYS_IT_BUILDS = "cmake() { echo called >>called.txt; }; "


def builds(checkout):
    """Learns once; how often CMake was started in all."""
    run(checkout, "learn", functions=EVERYTHING_INSTALLED + SAYS_IT_BUILDS.replace(
        "called.txt", str(checkout / "called.txt")))
    return len((checkout / "called.txt").read_text().splitlines())


def test_nothing_is_built_when_no_source_is_newer_than_the_last_build(checkout):
    source = checkout / "src" / "a.cpp"
    source.parent.mkdir()
    source.touch()
    os.utime(source, (1, 1))
    os.utime(source.parent, (1, 1))
    first = builds(checkout)
    assert first > 0
    assert builds(checkout) == first
    stamp = next(checkout.glob("build/.built*"))
    os.utime(stamp, (10, 10))
    os.utime(source, (20, 20))
    second = builds(checkout)
    assert second == 2 * first
    source.unlink()  # which its folder tells
    os.utime(next(checkout.glob("build/.built*")), (10, 10))
    assert builds(checkout) == 3 * first


def test_after_a_failed_build_the_next_one_is_tried(checkout):
    run(checkout, "learn", functions=EVERYTHING_INSTALLED + "cmake() { return 1; }; ")
    assert builds(checkout) > 0


def test_a_failed_build_shows_its_log_and_starts_nothing(checkout):
    result = run(checkout, "learn", functions=EVERYTHING_INSTALLED
                 + "cmake() { echo what the compiler said; return 1; }; ")
    assert result.returncode == 1
    assert "what the compiler said" in result.stderr and "build.log" in result.stderr
    assert result.stdout == ""


@pytest.fixture(name="study_checkout")
def fixture_study_checkout(checkout):
    """A checkout whose study and report tell how they were called, and end as they are told."""
    program = checkout / "devel" / "lib" / "hexapod_repertoire" / "study"
    program.parent.mkdir(parents=True)
    program.write_text('#!/bin/sh\necho "study: $*"\nexit ${STUDY_ENDS:-0}\n')
    program.chmod(0o755)
    report = checkout / "src" / "hexapod_repertoire" / "study_report.py"
    report.parent.mkdir(parents=True)
    (report.parent / "__init__.py").touch()
    report.write_text("import sys\nprint('report:', *sys.argv[1:])\n")
    return checkout


@pytest.mark.parametrize("arguments, folder", [
    (["quick:=true"], "study"), (["folder:=/data/a"], "/data/a"), (["--folder", "b"], "b"),
    (["--quick", "--folder=c"], "c")])
def test_reproduce_reports_on_the_folder_of_the_study(study_checkout, arguments, folder):
    result = run(study_checkout, "reproduce", *arguments, functions=EVERYTHING_INSTALLED + NO_BUILD)
    assert result.returncode == 0, result.stderr
    assert result.stdout.splitlines() == [f"study: {' '.join(arguments)}", f"report: {folder}"]


@pytest.mark.parametrize("code, reported", [("1", True), ("2", False)])
def test_reproduce_reports_on_what_is_left_of_a_study_but_not_on_a_mistake(
        study_checkout, code, reported):
    result = run(study_checkout, "reproduce", functions=EVERYTHING_INSTALLED + NO_BUILD,
                 STUDY_ENDS=code)
    assert str(result.returncode) == code
    assert ("report:" in result.stdout) == reported


@pytest.fixture(name="campaign_checkout")
def fixture_campaign_checkout(checkout):
    """A checkout with one campaign, which ends as its last argument says."""
    campaigns = checkout / "test" / "campaigns"
    campaigns.mkdir(parents=True)
    (checkout / "devel" / "setup.bash").write_text("")
    (campaigns / "storm.py").write_text(
        '"""Blows at everything."""\nimport sys\nprint("blew", *sys.argv[1:])\n'
        'print("on the way", file=sys.stderr)\nsys.exit(int(sys.argv[-1]))\n')
    (campaigns / "rain.cpp").write_text("// Drops on everything.\nint main() {}\n")
    (campaigns / "campaigns_test.py").touch()
    return checkout


def test_campaigns_are_listed_with_what_they_do(campaign_checkout):
    result = run(campaign_checkout, "campaign")
    assert [line.split(maxsplit=1) for line in result.stdout.splitlines()] == [
        ["storm", "Blows at everything."], ["rain", "Drops on everything."]]


def test_an_unknown_campaign_is_refused_with_those_there_are(campaign_checkout):
    result = run(campaign_checkout, "campaign", "snow")
    assert result.returncode == 2
    assert "'snow'" in result.stderr and "storm" in result.stderr


def test_the_report_of_a_campaign_that_succeeds_is_kept_where_asked(campaign_checkout):
    kept = campaign_checkout / "results" / "campaigns" / "storm.md"
    functions = EVERYTHING_INSTALLED + NO_BUILD
    assert run(campaign_checkout, "campaign", "storm", "0", functions=functions).returncode == 0
    assert not kept.exists()
    failed = run(campaign_checkout, "campaign", "storm", "--write", "3", functions=functions)
    assert failed.returncode == 1 and not kept.exists()
    run(campaign_checkout, "campaign", "storm", "--write", "0", functions=functions)
    report = kept.read_text()
    assert "`./run campaign storm 0`" in report and report.endswith("blew 0\n")
