#!/usr/bin/python3
"""Publishes a large map of which a bit changes every time, until a line comes on standard input;
the last one is there until that ends.

Boxes all over, and some that come and go around the position given as arguments [m, in odom]. A
process of its own: writing 16 million cells holds up others in the same interpreter. Prints the
position of the newest box, as a line of JSON, after each map.
"""
import io
import json
import random
import struct
import sys
import threading
import time

import rospy
from nav_msgs.msg import OccupancyGrid

SEED = 13
PERIOD_S = 1.0
SIDE, RESOLUTION_M = 4000, 0.05
BOX_CELLS = 16
BOXES = 4000  # scattered, a share of 6 % of the floor
RECENT, RECENT_M = 12, 8.0  # that come and go around the start


class LargeGrid(OccupancyGrid):
    """Writes data that is bytes as they are: number by number, 16 million take seconds."""

    def serialize(self, buff):
        head = io.BytesIO()
        OccupancyGrid(self.header, self.info, []).serialize(head)
        buff.write(head.getvalue()[:-4])
        buff.write(struct.pack("<I", len(self.data)))
        buff.write(self.data)


class LargeMap:
    """The map around a position, and what comes and goes in it."""

    def __init__(self, x_m, y_m):
        self.random, self.middle = random.Random(SEED), (x_m, y_m)
        self.cells = bytearray(SIDE * SIDE)
        for _ in range(BOXES):
            self.fill(self.draw(SIDE // 2 - BOX_CELLS), 100)
        self.recent = []  # the first cell of each, the newest last
        self.message = LargeGrid()
        self.message.header.frame_id = "odom"
        self.message.info.resolution = RESOLUTION_M
        self.message.info.width = self.message.info.height = SIDE
        self.message.info.origin.position.x = x_m - SIDE * RESOLUTION_M / 2.0
        self.message.info.origin.position.y = y_m - SIDE * RESOLUTION_M / 2.0
        self.message.info.origin.orientation.w = 1.0

    def draw(self, within):
        """(row, column) of the first cell of a box in so many cells around the middle, of which the
        innermost are left free."""
        while True:
            row, column = (SIDE // 2 + self.random.randrange(-within, within) for _ in range(2))
            if max(abs(row - SIDE // 2), abs(column - SIDE // 2)) > 1.0 / RESOLUTION_M + BOX_CELLS:
                return row, column

    def fill(self, box, value):
        row, column = box
        for i in range(BOX_CELLS):
            begin = (row + i) * SIDE + column
            self.cells[begin:begin + BOX_CELLS] = bytes([value]) * BOX_CELLS

    def change(self):
        """Another box comes, and the oldest of many goes; (x, y) of the middle of the new one."""
        if len(self.recent) >= RECENT:
            self.fill(self.recent.pop(0), 0)
        self.recent.append(self.draw(round(RECENT_M / RESOLUTION_M)))
        self.fill(self.recent[-1], 100)
        self.message.data = bytes(self.cells)
        row, column = self.recent[-1]
        return [start + (cell + BOX_CELLS / 2.0 - SIDE / 2.0) * RESOLUTION_M
                for start, cell in zip(self.middle, (column, row))]


def main():
    """Until standard input ends."""
    rospy.init_node("large_map", disable_signals=True, disable_rostime=True)
    over = threading.Event()
    input_ends = threading.Thread(target=lambda: (sys.stdin.readline(), over.set(),
                                                  sys.stdin.read()), daemon=True)
    input_ends.start()
    large_map = LargeMap(float(sys.argv[1]), float(sys.argv[2]))
    publisher = rospy.Publisher("map", LargeGrid, latch=True, queue_size=1)
    due = time.monotonic()
    while not over.is_set():
        newest = large_map.change()
        publisher.publish(large_map.message)
        print(json.dumps(newest), flush=True)
        due += PERIOD_S
        over.wait(max(0.0, due - time.monotonic()))
    input_ends.join()  # a latched message goes with its publisher


if __name__ == "__main__":
    main()
