#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hunts for wrong numbers: random scenes, each solved by theories that have to agree.

Usage: hunt.py LAMELLA WORKDIR --count N --seed S [--jobs 2] [--case I] [--bars]
               [--theories LE-2,SV-6,solid-2] [--large]

A scene is a body (a laminate with angle plies, perhaps with a foam, a box or a tube; turned
anyhow), held at an end, at both, or at an end and along a line inside the span, under a
pressure, an end force, a couple, heat or weight, perhaps with a second body, a roller or
a floor that it touches. The same number is asked of LE-2, SV-6 and solid-2, or of others
(LE-2 first): the displacement of a probe away from whatever touches the body, in the direction in which it
is largest, and the forces of contacts. With --bars a run of LE-2 with error bars is held
against LE-3 on twice the elements. What is due:

    runs        all models of a scene run, or none does (an answer of InputError or
                NumericsError of all of them is no finding, of one it is)
    agree       all differ from LE-2 by less than 3 % of the displacement and 5 % of a
                contact's force, or from LE-3 on twice the elements by less than LE-2 does
                (which is coarse beside heat and supports); solid-2 has quadratic functions
                along the axis for cubic ones, and SV-N fields of its own
    holds       an error bar that is trusted holds the finer number

With --large (scenes that are not heated) Rotations = large takes the place of theories: loads
and ways of obstacles are scaled so that the probe goes by a tenth of the length, or that
something turns by half a radian, what comes first by the linear theory, and

    small       at a thousandth of that it is within 1 % of the linear run
    ends        at all of it, in four steps, a run ends with results or with a sentence
    one path    in one step it comes to the same place, within 1e-4
    finer       on twice the elements to within 5 %, where no note says that they are too long
    turning     in SV-6, whose sections turn as a whole, it ends as well, and within 5 % of LE-2
                or of LE-2 on twice the elements, where no note says that sections change their
                shape

where strains that another mesh has beyond the law's range, by less than 8 %, are no finding,
and "finer" and "turning" are not asked where a note tells of strains above 10 %.

The same seed gives the same scenes. What is a finding stays in WORKDIR/cases, each scene
with the lines that say what it is. Exit status 1 if there is one."""

import argparse
import concurrent.futures
import json
import math
import os
import random
import re
import shutil
import subprocess
import sys
from pathlib import Path

MODELS = "LE-2,SV-6,solid-2"
OF_DISPLACEMENTS, OF_FORCES = 0.03, 0.05
ENVIRONMENT = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}
MATERIALS = """
subsection Material carbon
  set Engineering constants = 140000, 9000, 9000, 4800, 4800, 3200, 0.3, 0.3, 0.4
  set Thermal expansion     = -0.5e-6, 30e-6, 30e-6
  set Density               = 1.6e-9
end
subsection Material glass
  set Engineering constants = 42000, 12000, 12000, 4500, 4500, 4000, 0.28, 0.28, 0.4
  set Thermal expansion     = 7e-6, 22e-6, 22e-6
  set Density               = 2e-9
end
subsection Material steel
  set Isotropic         = 200000, 0.3
  set Thermal expansion = 12e-6
  set Density           = 7.8e-9
end
subsection Material foam
  set Isotropic         = 150, 0.3
  set Thermal expansion = 35e-6
  set Density           = 1e-10
