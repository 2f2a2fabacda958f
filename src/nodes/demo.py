#!/usr/bin/python3
"""Walks to the goals of config/demo.yaml with the repertoire being published."""
import sys

from hexapod_repertoire.demo import main

sys.exit(main())
