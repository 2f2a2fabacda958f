"""A picture of an imported robot: stand, feet, collision shapes over what is seen, forward."""
import pathlib
import typing

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend comes first)
import numpy as np  # noqa: E402
from mpl_toolkits.mplot3d.art3d import Poly3DCollection  # noqa: E402

# Corners of a box as the program lists them: bit 0 is x, bit 1 y, bit 2 z.
BOX_EDGES = [(a, a | bit) for a in range(8) for bit in (1, 2, 4) if not a & bit]
FLOOR_M = 0.002
VIEWS = ((25, -60, "from the right"), (0, 0, "from ahead"), (90, -90, "from above"))


def outline(shape: typing.Mapping) -> typing.List[np.ndarray]:
    """Lines of a collision shape, each an array of points (n, 3) [m]."""
    points = np.array(shape["points"])
    if shape["kind"] == "box":
        return [points[[a, b]] for a, b in BOX_EDGES]
    around = np.linspace(0.0, 2.0 * np.pi, 25)
    radius = shape["radius_m"]
    lines = []
    for center in points:
        for first, second in ((0, 1), (0, 2), (1, 2)):
            ring = np.tile(center, (len(around), 1))
            ring[:, first] += radius * np.cos(around)
            ring[:, second] += radius * np.sin(around)
            lines.append(ring)
    if len(points) == 2:
        axis = points[1] - points[0]
        side = np.cross(axis, [0.0, 0.0, 1.0] if abs(axis[2]) < 0.9 * np.linalg.norm(axis)
                        else [1.0, 0.0, 0.0])
        side *= radius / max(np.linalg.norm(side), 1e-9)
        up = np.cross(axis, side)
        up *= radius / max(np.linalg.norm(up), 1e-9)
        lines += [points + offset for offset in (side, -side, up, -up)]
    return lines


def lowest(shape: typing.Mapping) -> np.ndarray:
    """The point of a shape that is nearest to the floor."""
    points = np.array(shape["points"])
    point = points[np.argmin(points[:, 2])].copy()
    point[2] -= shape["radius_m"]
    return point


def draw_view(axes, data: typing.Mapping, size_m: float) -> None:
    """One view of the robot on its floor."""
    if data["looks"]:
        axes.add_collection3d(Poly3DCollection(np.array(data["looks"]), facecolor="0.8",
                                               edgecolor="0.7", linewidth=0.1, alpha=0.35))
    for shape in data["shapes"]:
        for line in outline(shape):
            axes.plot(*line.T, color="tab:blue", linewidth=0.6)
        foot = lowest(shape)
        if foot[2] < FLOOR_M:
            axes.scatter(*foot, color="tab:red", s=12)
    axes.quiver(0, 0, data["height_m"], 0.8 * size_m, 0, 0, color="tab:green", linewidth=2)
    grid = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]) * size_m
    axes.add_collection3d(Poly3DCollection([grid], facecolor="wheat", alpha=0.25))
    axes.set_xlim(-size_m, size_m)
    axes.set_ylim(-size_m, size_m)
    axes.set_zlim(-0.7 * size_m, 1.3 * size_m)
    axes.set_axis_off()


def draw(data: typing.Mapping, file: pathlib.Path) -> None:
    """Writes the picture of what the program's pictureData() tells."""
    points = np.concatenate([np.array(shape["points"]) for shape in data["shapes"]])
    size_m = 1.1 * float(np.abs(points[:, :2]).max())
    figure = plt.figure(figsize=(15, 6))
    figure.subplots_adjust(left=0.0, right=1.0, bottom=0.0, top=0.9, wspace=0.0)
    for i, (elevation, azimuth, name) in enumerate(VIEWS):
        axes = figure.add_subplot(1, len(VIEWS), i + 1, projection="3d")
        draw_view(axes, data, size_m)
        axes.view_init(elev=elevation, azim=azimuth)
        axes.set_title(name, fontsize=9)
    state = "ready to learn" if data["ready"] else "not ready to learn"
    figure.suptitle(f"{data['name']}: {state}; blue: what collides, red: on the floor, "
                    f"green: forward", fontsize=10)
    figure.savefig(file, dpi=110)
    plt.close(figure)
