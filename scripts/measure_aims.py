# SPDX-License-Identifier: LGPL-2.1-or-later
"""What fields of the section's own (Theory = SV, SV-N) are held to beside the tables
of measure_fields.py: hairs, walls, compact bodies, coupons, the paper's scenes, many
plies. See scripts/measure."""

import json
import math
import resource
import subprocess
import tempfile
from pathlib import Path

from measure_fields import (SANDWICH, STRESSES, FieldRun, at_their_word, box,
                            cantilever_scene, contact_table, coupons, double_t,
                            exponent, gmsh_sandwich, graded, half_disc, laminate,
                            main_stresses_off, off, percent, plate_scene, scene_text,
                            stress_cells, stresses_off, turns, twist_off, worst_place)
from measure_tools import ENVIRONMENT, PROGRAM, ROOT, table


class TimedRun(FieldRun):
    """A run with its user CPU seconds, start-up taken off, or with the failure that
    ended it."""

    def __init__(self, scene, theory, order=None, overrides=()):
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        self.failure = ""
        try:
            super().__init__(scene, theory, order, overrides)
        except RuntimeError as error:
            self.failure = str(error)
        spent = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
        self.cpu = max(0., spent - start_up())

    def cost_cells(self):
        return [self.summary["dofs"], f"{self.cpu:.2f}",
                f"{self.summary['peak_memory_mb']:.0f}"]


def start_up(known=[]):
    """User CPU seconds of a run that does nothing."""
    if not known:
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        subprocess.run([PROGRAM, "--version"], env=ENVIRONMENT, capture_output=True)
        known.append(resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before)
    return known[0]


def reason(failure):
    """The first sentence of a failure, without who says it."""
    return failure.split("lamella: ")[-1].split(". ")[0]


# Hairs.

def compliance(section):
    """The 6 x 6 compliance of a section, as the program gives it."""
    scene = cantilever_scene(section, 1., "bending")
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "scene.prm"
        path.write_text(scene_text(scene))
        subprocess.run([PROGRAM, path, "--output", Path(folder) / "out", "--set",
                        "Theory=LE-1"], env=ENVIRONMENT, capture_output=True,
                       check=True)
        file = Path(folder) / "out" / "sections" / "beam.json"
        return json.loads(file.read_text())["compliance"]


def beam_deflection(c, length, force):
    """Of the end of a cantilever under a force there: the integral of N^T c N / F with
    N = F (F_z = 1, M_x = L - y)."""
    return force * length * (c[2][2] + c[2][3] * length + c[3][3] * length ** 2 / 3)


def hair_scene(section, slenderness):
    """A force at the end, elements that double away from the clamp. (Short elements at
    the free end, too, cost digits from L/h = 1e4 on, with every theory.)"""
    length = float(slenderness)
    scene = cantilever_scene(section, length, "bending")
    scene["Body beam"]["Kinematics"] = graded(length, [(0., 0., .125)])
    return {key: value for key, value in scene.items() if not key.startswith("Line")}


def hairs():
    """Hairs: w of a cantilever's end, SV and LE-3 against Saint-Venant's beam (6 x 6
    compliance) and against each other; the first correction."""
    rows = []
    for name, section in (("[0/90/0]", laminate("0/90/0")),
                          ("[45/-45/0]", laminate("45/-45/0")),
                          ("sandwich", SANDWICH)):
        c = compliance(section)
        for slenderness in (1e2, 1e3, 1e4, 1e5, 1e6):
            runs = [TimedRun(hair_scene(section, slenderness), theory, 3)
                    for theory in ("SV", "LE-3")]
            # Of a unit of traction on b h = 2.
            beam = beam_deflection(c, slenderness, -2.)
            row, values = [name, f"{slenderness:.0e}"], []
            for run in runs:
                if run.failure:
                    row += [reason(run.failure), "", ""]
                    continue
                values.append(run.value("end_center", "uz"))
                error = values[-1] / beam - 1
                row += [f"{error:.2e}", f"{error * slenderness:.4f}",
                        f"{(run.summary['free_corrections'] or [0.])[0]:.0e}"]
            row += [f"{values[0] / values[1] - 1:.1e}"] if len(values) == 2 else [""]
            rows.append(row)
    table(["section", "L/h", "SV: w off the beam", "times L/h", "first correction",
           "LE-3: w off the beam", "times L/h", "first correction",
           "SV off LE-3"], rows)


