#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws what each variant uses of the tolerances: plot.py TRADE.CSV PICTURE.PNG."""

import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

# Of step-7.cc.
TOLERANCES = {"press: fz": 0.02, "tension: syy": 0.03, "shear/1: syz": 0.03}
LOOKS = {"press: fz": ("force, 2 %", "o", "#0072b2"),
         "tension: syy": ("bending stress, 3 %", "s", "#009e73"),
         "shear/1: syz": ("shear stress, 3 %", "^", "#d55e00")}
BUDGET = 1000
# Where a name stands beside its variant, points.
NAMES = {"TBT": (-6, 8), "LE-1, axis 0.5, section 0.5": (-10, 8), "TE-6": (0, 8),
         "LE-2, axis 0.5, section 0.5": (0, 8), "TE-3, axis 0.5": (8, 8),
         "LE-2": (4, 8), "solid-2": (0, 8), "TE-4": (0, 8),
         "LE-3, axis 0.5, section 0.5": (0, 8), "LE-2, section 2": (0, 8),
         "LE-3": (0, 8), "LE-3, axis 2": (6, 8), "EBBT": (6, 8)}

variants = {}
with open(sys.argv[1], newline="") as file:
    for row in csv.DictReader(file):
        if row["error"]:
            variants.setdefault((row["variant"], int(row["dofs"])), {})[row["quantity"]] = (
                float(row["error"]) / TOLERANCES[row["quantity"]])

figure, axes = plt.subplots(figsize=(8, 4.8), layout="constrained")
axes.axhspan(1e-3, 1, color="#eef5ee", zorder=0)
axes.axhline(1, color="0.4", linewidth=0.8)
axes.text(95, 0.93, "enough", va="top", color="0.3", fontsize=9)
axes.axvline(BUDGET, color="0.4", linewidth=0.8, linestyle=":")
axes.text(BUDGET, 1.3e-3, " budget", color="0.3", fontsize=9)
for (name, dofs), used in variants.items():
    worst = max(used.values())
    axes.plot([dofs, dofs], [min(used.values()), worst], color="0.75", zorder=1)
    if name in NAMES:
        axes.annotate(name.replace(", section", ",\nsection").replace(", axis", ",\naxis"),
                      (dofs, worst), NAMES[name], textcoords="offset points",
                      ha="center", fontsize=7.5, color="0.2",
                      bbox={"color": "white", "alpha": 0.75, "pad": 0.5})
for quantity, (label, mark, color) in LOOKS.items():
    axes.loglog([dofs for _, dofs in variants], [used[quantity] for used in variants.values()],
                mark, color=color, markersize=5.5, label=label)
axes.set_xlim(90, 16000)
axes.set_ylim(1e-3, 200)
axes.set_xlabel("degrees of freedom")
axes.set_ylabel("error over tolerance")
axes.legend(loc="upper right", framealpha=1)
figure.savefig(sys.argv[2], dpi=130)
