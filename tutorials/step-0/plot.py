# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws step-0.csv beside beam theory: plot.py STEP-0.CSV PICTURE.PNG."""

import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

FORCE, LENGTH, GAP, EI = 20.0, 1.0, 0.01, 143.64

with open(sys.argv[1], newline="") as file:
    rows = list(csv.DictReader(file))
y = [float(row["y"]) for row in rows]
uz = [1e3 * float(row["uz"]) for row in rows]


def cantilever(tip_force):
    """w(y) = F y^2 (3 L - y) / (6 EI), downwards, in mm."""
    return [-1e3 * tip_force * s * s * (3 * LENGTH - s) / (6 * EI) for s in y]


carried = FORCE - 3 * EI * GAP / LENGTH**3
figure, axes = plt.subplots(figsize=(8, 4), layout="constrained")
axes.plot(y, cantilever(FORCE), color="0.6", linestyle="--",
          label="beam theory without stops")
axes.plot(y, cantilever(FORCE - carried), color="#d55e00", linewidth=4, alpha=0.4,
          label="beam theory on the stops")
axes.plot(y, uz, color="#0072b2", label="step-0: 8 B4 x 6 L9")
axes.plot([LENGTH], [-1e3 * GAP], marker="^", markersize=12, color="black",
          linestyle="none", label="stops, 10 mm below")
axes.set_xlabel("y [m]")
axes.set_ylabel("$u_z$ [mm]")
axes.set_title("A cantilever that meets its stops")
axes.grid(color="0.9")
axes.spines[["top", "right"]].set_visible(False)
axes.legend(frameon=False)
figure.savefig(sys.argv[2], dpi=150)
