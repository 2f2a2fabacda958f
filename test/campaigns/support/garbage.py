"""Messages of valid type and senseless content, drawn from a seed."""
import copy
import importlib
import math
import random
import re
import time

import rospy

MANY = 100000
# Names that the receivers know, so that a message gets past the first look at it.
WORDS = ("odom", "base_footprint", "/odom", "map", "")


def class_of(kind, part="msg"):
    """The Python class of "package/Type"."""
    package, name = kind.split("/")
    return getattr(importlib.import_module(f"{package}.{part}"), name)


def number_range(kind):
    """(least, largest) of an integer type of ROS."""
    if kind in ("bool", "byte", "char"):
        kind = "int8" if kind == "byte" else "uint8"
    bits = int(kind.lstrip("uint"))
    return (0, 2**bits - 1) if kind.startswith("u") else (-(2**(bits - 1)), 2**(bits - 1) - 1)


class Garbage:
    """Makes plausible messages and spoils them."""

    def __init__(self, seed, samples):
        """samples: real messages, by type; of other types it makes up plausible ones."""
        self.dice = random.Random(seed)
        self.samples = samples

    def message(self, kind):
        """A message of a type, in which one field, some or all are senseless."""
        return self._spoil(self.plausible(kind))

    def request(self, request_class):
        """The same as request of a service."""
        request = request_class()
        self.fill(request)
        return self._spoil(request)

    def _spoil(self, message):
        fields = list(self._fields(message))
        if fields:
            count = self.dice.choice((1, 1, 1, 2, 3, len(fields)))
            for holder, key, field_kind in self.dice.sample(fields, min(count, len(fields))):
                setattr(holder, key, self._senseless(field_kind, getattr(holder, key)))
        return message

    def plausible(self, kind):
        """A message as somebody might mean it: a real one where there is one."""
        if kind in self.samples:
            return copy.deepcopy(self.samples[kind])
        message = class_of(kind)()
        self.fill(message)
        return message

    def fill(self, message):
        """Gives every field of a message a plausible value."""
        if message._type == "geometry_msgs/Quaternion":
            yaw = self.dice.uniform(-math.pi, math.pi)
            message.z, message.w = math.sin(yaw / 2.0), math.cos(yaw / 2.0)
            return
        for key, kind in zip(message.__slots__, message._slot_types):
            setattr(message, key, self._plausible_field(kind, getattr(message, key)))
        if message._type == "nav_msgs/OccupancyGrid":
            message.info.resolution, message.info.width, message.info.height = 0.05, 20, 10
            message.data = [0] * 200

    def _plausible_field(self, kind, default):
        if kind.endswith("]"):
            base, count = re.fullmatch(r"(.*)\[(\d*)\]", kind).groups()
            return [self._plausible_field(base, self._default(base))
                    for _ in range(int(count or self.dice.randrange(4)))]
        if kind == "string":
            return self.dice.choice(WORDS)
        if kind == "time":
            return rospy.Time.from_sec(self.dice.choice((0.0, time.time())))
        if kind == "duration":
            return rospy.Duration(1)
        if kind.startswith("float"):
            return self.dice.uniform(-1.0, 1.0)
        if isinstance(default, rospy.Message):
            self.fill(default)
            return default
        return self.dice.randrange(2)

    @staticmethod
    def _default(kind):
        return class_of(kind)() if "/" in kind else 0

    def _fields(self, message):
        """(holder, key, type) of every field, those of nested messages instead of them; of the
        messages in an array one is looked into."""
        for key, kind in zip(message.__slots__, message._slot_types):
            value = getattr(message, key)
            if isinstance(value, rospy.Message):
                yield from self._fields(value)
                continue
            yield message, key, kind
            if isinstance(value, (list, tuple)) and value and isinstance(value[0], rospy.Message):
                yield from self._fields(self.dice.choice(value))

    def _senseless(self, kind, value):
        if kind.endswith("]"):
            return self._senseless_array(kind, list(value))
        if kind == "string":
            return self._senseless_string()
        if kind in ("time", "duration"):
            return self._senseless_time(kind)
        if kind.startswith("float"):
            huge = 3e38 if kind == "float32" else 1e308
            return self.dice.choice((math.nan, math.inf, -math.inf, 0.0, -0.0, 1e-45, huge, -huge,
                                     1e9, -1e4, self.dice.gauss(0.0, 10.0)))
        least, largest = number_range(kind)
        return self.dice.choice((least, largest, 0, 1, self.dice.randint(least, largest)))

    def _senseless_string(self):
        length = self.dice.choice((1, 10, 300, 10000, MANY))
        return self.dice.choice(("", "/", "//", " ", "\0", "%s%n", "../../x", "\u00e9\u4e16", "nan",
                                 "x" * length, str(self.dice.random())))

    def _senseless_time(self, kind):
        value = rospy.Time() if kind == "time" else rospy.Duration()
        now_s = int(time.time())
        seconds = (0, 1, now_s - 3600, now_s + 3600, now_s, 2**31 - 1)
        value.secs = self.dice.choice(seconds + ((2**32 - 1,) if kind == "time" else (-2**31,)))
        # More than a second of nanoseconds can be written on the wire, too.
        value.nsecs = self.dice.choice((0, 999999999, 2**31 - 1))
        return value

    def _senseless_array(self, kind, values):
        base, count = re.fullmatch(r"(.*)\[(\d*)\]", kind).groups()
        simple = not values or not isinstance(values[0], rospy.Message)
        if count or (values and self.dice.random() < 0.4):
            if values and simple:
                place = self.dice.randrange(len(values))
                values[place] = self._senseless(base, values[place])
            return values
        if not values:
            values = [self._plausible_field(base, self._default(base))]
        size = self.dice.choice((0, len(values) - 1, len(values) + 1, 2 * len(values), 1000,
                                 MANY if simple and base != "string" else 3000))
        return (values * (size // len(values) + 1))[:size]
