# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bars of errors (Goals/Error bars) against true errors, those to a much finer run of the
same scene; see scripts/measure."""

import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from measure_fields import laminate, materials_of, scene_text
from measure_tools import ENVIRONMENT, PROGRAM, ROOT, read, table

# Errors below this share of the scale are not compared, nor those below so many times
# what the finer run itself leaves open: its change from a theory that is one poorer. Of
# a goal in a singular place this is large, however fine the run.
SMALL, ABOVE_FLOOR = 1e-3, 3.


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
            self.tables = {path.name: read(path)
                           for path in (Path(folder) / "out").glob("*.csv")}
            self.probes = self.tables["probes.csv"]

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
        "Title": "Cantilever", "Units": "mm, N", **materials_of(section),
        "Section strip": section,
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
            # Finer elements than these at a clamp, a hair of 1e4 heights long, are
            # beyond double precision.
            finer = "auto" if slenderness > 1000 else "auto 2"
            yield (f"{name}, L/h = {slenderness}", cantilever(section, slenderness),
                   TIP, theories,
                   ["Theory=LE-4" if slenderness <= 20 else "Theory=LE-3",
                    f"Body beam/Kinematics/Axis elements={finer}"])


def pagano(slenderness):
    """Half of a [0/90/0] strip in cylindrical bending, as in tutorials/step-2, where the
    exact solution is known; @p slenderness is span over height."""
    length = 1.5 * slenderness
    graphite = "175000, 7000, 7000, 3500, 3500, 1400, 0.25, 0.25, 0.25"
    return {
        "Title": "Cylindrical bending", "Units": "mm, N",
        "Material graphite": {"Engineering constants": graphite},
        "Section strip": {"Width": 1, "Layup": "0/90/0", "Ply thickness": 1},
        "Body half": {"Section": "strip", "Length": length,
                      "Kinematics": {"Axis elements": 6}},
        "Support plane_strain": {"On": "half: body", "u": "0, free, free"},
        "Support bearing": {"On": "half: start", "u": "free, free, 0"},
        "Support symmetry": {"On": "half: end", "u": "free, 0, free"},
        "Load pull": {"On": "half: top",
                      "Pressure": f"{-36. / slenderness ** 2} * sin(pi*y/{2 * length})"},
        "Probe deflection": {"At": f"half: 0.5, {length}, 1.5"},
        "Probe top": {"At": f"half: 0.5, {length}, 3"},
        "Probe shear": {"At": "half: 0.5, 0, 1.5"}}


def paganos():
    for slenderness in (4, 10, 50):
        yield (f"Pagano [0/90/0], L/h = {slenderness}", pagano(slenderness),
               ["deflection: uz", "top: syy", "shear: syz"],
               ["EBBT", "TE-3", "TE-5", "LE-1", "LE-2", "solid-1", "solid-2"],
               ["Theory=LE-5", "Body half/Kinematics/Axis elements=24"])


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
    # The contact is node to node by penalty: the truth has no penetration.
    yield ("laminated beams", beams,
           ["upper_top: uz", "lower_top: uz", "upper_top: syy", "middle: fz"],
           ["EBBT", "TE-2", "TE-4", "LE-1", "LE-2"],
           ["Theory=LE-4", "Contact middle/Enforcement=exact"] + finer)
    yield ("double-T, twisted", ROOT / "tests/scenes/double_t.prm",
           ["middle: uz", "edge: uz", "root: syy"],
           ["EBBT", "TE-3", "TE-6", "LE-1", "LE-2", "SV", "SV-6", "solid-1"],
           ["Theory=LE-6", "Body beam/Kinematics/Axis breaks=",
            "Body beam/Kinematics/Axis elements=auto 2"])
    yield ("coupon", ROOT / "prm/flexure_test.prm",
           ["c_nose: fz", "middle: uz", "outer: syy", "core: syz", "below: szz"],
           ["TE-4", "SV", "SV-6"],
           ["Theory=SV-14", "Section laminate/Cells across=8",
            "Body coupon/Kinematics/Axis elements=4, 8, 16, 8, 16, 8, 4"])
    crossed = ROOT / "tests/scenes/crossed_beams.prm"
    lengths = ["Body upper/Kinematics/Axis elements=6, 8, 6",
               "Body lower/Kinematics/Axis elements=6, 8, 6"]
    yield ("crossed beams", crossed, ["press: fz", "cross: fz"],
           ["EBBT", "TE-2", "LE-1", "LE-2", "SV-6"], ["Theory=LE-4"] + lengths)
    strip = ROOT / "prm/hertz_plane_strain.prm"
    yield ("Hertz, plane strain", strip, None, ["LE-1", "LE-2"],
           ["Theory=LE-3", "Section half/Finest cell=0.01"])


def from_below():
    """Scenes of LE-3 and LE-4, whose bars are made of what they have: shipped ones, strips
    and cantilevers, and some that nobody fitted a rule to. Truths are richer in every
    source: two degrees more on an axis twice as fine, or four times."""
    both = ["LE-3", "LE-4"]
    for name, scene, quantities, _, finer in [*paganos(), *cantilevers()]:
        if re.search(r"= (4|5|10|20|50)$", name):
            yield name, scene, quantities, both, ["Theory=LE-6", *finer[1:]]
    twice = ["Body beam/Kinematics/Axis breaks=", "Body beam/Kinematics/Axis elements=auto 2"]
    yield ("double-T, twisted", ROOT / "tests/scenes/double_t.prm",
           ["middle: uz", "edge: uz", "root: syy"], both, ["Theory=LE-6", *twice])
    exact = "Contact middle/Enforcement=exact"
    finer = [f"Body {body}/Kinematics/Axis elements=60" for body in ("upper", "lower")]
    yield ("laminated beams", ROOT / "prm/laminated_beams.prm",
           ["upper_top: uz", "lower_top: uz", "upper_top: syy", "middle: fz"],
           [["LE-3", exact], ["LE-4", exact]], ["Theory=LE-6", exact, *finer])
    yield ("crossed beams", ROOT / "tests/scenes/crossed_beams.prm", ["press: fz", "cross: fz"],
           both, ["Theory=LE-5"] + [f"Body {body}/Kinematics/Axis elements=8, 12, 8"
                                    for body in ("upper", "lower")])
    yield ("Hertz, plane strain", ROOT / "prm/hertz_plane_strain.prm", None, ["LE-3"],
           ["Theory=LE-5", "Section half/Finest cell=0.01"])


# Comparison.

def quantities_of(scene):
    """Those that the scene has References for."""
    run = BarRun(scene, ["Goals/Error bars=richer"])
    return list(run.summary["goals"])


def poorer(overrides):
    """The same with a theory that is one poorer: LE-3 for LE-4, SV-10 for SV-14."""
    def less(found):
        step = 4 if found[1] == "SV" else 1
        return f"Theory={found[1]}-{int(found[2]) - step}"
    return [re.sub(r"^Theory=(\w+)-(\d+)$", less, override) for override in overrides]


def compare(name, scene, quantities, theories, finer, how="richer"):
    """A row for each theory and quantity: name, theory, quantity; then over the scale of
    the goal the error, the estimate, the bar (None without one), and what the truth
    leaves open; or name, theory, and why the run has failed."""
    quantities = quantities or quantities_of(scene)
    true, nearly_true = BarRun(scene, finer), BarRun(scene, poorer(finer))
    if true.failure or nearly_true.failure:
        raise RuntimeError(f"{name}: {true.failure or nearly_true.failure}")
    rows = []
    for theory in theories:
        print(f"{name}: {theory}", file=sys.stderr)
        theory, *overrides = [theory] if isinstance(theory, str) else theory
        run = BarRun(scene, [f"Theory={theory}", f"Goals/Error bars={how}", *overrides,
                             "Goals/Quantities=" + " | ".join(quantities)])
        if run.failure:
            rows.append([name, theory, run.failure])
            continue
        for quantity in quantities:
            goal = run.summary["goals"][quantity]
            error = true.value(quantity) - goal["value"]
            floor = abs(true.value(quantity) - nearly_true.value(quantity))
            rows.append([name, theory, quantity] + [
                value / goal["scale"] for value in (error, goal["estimate"])] + [
                goal["bar"] / goal["scale"] if goal["trusted"] else None,
                floor / goal["scale"]])
    return rows


def is_compared(row):
    return abs(row[3]) > max(SMALL, ABOVE_FLOOR * row[6])


def cells(row):
    if len(row) == 3:
        return row[:2] + ["", "", "", "", "", "", row[2][:160]]
    name, theory, quantity, error, estimate, bar, floor = row
    return [name, theory, quantity, f"{100 * error:.3g}", f"{100 * floor:.2g}",
            f"{100 * estimate:.3g}", "none" if bar is None else f"{100 * bar:.3g}",
            f"{estimate / error:.2f}" if is_compared(row) else "",
            "" if bar is None else "yes" if abs(error) <= bar else
            f"no ({abs(error) / bar:.2g})"]


def share(some, of):
    return f"{100 * sum(some) / len(of):.3g} % of {len(of)}" if of else "none"


def summary(rows):
    """A paragraph of what the rows come to."""
    values = [row for row in rows if len(row) == 7]
    with_bar = [row for row in values if row[5] is not None]
    text = (f"{len(values)} goal values of {len({row[0] for row in rows})} scenes, "
            f"{len(rows) - len(values)} runs without a result. The truth leaves "
            f"{100 * max((row[6] for row in values), default=0.):.2g} % open at most; "
            f"{sum(map(is_compared, values))} errors are above {100 * SMALL:g} % of the "
            f"scale and {ABOVE_FLOOR:g} times that. ")
    for what, of in (("these", values), ("those with a bar", with_bar)):
        ratios = [row[4] / row[3] for row in of if is_compared(row)]
        text += (f"Of {what} the effectivity (estimate over error) is within 0.7 to 1.3 "
                 f"in {share([0.7 <= r <= 1.3 for r in ratios], ratios)}, within 0.5 to "
                 f"2 in {share([0.5 <= r <= 2. for r in ratios], ratios)}. ")
    misses = [row for row in with_bar if abs(row[3]) > row[5] + 1e-12]
    text += (f"{len(with_bar)} values have a bar; it holds in "
             f"{share([row not in misses for row in with_bar], with_bar)}")
    if misses:
        factor, worst = max((abs(row[3]) / row[5], row) for row in misses)
        text += (f", {sum(abs(row[3]) > 3. * row[5] for row in misses)} are more than "
                 f"three times too small, {sum(abs(row[3]) <= row[6] for row in misses)} "
                 f"miss by no more than the truth leaves open. The worst is "
                 f"{', '.join(worst[:3])}: {factor:.2g} times too small")
    return text + "."


def judge(cases, how):
    rows = []
    for case in cases:
        try:
            rows += compare(*case, how)
        except RuntimeError as error:
            rows.append([case[0], "the truth", str(error)])
    table(["scene", "theory", "goal", "error, %", "truth open, %", "estimate, %", "bar, %",
           "effectivity", "holds"], [cells(row) for row in rows])
    print(summary(rows) + "\n")


def bars(pick=""):
    """Every bar from richer models beside the error that it is of; doc/error-bars.md sums it
    up."""
    judge([case for case in [*shipped(), *paganos(), *cantilevers()] if pick in case[0]],
          "richer")


def bars_below(pick=""):
    """Every bar from what the run has beside the error that it is of."""
    judge([case for case in from_below() if pick in case[0]], "auto")


def bars_half(pick=""):
    """Bars of LE-1, LE-2 and other theories, which models on half of the axis make, beside
    the errors that they are of."""
    def beams(theories):
        return [theory for theory in theories if not theory.startswith("solid")]

    def is_slender(name):
        return name.endswith(("= 100", "= 1000", "= 10000"))
    judge([(name, scene, quantities, beams(theories), finer)
           for name, scene, quantities, theories, finer
           in [*shipped(), *paganos(), *cantilevers()]
           if pick in name and not is_slender(name)], "true")
