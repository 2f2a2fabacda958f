"""Before a robot walks: `preflight` looks at its wires, `joint_check` moves one joint at a time."""
import argparse
import functools
import pathlib
import sys
import tempfile
from typing import Any, Dict, List, Tuple

import rosgraph
import rospy
import yaml
from sensor_msgs.msg import JointState

from hexapod_repertoire import joint_check, preflight
from hexapod_repertoire.client import INTERRUPTED, PATIENCE_S, STATES
from hexapod_repertoire.msg import (ExecuteBehaviorAction, ExecuteBehaviorGoal,
                                    ExecuteBehaviorResult, ExecutorState)
from hexapod_repertoire.waiting import Asker, Latest, Silence

COMMAND_TYPES = {"sensor_msgs/JointState", "trajectory_msgs/JointTrajectory",
                 "std_msgs/Float64MultiArray", "std_msgs/Float64"}
NO_EXECUTOR = ("No executor answers on executor/state; start one for your robot: ./run walk "
               "simulated:=false, with its urdf_file, robot_config and executor_config.")


def parser() -> argparse.ArgumentParser:
    """Of the words after ./run."""
    top = argparse.ArgumentParser(prog="./run", description=__doc__)
    top.add_argument("--programs", type=pathlib.Path, required=True, help=argparse.SUPPRESS)
    verbs = top.add_subparsers(dest="verb", required=True)
    verbs.add_parser("preflight", help="look at who listens and who tells; nothing moves")
    check = verbs.add_parser("joint_check", help="move one joint at a time and hold what moved "
                             "against what should have; feet off the floor")
    check.add_argument("--yes", action="store_true", help="do not ask, the feet are off the floor")
    check.add_argument("--wait", action="store_true", help="wait until the executor is ready")
    return top


def robot_of_session(programs: pathlib.Path) -> Dict[str, Any]:
    """The robot that the executor of this session was given. Raises RuntimeError without one."""
    try:
        urdf = rospy.get_param("robot_description")
        config = rospy.get_param("executor/robot_config")
    except KeyError as missing:
        raise RuntimeError(f"The parameter {missing} is not set. {NO_EXECUTOR}") from None
    with tempfile.NamedTemporaryFile("w", suffix=".urdf", encoding="utf-8") as file:
        file.write(urdf)
        file.flush()
        return joint_check.described(programs / "describe_robot", file.name, config)


def executor_state() -> ExecutorState:
    """What the executor says of itself; Silence without one."""
    return Latest("executor/state", ExecutorState).wait(lambda _: True, PATIENCE_S, NO_EXECUTOR)


def names_on_the_wire(robot: Dict[str, Any]) -> List[str]:
    """What the driver calls the joints, by the executor's joint map."""
    names = [joint.name for joint in joint_check.joints_of(robot)]
    file = rospy.get_param("executor/joint_map", "")
    if not file:
        return names
    with open(file, encoding="utf-8") as stream:
        entries = (yaml.safe_load(stream) or {}).get("joints", {})
    return [(entries.get(name) or {}).get("name", name) for name in names]


def listeners() -> Dict[str, List[str]]:
    """Who subscribes to the executor's command topics, by the master."""
    master = rosgraph.Master(rospy.get_name())
    executor = rospy.resolve_name("executor")
    types = dict(master.getTopicTypes())
    publishers, subscribers, _ = master.getSystemState()
    heard = dict(subscribers)
    return {topic: heard.get(topic, []) for topic, nodes in publishers
            if executor in nodes and types.get(topic) in COMMAND_TYPES}


def look(programs: pathlib.Path) -> int:
    """Prints the findings; 0 when nothing is wrong."""
    ear = preflight.Ear(rospy, JointState)
    state = executor_state()
    robot = robot_of_session(programs)
    findings = [preflight.Finding(preflight.OK, "executor",
                                  f"{STATES[state.state]}: {state.reason}")]
    findings += preflight.judge_listeners(listeners())
    findings += preflight.judge_joints(ear.listen(preflight.LOOK_S), names_on_the_wire(robot),
                                       preflight.LOOK_S,
                                       rospy.get_param("executor/feedback_timeout_s", None))
    findings += preflight.judge_timers(preflight.usb_timers())
    print(preflight.table(findings))
    problem = preflight.first_problem(findings)
    ready = "" if state.state == ExecutorState.READY else "to be armed: ./run arm; then"
    print(f"Not ready: {problem.subject}: {problem.text}." if problem else
          f"Ready{ready and ' ' + ready}: with its feet off the floor, ./run joint_check.")
    return 1 if problem else 0


