#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws the errors of frequencies and their bars: plot.py STEP-17.CSV FREQUENCIES.PNG."""

import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

COLORS = {"EBBT": "#000000", "TBT": "#D55E00", "TE-3": "#E69F00", "LE-1": "#56B4E9",
          "LE-2": "#0072B2", "SV-6": "#009E73"}

plt.rcParams.update({"font.size": 10, "axes.spines.top": False,
                     "axes.spines.right": False, "legend.frameon": False})


def draw_errors(table, path):
    """Errors, and bars above them, over the half-wave length; a panel per layup."""
    with open(table, newline="") as file:
        rows = list(csv.DictReader(file))
    layups = list(dict.fromkeys(row["layup"] for row in rows))
    figure, panels = plt.subplots(1, len(layups), figsize=(9, 4.6), sharey=True,
                                  layout="constrained")
    for axes, layup in zip(panels, layups):
        for theory, color in COLORS.items():
            points = sorted((float(row["slenderness"]) / int(row["mode"]),
                             100. * abs(float(row["error"])), 100. * float(row["bar"]))
                            for row in rows
                            if (row["layup"], row["theory"]) == (layup, theory))
            x, errors, bars = zip(*points)
            axes.plot(x, errors, "o-", color=color, markersize=5, label=theory)
            axes.vlines(x, errors, bars, color=color, linewidth=1., alpha=0.5)
            axes.plot(x, bars, "_", color=color, markersize=8, alpha=0.5)
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_xticks([2, 5, 10, 20], labels=["2", "5", "10", "20"], minor=False)
        axes.minorticks_off()
        axes.yaxis.set_major_formatter(lambda value, _: f"{value:g}")
        axes.set_xlabel("half-wave length / height, L / (n h)")
        axes.set_title(f"[{layup}]", fontsize=10)
        axes.grid(axis="y", color="0.92")
    panels[0].set_ylabel("error of the frequency [%]")
    panels[0].plot([], [], "_", color="0.4", markersize=8, label="error bar")
    panels[-1].legend(*panels[0].get_legend_handles_labels(), loc="center left",
                      bbox_to_anchor=(1., 0.5))
    figure.savefig(path, dpi=110)


draw_errors(sys.argv[1], sys.argv[2])
