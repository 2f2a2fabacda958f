"""Draws what a calibration found: parameters with intervals, errors of prediction."""
import math
import pathlib
import typing

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend comes first)
import numpy as np  # noqa: E402

BEFORE, AFTER = "tab:orange", "tab:blue"


def draw_parameters(axes, parameters: typing.Sequence[typing.Mapping]) -> None:
    """Scales about 1 with their 95 % intervals; the truth, where it is known, as a cross."""
    scales = [one for one in parameters if one["name"].endswith("_scale")]
    for row, one in enumerate(reversed(scales)):
        axes.plot([one["low"], one["high"]], [row, row], color=AFTER, linewidth=3)
        axes.plot(one["value"], row, "o", color=AFTER)
        if one["truth"] is not None:
            axes.plot(one["truth"], row, "x", color="black", markersize=9)
    axes.axvline(1.0, color="0.6", linewidth=0.8)
    axes.set_yticks(range(len(scales)))
    axes.set_yticklabels([one["name"].replace("_scale", "") for one in reversed(scales)])
    axes.set_ylim(-0.6, len(scales) - 0.4)
    axes.set_xlabel("times what the files say, 95 %" +
                    (" (x: true)" if scales[0]["truth"] is not None else ""))


def misses(trials: typing.Sequence[typing.Mapping], when: str) -> np.ndarray:
    """x, y [m] and heading [rad] of the misses that are known, (n, 3)."""
    known = [one[when] for one in trials if one[when] is not None]
    return np.array(known, dtype=float).reshape(-1, 3)


def draw_misses(axes, trials: typing.Sequence[typing.Mapping]) -> None:
    """Where behaviours ended about where they were expected, before and after."""
    for when, color in (("before", BEFORE), ("after", AFTER)):
        for is_check, marker in ((False, "o"), (True, "s")):
            found = misses([one for one in trials if one["check"] == is_check], when)
            if len(found):
                axes.scatter(*(1e3 * found[:, :2].T), s=18, marker=marker, color=color, alpha=0.8,
                             label=f"{when}, {'not fitted' if is_check else 'fitted'}")
    axes.axhline(0.0, color="0.8", linewidth=0.8)
    axes.axvline(0.0, color="0.8", linewidth=0.8)
    axes.set_aspect("equal", adjustable="datalim")
    axes.set_xlabel("ahead [mm]")
    axes.set_ylabel("to the left [mm]")
    axes.set_title("ends, from where they were expected", fontsize=9)
    axes.legend(fontsize=7)


def draw_shares(axes, trials: typing.Sequence[typing.Mapping]) -> None:
    """Share of the behaviours whose heading was missed by at most so much."""
    for when, color in (("before", BEFORE), ("after", AFTER)):
        found = np.sort(np.abs(np.degrees(misses(trials, when)[:, 2])))
        if len(found):
            axes.step(found, np.arange(1, len(found) + 1) / len(found), where="post", color=color,
                      label=when)
    axes.set_xlim(left=0.0)
    axes.set_ylim(0.0, 1.02)
    axes.set_xlabel("heading missed by at most [deg]")
    axes.set_ylabel("share of behaviours")
    axes.legend(fontsize=7)


def draw(data: typing.Mapping, file: pathlib.Path) -> None:
    """Writes the picture of what the program's pictureData() tells."""
    figure, axes = plt.subplots(1, 3, figsize=(13, 4.2))
    draw_parameters(axes[0], data["parameters"])
    draw_misses(axes[1], data["trials"])
    draw_shares(axes[2], data["trials"])
    slope = math.degrees(math.hypot(*(one["value"] for one in data["parameters"]
                                      if one["name"].startswith("slope"))))
    figure.suptitle(f"Calibration of {data['robot']}: {len(data['trials'])} behaviours; floor "
                    f"sloping by {slope:.2f} deg", fontsize=10)
    figure.tight_layout()
    figure.savefig(file, dpi=110)
    plt.close(figure)
