# SPDX-License-Identifier: LGPL-2.1-or-later
"""doc/beyond-linear.md: stiffening and buckling factors beside closed forms, and what
they cost; see scripts/measure."""

import math

from measure_tools import ROOT, Run, table

SCENES = ROOT / "tests/scenes"
THEORIES = ("EBBT", "TBT", "TE-3", "LE-2", "SV-4", "solid-2")


def strip():
    """A strip between clamps under a uniform pressure: r = 0.696686 (W/h)^2."""
    rows = []
    for theory in THEORIES:
        more = ["Body strip/Kinematics/Axis elements=64"] if theory == "solid-2" else []
        run = Run(SCENES / "deflected_strip.prm",
                  [f"Theory={theory}", "Load factors=1, 2, 4, 8, 16"] + more)
        steps = run.summary["beyond_linear"]["steps"]
        rows.append([theory, run.summary["dofs"]] + [f"{s['stiffening']:.5g}" for s in steps])
    rows.append(["closed form", ""] +
                [f"{0.696686 * (0.5 * t) ** 2:.5g}" for t in (1, 2, 4, 8, 16)])
    table(["theory", "DoFs"] + [f"W/h = {0.5 * t:g}" for t in (1, 2, 4, 8, 16)], rows)


def columns():
    """Euler's column, L/h = 200, of steel and of a [0/90/0] laminate."""
    euler = {"strip": math.pi ** 2 * 2.7e6 / (4. * 600. ** 2),
             "laminate": math.pi ** 2 * 1.82797e6 / (4. * 600. ** 2)}
    rows = []
    for theory in THEORIES:
        row = [theory]
        for section, load in euler.items():
            more = ["Body column/Kinematics/Axis elements=40"] if theory == "solid-2" else []
            run = Run(SCENES / "column.prm",
                      [f"Theory={theory}", f"Body column/Section={section}",
                       "Beyond linear range=accept"] + more)
            force = -run.summary["loads"]["weight"]["force"][2]
            factor = run.summary["beyond_linear"]["buckling_factor"]
            row += [f"{factor * force:.4f}", f"{100. * (factor * force / load - 1.):+.2f} %"]
        rows.append(row)
    rows.append(["Euler"] + [cell for load in euler.values() for cell in (f"{load:.4f}", "")])
    table(["theory", "steel [N]", "off", "[0/90/0] [N]", "off"], rows)


def shipped():
    """What the shipped scenes say, and what it costs of a linear step."""
    rows = []
    for scene in sorted((ROOT / "prm").glob("*.prm")):
        run = Run(scene, ["Write VTU=false"])
        seconds = run.summary["seconds"]
        steps = run.summary["load_steps"]
        step = (seconds["assembly"] + seconds["factorisation"] +
                (seconds["solve"] + seconds["contact"]) / steps)
        found = run.summary["beyond_linear"]
        factor = found["buckling_factor"]
        rows.append([f"`{scene.name}`", run.summary["dofs"],
                     f"{100. * found['stiffening']:.2g} %",
                     "-" if factor is None else f"{factor:.3g}",
                     f"{step:.3f}", f"{seconds['beyond'] / steps / step:.3f}"])
    table(["scene", "DoFs", "stiffening", "buckling factor", "a linear step [s]",
           "of which these take"], rows)


def beyond():
    """Stiffening, buckling, and what they cost."""
    strip()
    columns()
    shipped()