def wait_until_ready() -> None:
    """Tells on the way why the executor is not; Silence without one."""
    told = set()

    def is_ready(state: ExecutorState) -> bool:
        if state.state != ExecutorState.READY and state.reason not in told:
            told.add(state.reason)
            print(f"The executor is {STATES[state.state]}: {state.reason}", flush=True)
        return state.state == ExecutorState.READY

    Latest("executor/state", ExecutorState).wait(is_ready, PATIENCE_S, NO_EXECUTOR)


def move(programs: pathlib.Path, is_confirmed: bool, waits: bool) -> int:
    """Moves leg after leg; 0 when all moved as they should."""
    if waits:
        wait_until_ready()
    state = executor_state()
    if state.state != ExecutorState.READY:
        print(f"The executor is {STATES[state.state]} ({state.reason}): arm it with ./run arm, "
              "feet off the floor.", file=sys.stderr)
        return 1
    robot = robot_of_session(programs)
    if not is_confirmed and not joint_check.confirm():
        print("Nothing was moved.")
        return 1
    executor = Asker("execute", ExecuteBehaviorAction, "executor")
    names = [joint.name for joint in joint_check.joints_of(robot)]
    faults, seen = 0, False
    for movement in joint_check.movements(robot):
        print(joint_check.sentence(movement), flush=True)
        problems, is_read = joint_check.try_out(
            movement, functools.partial(play, executor, names, movement))
        seen = seen or is_read
        for problem in problems:
            print(f"  WRONG: {problem}")
        faults += len(problems)
    print(conclusion(faults, seen))
    return 1 if faults else 0


def play(executor: Asker, names: List[str],
         movement: joint_check.Movement) -> Tuple[bool, Dict[str, float]]:
    """Moves a joint: whether no command was skipped, and the swings measured. RuntimeError if not
    played."""
    try:
        result = executor.ask(ExecuteBehaviorGoal(
            entry_id=-1, genome=movement.genome, gene_levels=joint_check.GENE_LEVELS,
            joints=[movement.joint]))
    except (KeyboardInterrupt, rospy.ROSInterruptException):
        executor.cancel()
        raise
    if result.code not in (ExecuteBehaviorResult.SUCCEEDED, ExecuteBehaviorResult.SKIPPED):
        raise RuntimeError(f"It was not played: {result.message}")
    return (result.code == ExecuteBehaviorResult.SUCCEEDED,
            joint_check.swings(names, result.joint_min_rad, result.joint_max_rad))


def conclusion(faults: int, seen: bool) -> str:
    """The last line."""
    if not seen:
        return ("Every joint was moved; without joint_states only you have seen how. Did every foot "
                "go where it was said?")
    if faults:
        return f"{faults} things are wrong: mend them, then check again."
    return ("Every joint moved as far as it should, and no other. Which way it went only you have "
            "seen: where a foot went the other way, set sign: -1 in the joint map.")


def main(argv: List[str]) -> int:
    """Carries out the words after ./run; returns the exit code."""
    arguments = parser().parse_args(argv)
    if not rosgraph.is_master_online():
        print(f"No ROS master answers at {rosgraph.get_master_uri()}. {NO_EXECUTOR}",
              file=sys.stderr)
        return 1
    rospy.init_node("robot_check", anonymous=True, disable_signals=True, log_level=rospy.ERROR)
    try:
        if arguments.verb == "preflight":
            return look(arguments.programs)
        return move(arguments.programs, arguments.yes, arguments.wait)
    except (Silence, RuntimeError, OSError, yaml.YAMLError) as problem:
        print(problem, file=sys.stderr)
        return 1
    except (KeyboardInterrupt, rospy.ROSInterruptException):
        print("Broken off: the robot goes back to its neutral pose.", file=sys.stderr)
        return INTERRUPTED


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
