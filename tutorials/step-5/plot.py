#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prints the table of step-5 and draws the pressure: plot.py FOLDER PICTURE.PNG.

FOLDER holds a run for each width of the finest cell, called by it, and one with
more sectors, 24-sectors."""

import csv
import json
import math
import sys
from collections import defaultdict
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

MODULUS, RADIUS, CENTRE = 200 / (1 - 0.3**2), 8, 8
STYLES = {"0.1": ("#d55e00", "s", "h = 0.1"), "0.0125": ("#0072b2", "o", "h = 0.0125"),
          "24-sectors": ("#009e73", "", "h = 0.0125, 24 sectors")}


def last_step(file):
    with open(file, newline="") as stream:
        rows = list(csv.DictReader(stream))
    return [row for row in rows if row["step"] == rows[-1]["step"]]


def mean(values):
    return sum(values) / len(values)


figure, axes = plt.subplots(figsize=(8, 4.4), layout="constrained")
print("| h | DoFs | a/h | force | sigma_zz | p0 of the force | ratio |")
print("|---|---|---|---|---|---|---|")
for folder in sorted(Path(sys.argv[1]).iterdir(),
                     key=lambda f: 0 if "sectors" in f.name else -float(f.name)):
    contact = last_step(folder / "contact_nip.csv")
    force = sum(float(row["force"]) for row in contact)
    p0 = math.sqrt(force * MODULUS / math.pi / RADIUS)
    a = math.sqrt(4 * force * RADIUS / math.pi / MODULUS)
    stress = float(last_step(folder / "probes.csv")[0]["szz"])
    dofs = json.loads((folder / "summary.json").read_text())["dofs"]
    h = 0.0125 if "sectors" in folder.name else float(folder.name)
    print(f"| {folder.name} | {dofs} | {a / h:.1f} | {force:.5f} | {stress:.4f} | "
          f"{p0:.4f} | {-stress / p0:.4f} |")
    if folder.name in STYLES:
        pressure = defaultdict(list)
        for row in contact:
            pressure[float(row["x"]) - CENTRE].append(float(row["pressure"]))
        x = sorted(pressure)
        color, marker, label = STYLES[folder.name]
        axes.plot(x, [mean(pressure[s]) for s in x], color=color, marker=marker,
                  markersize=5, linewidth=1.3, label=label)
x = [a * (k / 200 - 1) for k in range(401)]
axes.plot(x, [p0 * math.sqrt(max(0, 1 - (s / a) ** 2)) for s in x], color="0.75",
          linewidth=7, zorder=0, label="Hertz", solid_capstyle="butt")
axes.set_xlim(-0.2, 0.2)
axes.set_ylim(0, 2)
axes.set_xlabel("x from the center")
axes.set_ylabel("pressure")
axes.grid(color="0.92")
axes.legend(loc="upper right", framealpha=1)
figure.savefig(sys.argv[2], dpi=130)