end
"""


def numbers(vector):
    return ", ".join(f"{x:.13g}" for x in vector)


def unit(v):
    size = math.sqrt(sum(x * x for x in v))
    return [x / size for x in v]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


class Frame:
    """Where a body stands: the scene's position of a point of the body's axes."""

    def __init__(self, dice):
        self.y, up = [0., 1., 0.], [0., 0., 1.]
        self.origin = [0., 0., 0.]
        if dice.random() < 0.5:
            self.y = unit([dice.uniform(-1., 1.) for _ in range(3)])
            up = unit([dice.uniform(-1., 1.) for _ in range(3)])
            self.origin = [dice.uniform(-100., 100.) for _ in range(3)]
        self.x = unit(cross(self.y, up))
        self.z = cross(self.x, self.y)

    def point(self, x, y, z):
        return [self.origin[k] + x * self.x[k] + y * self.y[k] + z * self.z[k] for k in range(3)]

    def vector(self, x, y, z):
        return [x * self.x[k] + y * self.y[k] + z * self.z[k] for k in range(3)]

    def body(self, name, section, length, at, elements):
        return (f"subsection Body {name}\n  set Section = {section}\n"
                f"  set Origin  = {numbers(self.point(*at))}\n  set Axis    = {numbers(self.y)}\n"
                f"  set Up      = {numbers(self.z)}\n  set Length  = {length:.6g}\n"
                f"  subsection Kinematics\n    set Axis elements = {elements}\n  end\nend\n")


def section(dice):
    """Text, width and height of a section called `section`."""
    kind = dice.choices(("laminate", "sandwich", "box", "tube"), (6, 2, 1, 1))[0]
    width = dice.choice((6., 10., 16.))
    if kind == "laminate":
        n = dice.randint(1, 3)
        plies = [dice.choice(("carbon", "glass", "steel")) for _ in range(n)]
        angles = [dice.choice((0, 0, 90, 45, -45, 30)) for _ in range(n)]
        thick = [dice.choice((1., 2., 3.)) for _ in range(n)]
    elif kind == "sandwich":
        plies, angles = ["carbon", "foam", "carbon"], [0, 0, 0]
        thick = [1., dice.choice((4., 8.)), 1.]
    if kind in ("laminate", "sandwich"):
        return (f"  set Width         = {width}\n  set Layup         = {'/'.join(map(str, angles))}\n"
                f"  set Ply thickness = {numbers(thick)}\n  set Ply materials = {', '.join(plies)}\n"
                f"  set Cells across  = 2\n", width, sum(thick), kind)
    height = dice.choice((8., 12.))
    text = (f"  set Shape          = {kind}\n  set Width          = {width}\n"
            f"  set Height         = {height}\n  set Wall thickness = 1.5\n"
            f"  set Material       = {dice.choice(('glass', 'steel'))}\n")
    if kind == "box":
        text += "  set Cells along wall = 2\n"
    return text, width, height, kind


class Scene:
    """Everything of one scene but its theory."""

    def __init__(self, seed, number):
        dice = random.Random(f"{seed}.{number}")
        self.frame = frame = Frame(dice)
        text, width, height, kind = section(dice)
        flat = kind in ("laminate", "sandwich")
        length = round(dice.uniform(6., 14.) * max(width, height))
        self.elements, self.length = 10, length
        bodies = [frame.body("beam", "section", length, (0., 0., 0.), self.elements)]
        blocks, names = [], {key: [] for key in ("Supports", "Loads", "Obstacles", "Contacts")}

        def add(kind, name, *entries):
            names[kind + ("ies" if kind == "Body" else "s")].append(name)
            blocks.append(f"subsection {kind} {name}\n" +
                          "".join(f"  set {entry}\n" for entry in entries) + "end\n")

        add("Support", "clamp", "On = beam: start")
        held = dice.choice(("start", "both", "inside") if flat else ("start", "both"))
        if held == "both":
            add("Support", "far", "On = beam: end")
        if held == "inside":
            y = dice.uniform(0.55, 0.8) * length
            along = [max((abs(n), k) for k, n in enumerate(frame.z))[1]]
            u = ["0" if k in along else "free" for k in range(3)]
            add("Support", "inside", "On = beam: line",
                f"At = {numbers(frame.point(0., y, 0.))}; {numbers(frame.point(width, y, 0.))}",
                "u = " + ", ".join(u))
        self.touched = None
        if held != "inside" and flat:
            self.touched = dice.choice((None, None, "roller", "second", "floor"))
        where = 0.6 * length
        load = dice.choice(("pressure", "force", "couple", "heat", "weight"))
        if self.touched in ("second", "floor") or (held == "both" and load in ("force", "couple")):
            load = "pressure"
        sign = -1. if self.touched == "floor" else dice.choice((-1., 1.))
        self.gravity = None
        if load == "pressure":
            face = "top" if flat else "start"
            if flat:
                add("Load", "push", f"On = beam: {face}", f"Pressure = {-sign * 0.02:.3g}")
            else:
                load = "weight"
        if load == "force":
            direction = frame.vector(dice.uniform(-1., 1.), dice.uniform(-1., 1.), sign)
            add("Load", "push", "On = beam: end", f"Force = {numbers(0.05 * x for x in direction)}")
        if load == "couple":
            direction = frame.vector(dice.uniform(-1., 1.), dice.uniform(-1., 1.), sign)
            add("Load", "turn", "On = beam: end", f"Couple = {numbers(20. * x for x in direction)}")
        if load == "heat":
            add("Load", "warm", "On = beam: body", f"Temperature = {dice.choice((40., -100.))}")
        if load == "weight":
            self.gravity = frame.vector(dice.uniform(-1., 1.), 0., sign)
        if self.touched == "roller":
            radius = dice.uniform(0.5, 2.) * height
            add("Obstacle", "roller", "Shape = cylinder",
                f"Through = {numbers(frame.point(0., where, height + radius))}",
                f"Axis = {numbers(frame.x)}", f"Radius = {radius:.13g}",
                f"u = {numbers(frame.vector(0., 0., -0.02 * height))}")
            # On a line of the mesh: between lines a coarse one lets it sink in.
            add("Contact", "touch", "First = beam: top", "Second = roller",
                "Discretization = node to surface")
        if self.touched == "floor":
            add("Obstacle", "floor", "Shape = plane",
                f"Through = {numbers(frame.point(0., 0., -0.001 * height))}",
                f"Normal = {numbers(frame.z)}")
            add("Contact", "touch", "First = beam: bottom", "Second = floor",
                "Discretization = surface to surface")
        if self.touched == "second":
            bodies.append(frame.body("other", "section", length,
                                     (0., 0., -height - 0.001 * height), self.elements))
            add("Support", "other_clamp", "On = other: ends")
            add("Contact", "touch", "First = beam: bottom", "Second = other: top",
                "Discretization = surface to surface")
        probe = frame.point(0.5 * width, (0.85 if held == "start" else 0.4) * length,
                            0. if flat else 0.75)
        self.text = (
            "set Units = mm, N\nset Rotation limit = 100\nset Beyond linear range = accept\n"
            "set Write VTU = false\nset Materials = carbon, glass, steel, foam\n"
            "set Sections = section\nset Bodies = beam" +
            (", other" if self.touched == "second" else "") + "\nset Probes = probe\n" +
            "".join(f"set {kind} = {', '.join(of)}\n" for kind, of in names.items() if of) +
            (f"set Gravity = {numbers(1e4 * g for g in self.gravity)}\n" if self.gravity else "") +
            MATERIALS + f"subsection Section section\n{text}end\n" + "".join(bodies) +
            "".join(blocks) +
            f"subsection Probe probe\n  set At = beam: {numbers(probe)}\nend\n")
        self.bodies = ("beam", "other") if self.touched == "second" else ("beam",)
        self.words = f"{kind}, held {held}, {load}, touches {self.touched}"

    def finer(self):
        """Twice the elements along all axes."""
        return [f"Body {body}/Kinematics/Axis elements={2 * self.elements}"
                for body in self.bodies]


def run(lamella, scene, folder, name, *entries):
    """summary.json, or what the program said and its exit status."""
    path = folder / "scene.prm"
    path.write_text(scene.text)
    words = [lamella, str(path), "--output", str(folder / name)]
    for entry in entries:
        words += ["--set", entry]
    try:
        done = subprocess.run(words, env=ENVIRONMENT, capture_output=True, text=True, check=False,
                              timeout=300)
    except subprocess.TimeoutExpired:
        return None, "takes more than 300 s"
    if done.returncode != 0:
        return None, f"exit status {done.returncode}: {done.stderr.strip()[:400]}"
    probes = (folder / name / "probes.csv").read_text().splitlines()
    row = dict(zip(probes[0].split(","), probes[-1].split(",")))
    summary = json.loads((folder / name / "summary.json").read_text())
    return {"u": [float(row[c]) for c in ("ux", "uy", "uz")],
            "forces": {name: math.hypot(*contact["force"])
                       for name, contact in summary.get("contacts", {}).items()},
            "rotation": summary.get("max_rotation", 0.),
            "goals": summary.get("goals", {}), "notes": {note["identifier"]: note["text"] for note in summary["warnings"]}}, ""


def distances(one, other):
    """Relative, of the displacement and of the contacts' forces."""
    yield "displacement", OF_DISPLACEMENTS, one["u"], other["u"], \
        math.dist(one["u"], other["u"]) / math.hypot(*one["u"])
    for name, force in one["forces"].items():
        if force > 0.:
            yield f"force of {name}", OF_FORCES, force, other["forces"][name], \
                abs(other["forces"][name] - force) / force


