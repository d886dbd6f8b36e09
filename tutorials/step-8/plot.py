#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws fields of the section of step-8 and step-15: plot.py FIELDS.CSV PICTURE.PNG."""

import csv
import sys

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt

WIDTH, HEIGHT = 13., 4.  # mm
COLUMNS = 3
# Where rows of panels begin: the first field and a title each.
TITLES = {"u_x": "Six rigid motions", "extension": "Six Saint-Venant warpings",
          "line, k = 0.2": "Responses to the nose along all of its line",
          "hat, k = 0.2": "Responses to the nose in the middle of the top"}

fields = {}
with open(sys.argv[1], newline="") as file:
    for row in csv.DictReader(file):
        fields.setdefault(row["field"], []).append(
            [float(row[c]) for c in ("x", "z", "ux", "uy", "uz")])


def on_grid(points):
    """x, z, u_x, u_y, u_z as arrays, a row for each z."""
    points = np.array(points)
    across = len(np.unique(points[:, 0]))
    return points.T.reshape(5, -1, across)


def lines(axes, x, z, **style):
    """The outline of every fourth ply and of a cell of the section each."""
    for j in range(0, x.shape[0], 4):
        axes.plot(x[j], z[j], **style)
    for i in range(0, x.shape[1], 4):
        axes.plot(x[:, i], z[:, i], **style)


def draw(axes, name, points):
    x, z, ux, uy, uz = on_grid(points)
    move = max(np.hypot(ux, uz).max(), 1e-300)
    along = np.abs(uy).max()
    # What is nothing beside the other is not blown up. Beyond that each is
    # scaled for itself, as far as no ply is squashed to less than a third:
    # fields have no size of their own.
    squash = max((-np.diff(uz, axis=0) / np.diff(z, axis=0)).max(), 1e-300)
    scale = min(0.9 / move, 0.67 / squash) if move > 1e-6 * along else 0.
    color = uy / along if along > 1e-6 * move else 0. * uy
    axes.plot([0, WIDTH, WIDTH, 0, 0], [0, 0, HEIGHT, HEIGHT, 0], color="0.6",
              linewidth=0.8, linestyle=(0, (3, 2)))
    picture = axes.pcolormesh(x + scale * ux, z + scale * uz, color, cmap="RdBu_r",
                              vmin=-1.15, vmax=1.15, shading="gouraud")
    lines(axes, x + scale * ux, z + scale * uz, color="black", linewidth=0.5)
    axes.set_title(name, fontsize=10, pad=3)
    axes.set_xlim(-1.3, WIDTH + 1.3)
    axes.set_ylim(-1.15, HEIGHT + 1.15)
    axes.set_aspect("equal")
    axes.axis("off")
    return picture


names = list(fields)
PARTS = {k: TITLES[name] for k, name in enumerate(names) if name in TITLES}
rows = len(fields) // COLUMNS
figure = plt.figure(figsize=(9, 1.42 * rows + 0.8))
starts = list(PARTS) + [len(fields)]
# A part's title takes a third of a row.
title, gap = 0.3, 0.12
total = rows + len(PARTS) * title + 0.45
top = 1.
for part, (begin, end) in enumerate(zip(starts, starts[1:])):
    top -= title / total
    figure.text(0.02, top + 0.25 * title / total, PARTS[begin], fontsize=11.5,
                fontweight="bold", va="bottom")
    for k in range(begin, end):
        row, column = divmod(k - begin, COLUMNS)
        axes = figure.add_axes([0.01 + column * 0.98 / COLUMNS,
                                top - (row + 1) / total,
                                0.97 / COLUMNS, (1 - gap) / total])
        label = names[k].split(", ")[-1]
        if label.startswith("k = "):
            k_value = float(label[4:])
            label = f"k = {k_value:g} / mm, wave length {2 * np.pi / k_value:.2g} mm"
        elif label.startswith("u_"):
            label = f"${label}$"
        picture = draw(axes, label, fields[names[k]])
    top -= -(-(end - begin) // COLUMNS) / total
bar = figure.colorbar(picture, cax=figure.add_axes([0.33, 0.245 / total, 0.34, 0.0765 / total]),
                      orientation="horizontal", ticks=[-1, 0, 1])
bar.ax.set_xlim(-1, 1)
bar.ax.tick_params(labelsize=8.5, length=2)
figure.text(0.32, 0.283 / total, r"$u_y$ over its largest", ha="right", va="center",
            fontsize=9.5)
figure.savefig(sys.argv[2], dpi=110)
