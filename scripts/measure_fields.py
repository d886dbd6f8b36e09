# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fields of the section's own (Theory = SV, SV-N, Theories) against all fields of the
section (LE-2, LE-3) on the same meshes; see scripts/measure."""

import json
import math
import re
import subprocess
import tempfile
from pathlib import Path

from measure_tools import ENVIRONMENT, PROGRAM, ROOT, read, table

ANYWHERE = (-math.inf, math.inf)
STRESSES = ("syy", "syz", "szz", "sxy", "sxx", "sxz")
CARBON = {"Library": "IM7-8552"}
MATERIALS = {"Material carbon": CARBON, "Material core": {"Isotropic": "171, 0.3"},
             "Material aluminium": {"Isotropic": "70000, 0.3"}}


# Scenes and runs.

def scene_text(scene):
    """@p scene, entries and {"Kind name": entries}, as a parameter file."""
    names, blocks = {}, []
    for key, value in scene.items():
        if isinstance(value, dict):
            kind, name = key.split()
            names.setdefault("Bodies" if kind == "Body" else kind + "s",
                             []).append(name)
            blocks += [f"subsection {key}"] + block_lines(value) + ["end"]
        else:
            blocks.append(f"set {key} = {value}")
    lists = [f"set {kind} = {', '.join(of_kind)}" for kind, of_kind in names.items()]
    return "\n".join(["set Write VTU = false"] + lists + blocks) + "\n"


def block_lines(entries):
    lines = []
    for key, value in entries.items():
        lines += ([f"subsection {key}"] + block_lines(value) + ["end"]
                  if isinstance(value, dict) else [f"set {key} = {value}"])
    return lines


class FieldRun:
    """A scene, a dictionary or a file, run with a theory: summary, probes, lines and
    the rows of its contacts."""

    def __init__(self, scene, theory, order=None, overrides=()):
        with tempfile.TemporaryDirectory() as folder:
            path = scene
            if isinstance(scene, dict):
                path = Path(folder) / "scene.prm"
                path.write_text(scene_text(scene))
            words = [PROGRAM, path, "--output", Path(folder) / "out"]
            for override in self.overrides(path, theory, order) + list(overrides):
                words += ["--set", override]
            done = subprocess.run(words, env=ENVIRONMENT, capture_output=True,
                                  text=True)
            if done.returncode:
                raise RuntimeError(f"{theory}: {done.stderr.strip()}")
            self.read(Path(folder) / "out")

    @staticmethod
    def overrides(path, theory, order):
        names = [line.split()[2] for line in Path(path).read_text().split("\n")
                 if line.startswith("subsection Body ")]
        orders = names if order and theory.startswith("SV") else []
        return (["Write VTU=false", f"Theory={theory}"] +
                [f"Body {name}/Kinematics/Section order={order}" for name in orders])

    def read(self, folder):
        self.summary = json.loads((folder / "summary.json").read_text())
        self.probes = {row["probe"]: row for row in read(folder / "probes.csv")}
        self.lines = {path.stem: read(path)
                      for path in sorted((folder / "lines").glob("*.csv"))}
        self.rows = {path.stem[len("contact_"):]: read(path)
                     for path in folder.glob("contact_*.csv")}

    def value(self, probe, column):
        return float(self.probes[probe][column])

    def force(self, contact):
        return self.summary["contacts"][contact]["force"][2]

    def fields(self):
        """As in "12 to 24" fields a node."""
        found = [re.search(r"(\d+( to \d+)?) fields a node", label)
                 for label in self.summary["theory"].values()]
        return "; ".join(match[1] if match else "all" for match in found)

    def costs(self):
        return [self.summary["dofs"], f"{self.summary['seconds']['total']:.2f}",
                f"{self.summary['peak_memory_mb']:.0f}"]


def graded(length, places, longest=math.inf):
    """Axis entries of elements that double away from @p places (begin, end, size)."""
    def size(y):
        return min(longest, *(fine if begin < y < end else
                              math.log(2) * (fine + max(begin - y, y - end, 0.))
                              for begin, end, fine in places))

    ends = sorted({0., length, *(y for place in places for y in place[:2])})
    breaks, parts = [], 200
    for begin, end in zip(ends, ends[1:]):
        marks = [begin]
        while marks[-1] < end:
            marks.append(min(end, marks[-1] + size(marks[-1]) / parts))
        n = max(1, round(len(marks) / parts))
        breaks += [marks[round(i * (len(marks) - 1) / n)] for i in range(1, n + 1)]
    breaks.pop()
    return {"Axis breaks": ", ".join(f"{y:.9g}" for y in breaks),
            "Axis elements": ", ".join("1" for _ in range(len(breaks) + 1))}


# What is compared.

def off(run, reference, probes, column="uz"):
    """The largest error of a column at @p probes over its largest value there."""
    largest = max(abs(reference.value(p, column)) for p in probes)
    return max(abs(run.value(p, column) - reference.value(p, column))
               for p in probes) / largest


def twist(run, left, right):
    return run.value(right, "uz") - run.value(left, "uz")


def twist_off(run, reference, pairs):
    largest = max(abs(twist(reference, *pair)) for pair in pairs)
    return max(abs(twist(run, *pair) - twist(reference, *pair))
               for pair in pairs) / largest


def stresses_off(run, reference, clear=ANYWHERE):
    """Of each stress of the lines and probes whose y is between those of @p clear: the
    largest error over the largest value, and where; nothing where it stays below a
    thousandth of the largest stress of all."""
    pairs = [(name, r, s) for name in reference.lines
             for r, s in zip(run.lines[name], reference.lines[name])]
    pairs += [(name, run.probes[name], reference.probes[name])
              for name in reference.probes]
    pairs = [(name, r, s) for name, r, s in pairs
             if clear[0] < float(s["y"]) < clear[1]]
    largest = {c: max(abs(float(s[c])) for _, _, s in pairs) for c in STRESSES}
    result = {}
    for c in STRESSES:
        if largest[c] > 1e-3 * max(largest.values()):
            error, name, y, z = max((abs(float(r[c]) - float(s[c])), name, s["y"],
                                     s["z"]) for name, r, s in pairs)
            result[c] = (error / largest[c], f"{name} y={float(y):.4g} "
                                             f"z={float(z):.3g}")
    return result


def percent(value):
    return f"{100 * value:.2g}"


def stress_cells(errors):
    return [percent(errors[c][0]) if c in errors else "" for c in STRESSES]


def worst_place(errors):
    c = max(errors, key=lambda c: errors[c][0])
    return f"{c} {percent(errors[c][0])} at {errors[c][1]}"


def padded(header, rows):
    table(header, [row + [""] * (len(header) - len(row)) for row in rows])


# B: responses against LE-3.

def laminate(layup, width=2., height=1., across=4, **more):
    n = len(layup.strip("[]").split("/"))
    return {"Width": width, "Layup": layup, "Ply thickness": height / n,
            "Ply materials": "carbon", "Cells across": across, **more}


SANDWICH = {"Width": 2., "Layup": "0/0/0", "Ply thickness": "0.1, 0.8, 0.1",
            "Ply materials": "carbon, core, carbon", "Cells per ply": "1, 2, 1",
            "Cells across": 4}


def patch(x0, x1, y0, y1):
    return f"if((x>{x0})&&(x<{x1})&&(y>{y0})&&(y<{y1}),1,0)"


def line_between(p, q, samples):
    start, end = ("beam: " + ", ".join(f"{c:.9g}" for c in r) for r in (p, q))
    return {"From": start, "To": end, "Samples": samples}


def materials_of(section):
    return {name: constants for name, constants in MATERIALS.items()
            if name.split()[1] in str(section)}


def beam_scene(section, length, load, box, axis, both=True, at=None, lines=()):
    """A clamped beam under @p load, probes across it at three places, lines through
    it: (name, from, to, samples). @p box is x0, x1, z: between which it is probed, and
    how high."""
    x0, x1, z = box
    scene = {"Units": "mm, N", "Rotation limit": "1e30",
             **materials_of(section), "Section beam": section,
             "Body beam": {"Section": "beam", "Length": length,
                           "Kinematics": axis},
             "Support clamp": {"On": "beam: ends" if both else "beam: start"},
             "Load load": {"On": "beam: top", **load}}
    at = at or {"middle": length / 2, "third": length / 3}
    for name, y in at.items():
        for side, x in (("left", x0), ("center", (x0 + x1) / 2), ("right", x1)):
            scene[f"Probe {name}_{side}"] = {"At": f"beam: {x}, {y:.9g}, {z}"}
    for name, p, q, samples in lines:
        scene[f"Line {name}"] = line_between(p, q, samples)
    return scene


def usual_lines(length, y_load, x_load, width, height, half):
    """Through the thickness under the load, beside it and far from it, along the
    axis at three heights."""
    places = {"under": y_load, "beside": y_load + half + 0.25 * height,
              "away": y_load - half - 1.5 * height}
    lines = [(name, (x_load, y, 0), (x_load, y, height), 11)
             for name, y in places.items()]
    lines += [(f"along_{k}", (x_load, 0, z), (x_load, length, z), 121)
              for k, z in enumerate((0.05 * height, 0.5 * height, 0.95 * height))]
    lines += [("across", (0, y_load + 0.1 * half, 0.7 * height),
               (width, y_load + 0.1 * half, 0.7 * height), 21)]
    return lines


def plate_scene(section, slenderness, x0, x1, half=0.5, whole=False, size=0.25):
    """A laminate of b = 2, h = 1, clamped at both ends, under a patch or all over."""
    length, y = float(slenderness), slenderness / 2
    pressure = "1" if whole else patch(x0, x1, y - half, y + half)
    places = [(0., 0., .125), (length, length, .125)]
    places += [] if whole else [(y - half, y + half, size)]
    # Under a load all over LE itself needs elements of a height: with those of seven
    # that grading alone leaves, szz and sxz of LE-3 are 20 to 50 % off.
    axis = graded(length, places, 1. if whole else math.inf)
    return beam_scene(section, length, {"Pressure": pressure}, (0., 2., 0.), axis,
                      lines=usual_lines(length, y, (x0 + x1) / 2, 2., 1., half))


def local_scenes():
    """Names, scenes, heights that distances from clamps are measured with."""
    middle, aside = (.5, 1.5), (1., 1.5)
    for layup, (x0, x1) in (("0/90/0", middle), ("45/-45/0", aside)):
        for slenderness in (20, 100):
            yield (f"[{layup}], L/h = {slenderness}, patch from x = {x0} to {x1}",
                   plate_scene(laminate(layup), slenderness, x0, x1), 1.)
        yield (f"[{layup}], L/h = 20, pressure all over the top",
               plate_scene(laminate(layup), 20, x0, x1, whole=True), 1.)
    yield "sandwich, L/h = 20, central patch", plate_scene(SANDWICH, 20, *middle), 1.
    yield "double-T, 600 long, eccentric patch on its flange", double_t(), 20.
    yield "box, 400 long, eccentric patch", box(), 20.
    yield "half disc, 200 long, patch on its arc", half_disc(), 10.
    yield "Gmsh sandwich of prm/sections, 300 long, patch", gmsh_sandwich(), 12.


def walls_scene(section, length, load, box, lines):
    y, half, size = length / 2, 5., 2.5
    axis = graded(length, [(0., 0., size), (length, length, size),
                           (y - half, y + half, size)])
    return beam_scene(section, length, load, box, axis, both=True, lines=lines)


def wall_lines(length, through, along):
    """Through walls at @p through, (x, z) from and to, at mid-span, beside it and at a
    third; along the axis at @p along, (x, z)."""
    lines = []
    for name, y in (("under", length / 2), ("beside", length / 2 + 10.),
                    ("away", length / 3)):
        lines += [(f"{name}_{k}", (p[0], y, p[1]), (q[0], y, q[1]), 21)
                  for k, (p, q) in enumerate(through)]
    lines += [(f"along_{k}", (x, 0, z), (x, length, z), 121)
              for k, (x, z) in enumerate(along)]
    return lines


def double_t():
    section = {"Shape": "double-T", "Width": 20., "Height": 30., "Web thickness": 2.,
               "Flange thickness": 3., "Cells along wall": 3, "Material": "aluminium"}
    lines = wall_lines(600., [((10., 0.), (10., 30.)), ((0., 28.5), (20., 28.5))],
                       [(10., 15.), (19., 28.5), (10., 1.), (9.3, 26.)])
    return walls_scene(section, 600., {"Pressure": patch(14., 20., 295., 305.)},
                       (0., 20., 0.), lines)


def box():
    section = {"Shape": "box", "Width": 30., "Height": 20.,
               "Wall thickness": "2, 2, 2, 2", "Cells along wall": 4,
               "Material": "aluminium"}
    lines = wall_lines(400., [((1., 0.), (1., 20.)), ((0., 19.), (30., 19.))],
                       [(1., 10.), (22., 19.5), (15., 1.), (29., 17.)])
    return walls_scene(section, 400., {"Pressure": patch(18., 26., 195., 205.)},
                       (0., 30., 0.), lines)


def half_disc():
    section = {"Shape": "half disc", "Radius": 10., "Finest cell": 2.5,
               "Sectors": 8, "Material": "aluminium"}
    lines = wall_lines(200., [((10., 0.), (10., 10.)), ((1., 2.), (19., 2.))],
                       [(10., 0.2), (10., 5.), (5., 2.), (10., 9.5)])
    return walls_scene(section, 200.,
                       {"On": "beam: arc", "Pressure": patch(10., 14., 95., 105.)},
                       (0., 20., 0.), lines)


def gmsh_sandwich():
    section = {"Shape": "file",
               "File": ROOT / "prm" / "sections" / "sandwich.msh",
               "Parts": "skin: carbon 45 | core: core"}
    lines = wall_lines(300., [((18., 0.), (18., 12.)), ((1., 11.), (39., 11.))],
                       [(18., 6.), (18., 11.5), (30., 1.), (39., 6.)])
    return walls_scene(section, 300., {"Pressure": patch(14., 22., 145., 155.)},
                       (0., 40., 0.), lines)


def beam_errors(run, reference, height):
    """Deflection, twist, stresses farther than half a height from clamps; where they
    are worst, and worst farther than three."""
    length = max(float(row["y"]) for rows in reference.lines.values() for row in rows)
    stresses, inner = (stresses_off(run, reference, (far, length - far))
                       for far in (height / 2, 3 * height))
    probes = list(reference.probes)
    names = sorted({p.rsplit("_", 1)[0] for p in probes})
    return ([percent(off(run, reference, probes)),
             percent(twist_off(run, reference,
                               [(n + "_left", n + "_right") for n in names]))
             if turns(reference, names) else ""] + stress_cells(stresses) +
            [worst_place(stresses), worst_place(inner)])


def turns(run, names):
    largest = max(abs(run.value(n + "_center", "uz")) for n in names)
    return any(abs(twist(run, n + "_left", n + "_right")) > 1e-4 * largest
               for n in names)


HEADER = ["theory", "fields a node", "DoFs", "seconds", "memory [MB]", "w", "twist",
          *STRESSES, "worst", "worst beyond 3 H"]


def local(theories=("SV", "SV-3", "SV-6", "SV-10", "LE-2"), pick=""):
    """B. Local loads: errors in % of LE-3 (Section order = 3)."""
    for name, scene, height in local_scenes():
        if pick not in name:
            continue
        reference = FieldRun(scene, "LE-3")
        rows = [["LE-3", ""] + reference.costs()]
        for theory in theories:
            run = FieldRun(scene, theory, order=3)
            rows.append([theory, run.fields()] + run.costs() +
                        beam_errors(run, reference, height))
        print(f"{name}\n")
        padded(HEADER, rows)


# C: one body on rollers.

def coupon(section, width, height, span, radii, press, across_cells, elements):
    """Three-point bending: span between rollers of radii[1], the nose of radii[0]
    goes down by @p press; @p elements: half the length and the number of the fine
    elements under nose and rollers."""
    length, margin = 1.2 * span, 0.1 * span
    half, n = elements
    middle, right = length / 2, length - margin
    breaks = [margin - half, margin + half, middle - half, middle + half,
              right - half, right + half]
    scene = {"Units": "mm, N", **materials_of(section),
             "Section laminate": {"Width": width, "Cells across": across_cells,
                                  **section},
             "Body coupon": {"Section": "laminate", "Length": length,
                             "Stabilization": "1e-7",
                             "Kinematics": {
                                 "Axis elements": f"3, {n}, 8, {n}, 8, {n}, 3",
                                 "Axis breaks": ", ".join(f"{y:.9g}"
                                                          for y in breaks)}}}
    for name, y, z, radius, u in (
            ("nose", middle, height + radii[0], radii[0], f"0, 0, {-press}"),
            ("left", margin, -radii[1], radii[1], "0, 0, 0"),
            ("right", right, -radii[1], radii[1], "0, 0, 0")):
        scene[f"Obstacle {name}"] = {"Shape": "cylinder", "Axis": "1, 0, 0",
                                     "Through": f"0, {y:.9g}, {z:.9g}",
                                     "Radius": radius, "u": u}
        scene[f"Contact c_{name}"] = {
            "First": f"coupon: {'top' if name == 'nose' else 'bottom'}",
            "Second": name, "Discretization": "surface to surface",
            "Enforcement": "exact", "Search distance": max(radii)}
    for name, y, u in (("guide", middle, "0, 0, free"),
                       ("guide_y", margin, "0, free, free")):
        scene[f"Support {name}"] = {"On": "coupon: point", "u": u,
                                    "At": f"{width / 2}, {y:.9g}, {height / 2}"}
    quarter = (margin + middle) / 2
    for name, y, z in (("middle", middle, 0.), ("quarter", quarter, 0.),
                       ("left_edge", quarter, 0.), ("outer", middle, 0.02 * height),
                       ("core", quarter, 0.49 * height),
                       ("below", middle, 0.9 * height),
                       ("beside", middle + 0.4 * height, 0.7 * height),
                       ("upper", quarter, 0.98 * height)):
        x = 0. if name == "left_edge" else width / 2
        scene[f"Probe {name}"] = {"At": f"coupon: {x}, {y:.9g}, {z:.9g}"}
    return scene


def coupons():
    """Names and scenes."""
    for layup in ("0/90/0", "45/-45/0"):
        section = {"Layup": layup, "Ply thickness": 1., "Ply materials": "carbon"}
        yield (f"[{layup}], 3 thick, span 60",
               coupon(section, 10., 3., 60., (5., 5.), 0.5, 4, (2., 6)))
    section = {"Layup": "0/0/0", "Ply thickness": "0.5, 4, 0.5",
               "Ply materials": "carbon, core, carbon", "Cells per ply": "1, 4, 1"}
    yield ("sandwich, 5 thick, span 100",
           coupon(section, 10., 5., 100., (5., 5.), 0.5, 4, (2., 6)))
    section = {"Layup": "[90/0/30/-30]2s", "Ply thickness": 0.2,
               "Ply materials": "carbon"}
    yield ("[90/0/30/-30]2s, 3.2 thick, span 80",
           coupon(section, 20., 3.2, 80., (5., 2.), 2., 6, (1., 6)))


def mean_pressure(run, reference, contact, center=0.25):
    """Mean over those rows that press in @p reference, near the middle across; how
    many press."""
    pairs = [(r, s) for r, s in zip(run.rows[contact], reference.rows[contact])
             if int(s["active"])]
    x = [float(s["x"]) for s in reference.rows[contact]]
    middle, reach = (min(x) + max(x)) / 2, center * (max(x) - min(x))
    # Of two crossed bodies only edges press.
    pairs = [(r, s) for r, s in pairs
             if abs(float(s["x"]) - middle) <= reach] or pairs
    area = sum(float(s["area"]) for _, s in pairs)
    return (sum(float(r["pressure"]) * float(s["area"]) for r, s in pairs) / area,
            sum(int(r["active"]) for r in run.rows[contact]))


def contact_errors(run, reference, contacts, clear):
    """Force, deflection, stresses, pressure of each contact."""
    stresses = stresses_off(run, reference, clear)
    forces = [abs(run.force(c) / reference.force(c) - 1) for c in contacts]
    pressures, active = [], []
    for c in contacts:
        mean, n = mean_pressure(run, reference, c)
        truth, m = mean_pressure(reference, reference, c)
        pressures.append(percent(abs(mean / truth - 1)))
        active.append(f"{n}/{m}")
    return ([percent(max(forces)), percent(off(run, reference, reference.probes))] +
            stress_cells(stresses) + [", ".join(pressures), ", ".join(active),
                                      worst_place(stresses)])


def at_their_word(theory, bodies):
    """@p theory as `Theories`, of which no body keeps all fields for having nothing to
    win."""
    return [f"Body {body}/Kinematics/Theories={theory}" for body in bodies]


CONTACT_HEADER = ["theory", "fields a node", "DoFs", "seconds", "memory [MB]", "force",
                  "w", *STRESSES, "pressures", "active rows", "worst stress"]


def contact_table(name, scene, theories, order, overrides=(), clear=ANYWHERE, word=()):
    """The bodies @p word have the theory as `Theories`, which never keep all fields."""
    reference = FieldRun(scene, f"LE-{order}", overrides=overrides)
    contacts = sorted(reference.rows)
    rows = [[f"LE-{order}", ""] + reference.costs()]
    for theory in theories:
        run = FieldRun(scene, theory, order,
                       list(overrides) + at_their_word(theory, word))
        rows.append([theory, run.fields()] + run.costs() +
                    contact_errors(run, reference, contacts, clear))
    print(f"{name}; contacts {', '.join(contacts)}, the force on the first "
          f"{reference.force(contacts[0]):.6g}\n")
    padded(CONTACT_HEADER, rows)


def rollers(theories=("SV-3", "SV-6", "SV-10"), pick=""):
    """C. Coupons on rollers: errors in % of LE-2 (Section order = 2)."""
    for name, scene in coupons():
        if pick in name:
            contact_table(name, scene, theories, 2)


# D: two bodies.

def disc_on_laminate():
    """A half disc across a laminate, arc down; its clamped ends go down."""
    return {"Units": "mm, N", "Material carbon": CARBON,
            "Material aluminium": MATERIALS["Material aluminium"],
            "Section disc": {"Shape": "half disc", "Radius": 4., "Finest cell": 1.,
                             "Sectors": 8, "Material": "aluminium"},
            "Section strip": {"Width": 12., "Layup": "0/90/0", "Ply thickness": 1.,
                              "Ply materials": "carbon", "Cells across": 4},
            "Body disc": {"Section": "disc", "Length": 40., "Axis": "1, 0, 0",
                          "Up": "0, 0, -1", "Origin": "-14, 36, 7",
                          "Kinematics": {"Axis elements": "4, 6, 4",
                                         "Axis breaks": "14, 26"}},
            "Body strip": {"Section": "strip", "Length": 80.,
                           "Kinematics": {"Axis elements": "1, 4, 6, 4, 1",
                                          "Axis breaks": "1, 38, 42, 79"}},
            "Support clamps": {"On": "strip: ends"},
            "Support press": {"On": "disc: ends", "u": "0, 0, -0.5"},
            "Contact nip": {"First": "strip: top", "Second": "disc: arc",
                            "Discretization": "surface to surface",
                            "Enforcement": "exact", "Search distance": 2.},
            "Probe strip_bottom": {"At": "strip: 6, 40, 0.1"},
            "Probe strip_quarter": {"At": "strip: 6, 20, 1.4"},
            "Probe strip_edge": {"At": "strip: 0, 20, 0.1"},
            "Probe disc_middle": {"At": "disc: 6, 40, 6.8"},
            "Probe disc_quarter": {"At": "disc: -6, 40, 5"}}


def bodies(theories=("SV-6", "SV-10"), pick=""):
    """D. Two bodies and a sandwich under a roller: errors in % of LE-2 (Section
    order = 2)."""
    prm, scenes = ROOT / "prm", ROOT / "tests" / "scenes"
    for name, scene, overrides, clear in (
            ("prm/laminated_beams.prm", prm / "laminated_beams.prm", [], ANYWHERE),
            ("tests/scenes/crossed_beams.prm", scenes / "crossed_beams.prm",
             crossed_probes(), ANYWHERE),
            ("half disc on [0/90/0]", disc_on_laminate(), [], ANYWHERE),
            # Farther than half a height from the clamps.
            ("prm/sandwich.prm", prm / "sandwich.prm", [], (18., 482.))):
        if pick in name:
            contact_table(name, scene, theories, 2, overrides, clear)


def crossed_probes():
    """Probes, and axes fine enough to have a far part."""
    places = {"above": "upper: 0.25, 3, 0.6", "aside": "upper: -0.75, 3, 0.42",
              "below": "lower: 0.25, 3, 0.02", "beside": "lower: 0.25, 1.5, 0.2"}
    return (["Probes=" + ", ".join(places)] +
            [f"Probe {name}/At={at}" for name, at in places.items()] +
            ["Body upper/Kinematics/Axis elements=4, 6, 4",
             "Body lower/Kinematics/Axis elements=4, 7, 4"])


# E: lists by hand, nested spaces.

def by_hand():
    """E. Theories = LE-2, SV-6, LE-2 against LE-2 all along; nested energies."""
    scene, height = plate_scene(laminate("45/-45/0"), 20, 1., 1.5), 1.
    reference = FieldRun(scene, "LE-2")
    rows = [["LE-2", ""] + reference.costs()]
    for theories, breaks in (("SV-6", ""), ("LE-2, SV-6, LE-2", "3, 17"),
                             ("LE-2, SV-6, LE-2, SV-6, LE-2", "3, 9, 11, 17"),
                             ("SV-6, LE-2, SV-6", "9, 11"),
                             ("LE-2, SV, LE-2", "7, 13"), ("LE-2", "")):
        pieces = [f"Body beam/Kinematics/Theories={theories}",
                  f"Body beam/Kinematics/Theory breaks={breaks}"] if breaks else []
        run = FieldRun(scene, "SV-6" if breaks else theories, 2, pieces)
        rows.append([f"{theories} ({breaks})", run.fields()] + run.costs() +
                    beam_errors(run, reference, height))
    padded(HEADER, rows)
    nested()


def nested():
    """Strain energies under given loads: those of a larger space are no smaller. SV-3
    and SV-6 both hold SV, but neither the other."""
    coupled, rows = laminate("45/-45/0"), []
    for name, scene in (("[45/-45/0], patch", plate_scene(coupled, 20, 1., 1.5)),
                        ("[45/-45/0], all over the top",
                         plate_scene(coupled, 20, 1., 1.5, whole=True)),
                        ("sandwich, patch", plate_scene(SANDWICH, 20, .5, 1.5)),
                        ("double-T", double_t())):
        energies = [FieldRun(scene, theory, 2).summary["energy"]
                    for theory in ("SV", "SV-3", "SV-6", "SV-10", "LE-2")]
        steps = [b / a - 1 for a, b in zip(energies, energies[1:])]
        rows.append([name] + [f"{energy:.10e}" for energy in energies] +
                    ["yes" if min(steps) > -1e-10 else f"no: {min(steps):.1e}"])
    table(["scene", "SV", "SV-3", "SV-6", "SV-10", "LE-2", "each no less"], rows)


# A: Saint-Venant fields alone, slender and not.

def cantilever_scene(section, slenderness, load):
    """b = 2, h = 1, clamped at its start, loaded at its end."""
    length = float(slenderness)
    force = "0, 0, -1" if load == "bending" else "-(z-0.5), 0, x-1"
    lines = [(f"middle_{k}", (x, 0.5 * length, 0.), (x, 0.5 * length, 1.), 11)
             for k, x in enumerate((0.9, 1.6))]
    places = [(0., 0., .125), (length, length, .125)]
    return beam_scene(section, length, {"On": "beam: end", "Force": force},
                      (0., 2., 0.5), graded(length, places), both=False,
                      at={"end": length}, lines=lines)


def central():
    """A. SV against LE-3, a cantilever: errors in % by slenderness."""
    slenderness = (5, 20, 100, 1000)
    rows = []
    for name, section in (("[0/90/0]", laminate("0/90/0")),
                          ("[45/-45/0]", laminate("45/-45/0")),
                          ("sandwich", SANDWICH)):
        for load in ("bending", "torsion"):
            rows += central_rows(name, section, load, slenderness)
    table(["section", "load", "error of", *(f"L/h = {s}" for s in slenderness)], rows)


def central_rows(name, section, load, slenderness):
    probes, pair = ["end_center"], ("end_left", "end_right")
    found = {"w": [], "twist": [], "stresses at mid-span": []}
    for s in slenderness:
        scene = cantilever_scene(section, s, load)
        reference, run = FieldRun(scene, "LE-3"), FieldRun(scene, "SV", 3)
        turn = abs(twist(reference, *pair))
        deflection = abs(reference.value("end_center", "uz"))
        found["w"].append(percent(off(run, reference, probes))
                          if deflection > 1e-3 * turn else "")
        found["twist"].append(percent(twist_off(run, reference, [pair]))
                              if turn > 1e-3 * deflection else "")
        found["stresses at mid-span"].append(
            main_stresses_off(run, reference))
    return [[name, load, what] + values for what, values in found.items()
            if any(values)]


def main_stresses_off(run, reference):
    """Of the lines, over the largest normal and the largest shear stress of them,
    unless that is a thousandth of the other; the larger of both errors."""
    pairs = [(r, s) for name in reference.lines
             for r, s in zip(run.lines[name], reference.lines[name])]
    kinds = ("sxx", "syy", "szz"), ("sxy", "syz", "sxz")
    largest = [max(abs(float(s[c])) for _, s in pairs for c in kind) for kind in kinds]
    return percent(max(max(abs(float(r[c]) - float(s[c])) for r, s in pairs
                           for c in kind) / value for kind, value in
                       zip(kinds, largest) if value > 1e-3 * max(largest)))


def exponent(x, y):
    """Of y = c x^a, by least squares of logarithms."""
    u, v = [math.log(t) for t in x], [math.log(t) for t in y]
    mu, mv = sum(u) / len(u), sum(v) / len(v)
    return (sum((p - mu) * (q - mv) for p, q in zip(u, v)) /
            sum((p - mu) ** 2 for p in u))


def fields():
    """Fields of the section's own (SV, SV-N, Theories) against LE-N: errors in %."""
    for part in (central, local, rollers, bodies, by_hand):
        print(f"### {part.__doc__}\n")
        part()
