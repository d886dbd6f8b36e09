# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bars of errors (Goals/Error bars) against true errors, those to a much finer run of the
same scene; see scripts/measure."""

import json
import subprocess
import tempfile
from pathlib import Path

from measure_fields import laminate, materials_of, scene_text
from measure_tools import ENVIRONMENT, PROGRAM, ROOT, read, table

# Errors below this share of the scale are not compared: the finer runs have some, too.
SMALL = 1e-3


class BarRun:
    """A scene run with overrides: its summary and probes, by the names of quantities."""

    def __init__(self, scene, overrides):
        self.failure = ""
        with tempfile.TemporaryDirectory() as folder:
            path = scene
            if isinstance(scene, dict):
                path = Path(folder) / "scene.prm"
                path.write_text(scene_text(scene))
            words = [PROGRAM, path, "--output", Path(folder) / "out"]
            for override in ["Write VTU=false", *overrides]:
                words += ["--set", override]
            done = subprocess.run(words, env=ENVIRONMENT, capture_output=True,
                                  text=True)
            if done.returncode:
                self.failure = done.stderr.strip()
                return
            self.summary = json.loads((Path(folder) / "out/summary.json").read_text())
            self.probes = read(Path(folder) / "out/probes.csv")

    def value(self, quantity):
        name, column = quantity.split(": ")
        name, _, ply = name.partition("/")
        for row in self.probes:
            if row["probe"] == name and ply in ("", row["ply"]):
                return float(row[column])
        for kind, key in (("contacts", "force"), ("supports", "reaction")):
            if name in self.summary[kind]:
                return self.summary[kind][name][key]["xyz".index(column[1])]
        raise KeyError(quantity)


# Scenes.

ISOTROPIC = {"Width": 1., "Layup": "0", "Ply thickness": 1.,
             "Ply materials": "aluminium", "Cells per ply": 4, "Cells across": 4}


def cantilever(section, length):
    """Clamped at its start, a force over its end; deflection of the tip, stresses at a
    third of the length at the top and inside."""
    width = section["Width"]
    x = 0.3 * width
    return {
        "Title": "Cantilever", "Units": "mm, N", **materials_of(section), "Section strip": section,
        "Body beam": {"Section": "strip", "Length": length,
                      "Kinematics": {"Axis elements": "auto"}},
        "Support clamp": {"On": "beam: start"},
        "Load tip": {"On": "beam: end", "Force": f"0, 0, {1e-3 / length ** 2}"},
        "Probe tip": {"At": f"beam: {width / 2}, {length}, 0.5"},
        "Probe third": {"At": f"beam: {x}, {length / 3}, 0.9"},
        "Probe inside": {"At": f"beam: {x}, {length / 3}, 0.45"}}


TIP = ["tip: uz", "third: syy", "inside: syz"]


def cantilevers():
    layups = (("square", ISOTROPIC), ("[0/90/0]", laminate("0/90/0")),
              ("[45/-45/0]", laminate("45/-45/0")))
    for name, section in layups:
        for slenderness in (5, 20, 100, 1000, 10000):
            theories = ["EBBT", "TE-3", "LE-1", "LE-2", "SV", "SV-6"]
            if slenderness <= 20:
                theories += ["solid-1"]
            yield (f"{name}, L/h = {slenderness}", cantilever(section, slenderness),
                   TIP, theories,
                   ["Theory=LE-4" if slenderness <= 20 else "Theory=LE-3",
                    "Body beam/Kinematics/Axis elements=auto 2"])


def shipped():
    sandwich = ROOT / "prm/sandwich.prm"
    yield ("sandwich", sandwich,
           ["indentation: fz", "quarter: uy", "bottom: syy", "bottom: uz", "core: syz",
            "tension: syy"],
           ["EBBT", "TE-4", "TE-8", "LE-1", "LE-2", "SV", "SV-6", "solid-1"],
           ["Theory=LE-4", "Body beam/Kinematics/Axis breaks=",
            "Body beam/Kinematics/Axis elements=auto 2"])
    beams = ROOT / "prm/laminated_beams.prm"
    finer = [f"Body {body}/Kinematics/Axis elements=60" for body in ("upper", "lower")]
    yield ("laminated beams", beams,
           ["upper_top: uz", "lower_top: uz", "upper_top: syy", "middle: fz"],
           ["EBBT", "TE-2", "TE-4", "LE-1", "LE-2"], ["Theory=LE-3"] + finer)
    yield ("double-T, twisted", ROOT / "tests/scenes/double_t.prm",
           ["middle: uz", "edge: uz", "root: syy"],
           ["EBBT", "TE-3", "TE-6", "LE-1", "LE-2", "SV", "SV-6", "solid-1"],
           ["Theory=LE-4", "Body beam/Kinematics/Axis breaks=",
            "Body beam/Kinematics/Axis elements=auto 2"])
    yield ("coupon", ROOT / "prm/flexure_test.prm",
           ["c_nose: fz", "middle: uz", "outer: syy", "core: syz", "below: szz"], ["TE-4", "SV", "SV-6"],
           ["Theory=SV-14", "Section coupon/Cells across=8"])
    crossed = ROOT / "tests/scenes/crossed_beams.prm"
    lengths = ["Body upper/Kinematics/Axis elements=6, 8, 6",
               "Body lower/Kinematics/Axis elements=6, 8, 6"]
    yield ("crossed beams", crossed, ["press: fz", "cross: fz"],
           ["EBBT", "TE-2", "LE-1", "LE-2", "SV-6"], ["Theory=LE-4"] + lengths)
    strip = ROOT / "prm/hertz_plane_strain.prm"
    yield ("Hertz, plane strain", strip, None, ["LE-1", "LE-2"], ["Theory=LE-4"])


# Comparison.

def quantities_of(scene):
    """Those that the scene has References for."""
    run = BarRun(scene, ["Goals/Error bars=true"])
    return list(run.summary["goals"])


def compare(name, scene, quantities, theories, finer):
    """A row for each theory and quantity."""
    quantities = quantities or quantities_of(scene)
    true = BarRun(scene, finer)
    if true.failure:
        raise RuntimeError(f"{name}: {true.failure}")
    rows = []
    for theory in theories:
        run = BarRun(scene, [f"Theory={theory}", "Goals/Error bars=true",
                             "Goals/Quantities=" + " | ".join(quantities)])
        if run.failure:
            rows.append([name, theory, "", run.failure])
            continue
        for quantity in quantities:
            goal = run.summary["goals"][quantity]
            error = true.value(quantity) - goal["value"]
            rows.append([name, theory, quantity, error / goal["scale"],
                         goal["estimate"] / goal["scale"],
                         goal["bar"] / goal["scale"] if goal["trusted"] else None,
                         goal.get("why", "")])
    return rows


def cells(row):
    if len(row) == 4:
        return row[:2] + ["", "", "", "", "", row[3][:60]]
    name, theory, quantity, error, estimate, bar, why = row
    compared = abs(error) > SMALL
    return [name, theory, quantity, f"{100 * error:.3g}", f"{100 * estimate:.3g}",
            "none" if bar is None else f"{100 * bar:.3g}",
            f"{estimate / error:.2f}" if compared else "",
            "" if bar is None else "yes" if abs(error) <= bar else
            f"no ({abs(error) / bar:.2g})"]


def share(some, of):
    return f"{100 * sum(some) / len(of):.0f} % of {len(of)}" if of else "none"


def print_shares(rows):
    rows = [row for row in rows if len(row) == 7]
    large = [row[4] / row[3] for row in rows if abs(row[3]) > SMALL]
    held = [(abs(row[3]), row[5]) for row in rows if row[5] is not None]
    print(f"Goal values: {len(rows)}; errors above {100 * SMALL:g} %: {len(large)}.")
    print("Effectivity (estimate over error) of these within 0.7 to 1.3:",
          share([0.7 <= e <= 1.3 for e in large], large) + "; within 0.5 to 2:",
          share([0.5 <= e <= 2. for e in large], large) + ".")
    print("Bars:", len(held), "of", len(rows), "values have one;",
          "they hold in", share([e <= bar for e, bar in held], held) +
          "; more than three times too small are",
          sum(e > 3. * bar + 1e-12 for e, bar in held), "of them.")
    print()


def bars(pick=""):
    """doc/error-bars.md: every bar beside the error that it is of."""
    rows = []
    for case in [*shipped(), *cantilevers()]:
        if pick in case[0]:
            rows += compare(*case)
    table(["scene", "theory", "goal", "error, %", "estimate, %", "bar, %",
           "effectivity", "holds"], [cells(row) for row in rows])
    print_shares(rows)
