"""A large map that changes all the time."""
import io
import struct
import threading
import time

import rospy
import walking_session as ws
from nav_msgs.msg import OccupancyGrid

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


class MapStream:
    """Publishes it as long as it is entered: boxes all over, and some that come and go around the
    pose it was begun at."""

    def __init__(self, random_numbers, pose):
        self.random, self.sent, self.middle = random_numbers, 0, pose
        self.cells = bytearray(SIDE * SIDE)
        for _ in range(BOXES):
            self.fill(self.draw(SIDE // 2 - BOX_CELLS), 100)
        self.recent = []  # the first cell of each, the newest last
        self.message = LargeGrid()
        self.message.header.frame_id = "odom"
        self.message.info.resolution = RESOLUTION_M
        self.message.info.width = self.message.info.height = SIDE
        self.message.info.origin.position.x = pose[0] - SIDE * RESOLUTION_M / 2.0
        self.message.info.origin.position.y = pose[1] - SIDE * RESOLUTION_M / 2.0
        self.message.info.origin.orientation.w = 1.0
        self.publisher = rospy.Publisher("map", LargeGrid, latch=True, queue_size=1)
        ws.wait_for(lambda: self.publisher.get_num_connections() > 0, 20.0, "the planner on map")
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._run)

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

    def position(self, box):
        """(x, y) of the middle of a box in odom [m]."""
        row, column = box
        return tuple(start + (cell + BOX_CELLS / 2.0 - SIDE / 2.0) * RESOLUTION_M
                     for start, cell in zip(self.middle, (column, row)))

    def __enter__(self):
        self._thread.start()
        ws.wait_for(lambda: self.sent, 20.0, "the first map")
        return self

    def __exit__(self, *_):
        self._over.set()
        self._thread.join()

    def _run(self):
        due = time.monotonic()
        while not self._over.is_set():
            if len(self.recent) >= RECENT:
                self.fill(self.recent.pop(0), 0)
            box = self.draw(round(RECENT_M / RESOLUTION_M))
            self.fill(box, 100)
            self.recent.append(box)
            self.message.data = bytes(self.cells)
            self.publisher.publish(self.message)
            self.sent += 1
            due += PERIOD_S
            self._over.wait(max(0.0, due - time.monotonic()))
