# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws sigma_yz through the height: plot.py STEP-1.CSV PICTURE.PNG."""

import csv
import sys
from collections import defaultdict

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

HEIGHT, MEAN = 0.1, 1000 / 0.1**2  # m, F / A in Pa

profiles = defaultdict(lambda: ([], []))
with open(sys.argv[1], newline="") as file:
    for row in csv.DictReader(file):
        stress, z = profiles[row["theory"]]
        stress.append(float(row["syz"]) / MEAN)
        z.append(1e3 * float(row["z"]))

figure, axes = plt.subplots(figsize=(8, 4.4), layout="constrained")
z = profiles["EBBT"][1]
axes.plot([1.5 * (1 - (2e-3 * s / HEIGHT - 1) ** 2) for s in z], z, color="0.75",
          linewidth=7, label="equilibrium", solid_capstyle="butt")
for theory, style in {
        "EBBT": dict(color="black"),
        "TBT": dict(color="#e69f00"),
        "TE-2": dict(color="#009e73"),
        "TE-4": dict(color="#0072b2"),
        "LE-3": dict(color="#d55e00", marker="o", markersize=4.5, markevery=2,
                     linestyle="none")}.items():
    axes.plot(*profiles[theory], label=theory, linewidth=1.8, clip_on=False,
              zorder=3, **style)
axes.set_xlabel(r"$\sigma_{yz}$ at mid-span, mean over the width, over $F/A$")
axes.set_ylabel("z [mm]")
axes.set_xlim(0, 1.6)
axes.set_ylim(0, 1e3 * HEIGHT)
axes.set_title("What each theory knows of the shear stress")
axes.grid(color="0.9")
axes.spines[["top", "right"]].set_visible(False)
axes.legend(frameon=False, loc="center left", bbox_to_anchor=(1, 0.5))
figure.savefig(sys.argv[2], dpi=150)
