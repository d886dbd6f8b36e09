#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs scenes in other units, mirrored, turned, in another order, on more threads and
processes and in more load steps, and compares the results with those of the scenes as
they are.

Usage: invariance.py LAMELLA WORKDIR [NAMES...] [--quick] [--only mm,skew] [--jobs 2]
       [--tolerance 1e-8]

NAMES are scenes (by default all but those of CUT). Every scene is a
function here that writes its text for a Transformation; results are transformed back:
fields at the probes, reactions, contact forces, strain energy. A difference is taken over the largest value of its kind
(displacements, stresses, ...) in the original scene. --quick leaves out some scenes and
transformations. Each run stays in WORKDIR/SCENE/TRANSFORMATION.

Exit status 1 if a run fails or a difference is above the tolerance.
"""

import argparse
import concurrent.futures
import csv
import json
import math
import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
IDENTITY = ((1., 0., 0.), (0., 1., 0.), (0., 0., 1.))
MIRROR = ((-1., 0., 0.), (0., 1., 0.), (0., 0., 1.))
ABOUT_Z = ((.8, -.6, 0.), (.6, .8, 0.), (0., 0., 1.))
QUARTER = ((0., -1., 0.), (1., 0., 0.), (0., 0., 1.))
SKEW = ((2 / 3, -1 / 3, 2 / 3), (2 / 3, 2 / 3, -1 / 3), (-1 / 3, 2 / 3, 2 / 3))


def apply(matrix, v):
    return [sum(matrix[i][j] * v[j] for j in range(3)) for i in range(3)]


def transposed(matrix):
    return [[matrix[j][i] for j in range(3)] for i in range(3)]


def product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def text(*values):
    """Numbers as they are read back, without a difference."""
    return ", ".join(repr(float(value)) for value in values)


class Transformation:
    """x' = length * matrix * x, forces times force; and what else is done otherwise."""

    def __init__(self, length=1., force=1., matrix=IDENTITY, reverse=False, options=(),
                 processes=1, factors="1"):
        self.length, self.force, self.matrix = length, force, matrix
        self.reverse, self.options = reverse, list(options)
        self.processes, self.factors = processes, factors
        columns = transposed(matrix)
        self.mirrors = sum(a * b for a, b in zip(cross(columns[0], columns[1]), columns[2])) < 0.

    # -- what a scene says, in its new words

    def point(self, *x):
        return text(*(self.length * c for c in apply(self.matrix, x)))

    displacement = point

    def direction(self, *d):
        return text(*apply(self.matrix, d))

    def lengths(self, *values):
        return text(*(self.length * v for v in values))

    def stresses(self, *values):
        return text(*(self.force / self.length**2 * v for v in values))

    def isotropic(self, modulus, nu):
        return f"{self.stresses(modulus)}, {nu}"

    def orthotropic(self, moduli, nus):
        return f"{self.stresses(*moduli)}, {text(*nus)}"

    def penalty(self, value):
        """Per area."""
        return text(self.force / self.length**3 * value)

    def angle(self, value):
        """A mirror turns fibers the other way."""
        return -value if self.mirrors else value

    def layup(self, *angles):
        return "/".join(str(self.angle(a)) for a in angles)

    def sides(self, values):
        """Of left and right: a mirror swaps them."""
        return list(reversed(values)) if self.mirrors else list(values)

    def side(self, name):
        swapped = {"left": "right", "right": "left"}
        return swapped.get(name, name) if self.mirrors else name

    def expression(self, formula):
        """A formula of {x}, {y}, {z} of the original, in the coordinates of the new scene."""
        back = transposed(self.matrix)
        parts = {name: "(" + "+".join(f"({row[k]!r})*{c}" for k, c in enumerate("xyz"))
                 + f")/({self.length!r})" for name, row in zip("xyz", back)}
        return formula.format(**{name: f"({part})" for name, part in parts.items()})

    def pressure(self, formula):
        return f"({self.force / self.length**2!r})*({self.expression(formula)})"

    def forces(self, *formulas, per_length=0):
        """Of points; of lines or surfaces with per_length = 1 or 2."""
        scale = self.force / self.length**per_length
        return ", ".join("+".join(f"({scale * self.matrix[i][j]!r})*({self.expression(f)})"
                                  for j, f in enumerate(formulas)) for i in range(3))

    def names(self, *names):
        return ", ".join(reversed(names) if self.reverse else names)

    def turns_axes_into_axes(self):
        return all(abs(c) in (0., 1.) for row in self.matrix for c in row)


