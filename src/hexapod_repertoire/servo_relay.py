"""Passes joint commands on to servo drivers that take messages of other packages.

`interbotix`: interbotix_xs_msgs/JointGroupCommand, the joints of a group in its order [rad].
`servo_array`: i2cpwm_board/ServoArray of a PCA9685 board, pulse lengths in ticks.
Their message classes are looked up when the relay starts. It sends nothing but what it is sent, so
that a stop of the executor stops the driver's commands, too.
"""
import pathlib
from typing import Any, Callable, Dict, List, NamedTuple, Sequence, Tuple

import rospy
import yaml
from roslib.message import get_message_class
from sensor_msgs.msg import JointState

# Topic and message type of each driver, as its package has them.
DRIVERS = {"interbotix": ("commands/joint_group", "interbotix_xs_msgs/JointGroupCommand"),
           "servo_array": ("servos_absolute", "i2cpwm_board/ServoArray")}
SERVO_KEYS = {"servo", "center", "per_rad", "least", "most"}


class RelayError(RuntimeError):
    """What is wrong with the relay's configuration, in a sentence."""


class Pulse(NamedTuple):
    """One servo of a PCA9685 board: ticks = center + per_rad * angle, within least .. most.

    At 50 Hz a tick is 20 ms / 4096: 307 are 1.5 ms, the middle, and 130.4 per radian are the usual
    1 ms for 90 degrees.
    """
    servo: int
    center: float = 307.2
    per_rad: float = 130.4
    least: float = 102.4
    most: float = 512.0

    def ticks(self, angle_rad: float) -> float:
        """The pulse for an angle."""
        return min(max(self.center + self.per_rad * angle_rad, self.least), self.most)


def read_config(file: str) -> Dict[str, Any]:
    """The YAML of a relay: group and joints, or servos. Empty for no file."""
    if not file:
        return {}
    try:
        config = yaml.safe_load(pathlib.Path(file).expanduser().read_text(encoding="utf-8")) or {}
    except (OSError, UnicodeError, yaml.YAMLError) as problem:
        raise RelayError(f"{file} cannot be read: {problem}") from None
    unknown = set(config) - {"group", "joints", "servos", "topic", "message"}
    if unknown:
        raise RelayError(f"{file}: {', '.join(sorted(unknown))} is not known; expected group, "
                         "joints, servos, topic or message.")
    return config


def pulses_of(servos: Any) -> Dict[str, Pulse]:
    """The servos of a board, by the joints' names on the wire."""
    if not isinstance(servos, dict) or not servos:
        raise RelayError("servos is missing: expected for every joint, by its name on the wire, "
                         "{servo: 1, center: 307, per_rad: 130}.")
    pulses = {}
    for joint, values in servos.items():
        if not isinstance(values, dict) or "servo" not in values or set(values) - SERVO_KEYS:
            raise RelayError(f"servos.{joint} is {values}; expected servo, and if need be center, "
                             "per_rad, least and most.")
        pulses[joint] = Pulse(**values)
    numbers = [pulse.servo for pulse in pulses.values()]
    twice = sorted({number for number in numbers if numbers.count(number) > 1})
    if twice:
        raise RelayError(f"servos has number {twice[0]} twice.")
    return pulses


def values_of(joints: Sequence[str], command: JointState) -> List[float]:
    """The angles of these joints in a command; raises RelayError when it has not all of them."""
    angles = dict(zip(command.name, command.position))
    missing = [joint for joint in joints if joint not in angles]
    if missing:
        raise RelayError(f"joint_command has no {', '.join(missing)}; it has "
                         f"{', '.join(command.name)}.")
    return [angles[joint] for joint in joints]


def group_converter(message_class: Any, config: Dict[str, Any]) -> Callable[[JointState], Any]:
    """Makes JointGroupCommands; joints in the order of the group, or of the robot."""
    group, joints = config.get("group", "all"), config.get("joints", [])
    return lambda command: message_class(name=group,
                                         cmd=values_of(joints or command.name, command))


def array_converter(message_class: Any, servo_class: Any,
                    config: Dict[str, Any]) -> Callable[[JointState], Any]:
    """Makes ServoArrays, a servo for each joint that the configuration names."""
    pulses = pulses_of(config.get("servos"))

    def convert(command: JointState) -> Any:
        angles_rad = values_of(list(pulses), command)
        return message_class(servos=[servo_class(servo=pulse.servo, value=pulse.ticks(angle_rad))
                                     for pulse, angle_rad in zip(pulses.values(), angles_rad)])
    return convert


def class_of(message: str) -> Any:
    """The Python class of a message type."""
    found = get_message_class(message)
    if found is None:
        raise RelayError(f"The message {message} is not installed here; install the driver's "
                         "package and source its workspace.")
    return found


def converter(driver: str, config: Dict[str, Any]) -> Tuple[str, Any, Callable[[JointState], Any]]:
    """Topic, message class and conversion of a driver."""
    if driver not in DRIVERS:
        raise RelayError(f"~driver is '{driver}'; expected {' or '.join(DRIVERS)}.")
    topic, message = DRIVERS[driver]
    topic, message = config.get("topic", topic), config.get("message", message)
    message_class = class_of(message)
    if driver == "interbotix":
        return topic, message_class, group_converter(message_class, config)
    servo_class = class_of(message.split("/")[0] + "/Servo")
    return topic, message_class, array_converter(message_class, servo_class, config)


def main() -> int:
    """Relays until ROS shuts down."""
    rospy.init_node("servo_relay")
    try:
        topic, message_class, convert = converter(
            rospy.get_param("~driver", ""), read_config(rospy.get_param("~config", "")))
    except RelayError as problem:
        rospy.logfatal(problem)
        return 2
    publisher = rospy.Publisher(topic, message_class, queue_size=1)

    def relay(command: JointState) -> None:
        try:
            publisher.publish(convert(command))
        except RelayError as problem:
            rospy.logerr_throttle(5.0, str(problem))
    rospy.Subscriber("joint_command", JointState, relay, queue_size=1, tcp_nodelay=True)
    rospy.spin()
    return 0