def models_disagree(lamella, scene, folder, theories):
    found, faults, failed = {}, [], {}
    for theory in theories:
        # Quadratic functions along the axis where beams have cubic ones.
        finer = scene.finer() if theory.startswith("solid") else []
        result, words = run(lamella, scene, folder, theory, f"Theory={theory}", *finer)
        if result is None:
            failed[theory] = words
        else:
            found[theory] = result
    if failed and found:
        faults += [f"{theory} alone fails, {words}" for theory, words in failed.items()]
    if "LE-2" not in found:
        return faults
    poor, rich = found["LE-2"], None
    for theory, other in found.items():
        for what, most, there, here, off in distances(poor, other):
            if off <= most:
                continue
            if rich is None:
                rich, words = run(lamella, scene, folder, "LE-3", "Theory=LE-3",
                                  *scene.finer())
            if rich is None:
                return faults + [f"LE-3 fails, {words}"]
            off_rich, left = ({w: d for w, _, _, _, d in distances(rich, model)}.get(what, 0.)
                              for model in (other, poor))
            if off_rich > max(most, left):
                faults.append(f"{theory}: {what} {here} beside {there} of LE-2, "
                              f"{100. * off:.2g} % off, and {100. * off_rich:.2g} % off LE-3, "
                              f"off which LE-2 is {100. * left:.2g} %")
    return faults