class Writer:
    """The text of a scene for a transformation."""

    def __init__(self, transformation, theory):
        self.t, self.theory = transformation, theory
        self.lists, self.parts, self.widths, self.files = {}, [], {}, {}
        self.swapped, self.top = [], []

    def add(self, kind, name, entries, inner=()):
        plural = "Bodies" if kind == "Body" else kind + "s"
        self.lists.setdefault(plural, []).append(name)
        lines = [f"subsection {kind} {name}"]
        lines += [f"  set {key} = {value}" for key, value in entries.items()]
        if inner:
            lines += ["  subsection Kinematics"]
            lines += [f"    set {key} = {value}" for key, value in inner.items()]
            lines += ["  end"]
        self.parts.append("\n".join([*lines, "end"]))

    def section(self, name, width, entries):
        """A mirrored section lies within the same width; None: about its origin."""
        self.widths[name] = width
        self.add("Section", name, entries)

    def laminate(self, name, width, angles, thickness, materials, **more):
        entries = {"Width": self.t.lengths(width), "Layup": self.t.layup(*angles),
                   "Ply thickness": self.t.lengths(*thickness), "Ply materials": materials}
        entries.update({key.replace("_", " "): value for key, value in more.items()})
        self.section(name, width, entries)

    def body(self, name, section, length, origin=(0., 0., 0.), axis=(0., 1., 0.),
             up=(0., 0., 1.), more=None, **kinematics):
        width = self.widths[section]
        if self.t.mirrors and width is not None:
            # The section's x points the other way, so its corner is the other one.
            across = cross(axis, up)
            origin = [o + width * a for o, a in zip(origin, across)]
        self.add("Body", name, {
            "Section": section, "Length": self.t.lengths(length),
            "Origin": self.t.point(*origin), "Axis": self.t.direction(*axis),
            "Up": self.t.direction(*up), **(more or {})},
            {key.replace("_", " "): value for key, value in kinematics.items()})

    def support(self, name, on, u=(0., 0., 0.), at=()):
        entries = {"On": on, "u": self.t.displacement(*u)}
        if at:
            entries["At"] = "; ".join(self.t.point(*x) for x in at)
        self.add("Support", name, entries)

    def wall(self, name, on):
        self.add("Support", name, {"On": on, "Normal displacement": "0"})

    def contact(self, name, first, second, symmetric=True, points=None, **more):
        if symmetric and self.t.reverse:
            first, second = second, first
            points = {"first": "second", "second": "first"}.get(points, points)
            self.swapped.append(name)
        entries = {"First": first, "Second": second}
        if points:
            entries["Slave side"] = points
        entries.update({key.replace("_", " "): value for key, value in more.items()})
        self.add("Contact", name, entries)

    def probe(self, name, body, *x):
        self.add("Probe", name, {"At": f"{body}: {self.t.point(*x)}"})

    def text(self):
        lines = [f"set Theory = {self.theory}", "set Units = none", "set Write VTU = false",
                 f"set Load factors = {self.t.factors}", "set Rotation limit = 100",
                 "set Beyond linear range = accept", *self.top]
        lines += [f"set {kind} = {self.t.names(*names)}" for kind, names in self.lists.items()]
        parts = reversed(self.parts) if self.t.reverse else self.parts
        return "\n".join([*lines, *parts]) + "\n"


# ---- the scenes

SCENES = {}
QUICK = ("cantilever", "beams", "crossed", "floor", "meshed", "solids")
# Responses are cut by a tolerance of per cents: where the section is rounded otherwise (in
# inches, in a mirror) a field more or less, or 1e-6 of another answer. Not in `all`.
CUT = ("fields",)
CARBON = ((161e9, 11.38e9, 11.38e9, 5.17e9, 5.17e9, 3.98e9), (0.32, 0.32, 0.44))


def scene(function):
    SCENES[function.__name__] = function
    return function


