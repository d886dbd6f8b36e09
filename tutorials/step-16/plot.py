#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws the true errors and the bars of step-16: plot.py STEP-14.CSV BARS.PNG."""

import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

GOALS = {"tip: uz": ("deflection of the tip", "#0072B2", "o"),
         "outer: syy": ("bending stress in the outer ply", "#009E73", "s"),
         "inner: syz": ("shear stress in the middle ply", "#D55E00", "^")}

plt.rcParams.update({"font.size": 10, "axes.spines.top": False,
                     "axes.spines.right": False, "legend.frameon": False})


def draw_bars(table, path):
    """True errors, and bars above them, on one axis of per cents."""
    with open(table, newline="") as file:
        rows = list(csv.DictReader(file))
    names = list(dict.fromkeys(row["theory"] for row in rows))
    figure, axes = plt.subplots(figsize=(8, 4.3), layout="constrained")
    for k, (goal, (name, color, mark)) in enumerate(GOALS.items()):
        for row in (row for row in rows if row["goal"] == goal):
            x = names.index(row["theory"]) + 0.2 * (k - 1)
            error = 100. * abs(float(row["error"]))
            axes.plot(x, error, mark, color=color, markersize=6)
            if row["bar"]:
                bar = 100. * float(row["bar"])
                axes.plot([x, x], [1e-4, bar], color=color, linewidth=1.2, alpha=0.6)
                axes.plot([x - 0.07, x + 0.07], [bar, bar], color=color, linewidth=2.)
            else:
                axes.annotate("no bar", (x, error), (0, 7), ha="center", fontsize=8,
                              textcoords="offset points", color=color)
        axes.plot([], [], mark, color=color, label=name)
    axes.plot([], [], "_", color="0.3", markersize=10, markeredgewidth=2.,
              label="its bar")
    axes.set_yscale("log")
    axes.set_ylim(1e-3, 400.)
    axes.yaxis.set_major_formatter(lambda value, _: f"{value:g}")
    dofs = {row["theory"]: int(row["dofs"]) for row in rows}
    axes.set_xticks(range(len(names)), labels=[f"{name}\n{dofs[name]:,}"
                                               for name in names])
    axes.set_xlabel("theory, DoFs")
    axes.set_ylabel("true error [%]")
    axes.grid(axis="y", color="0.92")
    axes.legend(loc="upper right", fontsize=9)
    figure.savefig(path, dpi=110)


draw_bars(sys.argv[1], sys.argv[2])
