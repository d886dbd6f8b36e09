#!/usr/bin/env python3
"""Draws trade.png and trade.svg beside it from trade.csv: change it to taste.

A row of two panels for each quantity: error against seconds and against degrees of
freedom, axes logarithmic. Theories differ by color and mark; the Pareto front, which
nothing beats in both (accidents, which a richer variant gives away, aside), is filled, named
where there is room, and joined by steps.
"""

import csv
import math
import re
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.ticker import (FixedLocator, FuncFormatter, MaxNLocator,  # noqa: E402
                               NullLocator)

TITLE = ""
TOLERANCES = []  # per cent

HERE = Path(__file__).resolve().parent
# Zero has no place on a logarithmic axis.
LEAST_ERROR = 1e-4
# From pale to dark with rising order.
LOOKS = {"EBBT": ("p", ["#b3b3b3"]), "TBT": ("^", ["#6e6e6e"]),
         "TE": ("o", ["#fdae6b", "#f16913", "#d94801", "#a63603", "#7f2704", "#4d1600"]),
         "SV": ("v", ["#dadaeb", "#cbc9e2", "#bcbddc", "#aba8d1", "#9e9ac8", "#8a83bf",
                      "#756bb1", "#6751a3", "#54278f", "#3f007d"]),
         "LE": ("s", ["#9ecae1", "#4292c6", "#08519c", "#041f4a"]),
         "solid": ("D", ["#74c476", "#006d2c"]),
         # From 10 % down, a decade each.
         "tolerance": ("*", ["#f1b6da", "#de77ae", "#c51b7d", "#8e0152"])}
COSTS = (("seconds", "front_seconds", "seconds of the whole process"),
         ("dofs", "front_dofs", "degrees of freedom"))


def look_of(theory):
    if theory.startswith("tolerance "):
        mark, colors = LOOKS["tolerance"]
        decade = round(1 - math.log10(float(theory.split()[1])))
        return mark, colors[min(max(decade, 0), len(colors) - 1)]
    family, _, order = theory.partition("-")
    mark, colors = LOOKS[family]
    digits = re.match(r"\d+", order)
    return mark, colors[min(int(digits[0]) if digits else 1, len(colors)) - 1]


def rows_by_quantity():
    """The variants that have an error, by quantity, both in the order of the table."""
    rows = {}
    with open(HERE / "trade.csv", newline="", encoding="utf-8") as table:
        for row in csv.DictReader(table):
            if row["error"]:
                row["error"] = max(100 * float(row["error"]), LEAST_ERROR)
                rows.setdefault(row["quantity"], []).append(row)
    return rows


def label_plainly(axis, low, high):
    """1, 2 and 5 of each decade as they are read, or 1 alone where these are many."""
    leading = (1, 2, 5) if high < 300 * low else (1,)
    ticks = [m * 10.0 ** d for d in range(-12, 13) for m in leading
             if low <= m * 10.0 ** d <= high]
    if len(ticks) < 2:
        ticks = [t for t in MaxNLocator(4).tick_values(low, high) if low <= t <= high]
    axis.set_major_locator(FixedLocator(ticks))
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axis.set_minor_locator(NullLocator())


def draw_front(panel, front, cost):
    front = sorted(front, key=lambda row: float(row[cost]))
    x = [float(row[cost]) for row in front]
    y = [row["error"] for row in front]
    (left, right), (_, top) = panel.get_xlim(), panel.get_ylim()
    panel.step([x[0]] + x + [right], [top] + y + [y[-1]], where="post",
               color="#c0c0c0", linewidth=1.6, zorder=1)
    # A name has room if it keeps clear of the one before it.
    last = None
    for row, a, b in zip(front, x, y):
        here = panel.transData.transform((a, b))
        if last is None or abs(here[0] - last[0]) > last[2] or abs(here[1] - last[1]) > 14:
            far_right = here[0] > panel.transAxes.transform((0.7, 0))[0]
            panel.annotate(row["variant"], (a, b), fontsize=7.5, color="#303030",
                           xytext=(-6 if far_right else 6, 6), parse_math=False,
                           textcoords="offset points",
                           ha="right" if far_right else "left")
            last = (*here, 6 * len(row["variant"]) + 14)


def draw_panel(panel, rows, cost, on_front, label):
    for row in rows:
        mark, color = look_of(row["theory"])
        panel.loglog(float(row[cost]), row["error"], mark, color=color, markersize=7,
                     fillstyle="full" if row[on_front] == "1" else "none", zorder=2)
    for tolerance in TOLERANCES:
        panel.axhline(tolerance, color="#505050", linewidth=0.9, linestyle=":", zorder=1.5)
    panel.margins(x=0.12, y=0.12)
    panel.autoscale_view()
    for axis, limits in ((panel.xaxis, panel.get_xlim()), (panel.yaxis, panel.get_ylim())):
        label_plainly(axis, *limits)
    panel.set_xlim(panel.get_xlim())
    panel.set_ylim(panel.get_ylim())
    draw_front(panel, [row for row in rows if row[on_front] == "1"], cost)
    panel.set_xlabel(label)
    panel.grid(color="0.92")
    panel.set_axisbelow(True)
    panel.spines[["top", "right"]].set_visible(False)


def main():
    quantities = rows_by_quantity()
    if not quantities:
        return
    n = len(quantities)
    height = 3.4 * n + 0.6
    figure, panels = plt.subplots(n, 2, squeeze=False, figsize=(11.5, height))
    figure.subplots_adjust(left=0.07, right=0.87, wspace=0.16, hspace=0.42,
                           top=1 - 0.75 / height, bottom=0.55 / height)
    for row_of_panels, (quantity, rows) in zip(panels, quantities.items()):
        for panel, cost in zip(row_of_panels, COSTS):
            panel.set_title(quantity, fontsize=10, parse_math=False)
            draw_panel(panel, rows, *cost)
        row_of_panels[0].set_ylabel("error [%]")
    theories = dict.fromkeys(row["theory"] for rows in quantities.values() for row in rows)
    handles = [plt.Line2D([], [], linestyle="", marker=look_of(t)[0], color=look_of(t)[1],
                          label=t) for t in theories]
    figure.legend(handles=handles, loc="upper right", frameon=False, fontsize=9,
                  bbox_to_anchor=(0.995, 1 - 0.65 / height))
    figure.suptitle(TITLE, parse_math=False, x=0.02, y=1 - 0.12 / height, ha="left",
                    fontsize=12)
    for name in ("trade.png", "trade.svg"):
        figure.savefig(HERE / name, dpi=110)


main()
