"""Moves one joint at a time, feet off the floor, and holds what moved against what should have."""
import math
import pathlib
import subprocess
import sys
from typing import Any, Callable, Dict, List, NamedTuple, Sequence, Tuple

import yaml

# Of the gait's full swing: level 2 of the paper's 0 .. 4.
GENE_LEVELS, LEVEL, SHARE = 5, 2, 0.5
# A joint that swings this part of what it should is slow or smoothed, below the second it stands.
WHOLE, SOME = 0.7, 0.25
TRIES = 3


class Joint(NamedTuple):
    """A joint and its part in the gait."""
    name: str
    signal: int
    amplitude_rad: float


class Movement(NamedTuple):
    """One joint moved alone by its signal."""
    leg: str
    joint: str
    foot: str  # where it goes, at -1 and at 1
    genome: Tuple[int, ...]
    swings_rad: Dict[str, float]  # of every joint of the robot, from end to end


def joints_of(robot: Dict[str, Any]) -> List[Joint]:
    """All joints of a robot that describe_robot printed, in its order."""
    return [Joint(joint["name"], joint["signal"], joint["amplitude_rad"])
            for leg in robot["legs"] for joint in leg["joints"]]


def movements(robot: Dict[str, Any]) -> List[Movement]:
    """What is tried: every joint that takes part in the gait."""
    names = [joint.name for joint in joints_of(robot)]
    genes_per_leg = 2 * max([2] + [joint.signal for joint in joints_of(robot)])
    tried = []
    for index, leg in enumerate(robot["legs"]):
        for joint in leg["joints"]:
            if joint["amplitude_rad"] == 0.0:
                continue
            genome = [0] * (genes_per_leg * len(robot["legs"]))
            genome[genes_per_leg * index + 2 * (joint["signal"] - 1)] = LEVEL
            swings_rad = dict.fromkeys(names, 0.0)
            swings_rad[joint["name"]] = 2.0 * SHARE * abs(joint["amplitude_rad"])
            tried.append(Movement(leg["name"], joint["name"], joint["foot"], tuple(genome),
                                  swings_rad))
    return tried


def judge(movement: Movement, measured_rad: Dict[str, float]) -> List[str]:
    """What is wrong with how far the joints swung, from end to end; nan: nobody read it."""
    problems = []
    least_rad = SOME * movement.swings_rad[movement.joint]
    for name, expected_rad in movement.swings_rad.items():
        swung_rad = measured_rad.get(name, math.nan)
        degrees = f"{math.degrees(swung_rad):.0f} of {math.degrees(expected_rad):.0f} degrees"
        if math.isnan(swung_rad):
            if expected_rad:
                problems.append(f"{name} is not read: nothing on joint_states names it")
        elif expected_rad == 0.0:
            if swung_rad > least_rad:
                problems.append(f"{name} moved by {math.degrees(swung_rad):.0f} degrees and should "
                                "not have: are two servos or two names exchanged?")
        elif swung_rad < SOME * expected_rad:
            problems.append(f"{name} did not move ({degrees}): is its servo powered, torque on, "
                            "its name or id right?")
        elif swung_rad < WHOLE * expected_rad:
            problems.append(f"{name} moved too little ({degrees}): is it blocked, or does a speed, "
                            "acceleration or filter setting of the servo smooth it?")
        elif swung_rad > expected_rad / WHOLE:
            problems.append(f"{name} moved too far ({degrees}): is its scale right?")
    return problems


def try_out(movement: Movement,
            play: Callable[[], Tuple[bool, Dict[str, float]]]) -> Tuple[List[str], bool]:
    """What is wrong with a movement, and whether anybody read how far the joints swung.

    play() moves the joint and returns whether no command was skipped, and the swings by joint in
    rad, empty where nobody looked. What a busy machine's late commands do to other joints happens
    once, a fault each time: a movement is wrong when it is so in all of its tries.
    """
    for _ in range(TRIES):
        is_whole, measured_rad = play()
        problems = judge(movement, measured_rad) if measured_rad else []
        if is_whole and not problems:
            break
    return problems, bool(measured_rad)


def described(program: pathlib.Path, urdf: str, config: str) -> Dict[str, Any]:
    """What describe_robot says of a robot. Raises RuntimeError with its words."""
    result = subprocess.run([str(program), urdf, config], stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, universal_newlines=True, check=False)
    if result.returncode:
        raise RuntimeError(result.stderr.strip())
    return yaml.safe_load(result.stdout)


def swings(names: Sequence[str], low_rad: Sequence[float],
           high_rad: Sequence[float]) -> Dict[str, float]:
    """How far each joint swung by an executor's result; nothing of it when nobody looked."""
    if len(low_rad) != len(names) or len(high_rad) != len(names):
        return {}
    return {name: high - low for name, low, high in zip(names, low_rad, high_rad)}


def sentence(movement: Movement) -> str:
    """What a person should see now."""
    return (f"{movement.leg}, {movement.joint} alone: watch the foot go {movement.foot} cm ahead, "
            "left and up, first to the second")


def confirm() -> bool:
    """Asks whoever sits at the terminal."""
    print("The robot must hang or lie so that its feet are off the floor: every joint swings by half "
          "its gait.\nGo on? [y/N] ", end="", flush=True)
    return sys.stdin.readline().strip().lower() in ("y", "yes")
