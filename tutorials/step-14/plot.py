#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prints the table of step-14 and draws the shapes: plot.py FOLDER PICTURE.PNG.

FOLDER holds the runs `large` and `linear`."""

import csv
import json
import math
import sys
from collections import defaultdict
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

# The elastica at P L^2 / (E I) = 1, 2, 3, 4: how far its tip moves, over L
# (K. Mattiasson, Int. J. Numer. Meth. Engng 17, 1981).
ELASTICA = {1: (0.05643, 0.30172), 2: (0.16064, 0.49346), 3: (0.25442, 0.60325),
            4: (0.32894, 0.66996)}
LENGTH, ROLLER, RADIUS = 100, (290, -7.8), 7


def read(path):
    with open(path) as file:
        return list(csv.DictReader(file))


def shapes(folder, line):
    """Of each load step where the points of a line are."""
    steps = defaultdict(list)
    for row in read(folder / "lines" / f"{line}.csv"):
        steps[int(row["step"])].append((float(row["y"]) + float(row["uy"]),
                                        float(row["z"]) + float(row["uz"])))
    return steps


def print_tables(runs):
    print("| P L^2 / (E I) | -u / L, w / L of the elastica | large | linear |")
    print("|---|---|---|---|")
    tips = {name: {int(row["step"]): row for row in read(folder / "probes.csv")
                   if row["probe"] == "tip"} for name, folder in runs.items()}
    for step, (u, w) in ELASTICA.items():
        words = [f"{-float(tips[name][step]['uy']) / LENGTH:.5f}, "
                 f"{float(tips[name][step]['uz']) / LENGTH:.5f}" for name in runs]
        print(f"| {step} | {u:.5f}, {w:.5f} | {' | '.join(words)} |")
    print("\n| middle down | force of the roller, up and along: large | linear |\n|---|---|---|")
    forces = {name: read(folder / "history.csv") for name, folder in runs.items()}
    for step in range(4):
        words = [f"{-float(forces[name][step]['contact:rest:fz']):.4f}, "
                 f"{-float(forces[name][step]['contact:rest:fy']):.4f}" for name in runs]
        print(f"| {15 * (step + 1)} | {' | '.join(words)} |")


def draw(runs, picture):
    figure, axes = plt.subplots(1, 2, figsize=(11, 4.6), constrained_layout=True,
                                gridspec_kw={"width_ratios": [1, 1.45]})
    for panel, line, title in ((axes[0], "round_axis", "Bent round by a force at its end"),
                               (axes[1], "over_axis", "Over a roller")):
        for name, style in (("linear", {"color": "0.6", "linestyle": "--"}),
                            ("large", {"color": "C0"})):
            for step, points in shapes(runs[name], line).items():
                panel.plot(*zip(*points), **style, linewidth=1.6,
                           label=("Rotations = " + name) if step == 1 else None)
        panel.set_aspect("equal")
        panel.set_title(title)
        panel.set_xlabel("y [mm]")
        panel.spines[["top", "right"]].set_visible(False)
    axes[0].set_ylabel("z [mm]")
    axes[1].add_patch(plt.Circle(ROLLER, RADIUS, fill=False, color="0.2"))
    axes[0].legend(frameon=False, loc="upper left")
    figure.savefig(picture, dpi=130)


def main():
    folder = Path(sys.argv[1])
    runs = {name: folder / name for name in ("large", "linear")}
    print_tables(runs)
    draw(runs, sys.argv[2])


if __name__ == "__main__":
    main()