@scene
def cantilever(t):
    """Angle plies, a pressure that varies, an end pulled aside."""
    w = Writer(t, "LE-2")
    w.add("Material", "carbon", {"Engineering constants": t.orthotropic(*CARBON)})
    w.laminate("strip", 0.1, (30, -45, 90), (0.01, 0.02, 0.01), "carbon",
               Across_breaks=t.lengths(*([0.06] if t.mirrors else [0.04])),
               Cells_across=", ".join(t.sides("12")))
    w.body("beam", "strip", 1., (0.3, -0.2, 0.1), Axis_elements="3")
    w.support("clamp", "beam: start")
    w.add("Load", "wind", {"On": "beam: top", "Pressure": t.pressure("1e4*sin(pi*{y})*(1+{x})")})
    w.add("Load", "pull", {"On": "beam: end",
                           "Force": t.forces("1e5", "2e5*{z}", "-3e5*{x}", per_length=2)})
    w.probe("tip", "beam", 0.35, 0.8, 0.12)
    w.probe("middle", "beam", 0.32, 0.25, 0.11)  # on an interface
    w.probe("edge", "beam", 0.3, 0.1, 0.14)
    return w


@scene
def beams(t):
    """Two laminated beams, node to node, penalty."""
    w = Writer(t, "LE-2")
    w.add("Material", "carbon", {"Engineering constants": t.orthotropic(*CARBON)})
    w.laminate("strip", 0.1, (30, 90, 0), (0.002,), "carbon", Cells_across="2")
    w.body("upper", "strip", 2., (0., 0., 0.007), Axis_elements="4")
    w.body("lower", "strip", 2., Axis_elements="4")
    w.support("clamps", "upper: ends; lower: ends")
    w.support("press", "upper: line", (0., 0., -0.03), ((0., 1., 0.013), (0.1, 1., 0.013)))
    w.contact("middle", "upper: bottom", "lower: top", Penalty=t.penalty(1e12))
    w.probe("above", "upper", 0.03, 0.7, 0.013)
    w.probe("below", "lower", 0.1, 0.6, 0.004)
    return w


@scene
def classical(t):
    """EBBT on TBT, node to surface."""
    w = Writer(t, "EBBT")
    w.add("Material", "steel", {"Isotropic": t.isotropic(2e11, 0.3)})
    w.laminate("bar", 0.1, (0,), (0.02,), "steel")
    w.body("upper", "bar", 2., (0., 0., 0.021), Axis_elements="4")
    w.body("lower", "bar", 2.4, (0., -0.2, 0.), Axis_elements="5", Theory="TBT")
    w.support("clamps", "upper: ends; lower: ends")
    w.add("Load", "weight", {"On": "upper: top", "Force": t.forces(
        "0", "0", "-4e3*{y}", per_length=2)})
    w.contact("middle", "upper: bottom", "lower: top", points="first",
              Discretization="node to surface", Enforcement="augmented lagrangian")
    w.probe("above", "upper", 0.03, 0.7, 0.041)
    w.probe("below", "lower", 0.1, 1.1, 0.02)
    return w


@scene
def crossed(t):
    """Beams that cross, no cell on a cell, surface to surface, exact."""
    w = Writer(t, "LE-2")
    w.add("Material", "soft", {"Isotropic": t.isotropic(1000., 0.25)})
    w.laminate("above", 0.3, (0,), (0.2,), "soft", Cells_across="2")
    w.laminate("below", 0.5, (0,), (0.4,), "soft", Cells_across="3")
    w.body("upper", "above", 4., (-1.75, 3.15, 0.4), (1., 0., 0.),
           Axis_breaks=t.lengths(1.5, 2.5), Axis_elements="1, 2, 1")
    w.body("lower", "below", 6., Axis_breaks=t.lengths(2.5, 3.5), Axis_elements="1, 3, 1")
    w.support("press", "upper: ends", (0., 0., -0.05))
    w.support("clamps", "lower: ends")
    w.contact("cross", "upper: bottom", "lower: top", points="first",
              Discretization="surface to surface", Enforcement="exact")
    w.probe("above", "upper", 0.3, 3.1, 0.6)
    w.probe("below", "lower", 0.2, 2.7, 0.)
    return w


