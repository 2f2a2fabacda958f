#!/usr/bin/python3
"""Starts rviz with a configuration whose frames are parameters."""
import sys

from hexapod_repertoire.rviz_config import main

main(sys.argv)