def bar_fails(lamella, scene, folder):
    with_bars, words = run(lamella, scene, folder, "bars", "Theory=LE-2",
                           "Goals/Error bars=true", "Goals/Quantities=probe: ux | probe: uy | probe: uz")
    finer, _ = run(lamella, scene, folder, "finer", "Theory=LE-3",
                   *scene.finer())
    if finer is None:
        return []
    if with_bars is None:
        return [f"LE-2 with bars fails, {words}"]
    faults = []
    size = math.hypot(*finer["u"])
    for k, component in enumerate(("ux", "uy", "uz")):
        goal = with_bars["goals"].get(f"probe: {component}")
        if goal and goal["trusted"]:
            off = abs(finer["u"][k] - goal["value"])
            if off > goal["bar"] + 1e-4 * size:
                faults.append(f"{component} = {goal['value']:.6g} +- {goal['bar']:.2g}, but "
                              f"{finer['u'][k]:.6g} by LE-3 on twice the elements")
    return faults


def large_faults(lamella, scene, folder):
    """What is wrong with large rotations of a scene."""
    def solve(name, factors, *entries):
        return run(lamella, scene, folder, name, "Theory=LE-2", *entries,
                   "Load factors=" + numbers(factors))

    def stopped(result, words):
        """Not where the law's range, 5 % of strain, is what ends another mesh."""
        found = re.search(r"Strains reach ([0-9.]+) %", words)
        return result is None and not (found and float(found[1]) < 8.)

    def strained(result):
        """Whether a note tells of strains that laws differ at by more than what is asked."""
        found = (re.search(r"[Ss]trains reach ([0-9.]+) %", note) for note in result["notes"].values())
        return any(reach and float(reach[1]) > 10. for reach in found)

    def apart(one, other, most):
        return [f"{what}: {here} beside {there}, {100. * off:.2g} % off"
                for what, _, there, here, off in distances(one, other) if off > most]

    linear, _ = solve("linear", [1.])
    if "heat" in scene.words or linear is None or math.hypot(*linear["u"]) == 0.:
        return []
    full = min(0.1 * scene.length / math.hypot(*linear["u"]),
               0.5 / max(linear["rotation"], 1e-12))
    large, faults, small = "Rotations=large", [], 1e-3 * full
    linear, _ = solve("linear", [small])
    turned, words = solve("small", [small], large)
    if linear is not None and turned is None:
        faults.append(f"a thousandth fails, {words}")
    elif linear is not None:
        faults += ["a thousandth of " + fault for fault in apart(linear, turned, 0.01)]
    path, words = solve("path", [full * k for k in (0.25, 0.5, 0.75, 1.)], large)
    if path is None:
        return faults + ([] if "exit status 2: lamella: " in words else [f"it ends: {words}"])
    once, words = solve("once", [full], large)
    if once is None:
        faults.append(f"one step fails: {words}")
    else:
        faults += ["one step " + fault for fault in apart(path, once, 1e-4)]
    if strained(path):
        return faults
    finer, words = solve("finer", [full * k for k in (0.25, 0.5, 0.75, 1.)], large,
                         *scene.finer())
    if stopped(finer, words):
        faults.append(f"finer fails: {words}")
    elif finer is not None and "solve.element-rotation" not in path["notes"]:
        faults += ["finer " + fault for fault in apart(path, finer, 0.05)]
    turning, words = solve("turning", [full * k for k in (0.25, 0.5, 0.75, 1.)], large,
                           "Theory=SV-6")
    if stopped(turning, words):
        faults.append(f"SV-6 fails: {words}")
    elif turning is not None and "solve.section-shape" not in turning["notes"]:
        off = [apart(one, turning, 0.05) for one in (path, finer) if one is not None]
        if all(off):
            faults += ["SV-6 " + fault for fault in off[-1]]
    return faults


