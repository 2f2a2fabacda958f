#!/usr/bin/python3
"""Looks at a robot's wires, or moves its joints one at a time."""
import pathlib
import sys

import rospy
from hexapod_repertoire.robot_check import main

words = rospy.myargv(sys.argv)[1:]
sys.exit(main(["--programs", str(pathlib.Path(sys.argv[0]).resolve().parent), *words]))