@scene
def hertz(t):
    """Two half cylinders, pressed on each other a little aside."""
    w = Writer(t, "LE-2")
    w.add("Material", "solid", {"Isotropic": t.isotropic(200., 0.3)})
    w.section("half", 16., {"Shape": "half disc", "Radius": t.lengths(8.),
                            "Finest cell": t.lengths(1.)})
    w.body("upper", "half", 1., (16., 0., 16.), up=(0., 0., -1.), Axis_elements="1")
    w.body("lower", "half", 1., Axis_elements="1")
    w.support("press", "upper: flat", (0.001, 0., -0.05))
    w.support("floor", "lower: flat")
    w.contact("nip", "upper: arc", "lower: arc", points="second",
              Discretization="surface to surface", Enforcement="exact",
              Search_distance=t.lengths(0.3))
    w.probe("below", "lower", 8., 0.5, 7.)
    w.probe("aside", "upper", 9., 0.3, 10.)
    return w


@scene
def roller(t):
    """A sandwich under a rigid roller across it."""
    w = Writer(t, "LE-2")
    w.add("Material", "face", {"Engineering constants": t.orthotropic(
        (24e3, 8e3, 8e3, 3e3, 3e3, 2.8e3), (0.25, 0.25, 0.4))})
    w.add("Material", "foam", {"Isotropic": t.isotropic(35., 0.3)})
    w.laminate("sandwich", 50., (20, 0, -70), (2., 30., 2.), "face, foam, face",
               Cells_per_ply="1, 2, 1", Cells_across="1")
    w.body("beam", "sandwich", 500., Axis_breaks=t.lengths(230., 270.), Axis_elements="2, 4, 2")
    w.add("Obstacle", "roller", {
        "Shape": "cylinder", "Through": t.point(0., 251., 44.), "Radius": t.lengths(10.),
        "Axis": t.direction(1., 0.1, 0.), "u": t.displacement(0., 0., -4.)})
    w.support("clamps", "beam: ends")
    w.contact("indentation", "beam: top", "roller", symmetric=False,
              Discretization="surface to surface", Enforcement="exact",
              Search_distance=t.lengths(5.))
    w.probe("below", "beam", 20., 240., 20.)
    w.probe("interface", "beam", 0., 125., 32.)
    return w


def fields_writer(t):
    """A laminate that bends and twists, under a patch beside its middle."""
    w = Writer(t, "SV-4")
    w.add("Material", "carbon", {"Engineering constants": t.orthotropic(*CARBON)})
    w.laminate("strip", 0.1, (30, -45, 90), (0.01, 0.02, 0.01), "carbon", Cells_across="3")
    w.add("Load", "patch", {"On": "beam: top", "Pressure": t.pressure(
        "if(({y}>0.4)&&({y}<0.5)&&({x}>0.35),1e5,0)")})
    w.probe("below", "beam", 0.37, 0.25, 0.11)
    w.probe("aside", "beam", 0.31, 0.6, 0.13)
    return w


@scene
def fields(t):
    """Fields of the section's own, a roller on them."""
    w = fields_writer(t)
    w.body("beam", "strip", 2., (0.3, -0.2, 0.1), Axis_elements="20", Section_order="2")
    w.support("clamps", "beam: ends")
    w.add("Obstacle", "roller", {
        "Shape": "cylinder", "Through": t.point(0.35, 1., 0.24), "Radius": t.lengths(0.1),
        "Axis": t.direction(1., 0., 0.), "u": t.displacement(0., 0., -0.002)})
    w.contact("nip", "beam: top", "roller", symmetric=False,
              Discretization="surface to surface", Enforcement="exact",
              Search_distance=t.lengths(0.02))
    return w


@scene
def lists(t):
    """Theories by hand: nodes with all fields beside nodes with few."""
    w = fields_writer(t)
    w.body("beam", "strip", 2., (0.3, -0.2, 0.1), Axis_elements="20", Section_order="auto",
           Theories="LE-2, SV-4, SV", Theory_breaks=t.lengths(0.2, 1.2))
    w.support("clamp", "beam: start")
    return w


