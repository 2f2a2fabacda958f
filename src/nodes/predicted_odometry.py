#!/usr/bin/python3
"""Publishes odometry from what the repertoire promises of each behaviour that is played."""
import sys

from hexapod_repertoire.predicted_odometry import main

sys.exit(main())
