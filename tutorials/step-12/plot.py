#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws the leaves, bent as they are, with what they press on each other and how near they
are to failure: plot.py FOLDER PICTURE.PNG."""

import csv
import json
import sys
from pathlib import Path

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.collections import PolyCollection

LEAVES = ("lowest", "second", "third", "longest")
HALF = 3.  # mm, of the thickness
FOLDER = Path(sys.argv[1])


def read(name, **wanted):
    with open(FOLDER / name, newline="") as file:
        return [row for row in csv.DictReader(file)
                if all(row[key] == value for key, value in wanted.items())]


def column(rows, name):
    return np.array([float(row[name] or "nan") for row in rows])


figure, axis = plt.subplots(figsize=(9, 4.2), constrained_layout=True)
nearest = max(np.nanmax(column(read("plies_along.csv"), "inverse_reserve_factor")), 1e-9)
for number, name in enumerate(LEAVES, 1):
    line = read(f"lines/{name}.csv")
    y, z = column(line, "y"), column(line, "z") + column(line, "uz")
    near = read("plies_along.csv", body=f"leaf-{number}")
    shade = np.interp(y, column(near, "y"), column(near, "inverse_reserve_factor"))
    edges = [np.stack([y, z + side * HALF], axis=1) for side in (-1., 1.)]
    leaf = PolyCollection(np.stack([edges[0][:-1], edges[0][1:], edges[1][1:],
                                    edges[1][:-1]], axis=1), cmap="YlOrRd",
                          edgecolors="face", linewidths=0.3)
    leaf.set_array(0.5 * (shade[1:] + shade[:-1]))
    leaf.set_clim(0., nearest)
    axis.add_collection(leaf)
    for edge in edges:
        axis.plot(*edge.T, color="0.3", linewidth=0.6)
    axis.text(-4., z[0], f"leaf-{number}", ha="right", va="center", fontsize=9)

for name, contact in json.loads((FOLDER / "summary.json").read_text())["contacts"].items():
    force = contact["force"][2]
    pairs = [row for row in read(f"contact_{name}.csv") if float(row["active"])]
    y = np.mean(column(pairs, "y"))
    z = np.interp(y, *(column(read(f"lines/{LEAVES[int(name[-1]) - 1]}.csv"), c)
                       for c in ("y", "uz"))) + np.mean(column(pairs, "z"))
    axis.annotate(f"{force:.1f} N", (y, z), (y, z - 20.), ha="center", fontsize=9,
                  arrowprops={"arrowstyle": "->", "color": "0.2"})
axis.autoscale_view()
axis.set_ylim(-22., 30.)
axis.set_xlim(-32., 405.)
axis.set_xlabel("y [mm]")
axis.set_ylabel("z [mm]")
axis.spines[["top", "right"]].set_visible(False)
figure.colorbar(leaf, label="1/R, the larger the nearer to failure", pad=0.01)
figure.savefig(sys.argv[2], dpi=130)