@scene
def floor(t):
    """Blocks between walls on a floor that rises; the lower one is held by contact alone."""
    w = Writer(t, "LE-2")
    w.add("Material", "m", {"Isotropic": t.isotropic(200., 0.3)})
    w.laminate("above", 2., (0,), (0.7,), "m", Cells_across="3")
    w.laminate("below", 2., (0,), (0.5,), "m", Cells_across="2")
    w.body("upper", "above", 3., (0., 0., 0.51), Axis_elements="2")
    w.body("lower", "below", 3., more={"Stabilization": "1e-6"}, Axis_elements="3")
    w.wall("walls", "; ".join(f"upper: {t.side(n)}" for n in ("left", "start", "top"))
           + "; " + "; ".join(f"lower: {t.side(n)}" for n in ("left", "start")))
    w.add("Obstacle", "floor", {
        "Shape": "plane", "Through": t.point(9., 9., -0.01), "Normal": t.direction(0., 0., 1.),
        "u": t.displacement(0., 0., 0.05)})
    w.contact("faces", "upper: bottom", "lower: top", points="first",
              Discretization="surface to surface", Penalty=t.penalty(900.))
    w.contact("ground", "lower: bottom", "floor", symmetric=False,
              Discretization="surface to surface", Penalty=t.penalty(900.))
    w.probe("above", "upper", 1.3, 1.1, 0.7)
    w.probe("below", "lower", 0.4, 2.9, 0.1)
    return w


@scene
def box(t):
    """A box of unequal walls, twisted by tractions on its end."""
    w = Writer(t, "TE-4")
    w.add("Material", "carbon", {"Engineering constants": t.orthotropic(*CARBON)})
    left, right = t.sides((0.002, 0.004))
    w.section("box", 0.03, {"Shape": "box", "Width": t.lengths(0.03), "Height": t.lengths(0.02),
                            "Wall thickness": t.lengths(left, right, 0.003, 0.002),
                            "Fiber angle": t.angle(20), "Cells along wall": "2"})
    w.body("beam", "box", 0.3, Axis_elements="3")
    w.support("clamp", "beam: start")
    w.add("Load", "torque", {"On": "beam: end", "Force": t.forces(
        "1e8*({z}-0.01)", "0", "-1e8*({x}-0.015)", per_length=2)})
    w.probe("corner", "beam", 0.03, 0.3, 0.02)
    w.probe("wall", "beam", 0.001, 0.11, 0.012)
    return w


def mirrored_mesh(lines):
    """A mesh of format 4.1 with x turned to -x in its nodes."""
    first, last = lines.index("$Nodes") + 1, lines.index("$EndNodes")
    result = list(lines)
    for i in range(first + 1, last):
        words = lines[i].split()
        if len(words) == 3:
            result[i] = " ".join([repr(-float(words[0])), *words[1:]])
    return result


@scene
def meshed(t):
    """A section by Gmsh: skins at 45 degrees about a core, open at the left."""
    w = Writer(t, "LE-1")
    w.add("Material", "carbon", {"Engineering constants": t.orthotropic(*CARBON)})
    w.add("Material", "foam", {"Isotropic": t.isotropic(35e6, 0.4)})
    w.section("sandwich", None, {
        "Shape": "file", "File": "sandwich.msh", "Scale": t.lengths(0.001),
        "Parts": f"skin: carbon {t.angle(45)} | core: foam"})
    lines = (ROOT / "prm/sections/sandwich.msh").read_text().splitlines()
    w.files["sandwich.msh"] = "\n".join(mirrored_mesh(lines) if t.mirrors else lines) + "\n"
    w.body("beam", "sandwich", 0.3, (0.01, 0.02, 0.03), Axis_elements="2")
    w.support("clamp", "beam: start")
    # Names of a mesh are its own: nothing swaps them.
    w.add("Load", "press", {"On": "beam: left", "Pressure": t.pressure("1e4*{y}")})
    w.add("Load", "tip", {"On": "beam: point", "At": t.point(0.05, 0.32, 0.042),
                          "Force": t.forces("3", "0", "-5")})
    w.probe("skin", "beam", 0.03, 0.2, 0.041)
    w.probe("interface", "beam", 0.03, 0.12, 0.032)
    w.probe("core", "beam", 0.015, 0.1, 0.034)
    return w


