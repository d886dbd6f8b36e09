#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs a scene and reads its VTU as a VTK reader would, without VTK.

Usage: check_vtu.py LAMELLA SCENE.prm WORKDIR

Decodes the compressed arrays and checks that they are whole: offsets, types (72,
Lagrange hexahedra) and degrees for each cell, points and fields for each point; that
the displacement at each probe is that of probes.csv, to single precision, and all
strains and stresses at the points of a cut those of its table, to 2^-11 of the
component's largest in the element. Then the contacts' surfaces: their quadrilaterals cover the
facing surfaces once, their fields are those of contact_NAME.csv in doubles, and
pressure times area adds up to the force of summary.json.
"""

import csv
import json
import struct
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
import zlib
from pathlib import Path

FORMATS = {"Float32": "f", "Float64": "d", "Int32": "i", "UInt8": "B"}
FIELDS = ("exx eyy ezz gxy gxz gyz sxx syy szz sxy sxz syz "
          "s11 s22 s33 s12 s13 s23").split()
ELEMENT = 2. ** -11  # of the largest in an element: how a component is rounded
FILE = 2. ** -24  # of the largest of all: no finer than this


def read(path):
    """The one piece of a VTU and its arrays by name, with how many components each has."""
    head, _, data = path.read_bytes().partition(b'<AppendedData encoding="raw">\n_')
    piece = ElementTree.fromstring(head + b"</VTKFile>").find(".//Piece")
    arrays, ends = {}, 0
    for array in piece.iter("DataArray"):
        check(int(array.get("offset")) == ends, f"{array.get('Name')} follows")
        values, ends = decode(data, ends, FORMATS[array.get("type")])
        arrays[array.get("Name")] = values, int(array.get("NumberOfComponents"))
    check(data[ends:] == b"\n</AppendedData>\n</VTKFile>\n", "nothing else")
    return piece, arrays


def decode(data, begin, kind):
    """The numbers of an array in blocks of zlib, the VTK XML format, and where it ends."""
    n_blocks, size, last = struct.unpack_from("<3I", data, begin)
    packed = struct.unpack_from(f"<{n_blocks}I", data, begin + 12)
    begin += 12 + 4 * n_blocks
    result = b""
    for length in packed:
        result += zlib.decompress(data[begin:begin + length])
        begin += length
    assert len(result) == (n_blocks - (last > 0)) * size + last
    return struct.unpack(f"<{len(result) // struct.calcsize(kind)}{kind}", result), begin


def check(condition, what):
    if not condition:
        sys.exit(f"FAIL: {what}")
    print(f"ok: {what}")


def read_surface(path):
    """Arrays of a contact's VTU."""
    piece, found = read(path)
    arrays = {name: values if n == 1 else
              [values[k:k + n] for k in range(0, len(values), n)]
              for name, (values, n) in found.items()}
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
        # Tables have fifteen digits.
        check(all(abs(value - float(row[column])) <= 1e-14 * abs(value)
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


def check_cut(path, arrays, places):
    """Where two elements along the axis meet, in the table is the mean of both."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    middles = {row["cell"]: key(float(row[c]) for c in "xz") for row in rows
               if row["i"] == row["j"] == "4"}
    points = {}
    for begin in range(0, len(places), 36):
        element = places[begin:begin + 36]
        middle = key(sum(place[c] for place in element) / 36 for c in (0, 2))
        for k, place in enumerate(element, begin):
            points.setdefault((middle, key(place)), []).append(k)
    largest = [max(max(map(abs, arrays[name])) for name in FIELDS[k:k + 6])
               for k in (0, 6, 12)]
    worst, count = 0., 0
    for row in rows:
        here = points.get((middles[row["cell"]], key(float(row[c]) for c in "xyz")), [])
        count += len(here) == 2
        for k, name in enumerate(FIELDS if here else ()):
            size = max(abs(value) for begin in here
                       for value in arrays[name][begin // 36 * 36:begin // 36 * 36 + 36])
            unit = max(ELEMENT * size, FILE * largest[k // 6])
            worst = max(worst, abs(sum(arrays[name][p] for p in here) / len(here)
                                   - float(row[name])) / unit)
    check(count == 9 * len(middles) and worst < 1.,
          f"{count} points of {path.name}, to {worst:.2f} of what is rounded")


def key(place):
    return tuple(round(x, 5) for x in place)


def main():
    if len(sys.argv) != 4:
        sys.exit("Usage: check_vtu.py LAMELLA SCENE.prm WORKDIR")
    output = Path(sys.argv[3])
    subprocess.run([sys.argv[1], sys.argv[2], "--output", output], check=True,
                   stdout=subprocess.DEVNULL)
    collection = ElementTree.parse(output / "solution.pvd")
    names = [entry.get("file") for entry in collection.iter("DataSet")]
    check(len(names) == 1, "solution.pvd names one file")
    piece, found = read(output / names[0])
    n_points = int(piece.get("NumberOfPoints"))
    n_cells = int(piece.get("NumberOfCells"))
    arrays = {name: values for name, (values, _) in found.items()}

    check(len(arrays["offsets"]) == n_cells, f"{n_cells} offsets")
    check(arrays["offsets"][-1] == n_points == len(arrays["connectivity"]),
          f"connectivity of {n_points} points")
    check(set(arrays["types"]) == {72} and len(arrays["types"]) == n_cells,
          "Lagrange hexahedra")
    check(piece.find("CellData").get("HigherOrderDegrees") == "HigherOrderDegrees" and
          arrays["HigherOrderDegrees"] == (2, 3, 2) * n_cells,
          "of LE-2 across the section and B4 along the axis")
    check(n_points == 3 * 4 * 3 * n_cells, "that many points")
    check(sorted(arrays["connectivity"]) == list(range(n_points)),
          "every point belongs to one cell")
    for parts, names, count in (("Points", {"points"}, n_points),
                                ("PointData", {"displacement", *FIELDS}, n_points),
                                ("CellData", {"ply", "body", "fiber",
                                              "HigherOrderDegrees"}, n_cells)):
        check({array.get("Name") for array in piece.find(parts)} == names, parts)
        check(all(len(values) == n * count for values, n in map(found.get, names)),
              f"all of {parts}")

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
    check_cut(output / "cuts/upper_cut.csv", arrays, undeformed)
    summary = json.loads((output / "summary.json").read_text())
    for name, contact in summary["contacts"].items():
        check_contact(output, name, contact)


if __name__ == "__main__":
    main()
