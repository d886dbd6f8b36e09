#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prints the table of step-13 and draws shear and loop: plot.py FOLDER PICTURE.PNG.

FOLDER holds a run for each width of the finest cell, called by it; the finest is drawn."""

import csv
import math
import sys
from collections import defaultdict
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

MODULUS, RADIUS, CENTRE, FRICTION, PUSH = 200 / (1 - 0.3**2) / 2, 4, 8, 0.4, 0.0035
WAYS = [0, 0.25, 0.5, 0.75, 1, 0.5, 0, -0.5, -1, -0.5, 0, 0.5, 1]
PUSHED, BACK, FORTH = 4, 8, 12


class Step:
    """One load step of the contact: its nodes, and what theory makes of P and Q."""

    def __init__(self, rows):
        def column(name):
            return [float(row[name]) for row in rows]

        self.x = [x - CENTRE for x in column("x")]
        self.area, force, shear = column("area"), column("force"), column("shear_x")
        self.sticks = [row["state"] == "stick" for row in rows]
        self.P, self.Q = sum(force), sum(shear)
        self.pressure = [f / a if a > 0 else 0. for f, a in zip(force, self.area)]
        self.shear = [f / a if a > 0 else 0. for f, a in zip(shear, self.area)]
        self.dissipated = sum(d * a for d, a in zip(column("dissipated"), self.area))
        self.a = math.sqrt(4 * self.P * RADIUS / math.pi / MODULUS)
        self.left = 1 - abs(self.Q) / FRICTION / self.P
        self.c = self.a * math.sqrt(self.left)

    def ellipse(self, x, half):
        """mu p0 of a strip as wide as twice `half`, at x."""
        p0 = 2 * self.P / math.pi / self.a
        return FRICTION * p0 * half / self.a * math.sqrt(max(0, 1 - (x / half) ** 2))

    def cattaneo(self, x):
        """The shear after the first push."""
        return math.copysign(self.ellipse(x, self.a) - self.ellipse(x, self.c), self.Q)

    def cycle(self):
        """What going to and fro once dissipates."""
        y = self.left
        return ((FRICTION * self.P) ** 2 / math.pi / MODULUS *
                (4 * y * math.log(y) + 2 * (1 - y * y)))

    def off(self):
        """How far the shear is from Cattaneo's, over the area."""
        exact = [self.cattaneo(x) for x in self.x]
        return math.sqrt(sum(w * (q - e) ** 2 for w, q, e in zip(self.area, self.shear, exact)) /
                         sum(w * e * e for w, e in zip(self.area, exact)))


def steps_of(folder):
    by_step = defaultdict(list)
    with open(folder / "contact_nip.csv", newline="") as stream:
        for row in csv.DictReader(stream):
            by_step[int(row["step"])].append(row)
    return [Step(by_step[k]) for k in sorted(by_step)]


print("| h | a/h | Q / (mu P) | c | sticks to | shear off | energy of a cycle |")
print("|---|---|---|---|---|---|---|")
runs = sorted(Path(sys.argv[1]).iterdir(), key=lambda f: -float(f.name))
for run in runs:
    steps = steps_of(run)
    push = steps[PUSHED]
    stuck = max(x for x, sticks in zip(push.x, push.sticks) if sticks)
    found = steps[FORTH].dissipated - push.dissipated
    print(f"| {run.name} | {push.a / float(run.name):.0f} | {1 - push.left:.4f} | {push.c:.4f} | "
          f"{stuck:.4f} | {100 * push.off():.1f} % | {found / steps[FORTH].cycle():.4f} |")

figure, (over, loop) = plt.subplots(1, 2, figsize=(10, 4.2), layout="constrained",
                                    width_ratios=(3, 2))
push, back = steps[PUSHED], steps[BACK]
x = [push.a * (k / 200 - 1) for k in range(401)]
for side in (1, -1):
    over.plot(x, [side * push.ellipse(s, push.a) for s in x], color="0.6", linestyle="--",
              linewidth=1.2, label="mu p" if side > 0 else None)
over.plot(x, [push.cattaneo(s) for s in x], color="0.8", linewidth=6, label="Cattaneo",
          solid_capstyle="butt")
for step, color, label in ((push, "#0072b2", "pushed"), (back, "#d55e00", "pushed back")):
    nodes = defaultdict(list)
    for s, q in zip(step.x, step.shear):
        nodes[s].append(q)
    places = sorted(nodes)
    over.plot(places, [sum(nodes[s]) / len(nodes[s]) for s in places], color=color, marker="o",
              markersize=2.5, linewidth=1, label=label)
over.axvspan(-push.c, push.c, color="0.95", zorder=0)
over.text(0, -0.15, "sticks", ha="center", color="0.4")
over.set_xlim(-1.4 * push.a, 1.4 * push.a)
over.set_xlabel("x from the center")
over.set_ylabel("shear on the lower body")
over.grid(color="0.92")
over.legend(loc="lower right", framealpha=1, fontsize=8)

# Less the straight line between the turns, which takes nothing from the area.
line = 2 * PUSH / (push.Q - back.Q)
ways = [1e6 * (PUSH * f - line * s.Q) for f, s in zip(WAYS, steps)]
for first, last, color in ((0, PUSHED, "0.5"), (PUSHED, BACK, "#d55e00"), (BACK, FORTH, "#0072b2")):
    part = slice(first, last + 1)
    loop.plot(ways[part], [s.Q for s in steps[part]], color=color, marker="o", markersize=3.5,
              linewidth=1.3)
    loop.annotate("", xy=(ways[last - 1], steps[last - 1].Q),
                  xytext=(ways[last - 2], steps[last - 2].Q),
                  arrowprops={"arrowstyle": "-|>", "color": color, "mutation_scale": 16})
loop.set_xlabel("way, less the line between the turns [1e-6]")
loop.set_ylabel("Q")
loop.grid(color="0.92")
loop.margins(0.15)
figure.savefig(sys.argv[2], dpi=130)
