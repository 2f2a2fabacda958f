"""What the relay makes of a command, and which configurations it refuses."""
import types

import pytest

pytest.importorskip("rospy")
# pylint: disable=wrong-import-position
from hexapod_repertoire import servo_relay
from sensor_msgs.msg import JointState

COMMAND = JointState(name=["a", "b", "c"], position=[0.1, -0.2, 9.0])


def test_joints_of_a_group_come_in_its_order():
    convert = servo_relay.group_converter(types.SimpleNamespace, {"joints": ["c", "a"]})
    message = convert(COMMAND)
    assert (message.name, message.cmd) == ("all", [9.0, 0.1])
    assert servo_relay.group_converter(types.SimpleNamespace, {})(COMMAND).cmd == [0.1, -0.2, 9.0]
    with pytest.raises(servo_relay.RelayError, match="has no d; it has a, b, c"):
        servo_relay.group_converter(types.SimpleNamespace, {"joints": ["d"]})(COMMAND)


def test_pulses_stay_within_what_a_servo_bears():
    config = {"servos": {"c": {"servo": 3}, "b": {"servo": 7, "center": 300, "per_rad": -100}}}
    message = servo_relay.array_converter(types.SimpleNamespace, types.SimpleNamespace,
                                          config)(COMMAND)
    assert [(servo.servo, servo.value) for servo in message.servos] == [(3, 512.0), (7, 320.0)]


@pytest.mark.parametrize("servos, says", [
    (None, "servos is missing"), ({"a": {}}, "expected servo"),
    ({"a": {"servo": 1, "speed": 2}}, "expected servo"),
    ({"a": {"servo": 1}, "b": {"servo": 1}}, "number 1 twice")])
def test_servos_that_make_no_sense_are_refused(servos, says):
    with pytest.raises(servo_relay.RelayError, match=says):
        servo_relay.pulses_of(servos)


def test_a_configuration_with_unknown_keys_is_refused(tmp_path):
    file = tmp_path / "relay.yaml"
    file.write_text("group: legs\nspeed: 3\n")
    with pytest.raises(servo_relay.RelayError, match="speed is not known"):
        servo_relay.read_config(str(file))
    assert servo_relay.read_config("") == {}
