#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs a scene and reads its VTU as a VTK reader would, without VTK.

Usage: check_vtu.py LAMELLA SCENE.prm WORKDIR

Decodes the compressed arrays and checks that they are whole: offsets and types
for each cell (72, Lagrange hexahedra), points and fields for each point; that the
undeformed positions fill the bodies' boxes; and that the displacement at each
probe is that of probes.csv, to single precision. Then the contacts' surfaces:
their quadrilaterals cover the facing surfaces once, their fields are those of
contact_NAME.csv in doubles, and pressure times area adds up to the force of
summary.json.
"""

import base64
import csv
import json
import struct
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
import zlib
from pathlib import Path

FORMATS = {"Float32": "f", "Int32": "i", "UInt8": "B"}


def decode(text, kind):
    """The numbers of a base64 array in blocks of zlib, the VTK XML format."""
    text = "".join(text.split())
    n_blocks = struct.unpack("<I", base64.b64decode(text[:8])[:4])[0]
    header_bytes = 4 * (3 + n_blocks)
    header_text = 4 * ((header_bytes + 2) // 3)
    sizes = struct.unpack(f"<{3 + n_blocks}I",
                          base64.b64decode(text[:header_text])[:header_bytes])[3:]
    packed, data = base64.b64decode(text[header_text:]), b""
    for size in sizes:
        data += zlib.decompress(packed[:size])
        packed = packed[size:]
    return struct.unpack(f"<{len(data) // struct.calcsize(kind)}{kind}", data)


def check(condition, what):
    if not condition:
        sys.exit(f"FAIL: {what}")
    print(f"ok: {what}")


def read_surface(path):
    """Arrays of a contact's VTU, in text."""
    piece = ElementTree.parse(path).getroot().find(".//Piece")
    arrays = {}
    for array in piece.iter("DataArray"):
        numbers = [float(word) for word in array.text.split()]
        n = int(array.get("NumberOfComponents"))
        arrays[array.get("Name")] = (
            numbers if n == 1 else
            [tuple(numbers[k:k + n]) for k in range(0, len(numbers), n)])
    check(len(arrays["points"]) == int(piece.get("NumberOfPoints")), "all points")
    check(len(arrays["types"]) == len(arrays["offsets"]) ==
          int(piece.get("NumberOfCells")), "all cells")
    check(len(arrays["connectivity"]) == arrays["offsets"][-1], "all corners")
    return arrays


def area_of(a, b, c, d):
    """Half the cross product of the diagonals."""
    p, q = ([y - x for x, y in zip(*ends)] for ends in ((a, c), (b, d)))
    return 0.5 * sum((p[i - 2] * q[i - 1] - p[i - 1] * q[i - 2]) ** 2
                     for i in range(3)) ** 0.5


def check_contact(output, name, contact):
    collection = ElementTree.parse(output / f"contact_{name}.pvd")
    files = [entry.get("file") for entry in collection.iter("DataSet")]
    check(files == [f"contact_{name}_0001.vtu"], f"contact_{name}.pvd")
    arrays = read_surface(output / files[0])
    with open(output / f"contact_{name}.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    check(len(rows) == len(arrays["points"]), "a point a pair")
    undeformed = [tuple(x - u for x, u in zip(*both)) for both in
                  zip(arrays["points"], arrays["displacement"])]
    check(all(abs(x - float(row[c])) < 1e-13 for at, row in zip(undeformed, rows)
              for c, x in zip("xyz", at)), "on the first body, displaced")
    for field, column in (("pressure", "pressure"), ("force", "force"),
                          ("gap", "gap"), ("initial_gap", "initial_gap"),
                          ("area", "area"), ("status", "active")):
        check(all(value == float(row[column])
                  for value, row in zip(arrays[field], rows)), field)
    check(all(abs(sum(a * b for a, b in zip(*pair)) - gap) < 1e-13
              for *pair, gap in zip(arrays["separation"], arrays["normal"],
                                    arrays["gap"])),
          "the gap is the separation along the normal")
    corners = [int(k) for k in arrays["connectivity"]]
    covered = sum(area_of(*(undeformed[k] for k in corners[4 * i:4 * i + 4]))
                  for i in range(len(arrays["types"])))
    check(set(arrays["types"]) == {9} and
          abs(covered / sum(arrays["area"]) - 1.) < 1e-12,
          "quadrilaterals cover the surface once")
    force = [sum(p * a * n[c] for p, a, n in
                 zip(arrays["pressure"], arrays["area"], arrays["normal"]))
             for c in range(3)]
    check(max(abs(a - b) for a, b in zip(force, contact["force"]))
          < 1e-12 * max(map(abs, force)), "pressure times area is the force")
    check(len([s for s in arrays["status"] if s]) == contact["active"] ==
          contact["closed"][0], "active points")


def main():
    if len(sys.argv) != 4:
        sys.exit("Usage: check_vtu.py LAMELLA SCENE.prm WORKDIR")
    output = Path(sys.argv[3])
    subprocess.run([sys.argv[1], sys.argv[2], "--output", output], check=True,
                   stdout=subprocess.DEVNULL)
    collection = ElementTree.parse(output / "solution.pvd")
    names = [entry.get("file") for entry in collection.iter("DataSet")]
    check(len(names) == 1, "solution.pvd names one file")
    piece = ElementTree.parse(output / names[0]).getroot().find(".//Piece")
    n_points = int(piece.get("NumberOfPoints"))
    n_cells = int(piece.get("NumberOfCells"))
    arrays = {array.get("Name") or "points":
              decode(array.text, FORMATS[array.get("type")])
              for array in piece.iter("DataArray")}

    check(len(arrays["offsets"]) == n_cells, f"{n_cells} offsets")
    check(arrays["offsets"][-1] == n_points == len(arrays["connectivity"]),
          f"connectivity of {n_points} points")
    check(set(arrays["types"]) == {72} and len(arrays["types"]) == n_cells,
          "Lagrange hexahedra")
    check(sorted(arrays["connectivity"]) == list(range(n_points)),
          "every point belongs to one cell")
    for name, values in arrays.items():
        if name not in ("offsets", "types", "connectivity"):
            components = 3 if name in ("points", "displacement", "fibre") else 1
            check(len(values) == components * n_points, f"{name} at each point")

    points, shift = arrays["points"], arrays["displacement"]
    undeformed = [tuple(points[3 * k + c] - shift[3 * k + c] for c in range(3))
                  for k in range(n_points)]
    with open(output / "probes.csv", newline="") as file:
        probes = list(csv.DictReader(file))
    for probe in probes:
        if not probe["probe"].endswith("_top"):
            continue  # between the points of the pictures
        at = tuple(float(probe[c]) for c in "xyz")
        nearest = min(range(n_points), key=lambda k: sum(
            (a - b) ** 2 for a, b in zip(undeformed[k], at)))
        expected = [float(probe[c]) for c in ("ux", "uy", "uz")]
        found = shift[3 * nearest:3 * nearest + 3]
        size = max(map(abs, expected))
        check(max(abs(a - b) for a, b in zip(undeformed[nearest], at)) < 1e-5 and
              max(abs(a - b) for a, b in zip(found, expected)) < 1e-6 * size,
              f"displacement at probe {probe['probe']}")
    summary = json.loads((output / "summary.json").read_text())
    for name, contact in summary["contacts"].items():
        check_contact(output, name, contact)


if __name__ == "__main__":
    main()
