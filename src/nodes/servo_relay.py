#!/usr/bin/python3
"""Passes joint commands on to drivers with messages of their own packages."""
import sys

from hexapod_repertoire.servo_relay import main

sys.exit(main())
