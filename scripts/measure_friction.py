# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bars of runs with friction against true errors, and fields of SV-N for what rubs
(doc/verification/friction.md); see scripts/measure."""

import math
from functools import cache

from measure_bars import BarRun
from measure_tools import ROOT, table

# Errors below this share of the scale matter to nobody.
SMALL = 1e-4
SPRING = ROOT / "prm/leaf_spring_loop.prm"
LEAVES = ROOT / "tests/scenes/friction_leaves.prm"
CYLINDERS = ROOT / "tutorials/step-13/step-13.prm"
FIELDS = ROOT / "tests/scenes/friction_fields.prm"


def elements(n, bodies=("lower", "upper")):
    return [f"Body {body}/Kinematics/Axis elements={n}" for body in bodies]


# Name: scene, goals, the path, what makes the truth.
GROUPS = {
    "leaf spring": (
        SPRING, ("tip: uz", "interleaf-1: fz", "interleaf-3: fz", "interleaf-1: dissipated"),
        ["Load factors=0.5, 1, 0.5"],
        ["Theory=LE-4", *elements(24, ["leaf"]), "Substeps=4"]),
    "leaves": (
        LEAVES, ("tip: uz", "face: fy", "face: dissipated"), [],
        ["Theory=LE-4", *elements(80), "Substeps=4"]),
    "leaves, pressed in proportion": (
        LEAVES, ("tip: uz", "face: fy", "face: dissipated"),
        ["Load factors=1, 0.5, 1", "Load push/Factors=0.2, 1, -1"],
        ["Theory=LE-3", *elements(40), "Substeps=32"]),
    "cylinders, in proportion": (
        CYLINDERS, ("nip: fx", "nip: fz"), ["Load factors=1", "Support push/Factors=1"],
        ["Theory=LE-3", "Substeps=64"]),
}
RUNS = (
    [("leaf spring", [f"Theory={theory}"])
     for theory in ("EBBT", "TE-3", "LE-2", "LE-3", "SV-6")]
    + [("leaf spring", ["Theory=LE-2", *elements(4, ["leaf"])]),
       ("leaf spring", ["Theory=LE-2", "Contact interleaf/Enforcement=penalty"])]
    + [("leaves", [f"Theory={theory}", *elements(n)])
       for theory in ("LE-1", "LE-2", "LE-3", "SV-6") for n in (8, 20)]
    + [("leaves, pressed in proportion", [f"Substeps={n}", *elements(20)])
       for n in ("1", "4", "auto")]
    + [("cylinders, in proportion", [f"Substeps={n}"]) for n in ("1", "2", "8", "auto")])


def value(run, goal):
    """At the last load step."""
    name, column = goal.split(": ")
    if column == "dissipated":
        return run.summary["contacts"][name]["friction"]["dissipated"]
    rows = [row for row in run.probes if row["probe"] == name]
    return float(rows[-1][column]) if rows else run.value(goal)


@cache
def truth(group):
    scene, goals, path, richer = GROUPS[group]
    run = BarRun(scene, ["Goals/Error bars=false", *path, *richer])
    return {goal: value(run, goal) for goal in goals}


def friction():
    """doc/verification/friction.md, bars: of all goals their errors and bars over the scale."""
    rows, held, compared, ratios = [], 0, 0, []
    for group, overrides in RUNS:
        scene, goals, path, _ = GROUPS[group]
        with_goals = ["Goals/Quantities=" + " | ".join(goals), *path, *overrides]
        run, bare = (BarRun(scene, [*with_goals, f"Goals/Error bars={word}"])
                     for word in ("true", "false"))
        for row in run.tables["goals.csv"]:
            scale, bar = float(row["scale"]), float(row["bar"] or "nan")
            error = abs(float(row["value"]) - truth(group)[row["goal"]])
            if error > SMALL * scale and row["bar"]:
                compared += 1
                held += error <= bar
                ratios.append(bar / error)
            rows.append([group, ", ".join(word.split("=")[1] for word in overrides), row["goal"],
                         row["value"], f"{100. * error / scale:.2g} %",
                         f"{100. * bar / scale:.2g} %", f"{run.wall / bare.wall:.1f}"])
    table(["scene", "run", "goal", "value", "error", "bar", "seconds over those without"], rows)
    print(f"{held} of {compared} bars hold whose number is off by more than {SMALL:g} of its "
          f"scale; bar over error {min(ratios):.2g} to {max(ratios):.2g}.\n")


def off(run, other, columns):
    """How far the tractions of two runs are apart, L2 over the last step's area."""
    last, true = ([row for row in one.tables["contact_face.csv"] if row["step"] == "2"]
                  for one in (run, other))
    change = [(float(row[c]) - float(there[c])) ** 2 / float(row["area"])
              for row, there in zip(last, true) for c in columns]
    size = [float(there[c]) ** 2 / float(there["area"]) for there in true for c in columns]
    return f"{100. * math.sqrt(sum(change) / sum(size)):.2g} %"


def rubbing():
    """doc/verification/friction.md, fields of SV-N: two leaves that stick in part, and that are
    pushed askew until all of them slips."""
    rows = []
    for name, push in (("sticks in part", "0, 0, 0.8"), ("pushed askew", "0.1, 0, 3")):
        more = ["Goals/Error bars=false", f"Load push/Total force={push}", *elements(16)]
        true = BarRun(FIELDS, [*more, "Theory=LE-3"])
        for theory in ("SV-3", "SV-6", "LE-3"):
            run = BarRun(FIELDS, [*more, f"Theory={theory}"])
            deflection = value(run, "tip: uz") / value(true, "tip: uz") - 1.
            rows.append([name, theory, off(run, true, ["shear_y"]), off(run, true, ["shear_x"]),
                         f"{abs(deflection):.1g}", run.summary["dofs"], f"{run.wall:.1f}"])
    table(["face", "theory", "shear along", "shear across", "deflection", "DoFs", "s"], rows)