@scene
def solids(t):
    """Hexahedra of degree 1 on those of degree 2, refined where they meet."""
    w = Writer(t, "solid-2")
    w.add("Material", "ply", {"Engineering constants": t.orthotropic(
        (10., 4., 4., 2., 2., 1.5), (0.3, 0.3, 0.3))})
    w.laminate("above", 1., (20, -20), (0.4,), "ply", Cells_across="2")
    w.laminate("below", 1.5, (10,), (0.6,), "ply", Cells_across="2")
    w.body("upper", "above", 2., (0.2, 0., 0.61), Axis_elements="3", Theory="solid-1")
    w.body("lower", "below", 2., Axis_elements="2",
           Refine_near=f"{t.point(0.75, 1., 0.6)}: {t.lengths(0.3)}: 1")
    w.support("held", "lower: bottom")
    w.support("press", "upper: top", (0.003, 0.002, -0.05))
    w.contact("faces", "upper: bottom", "lower: top", points="second",
              Discretization="surface to surface", Enforcement="penalty",
              Penalty=t.penalty(1e3))
    w.probe("above", "upper", 0.7, 0.9, 0.8)
    w.probe("below", "lower", 0.8, 1.2, 0.5)
    return w


@scene
def disc(t):
    """A half disc, graded to one side of its arc, that is pressed there."""
    w = Writer(t, "LE-3")
    w.add("Material", "steel", {"Isotropic": t.isotropic(210000., 0.3)})
    w.section("disc", 20., {"Shape": "half disc", "Radius": t.lengths(10.),
                            "Finest cell": t.lengths(2.), "Sectors": "12",
                            "Graded towards": "120" if t.mirrors else "60"})
    w.body("roller", "disc", 40., Axis_elements="1")
    w.support("floor", "roller: flat")
    w.add("Load", "pressure", {"On": "roller: arc", "Pressure": t.pressure("2+0.1*{x}+0.02*{y}")})
    w.probe("inside", "roller", 12., 11., 5.)
    w.probe("low", "roller", 3., 37., 1.)
    return w


TRANSFORMATIONS = {
    "mm": Transformation(length=1000.),
    "inches": Transformation(length=1 / 0.0254, force=1 / 4.4482216),
    "mirror": Transformation(matrix=MIRROR),
    "quarter": Transformation(matrix=QUARTER),
    "about z": Transformation(matrix=ABOUT_Z),
    "skew": Transformation(matrix=SKEW),
    "skew mirror": Transformation(length=1000., matrix=product(SKEW, MIRROR)),
    "order": Transformation(reverse=True),
    "threads": Transformation(options=("--threads", "2")),
    "processes": Transformation(processes=2),
    "steps": Transformation(factors="0.5, 1"),
}
QUICKLY = ("mm", "mirror", "skew", "order", "processes", "steps")


# ---- runs and results

def run(program, name, label, transformation, workdir):
    """The folder of the results, and the writer of the scene."""
    folder = workdir / name / label.replace(" ", "_")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    writer = SCENES[name](transformation)
    (folder / "scene.prm").write_text(writer.text())
    for file, content in writer.files.items():
        (folder / file).write_text(content)
    environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1",
                   "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
                   "OMPI_MCA_mpi_yield_when_idle": "1"}
    launcher = ["mpirun", "--oversubscribe", "-np", str(transformation.processes)] \
        if transformation.processes > 1 else []
    done = subprocess.run(
        [*launcher, program, "scene.prm", "--output", "output", *transformation.options],
        cwd=folder, env=environment, capture_output=True, text=True)
    (folder / "log").write_text(done.stdout + done.stderr)
    if done.returncode != 0:
        raise RuntimeError(f"{name}, {label}: exit status {done.returncode}, {folder}/log:\n"
                           + done.stderr.strip()[:600])
    return folder / "output", writer


def tensor(voigt, shear=1.):
    """Of xx, yy, zz, xy, xz, yz."""
    xx, yy, zz, xy, xz, yz = voigt[:3] + [shear * v for v in voigt[3:]]
    return [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]


def turned_back(t, matrix):
    return sum(product(product(transposed(t.matrix), matrix), t.matrix), [])


