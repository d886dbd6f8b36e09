#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws what step-9 leaves in FOLDER: plot.py FOLDER DUALS.PNG."""

import csv
import sys
from pathlib import Path

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt

LOAD, HEIGHT = 20., 3.  # mm: where the force stands
# Of each goal its place, its name and symbol, and how far its dual is drawn to move.
GOALS = {"tip: uz": (30., 1.5, "deflection of the tip", r"$u_z$", 4.),
         "outer: syy": (10., 2.8, "bending stress in the outer ply", r"$\sigma_{yy}$", 4.),
         "inner: syz": (10., 1.5, "shear stress in the middle ply", r"$\sigma_{yz}$", 2.4)}
THEORIES = {"SV": ("#0072B2", -0.22), "LE-1": ("#D55E00", 0.), "LE-2": ("#009E73", 0.22)}

plt.rcParams.update({"font.size": 10, "axes.spines.top": False,
                     "axes.spines.right": False, "legend.frameon": False})


def read(folder, name):
    with open(Path(folder) / f"step-9-{name}.csv", newline="") as file:
        return list(csv.DictReader(file))


def deformed(axes, rows, at, size):
    """The section along the beam, its largest u_z drawn as @p size; plies are outlined,
    u_z is the color. Returns where the point @p at has gone."""
    y, z, uy, uz = (np.array([float(row[c]) for row in rows])
                    for c in ("y", "z", "uy", "uz"))
    across = len(np.unique(z))
    y, z, uy, uz = (v.reshape(across, -1) for v in (y, z, uy, uz))
    scale = size / np.abs(uz).max()
    axes.pcolormesh(y + scale * uy, z + scale * uz, scale * uz, cmap="RdBu_r", vmin=-5.,
                    vmax=5., shading="gouraud")
    for j in range(0, across, (across - 1) // 3):
        axes.plot((y + scale * uy)[j], (z + scale * uz)[j], color="0.15", linewidth=0.7)
    axes.plot([0, 30, 30, 0, 0], [0, 0, HEIGHT, HEIGHT, 0], color="0.6", linewidth=0.7,
              linestyle=(0, (3, 2)))
    axes.plot([0., 0.], [-2., HEIGHT + 2.], color="0.15", linewidth=3.)
    axes.set_aspect("equal")
    axes.set_xlim(-1., 31.5)
    axes.set_ylim(-4.2, HEIGHT + 4.2)
    axes.axis("off")
    place = np.unravel_index(np.argmin((y - at[0])**2 + (z - at[1])**2), y.shape)
    return (y + scale * uy)[place], (z + scale * uz)[place]


def shares(axes, rows, goal):
    """What the residual at each node does on the dual."""
    for theory, (color, shift) in THEORIES.items():
        here = [row for row in rows if row["theory"] == theory and row["goal"] == goal]
        y = np.array([float(row["y"]) for row in here])
        share = 100. * np.array([float(row["share"]) for row in here])
        axes.vlines(y + shift, 0., share, color=color, linewidth=1.8,
                    label=f"{theory}: {share.sum():+.2g} %")
    axes.axhline(0., color="0.3", linewidth=0.8)
    axes.set_xlim(-1., 31.5)
    axes.set_ylabel(f"error of {GOALS[goal][3]} [%]")
    axes.legend(loc="upper right", fontsize=9, handlelength=1., borderaxespad=0.)


def draw_duals(folder, path):
    fields, of_nodes = {}, read(folder, "shares")
    for row in read(folder, "fields"):
        fields.setdefault(row["field"], []).append(row)
    figure, axes = plt.subplots(4, 2, figsize=(10.4, 8.), layout="constrained")
    point = deformed(axes[0, 0], fields["primal"], (LOAD, HEIGHT), 4.)
    axes[0, 0].annotate("", point, (point[0], point[1] + 4.),
                        arrowprops={"arrowstyle": "-|>", "color": "black"})
    axes[0, 0].set_title("the beam under its load", fontsize=10, loc="left")
    axes[0, 1].axis("off")
    axes[0, 1].text(0., 0.05, "What each node adds to the error of the goal on the left:\n"
                    "the forces that a theory leaves unbalanced\nthere, times the dual.",
                    fontsize=10, va="bottom")
    for row, (goal, (y, z, name, _, size)) in zip(axes[1:], GOALS.items()):
        point = deformed(row[0], fields[goal], (y, z), size)
        row[0].plot(*point, "o", color="black", markersize=6, markerfacecolor="#ffd24d")
        row[0].set_title(f"dual of the {name}", fontsize=10, loc="left")
        shares(row[1], of_nodes, goal)
    axes[-1, 1].set_xlabel("y [mm]")
    figure.savefig(path, dpi=110)


draw_duals(sys.argv[1], sys.argv[2])
