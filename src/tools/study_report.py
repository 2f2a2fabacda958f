#!/usr/bin/python3
"""Writes the report of a study: table, figures and what to see in them."""
import sys

from hexapod_repertoire.study_report import main

sys.exit(main())