# Walls, twisted and loaded beside their middle.

def twisted(scene, center, length, size):
    """@p scene as a cantilever under tractions that turn about @p center of its end."""
    scene = {key: value for key, value in scene.items() if not key.startswith("Load")}
    x, z = center
    scene["Support clamp"] = {"On": "beam: start"}
    scene["Load load"] = {"On": "beam: end",
                          "Force": f"-(z - {z}), 0, x - {x}"}
    scene["Body beam"] = {**scene["Body beam"], "Kinematics": graded(
        length, [(0., 0., size), (length, length, size)])}
    return scene


def wall_scenes():
    """Names, scenes, heights of sections, distances from both ends."""
    for name, scene, height, length, center in (
            ("double-T", double_t(), 20., 600., (10., 15.)),
            ("box", box(), 20., 400., (15., 10.)),
            ("half disc", half_disc(), 10., 200., (10., 4.)),
            ("Gmsh section", gmsh_sandwich(), 12., 300., (20., 6.))):
        yield name + ", eccentric patch", scene, height, length
        yield name + ", twisted", twisted(scene, center, length, 2.5), height, length


WALL_HEADER = ["scene", "theory", "fields a node", "DoFs", "of LE-3's", "CPU [s]", "w",
               "twist", *STRESSES, "worst farther than H / 2", "than 3 H"]


def walls(theories=("SV-6", "SV-10"), pick=""):
    """Walls: errors in % of LE-3, stresses farther than half a height from ends."""
    rows = []
    for name, scene, height, length in wall_scenes():
        if pick not in name:
            continue
        reference = TimedRun(scene, "LE-3")
        rows.append([name, "LE-3", "", reference.summary["dofs"], "",
                     f"{reference.cpu:.1f}"] + [""] * 10)
        for theory in theories:
            run = TimedRun(scene, theory, 3)
            share = reference.summary["dofs"] / run.summary["dofs"]
            rows.append(["", theory, run.fields(), run.summary["dofs"],
                         f"1/{share:.0f}", f"{run.cpu:.1f}"] +
                        wall_errors(run, reference, height, length))
    table(WALL_HEADER, rows)


def wall_errors(run, reference, height, length):
    stresses, inner = (stresses_off(run, reference, (far, length - far))
                       for far in (height / 2, 3 * height))
    probes = list(reference.probes)
    names = sorted({p.rsplit("_", 1)[0] for p in probes})
    pairs = [(n + "_left", n + "_right") for n in names]
    return ([percent(off(run, reference, probes)),
             percent(twist_off(run, reference, pairs)) if turns(reference, names)
             else ""] + stress_cells(stresses) +
            [worst_place(stresses), worst_place(inner)])


# Compact bodies.

def compact():
    """Compact bodies: both sides of the rule, a [0/90/0] block under a patch (axes of
    10 to 40 nodes) and two half cylinders; errors in % of LE-2."""
    rows = []
    for elements in (3, 5, 7, 10, 13):
        scene = plate_scene(laminate("0/90/0", across=8), 4., 0.5, 1.5,
                            half=0.25)
        scene["Body beam"]["Kinematics"] = {"Axis elements": elements}
        rows += compact_rows(f"block, {3 * elements + 1} nodes", scene, ["beam"])
    rows += compact_rows("prm/hertz.prm", ROOT / "prm" / "hertz.prm",
                         ["upper", "lower"], forced=False)
    table(["body", "theory", "fields a node", "DoFs", "CPU [s]", "memory [MB]", "u",
           "stresses"], rows)


