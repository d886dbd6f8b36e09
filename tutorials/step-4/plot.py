#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws the error of the contact force over the penalty: plot.py STEP-4.CSV
PICTURE.PNG."""

import csv
import math
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

EPSILON = sys.float_info.epsilon
DOFS, AUTOMATIC = 1050, 4e6  # as the program prints them

with open(sys.argv[1], newline="") as file:
    rows = [{key: float(value) for key, value in row.items()}
            for row in csv.DictReader(file)]
ratio = [row["ratio"] for row in rows]

figure, axes = plt.subplots(figsize=(8, 4.8), layout="constrained")
axes.loglog(ratio, [-row["by_design"] for row in rows], color="0.75", linewidth=7,
            label="the penalty's own, 1 / (1 + eps / k)", solid_capstyle="butt")
for name, label, style in (
        ("once", "K + K$^p$ solved once", dict(color="#d55e00", marker="s")),
        ("full", "full, refined", dict(color="#0072b2", marker="o")),
        ("condensed", "condensed", dict(color="#009e73", marker="^"))):
    # Errors of zero are drawn at the last digit.
    points = [(r, max(abs(row[name]), 1e-16)) for r, row in zip(ratio, rows)
              if not math.isnan(row[name])]
    axes.loglog(*zip(*points), label=label, markersize=5, linewidth=1.2, **style)
for value, label, side in (
        (1 / math.sqrt(DOFS * EPSILON), "k / $\\sqrt{N t}$ ", "right"),
        (AUTOMATIC, " auto", "left"),
        (1 / (math.sqrt(DOFS) * EPSILON), "k / ($\\sqrt{N}$ t) ", "right")):
    axes.axvline(value, color="0.4", linewidth=0.8, linestyle=":")
    axes.text(value, 4, label, va="top", ha=side, color="0.25", fontsize=9)
axes.set_xlabel("penalty over the stiffness of the cubes, eps / k")
axes.set_ylabel("error of the contact force, relative")
axes.set_ylim(1e-17, 10)
axes.grid(color="0.92")
axes.legend(loc="lower left", framealpha=1)
figure.savefig(sys.argv[2], dpi=130)
