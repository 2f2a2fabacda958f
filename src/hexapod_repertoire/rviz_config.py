"""Shows rviz's configurations in other frames than they were saved with."""
import copy
import os
import pathlib
import sys
from typing import Any, Dict, List

import rospy
import yaml

FIXED = "<Fixed Frame>"


def in_frames(config: Dict[str, Any], fixed_frame: str, robot_frame: str,
              tf_prefix: str) -> Dict[str, Any]:
    """The configuration with these frames; "" leaves one as it is.

    Args:
        fixed_frame: what all is shown in.
        robot_frame: what views follow that follow the robot.
        tf_prefix: of the robot's links, without the slash behind it.
    """
    config = copy.deepcopy(config)
    manager = config["Visualization Manager"]
    if fixed_frame:
        manager["Global Options"]["Fixed Frame"] = fixed_frame
    for display in manager["Displays"]:
        if display["Class"] == "rviz/RobotModel" and tf_prefix:
            display["TF Prefix"] = tf_prefix
    views = [manager["Views"]["Current"], *(manager["Views"].get("Saved") or [])]
    for view in views:
        if robot_frame and view.get("Target Frame", FIXED) != FIXED:
            view["Target Frame"] = robot_frame
    return config


def written(config: Dict[str, Any], name: str) -> pathlib.Path:
    """Writes a configuration where a node of this name finds it, and always to the same file."""
    folder = pathlib.Path(os.environ.get("ROS_HOME", pathlib.Path.home() / ".ros"))
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / ("hexapod_" + name.strip("/").replace("/", "_") + ".rviz")
    file.write_text(yaml.safe_dump(config, sort_keys=False), encoding="utf-8")
    return file


def main(argv: List[str]) -> None:
    """Becomes rviz. The node's parameters: config, and the arguments of in_frames()."""
    words = [word for word in argv[1:] if word.startswith("__name:=")]
    name = words[0].split(":=")[1] if words else "rviz"
    path = rospy.names.ns_join(rospy.get_namespace(), name)
    wanted = rospy.get_param(path)
    with open(wanted.pop("config"), encoding="utf-8") as stream:
        config = yaml.safe_load(stream)
    file = written(in_frames(config, **wanted), path)
    os.execvp("rviz", ["rviz", "-d", str(file), *argv[1:]])


if __name__ == "__main__":
    main(sys.argv)