def fields_of(output, t):
    """kind -> numbers of the last load step, in the words of the original."""
    with open(output / "probes.csv") as file:
        rows = list(csv.DictReader(file))
    last = max(int(row["step"]) for row in rows)
    rows = sorted((row for row in rows if int(row["step"]) == last),
                  key=lambda row: (row["probe"], int(row["ply"])))
    result = {kind: [] for kind in ("positions", "displacements", "strains", "stresses",
                                    "ply stresses")}
    back = transposed(t.matrix)
    stress = t.force / t.length**2
    # A mirror turns the second axis of the plies.
    signs = (1, 1, 1, -1, 1, -1) if t.mirrors else (1,) * 6
    for row in rows:
        def numbers(*columns):
            return [float(row[c]) for c in columns]
        result["positions"] += [c / t.length for c in apply(back, numbers("x", "y", "z"))]
        result["displacements"] += [c / t.length for c in apply(back, numbers("ux", "uy", "uz"))]
        result["strains"] += turned_back(
            t, tensor(numbers("exx", "eyy", "ezz", "gxy", "gxz", "gyz"), 0.5))
        result["stresses"] += [s / stress for s in turned_back(
            t, tensor(numbers("sxx", "syy", "szz", "sxy", "sxz", "syz")))]
        result["ply stresses"] += [sign * s / stress for sign, s in zip(
            signs, numbers("s11", "s22", "s33", "s12", "s13", "s23"))]
    return result


def results_of(output, writer):
    t = writer.t
    result = fields_of(output, t)
    summary = json.loads((output / "summary.json").read_text())
    back = transposed(t.matrix)
    forces = []
    for name in sorted(summary["supports"]):
        forces += apply(back, summary["supports"][name]["reaction"])
    for name in sorted(summary["contacts"]):
        # The force is reported as it acts on the second.
        sign = -1. if name in writer.swapped else 1.
        forces += [sign * f for f in apply(back, summary["contacts"][name]["force"])]
    result["forces"] = [f / t.force for f in forces]
    result["energy"] = [summary["energy"] / (t.force * t.length)]
    result["dofs"] = [float(summary["dofs"])]
    return result


def largest_difference(good, other):
    """Over the largest value of the kind, and of which kind."""
    worst, kind = 0., ""
    for name, values in good.items():
        if len(values) != len(other[name]):
            return math.inf, f"{name}: {len(other[name])} numbers, not {len(values)}"
        size = max(map(abs, values))
        difference = max(abs(a - b) for a, b in zip(values, other[name])) / (size or 1.)
        if not difference <= worst:  # nan, too
            worst, kind = difference, name
    return worst, kind


def compare(program, name, labels, workdir):
    """label -> (difference, kind), or a message."""
    good = results_of(*run(program, name, "original", Transformation(), workdir))
    found = {}
    for label in labels:
        try:
            other = results_of(*run(program, name, label, TRANSFORMATIONS[label], workdir))
            found[label] = largest_difference(good, other)
        except RuntimeError as error:
            found[label] = (math.inf, str(error))
    return found


def arguments():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("lamella")
    parser.add_argument("workdir", type=Path)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--only", help="transformations, separated by commas")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--tolerance", type=float, default=1e-8)
    return parser.parse_args()


def main():
    given = arguments()
    names = given.names or (QUICK if given.quick else
                            [name for name in SCENES if name not in CUT])
    labels = (given.only.split(",") if given.only else
              QUICKLY if given.quick else list(TRANSFORMATIONS))
    for name in names:
        if name not in SCENES:
            sys.exit(f"There is no scene {name}; there are {', '.join(SCENES)}.")
    program, start = str(Path(given.lamella).resolve()), time.monotonic()
    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        found = list(pool.map(
            lambda name: compare(program, name, labels, given.workdir.resolve()), names))
    print(f"{'':12}", *(f"{label:>11}" for label in labels))
    faults = []
    for name, differences in zip(names, found):
        print(f"{name:12}", *(f"{differences[label][0]:11.1e}" for label in labels))
        faults += [f"FAIL: {name}, {label}: {differences[label][0]:.2e}, {differences[label][1]}"
                   for label in labels if not differences[label][0] <= given.tolerance]
    print(f"{time.monotonic() - start:.0f} s", *faults, sep="\n")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
