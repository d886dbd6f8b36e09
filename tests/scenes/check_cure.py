#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Holds the curvature of a cooled cross-ply strip against lamination theory.

Usage: check_cure.py LAMELLA SCENE WORKDIR

The strip is free, b wide and h = 2 thick. Lamination theory has plane stress in each ply and
no resultants at the edges; what the strip has at its free edges, in a layer as wide as the
strip is thick, it has not, so that the difference falls as h/b. Twice the width is then half
of it, asserted to a fifth, and the finest to one per cent of the curvature.
"""

import json
import subprocess
import sys
from pathlib import Path

E1, E2, G12, NU12 = 165e3, 9e3, 5.6e3, 0.34
ALPHA = (-0.5e-6, 30e-6)
THICKNESS, CHANGE = 1., -100.
WIDTHS = (10., 20., 40.)


def solved(matrix, right):
    """x of matrix x = right, by elimination with pivots."""
    rows = [list(row) + [value] for row, value in zip(matrix, right)]
    n = len(rows)
    for k in range(n):
        pivot = max(range(k, n), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        for i in range(n):
            if i != k:
                factor = rows[i][k] / rows[k][k]
                rows[i] = [a - factor * b for a, b in zip(rows[i], rows[k])]
    return [row[n] / row[k] for k, row in enumerate(rows)]


def lamination_theory():
    """kappa_yy = -u_z'' along the fibers of the lower ply, of [0/90] under CHANGE.

    Strains eps + z kappa in x (across) and y (along), z from the middle; no force and no moment
    in either direction. Nothing shears.
    """
    nu21 = NU12 * E2 / E1
    q11, q22 = E1 / (1. - NU12 * nu21), E2 / (1. - NU12 * nu21)
    q12 = NU12 * q22
    plies = [(-THICKNESS, 0., ((q22, q12), (q12, q11)), (ALPHA[1], ALPHA[0])),
             (0., THICKNESS, ((q11, q12), (q12, q22)), (ALPHA[0], ALPHA[1]))]
    matrix = [[0.] * 4 for _ in range(4)]
    right = [0.] * 4
    for bottom, top, q, alpha in plies:
        powers = [(top ** (k + 1) - bottom ** (k + 1)) / (k + 1) for k in range(3)]
        for i in range(2):
            for j in range(2):
                for m in range(2):
                    for n in range(2):
                        matrix[2 * m + i][2 * n + j] += q[i][j] * powers[m + n]
                    right[2 * m + i] += q[i][j] * alpha[j] * CHANGE * powers[m]
    return solved(matrix, right)[3]


def curvature(lamella, scene, width, theory, folder):
    length = 6. * width
    middle, aside = length / 2., length / 2. - 5.
    settings = {"Theory": theory,
                "Section strip/Width": width,
                "Body strip/Length": length,
                "Support pin/At": f"{width / 2}, 0, 0",
                "Support slide/At": f"{width / 2}, {length}, 0",
                "Support upright/At": f"{width / 2}, 0, 2",
                "Probe middle/At": f"strip: {width / 2}, {middle}, 1",
                "Probe aside/At": f"strip: {width / 2}, {aside}, 1"}
    command = [lamella, str(scene), "--output", str(folder)]
    for path, value in settings.items():
        command += ["--set", f"{path}={value}"]
    run = subprocess.run(command, capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"width {width}: {run.stderr}")
    summary = json.loads((folder / "summary.json").read_text())
    return (-summary["measures"]["curvature"], summary["dofs"],
            summary["seconds"]["total"])


def main():
    lamella, scene, work = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
    work.mkdir(parents=True, exist_ok=True)
    exact = lamination_theory()
    faults = []
    for theory in ("LE-2", "SV-6"):
        differences = []
        for width in WIDTHS:
            found, dofs, seconds = curvature(lamella, scene, width, theory,
                                             work / f"{theory}_{width:g}")
            differences.append(found / exact - 1.)
            print(f"{theory}, b/h = {width / 2:g}: {found:.6e}, lamination theory "
                  f"{exact:.6e}, {100 * differences[-1]:+.3f} %; {dofs} DoFs, "
                  f"{seconds:.2f} s")
        for wide, narrow in zip(differences[1:], differences):
            if not 0.8 < 2. * wide / narrow < 1.2:
                faults.append(f"{theory}: {narrow} and {wide} at twice the width: not as h/b")
        if not abs(differences[-1]) < 0.01:
            faults.append(f"{theory}: {differences[-1]} at the largest width")
    for fault in faults:
        print(fault)
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