def judge(arguments):
    lamella, work, seed, number, bars, theories, large = arguments
    scene = Scene(seed, number)
    folder = work / f"{seed}.{number}"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    faults = large_faults(lamella, scene, folder) if large else \
        models_disagree(lamella, scene, folder, theories)
    if bars:
        faults += bar_fails(lamella, scene, folder)
    if faults:
        kept = work / "cases" / f"{seed}.{number}"
        kept.mkdir(parents=True, exist_ok=True)
        shutil.copy(folder / "scene.prm", kept)
        (kept / "found").write_text("\n".join(faults) + "\n")
    shutil.rmtree(folder)
    return number, scene.words, faults


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("lamella")
    parser.add_argument("work", type=Path)
    parser.add_argument("--count", type=int, required=True)
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--case", type=int)
    parser.add_argument("--bars", action="store_true")
    parser.add_argument("--theories", default=MODELS)
    parser.add_argument("--large", action="store_true")
    options = parser.parse_args()
    shutil.rmtree(options.work / "cases", ignore_errors=True)
    cases = range(options.count) if options.case is None else [options.case]
    jobs = [(options.lamella, options.work, options.seed, k, options.bars,
             options.theories.split(","), options.large) for k in cases]
    findings = 0
    with concurrent.futures.ProcessPoolExecutor(options.jobs) as pool:
        for number, words, faults in pool.map(judge, jobs):
            if faults:
                findings += 1
                print(f"{options.seed}.{number} ({words}):", flush=True)
                for fault in faults:
                    print(f"    {fault}", flush=True)
    print(f"{len(jobs)} scenes, {findings} findings")
    sys.exit(1 if findings else 0)


if __name__ == "__main__":
    main()
