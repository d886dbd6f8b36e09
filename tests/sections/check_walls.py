#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Walls of one layup, [45/-45] all round, as beams and as solids.

Usage: check_walls.py LAMELLA WORKDIR [tube | box]

A tube and a box are clamped at one end; on the other end they are pulled, twisted,
bent about x and about z, and sheared. Far from both ends a constant force changes
nothing along the axis but a rigid motion, so two sections of the solid (solid-2) tell
by their displacements what a length of the beam does:

- extension, twist and curvatures of the solid against the compliance that is written
  for the section (sections/NAME.json): 1 %, of the largest of their kind;
- stresses in ply axes in the middle of each ply and displacements, of LE-3 and SV-6
  against the solid: 1 % of the largest; of SV-6 against LE-3 likewise.
"""

import csv
import json
import os
import subprocess
import sys
from pathlib import Path

# A box that is twisted by its ends changes its shape far into the beam.
LENGTH, STATIONS = 400., (190., 210.)
RADIUS, THICKNESS = 10., 1.
# Forces per area about the middle of the section, and the section force each makes.
CASES = {"pulled": ("0, 1, 0", 1), "twisted": ("0.1*z, 0, -0.1*x", 4),
         "bent": ("0, -0.1*z, 0", 3), "swayed": ("0, 0.1*x, 0", 5),
         "sheared": ("0, 0, 0.02", None)}
SHAPES = {
    "tube": {"entries": f"Shape = tube\nWidth = {2 * RADIUS}\nHeight = {2 * RADIUS}",
             "half": (RADIUS, RADIUS), "beam": "Cells around = 16",
             "solid": "Cells around = 32"},
    "box": {"entries": f"Shape = box\nWidth = {2 * RADIUS}\nHeight = {1.5 * RADIUS}",
            "half": (RADIUS, 0.75 * RADIUS), "beam": "Cells along wall = 4",
            "solid": "Cells along wall = 8"}}
# The compliance's strains, in the order of its forces.
STRAINS = {1: "extension", 3: "curvature about x", 4: "twist", 5: "curvature about z"}
STRESSES = ("s11", "s22", "s12")


def block(kind, name, entries, inside=""):
    lines = "".join(f"  set {entry}\n" for entry in entries.splitlines())
    return f"subsection {kind} {name}\n{lines}{inside}end\n"


def probe_places(half):
    """The middle of each ply in the middle of each wall: inner, outer."""
    for name, (i, j) in {"right": (1, 0), "left": (-1, 0), "top": (0, 1),
                         "bottom": (0, -1)}.items():
        for ply, depth in (("inner", 0.75), ("outer", 0.25)):
            yield (f"{name}_{ply}", i * (half[0] - depth * THICKNESS),
                   j * (half[1] - depth * THICKNESS))


def scene(shape, theory):
    about = SHAPES[shape]
    half = about["half"]
    cells = about["solid" if theory.startswith("solid") else "beam"]
    axis = "Axis breaks = 20, 100, 300, 380\nAxis elements = " + (
        "3, 5, 4, 5, 3" if theory.startswith("solid") else "2, 3, 2, 3, 2")
    kinematics = "  subsection Kinematics\n" + "".join(
        f"    set {entry}\n" for entry in axis.splitlines()) + "  end\n"
    probes = [(f"{case}_{name}", f"At = {case}: {x}, {0.5 * LENGTH}, {z}\nStress = recovered")
              for case in CASES for name, x, z in probe_places(half)]
    cuts = [(f"{case}_{k}", f"At = {case}: {y}\nSamples = 2")
            for case in CASES for k, y in enumerate(STATIONS)]
    head = f"""set Units = mm, N
set Theory = {theory}
set Materials = carbon
set Sections = wall
set Bodies = {", ".join(CASES)}
set Supports = clamp
set Loads = {", ".join(CASES)}
set Probes = {", ".join(name for name, _ in probes)}
set Cuts = {", ".join(name for name, _ in cuts)}
set Write VTU = false
"""
    text = [head, block("Material", "carbon", "Library = IM7-8552"),
            block("Section", "wall", about["entries"] + f"""