def compact_rows(name, scene, bodies, forced=True):
    reference = TimedRun(scene, "LE-2")
    rows = [[name, "LE-2", "all"] + reference.cost_cells() + ["", ""]]
    for theory in ("SV-6", "SV-10"):
        for words in [[], at_their_word(theory, bodies)][:1 + forced]:
            run = TimedRun(scene, theory, 2, words)
            label = theory + (" at its word" if words else "")
            if run.failure:
                rows.append(["", label, reason(run.failure), "", f"{run.cpu:.2f}", "",
                             "", ""])
                continue
            rows.append(["", label, run.fields()] + run.cost_cells() +
                        [percent(off(run, reference, reference.probes)),
                         main_stresses_off(run, reference)])
    return rows


# Coupons.

def middle_force(run, contact):
    """Of the pressures on the middle half of the width: each row's force is spread
    over its share of the width, half way to the rows beside it."""
    across = {}
    for row in run.rows[contact]:
        x = round(float(row["x"]), 6)
        across[x] = across.get(x, 0.) + float(row["pressure"]) * float(row["area"])
    x = sorted(across)
    ends = [x[0], *((a + b) / 2 for a, b in zip(x, x[1:])), x[-1]]
    low, high = (3 * x[0] + x[-1]) / 4, (x[0] + 3 * x[-1]) / 4
    return sum(across[at] * max(0., min(b, high) - max(a, low)) / (b - a)
               for at, a, b in zip(x, ends, ends[1:]))


def flexure():
    """prm/flexure_test.prm: the quantities of doc/verification/flexure-test.md, off the richest run
    in %; LE-2's own error among them."""
    cases = [("SV-6", 2), ("SV-10", 2), ("LE-2", None), ("SV-6", 3), ("SV-10", 3),
             ("SV-16", 3), ("SV-24", 3), ("SV-40", 3)]
    file = ROOT / "prm" / "flexure_test.prm"
    runs = [TimedRun(file, theory, order) for theory, order in cases]
    reference = [run for run in runs if not run.failure][-1]
    rows = []
    for (theory, order), run in zip(cases, runs):
        label = theory + (f" of LE-{order}" if order else "")
        if run.failure:
            rows.append([label, reason(run.failure)] + [""] * 9)
            continue
        def far(value, of):
            return f"{100 * (value / of - 1):+.3f}"
        rows.append([label, run.fields()] + run.cost_cells() +
                    [far(run.force("c_nose"), reference.force("c_nose"))] +
                    [far(run.value(*q), reference.value(*q)) for q in
                     (("outer", "syy"), ("core", "syz"), ("below", "szz"))] +
                    [far(*(middle_force(r, "c_nose") for r in (run, reference))),
                     sum(int(r["active"]) for r in run.rows["c_nose"])])
    table(["theory", "fields a node", "DoFs", "CPU [s]", "memory [MB]", "force",
           "syy outer", "syz core", "szz 0.1 mm below", "force on the middle half",
           "rows that touch"], rows)


def three_plies(theories=("SV-6", "SV-10"), pick=""):
    """Coupons of three plies under three rollers, their fields not all kept: errors in
    % of LE-3."""
    for name, scene in coupons():
        if pick in name and "s, " not in name:
            contact_table(name, scene, theories, 3, word=["coupon"])


# The paper's scenes.

def beyond(value, truth):
    return f"{100 * (value / truth - 1):+.2f}"


PAPER = {
    "laminated_beams.prm": (
        ("upper", "lower"),
        [("upper_top", "uz", -0.1343571), ("lower_top", "uz", -0.0447856),
         ("upper_top", "uy", 0.000215696), ("lower_top", "uy", 0.000071908),
         ("upper_top", "syy", -133.65e6), ("lower_top", "syy", -44.55e6),
         ("middle", "fz", -43.111), ("press", "fz", -172.461)]),
    "sandwich.prm": (
        ("beam",),
        [("indentation", "fz", 754.5), ("quarter", "uy", 0.05529),
         ("bottom", "syy", 32.08), ("core", "syz", -0.2278), ("tension", "syy", 2.543),
         ("bottom", "uz", -3.832)])}


