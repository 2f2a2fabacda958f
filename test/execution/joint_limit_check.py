#!/usr/bin/python3
"""Checks a stream of joint commands against the limits in a URDF, sharing no code with the executor.

usage: joint_limit_check.py URDF JOINTS < stream

The stream begins with one joint name per line. Then come records of three 8-byte words (kind, slot,
acceleration limit [rad/s^2], 0: none) and one angle [rad] per joint: 0 begins a session, 1 tells the
pose the robot rests in, 2 is a command.
"""
import sys
import xml.etree.ElementTree as ElementTree

import numpy as np

PERIOD_S = 0.030
SLACK = 1e-8  # of rounding, relative
SESSION, START, COMMAND = 0, 1, 2


def read_limits(urdf, names):
    """Lower and upper limits [rad] and velocity limits [rad/s] of the joints, in their order."""
    limits = {joint.get("name"): joint.find("limit")
              for joint in ElementTree.parse(urdf).getroot().findall("joint")
              if joint.find("limit") is not None}
    return [np.array([float(limits[name].get(key)) for name in names])
            for key in ("lower", "upper", "velocity")]


class Checker:
    """Follows one session after another; counts the commands that break a limit."""

    def __init__(self, limits):
        self.lower, self.upper, self.velocity = limits
        self.broken = {"position": 0, "velocity": 0, "acceleration": 0, "not finite": 0}
        self.commands = 0
        self.accelerated = 0
        self.largest_step = 0.0

    def session(self, _slot, acceleration, angles):
        self.acceleration = acceleration
        self.rest_at(angles)

    def start(self, _slot, _acceleration, angles):
        self.rest_at(np.clip(angles, self.lower, self.upper))

    def rest_at(self, angles):
        self.angles = angles
        self.step = np.zeros_like(angles)
        self.slot = None

    def command(self, slot, _acceleration, angles):
        self.commands += 1
        step = angles - self.angles
        if self.slot is not None and slot != self.slot + 1:
            self.step = np.zeros_like(step)  # commands were left out; the robot came to rest
        self.count("not finite", ~np.isfinite(angles))
        self.count("position", (angles < self.lower) | (angles > self.upper))
        self.count("velocity", np.abs(step) > self.velocity * PERIOD_S * (1 + SLACK))
        if self.acceleration > 0.0:
            self.accelerated += 1
            allowed = self.acceleration * PERIOD_S ** 2 * (1 + SLACK)
            self.count("acceleration", np.abs(step - self.step) > allowed + 1e-12)
        self.largest_step = max(self.largest_step, np.abs(step).max())
        self.angles, self.step, self.slot = angles, step, slot

    def count(self, what, wrong):
        self.broken[what] += int(wrong.any())


def main(urdf, joint_count):
    stream = sys.stdin.buffer
    names = [stream.readline().decode().strip() for _ in range(joint_count)]
    checker = Checker(read_limits(urdf, names))
    kinds = {SESSION: checker.session, START: checker.start, COMMAND: checker.command}
    record = np.dtype([("kind", "<i8"), ("slot", "<i8"), ("acceleration", "<f8"),
                       ("angles", "<f8", (joint_count,))])
    while True:
        block = stream.read(record.itemsize * 4096)
        if not block:
            break
        for entry in np.frombuffer(block, record):
            kinds[int(entry["kind"])](int(entry["slot"]), float(entry["acceleration"]),
                                      entry["angles"])
    print("| commands checked | with an acceleration limit | largest step | outside position | "
          "velocity | acceleration | not finite |\n|---|---|---|---|---|---|---|")
    print("| %d | %d | %.6f rad | %d | %d | %d | %d |" % (
        checker.commands, checker.accelerated, checker.largest_step, checker.broken["position"],
        checker.broken["velocity"], checker.broken["acceleration"], checker.broken["not finite"]))
    return 1 if any(checker.broken.values()) or checker.commands == 0 else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], int(sys.argv[2])))