Wall thickness = {THICKNESS}
Wall layup = 45/-45
""" + cells)]
    for case, (force, _) in CASES.items():
        text.append(block("Body", case, f"Section = wall\nOrigin = {-half[0]}, 0, "
                          f"{-half[1]}\nLength = {LENGTH}", kinematics))
        text.append(block("Load", case, f"On = {case}: end\nForce = {force}"))
    text.append(block("Support", "clamp",
                      "On = " + "; ".join(f"{case}: start" for case in CASES)))
    text += [block("Probe", *probe) for probe in probes]
    text += [block("Cut", *cut) for cut in cuts]
    return "".join(text)


class Run:
    def __init__(self, program, workdir, shape, theory):
        self.folder = workdir / f"{shape}_{theory}"
        self.folder.mkdir(parents=True, exist_ok=True)
        file = self.folder / "scene.prm"
        file.write_text(scene(shape, theory))
        one = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}
        done = subprocess.run([program, str(file), "--output", str(self.folder)],
                              capture_output=True, text=True, env={**one, **os.environ})
        if done.returncode:
            sys.exit(f"{shape}, {theory}: exit status {done.returncode}\n{done.stderr}")
        self.summary = json.loads((self.folder / "summary.json").read_text())

    def table(self, name):
        with (self.folder / name).open(newline="") as file:
            return list(csv.DictReader(file))

    def probes(self, columns):
        return {(row["probe"], column): float(row[column])
                for row in self.table("probes.csv") for column in columns}

    def compliance(self):
        return json.loads((self.folder / "sections/wall.json").read_text())["compliance"]


def rates(run, case):
    """Extension, curvatures and twist between the two stations, least squares over
    their points: u_y = e - z a_x + x a_z, u_x = b + z a_y, u_z = c - x a_y."""
    first, second = (run.table(f"cuts/{case}_{k}.csv") for k in (0, 1))
    points = [(float(p["x"]), float(p["z"])) for p in first]
    moved = [[float(q[c]) - float(p[c]) for c in ("ux", "uy", "uz")]
             for p, q in zip(first, second)]
    n = len(points)
    mean = [sum(p[d] for p in points) / n for d in (0, 1)]
    u = [sum(m[c] for m in moved) / n for c in range(3)]
    xx = sum((x - mean[0])**2 for x, _ in points)
    zz = sum((z - mean[1])**2 for _, z in points)
    about_x = -sum((z - mean[1]) * m[1] for (_, z), m in zip(points, moved)) / zz
    about_z = sum((x - mean[0]) * m[1] for (x, _), m in zip(points, moved)) / xx
    twist = sum((z - mean[1]) * m[0] - (x - mean[0]) * m[2]
                for (x, z), m in zip(points, moved)) / (xx + zz)
    length = STATIONS[1] - STATIONS[0]
    return {1: u[1] / length, 3: about_x / length, 4: twist / length,
            5: about_z / length}


def section_force(run, case):
    """What the load of this case makes of each section: a number of the compliance."""
    load = run.summary["loads"][case]
    place = CASES[case][1]
    return load["force"][place] if place < 3 else load["moment"][place - 3]


def compare(found, wanted, what, limit, faults):
    largest = max(abs(value) for value in wanted.values())
    worst = max(wanted, key=lambda key: abs(found[key] - wanted[key]))
    off = abs(found[worst] - wanted[worst]) / largest
    print(f"  {what}: off by {100 * off:.3f} % at most ({worst})")
    if not off < limit:
        faults.append(f"{what}: {off}")


def check_stiffness(solid, faults):
    """Each kind of strain over the root of the compliances of what goes with what."""
    compliance = solid.compliance()
    for case, (_, cause) in CASES.items():
        if cause is None:
            continue
        force, found = section_force(solid, case), rates(solid, case)
        for strain, name in STRAINS.items():
            scale = (compliance[strain][strain] * compliance[cause][cause])**0.5
            off = abs(found[strain] / force - compliance[strain][cause]) / scale
            print(f"  {case}, {name}: {found[strain] / force:.6g}, compliance "
                  f"{compliance[strain][cause]:.6g}, off by {100 * off:.3f} %")
            if not off < 0.01:
                faults.append(f"{case}, {name}: {off}")


def check_fields(found, wanted, what, faults):
    for case in CASES:
        for kind, columns in (("displacements", ("ux", "uy", "uz")),
                              ("stresses", STRESSES)):
            mine, other = ({key: value for key, value in run.probes(columns).items()
                            if key[0].startswith(case)} for run in (found, wanted))
            compare(mine, other, f"{what}, {case}, {kind}", 0.01, faults)


def told(run):
    return f"{run.summary['dofs']} DoFs, {run.summary['seconds']['total']:.2f} s"


def main():
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__.split("\n\n")[1])
    program, workdir = sys.argv[1], Path(sys.argv[2])
    faults = []
    for shape in sys.argv[3:] or SHAPES:
        solid, layers, fields = (Run(program, workdir, shape, theory)
                                 for theory in ("solid-2", "LE-3", "SV-6"))
        print(f"{shape}: solid-2 {told(solid)}; LE-3 {told(layers)}; SV-6 {told(fields)}")
        check_stiffness(solid, faults)
        check_fields(layers, solid, "LE-3 and solid-2", faults)
        check_fields(fields, solid, "SV-6 and solid-2", faults)
        check_fields(fields, layers, "SV-6 and LE-3", faults)
    if faults:
        sys.exit("\n".join(["Off:", *faults]))


if __name__ == "__main__":
    main()