def quantity(run, name, column):
    if name in run.summary["contacts"]:
        return run.force(name)
    if name in run.summary["supports"]:
        return run.summary["supports"][name]["reaction"][2]
    return run.value(name, column)


def paper():
    """The paper's beams and sandwich against converged values, off in %; the whole
    scene, CPU seconds without start-up (the least of three)."""
    for file, (bodies, quantities) in PAPER.items():
        rows = []
        for theory, order in (("LE-1", None), ("LE-2", None), ("SV", 2), ("SV-3", 2),
                              ("SV-6", 2), ("SV-10", 2), ("SV-6", 3), ("SV-10", 3)):
            runs = [TimedRun(ROOT / "prm" / file, theory, order) for _ in range(3)]
            run = min(runs, key=lambda r: r.cpu)
            off_by = [beyond(quantity(run, name, column), truth)
                      for name, column, truth in quantities]
            rows.append([theory + (f" of LE-{order}" if order else ""), run.fields()] +
                        run.cost_cells() + off_by +
                        [f"{max(abs(float(x)) for x in off_by):.2f}"])
        print(f"prm/{file}\n")
        table(["theory", "fields a node", "DoFs", "CPU [s]", "memory [MB]"] +
              [f"{name} {column}" for name, column, _ in quantities] + ["worst"], rows)


# Growth.

def growth_plies(most=32):
    """CPU seconds over plies, [0/90]ns of the same height, L/h = 20, SV-6 against LE-2
    (up to @p most plies)."""
    rows, spent = [], {"SV-6": {}, "LE-2": {}}
    for n in (4, 8, 16, 32, 64, 128):
        section = {**laminate(f"[0/90]{n // 4}s", across=4), "Ply thickness": 1 / n}
        row = [n]
        for theory, seconds in spent.items():
            if theory == "LE-2" and n > most:
                row += [""] * 3
                continue
            run = TimedRun(plate_scene(section, 20, .5, 1.5), theory, 2)
            if run.failure:
                row += [""] * (theory == "SV-6") + [reason(run.failure), "", ""]
                continue
            seconds[n] = run.cpu
            row += [run.fields()] * (theory == "SV-6") + run.cost_cells()
        rows.append(row)
    rows.append(growth_exponents(spent))
    table(["plies", *GROWTH_HEADER], rows)


GROWTH_HEADER = ["SV-6: fields a node", "DoFs", "CPU [s]", "memory [MB]", "LE-2: DoFs",
                 "CPU [s]", "memory [MB]"]


def growth_exponents(spent):
    """Of the last three."""
    sv, le = (f"{exponent(list(s)[-3:], list(s.values())[-3:]):.2f}"
              for s in spent.values())
    return ["exponent of the last three", "", "", sv, "", "", le, ""]


def growth_length():
    """CPU seconds over length, [0/90/0], elements of 2 h, SV-6 against LE-2."""
    rows, spent = [], {"SV-6": {}, "LE-2": {}}
    for length in (10., 32., 100., 316., 1000.):
        scene = plate_scene(laminate("0/90/0"), length, .5, 1.5)
        y = length / 2
        scene["Body beam"]["Kinematics"] = graded(
            length, [(0., 0., .125), (length, length, .125), (y - .5, y + .5, .25)], 2.)
        row = [f"{length:g}"]
        for theory, seconds in spent.items():
            run = TimedRun(scene, theory, 2)
            seconds[length] = run.cpu
            row += [run.fields()] * (theory == "SV-6") + run.cost_cells()
        rows.append(row)
    rows.append(growth_exponents(spent))
    table(["length over h", *GROWTH_HEADER], rows)


def aims():
    """What Theory = SV-N is held to."""
    for part in (hairs, walls, compact, flexure, three_plies, paper, growth_plies,
                 growth_length):
        print(f"### {part.__doc__}\n")
        part()
