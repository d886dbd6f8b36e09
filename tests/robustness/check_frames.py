#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A path with friction in other frames and in other units.

Usage: check_frames.py LAMELLA WORKDIR

Two cantilevers are pressed on each other, their ends pushed askew, to and fro, so that
points of the face between them stick, slip along curves and turn round. The scene is
run as it stands, turned as a whole (about an axis that is none of the scene's), and
with other units of length and stress. Turned and scaled back, displacements, gaps, forces,
shears and what is dissipated are the same to 1e-9 of the largest of their kind in
every load step, and every point is in the same state. Nothing but numbers: results do
not depend on the tangents that shears are resolved along, nor on how large numbers are.
"""

import csv
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

TOLERANCE = 1e-9
# Columns are the body axes x, y, z in the scene: rational, so that a frame is exact.
PLAIN = ((1., 0., 0.), (0., 1., 0.), (0., 0., 1.))
TURNED = ((-0.64, 0.6, -0.48), (0.48, 0.8, 0.36), (0.6, 0., -0.8))
SCENE = """
set Title        = To and fro
set Theory       = LE-2
set Units        = none
set Write VTU    = false
set Materials    = solid
set Sections     = leaf
set Bodies       = lower, upper
set Supports     = clamp
set Loads        = down, up, push
set Contacts     = face
set Probes       = tip, middle
set Load factors = 1, 1, 1, 1
set Substeps     = 2
subsection Material solid
  set Isotropic = {E}, 0.3
end
subsection Section leaf
  set Width         = {width}
  set Layup         = 0
  set Ply thickness = {thickness}
  set Ply materials = solid
  set Cells across  = 2
end
subsection Body lower
  set Section = leaf
  set Length  = {length}
  set Axis    = {axis}
  set Up      = {up_axis}
  subsection Kinematics
    set Axis elements = 5
  end
end
subsection Body upper
  set Section = leaf
  set Origin  = {origin}
  set Length  = {length}
  set Axis    = {axis}
  set Up      = {up_axis}
  subsection Kinematics
    set Axis elements = 4
  end
end
subsection Support clamp
  set On = lower: start; upper: start
end
subsection Load down
  set On    = upper: top
  set Force = {down}
end
subsection Load up
  set On    = lower: bottom
  set Force = {up}
end
subsection Load push
  set On          = upper: end
  set Total force = {push}
  set Factors     = 0, 1, -1, 0.4
end
subsection Contact face
  set First          = lower: top
  set Second         = upper: bottom
  set Discretization = {discretization}
  set Enforcement    = exact
  set Friction       = 0.3
end
subsection Probe tip
  set At = upper: {tip}
end
subsection Probe middle
  set At = lower: {middle}
end
"""


class Frame:
    """Turned by the body axes @p axes, lengths times @p length, stresses times @p stress."""

    def __init__(self, axes, length, stress):
        self.axes, self.length, self.stress = axes, length, stress
        self.units = {"length": length, "force": stress * length ** 2,
                      "traction": stress, "energy": stress * length ** 3,
                      "energy per area": stress * length}

    def of(self, vector, unit):
        return ", ".join(repr(self.units[unit] * sum(v * axis[c] for v, axis in
                                                     zip(vector, self.axes)))
                         for c in range(3))

    def back(self, vector, unit):
        return [sum(v * a for v, a in zip(vector, axis)) / self.units[unit]
                for axis in self.axes]

    def scene(self, discretization):
        return SCENE.format(
            E=repr(1000. * self.stress), width=repr(2. * self.length),
            thickness=repr(self.length), length=repr(6. * self.length),
            axis=", ".join(map(repr, self.axes[1])),
            up_axis=", ".join(map(repr, self.axes[2])),
            origin=self.of((0., 0., 1.), "length"),
            down=self.of((0., 0., -0.5), "traction"),
            up=self.of((0., 0., 0.5), "traction"),
            push=self.of((1.5, 1.2, 0.3), "force"), discretization=discretization,
            tip=self.of((1., 6., 2.), "length"), middle=self.of((1., 3., 0.5), "length"))


def results(program, frame, discretization, folder):
    """Of each kind its numbers, over all load steps and in the frame of the plain scene,
    and the states of all points."""
    folder.mkdir(parents=True)
    (folder / "scene.prm").write_text(frame.scene(discretization))
    done = subprocess.run([program, str(folder / "scene.prm"), "--output",
                           str(folder / "out")], capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"FAIL  {folder.name}: {done.stderr}")
    numbers, states = {}, []

    def add(kind, row, columns, unit):
        values = [float(row[column]) for column in columns]
        numbers.setdefault(kind, []).extend(
            frame.back(values, unit) if len(values) == 3 else
            [values[0] / frame.units[unit]])

    for row in csv.DictReader((folder / "out/probes.csv").open()):
        add("displacements", row, ("ux", "uy", "uz"), "length")
    for row in csv.DictReader((folder / "out/contact_face.csv").open()):
        states.append(row["state"])
        add("gaps", row, ("gap",), "length")
        add("forces", row, ("force",), "force")
        add("shears", row, ("shear_x", "shear_y", "shear_z"), "force")
        add("slips", row, ("slid",), "length")
        add("dissipated", row, ("dissipated",), "energy per area")
    path = json.loads((folder / "out/summary.json").read_text())["path"]
    add("path gap", path, ("gap",), "energy")
    return numbers, states


def main():
    program, work = str(Path(sys.argv[1]).resolve()), Path(sys.argv[2])
    shutil.rmtree(work, ignore_errors=True)
    os.environ.update(OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1")
    failed = False
    for discretization in ("surface to surface", "node to surface"):
        name = discretization.replace(" ", "_")
        plain, states = results(program, Frame(PLAIN, 1., 1.), discretization,
                                work / name)
        if {"stick", "slip"} - set(states):
            sys.exit(f"FAIL  the path has nothing of {set(states)}")
        for word, frame in (("turned", Frame(TURNED, 1., 1.)),
                            ("scaled", Frame(PLAIN, 1e-3, 1e6)),
                            ("both", Frame(TURNED, 25.4, 145.))):
            other, there = results(program, frame, discretization, work / f"{name}_{word}")
            off = {kind: max(abs(a - b) for a, b in zip(plain[kind], other[kind])) /
                   max(map(abs, plain[kind])) for kind in plain}
            same = states == there and all(share <= TOLERANCE for share in off.values())
            failed = failed or not same
            print(("ok    " if same else "FAIL  ") + f"{name} {word}: " + ", ".join(
                f"{kind} {share:.1e}" for kind, share in off.items()) +
                f", {sum(a != b for a, b in zip(states, there))} states of {len(states)}")
    sys.exit(failed)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("Usage: check_frames.py LAMELLA WORKDIR")
    main()
