#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Supports that nearly lie on a line of the mesh: check_near_lines.py LAMELLA SCENE DIR.

A strip is pressed along a line across it, on a line between two elements of its axis
and on its upper face. One end of the line is moved off, by 1e-13 to 1e-2, the latter 5 %
of an element. Up to 1e-6 of the height of the section the force is that of the line in
place, to 1e-6. Beyond that the line runs through an element and holds what the functions
of that do along it, which is another discretization of the same support: its force
differs by less than 0.05 %.
"""

import json
import pathlib
import subprocess
import sys

HEIGHT = 0.003
ON_THE_LINE = 1e-6 * HEIGHT
SMALL = {"Trade/Quantities": "middle: fz", "Probes": "", "Lines": "", "Cuts": "",
         "Write VTU": "false", "Section strip/Cells across": "2",
         "Body upper/Kinematics/Axis elements": "10",
         "Body lower/Kinematics/Axis elements": "10"}


def force(lamella, scene, folder, theory, point):
    """The force of the line from the corner to `point`, or what the program says."""
    entries = {**SMALL, "Theory": theory, "Support press/At": "0, 1, 0.106; " + point}
    command = [lamella, scene, "--output", folder]
    for path, value in entries.items():
        command += ["--set", f"{path}={value}"]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode != 0:
        return run.stderr.strip()
    summary = json.loads((pathlib.Path(folder) / "summary.json").read_text())
    return summary["supports"]["press"]["reaction"][2]


def main():
    lamella, scene, folder = sys.argv[1:4]
    failures = []
    for theory in ("LE-2", "SV-6"):
        there = force(lamella, scene, folder, theory, "0.1, 1, 0.106")
        if isinstance(there, str):
            sys.exit(f"{theory}, in place: {there}")
        exponents = (13, 11, 9, 8, 7, 6, 4, 2) if theory == "LE-2" else (12, 7, 2)
        along = [10.0 ** -e for e in exponents] + [0.9 * ON_THE_LINE]
        points = [(d, f"0.1, {1.0 + d:.16g}, 0.106") for d in along]
        points += [(d, f"0.1, 1, {0.106 - d:.16g}") for d in (1e-12, 2e-9)]
        for offset, point in points:
            found = force(lamella, scene, folder, theory, point)
            bound = 1e-6 if offset <= ON_THE_LINE else 5e-4
            if isinstance(found, str):
                failures.append(f"{theory}, {point}: {found}")
            elif abs(found / there - 1.0) > bound:
                failures.append(f"{theory}, {point}: {found} N instead of {there} N")
            print(theory, point, found if isinstance(found, str) else found / there - 1.0)
    if failures:
        sys.exit("\n".join(failures))


if __name__ == "__main__":
    main()
