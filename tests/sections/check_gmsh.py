#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes the shipped .geo files anew and compares what the program says of them.

Usage: check_gmsh.py LAMELLA SCENE WORKDIR

SCENE has a section of Shape = file for each .geo file beside it, of the same
name. Each file is meshed in format 4.1, and in 2.2 and then converted by the command
that the program's message about 2.2 names; the area must be that of the shipped .msh
(a tenth of a per cent: another Gmsh places the nodes of unstructured meshes otherwise),
boundaries and parts the same. Without gmsh the test is skipped (status 77).
"""

import re
import shutil
import subprocess
import sys
from pathlib import Path


def validate(program, scene, *arguments):
    done = subprocess.run([program, scene, "--validate", *arguments],
                          capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"exit status {done.returncode}: {done.stderr}")
    return done.stdout


def section(text, name):
    """(area, names of boundaries, materials of parts) as printed."""
    found = re.search(rf"^Section {name}: file.*?\n\n", text, re.M | re.S)
    if not found:
        sys.exit(f"nothing is printed of section {name}")
    return (float(re.search(r"area ([\d.e+-]+), centroid", found[0])[1]),
            re.findall(r"(\S+) \(length", found[0]),
            re.findall(r"part \d+: (\S+), (\S+) deg", found[0]))


def main():
    if len(sys.argv) != 4:
        sys.exit("Usage: check_gmsh.py LAMELLA SCENE WORKDIR")
    if not shutil.which("gmsh"):
        print("gmsh is not here: skipped")
        sys.exit(77)
    program, scene, workdir = sys.argv[1:]
    Path(workdir).mkdir(parents=True, exist_ok=True)
    shipped = validate(program, scene)
    faults, files = [], sorted(Path(scene).parent.glob("*.geo"))
    for geo in files:
        for version in ("msh41", "msh22"):
            mesh = Path(workdir).resolve() / f"{geo.stem}_{version}.msh"
            subprocess.run(["gmsh", "-2", str(geo), "-format", version, "-o", str(mesh)],
                           check=True, capture_output=True)
            if version == "msh22":
                subprocess.run(["gmsh", mesh, "-save", "-format", "msh41", "-o", mesh],
                               check=True, capture_output=True)
            text = validate(program, scene, "--set", f"Section {geo.stem}/File={mesh}")
            new, old = section(text, geo.stem), section(shipped, geo.stem)
            print(geo.stem, version, *new)
            if abs(new[0] - old[0]) > 1e-3 * old[0] or new[1:] != old[1:]:
                faults.append(f"{geo.stem} {version}: {new} instead of {old}")
    if not files:
        faults.append("no .geo file beside the scene")
    print("\n".join(faults))
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
