#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prints the table of step-6 and draws force and stresses: plot.py FOLDER
PICTURE.PNG."""

import csv
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

FULL = "4"  # the load step at which the roller is lowest


def read(name):
    with open(Path(sys.argv[1]) / name, newline="") as file:
        return list(csv.DictReader(file))


history = read("history.csv")
print("| load factor | roller [mm] | force [N] | top [mm] | bottom [mm] |")
print("|---|---|---|---|---|")
for row in history:
    factor = float(row["load_factor"])
    print(f"| {factor:g} | {-4 * factor:g} | "
          f"{float(row['contact:indentation:fz']):.2f} | "
          f"{float(row['probe:top:uz']):.4f} | {float(row['probe:bottom:uz']):.4f} |")

figure, (left, right) = plt.subplots(1, 2, figsize=(8.4, 4.2), layout="constrained")
for name, label, style in (
        ("top", "top", dict(color="#0072b2", marker="o")),
        ("bottom", "bottom", dict(color="#d55e00", marker="s", linestyle="--"))):
    left.plot([0] + [-float(row[f"probe:{name}:uz"]) for row in history],
              [0] + [float(row["contact:indentation:fz"]) for row in history],
              label=label, markersize=5, linewidth=1.4, **style)
left.set_xlabel("deflection at mid-span [mm]")
left.set_ylabel("force on a quarter [N]")
left.set_xlim(0, None)
left.set_ylim(0, None)
left.legend(loc="upper left")

for name, label, color, dash in (("below", "under the roller", "#0072b2", "-"),
                                  ("beside", "100 mm beside it", "#d55e00", "--")):
    rows = [row for row in read(f"lines/{name}.csv")
            if row["step"] == FULL and 3 <= float(row["z"]) <= 33 and row["ply"] == "4"]
    right.plot([float(row["szz"]) for row in rows], [float(row["z"]) for row in rows],
               color=color, linestyle=dash, linewidth=1.8,
               label=r"$\sigma_{zz}$, " + label)
right.set_xlabel("stress in the core [MPa]")
right.set_ylabel("z [mm]")
right.set_ylim(3, 33)
right.legend(loc="lower left")
for axes in (left, right):
    axes.grid(color="0.92")
figure.savefig(sys.argv[2], dpi=130)
