#!/usr/bin/python3
"""Walks to random goals with the running planner; prints how well predictions held."""
import sys

from hexapod_repertoire.trials import main

sys.exit(main())
