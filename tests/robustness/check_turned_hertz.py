#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hertz turned by thirds: the same areas and forces of all rows.

Usage: check_turned_hertz.py LAMELLA prm/hertz.prm WORKDIR

Turns prm/hertz.prm by the rotation [[2, -1, 2], [2, 2, -1], [-1, 2, 2]] / 3, none of
whose entries is a double, so that whatever a comparison of two nearly equal numbers
decides is decided anew: which slivers are left out when surfaces are cut with each
other, which points are within the Search distance. Areas and forces of the rows must
agree to 1e-10 of the largest.
"""

import csv
import re
import subprocess
import sys
from pathlib import Path

THIRDS = [[2 / 3, -1 / 3, 2 / 3], [2 / 3, 2 / 3, -1 / 3], [-1 / 3, 2 / 3, 2 / 3]]
UNIT = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
TOLERANCE = 1e-10


def turned(text, rotation):
    """The scene without what reports, its bodies and its press turned."""
    def vector(*x):
        return ", ".join(repr(sum(r * c for r, c in zip(row, x))) for row in rotation)
    text = re.sub(r"subsection (Probe|Line|Cut|Trade).*?\nend\n", "", text, flags=re.S)
    text = re.sub(r"set (Probes|Lines|Cuts|References) .*\n", "\n", text)
    text = re.sub(r"  set (Origin|Up) .*\n", "", text)
    text = re.sub(r"set u +=.*-0\.01", "set u = " + vector(0, 0, -0.01), text)
    for body, origin, up in (("upper", (16, 0, 16), -1), ("lower", (0, 0, 0), 1)):
        text = text.replace(
            f"subsection Body {body}\n",
            f"subsection Body {body}\n  set Origin = {vector(*origin)}\n"
            f"  set Axis = {vector(0, 1, 0)}\n  set Up = {vector(0, 0, up)}\n")
    return "set Write VTU = false\n" + text


def rows(program, scene, folder):
    subprocess.run([program, scene, "--output", folder], check=True,
                   stdout=subprocess.DEVNULL)
    with (folder / "contact_nip.csv").open(newline="") as file:
        return list(csv.DictReader(file))


def main():
    program, source, work = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
    work.mkdir(parents=True, exist_ok=True)
    found = []
    for name, rotation in (("plain", UNIT), ("turned", THIRDS)):
        scene = work / f"{name}.prm"
        scene.write_text(turned(source.read_text(), rotation))
        found.append(rows(program, scene, work / name))
    plain, other = found
    good = len(plain) == len(other)
    print(f"{len(plain)} rows, {len(other)} turned")
    for column in ("area", "force"):
        largest = max(float(row[column]) for row in plain)
        worst = max(abs(float(a[column]) - float(b[column]))
                    for a, b in zip(plain, other)) / largest
        good = good and worst < TOLERANCE
        print(f"{column}: {worst:.2g} of the largest")
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit("Usage: check_turned_hertz.py LAMELLA prm/hertz.prm WORKDIR")
    main()
