# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of doc/verification/laminated-beams.md, doc/verification/contact.md, doc/verification/theories.md,
doc/theory/stable-basis.md and doc/verification/parallel.md; see scripts/measure."""

import itertools
import json
import math
import sys
from concurrent.futures import ThreadPoolExecutor

from measure_aims import (aims, compact, flexure, growth_length, growth_plies, hairs,
                          paper, three_plies, walls)
from measure_ablation import ablation, ablation_passes, ablation_unseen
from measure_bars import bars, bars_richer
from measure_corners import corners
from measure_beyond import beyond
from measure_fields import fields
from measure_foreseen import foreseen, plans
from measure_rates import rates
from measure_solids import calculix, hanging, million, solids
from measure_friction import friction, rubbing
from measure_rubbing import cattaneo, coupon, crossed_cylinders, punch, rubbed, rubbing_cost, \
    rubbing_full
from measure_turning import rubbing_turning, thin, turning
from measure_rollers import rollers
from measure_leaves import leaves
from measure_tolerances import c3d20r, indentation, templates, tolerances
from measure_tools import POINT, ROOT, Run, axis, drawing, table


def variants():
    """Line and point, coarse to fine: displacements, stresses, forces."""
    graded = axis("8, 6, 10, 6, 8", "0.8, 0.95, 1.05, 1.2")
    cases = [
        ("line, 20 B4 x 4x3 L9", []),
        ("line, 20 B4 x 4x3 L16", ["Theory=LE-3"]),
        ("line, 38 graded B4 x 8x3 L9", ["Section strip/Cells across=8"] + graded),
        ("point, 20 B4 x 4x3 L9", POINT),
        ("point, 20 B4 x 16x3 L9", POINT + ["Section strip/Cells across=16"]),
        ("point, 38 graded B4 x 8x3 L9",
         POINT + ["Section strip/Cells across=8"] + graded)]
    rows = []
    for name, overrides in cases:
        run = Run("laminated_beams.prm", overrides)
        up, low = run.probes["upper_top"], run.probes["lower_top"]
        rows.append([name, run.summary["dofs"]] +
                    [f"{1e3 * float(p[c]):.{d}f}" for c, d in (("uz", 4), ("uy", 5))
                     for p in (up, low)] +
                    [f"{1e-6 * float(p['syy']):.2f}" for p in (up, low)] +
                    [f"{run.contact_force():.3f}",
                     f"{-run.summary['supports']['press']['reaction'][2]:.3f}"])
    table(["mesh", "DoFs", "u_z upper [mm]", "lower", "u_y upper [mm]", "lower",
           "sigma_yy upper [MPa]", "lower", "contact [N]", "press [N]"], rows)


def mean(rows, column):
    s = [float(row["s"]) for row in rows]
    v = [float(row[column]) for row in rows]
    steps = zip(s, s[1:], v, v[1:])
    return sum((b - a) * (p + q) / 2 for a, b, p, q in steps) / (s[-1] - s[0])


def shear():
    """Mean over the width of sigma_yz of the upper beam against equilibrium."""
    rows = []
    for name, theory, cells in (("L9", 2, 1), ("L9", 2, 3), ("L16", 3, 1),
                                ("25-node cell", 4, 1)):
        run = Run("laminated_beams_shear.prm",
                  [f"Theory=LE-{theory}", f"Section strip/Cells per ply={cells}"])
        row = [f"{cells} {name} a ply", run.summary["dofs"]]
        for line, equilibrium in (("upper_interface_1", 297900.),
                                  ("upper_interface_2", 297900.),
                                  ("upper_middle", 299900.)):
            value = -mean(run.lines[line], "syz")
            row.append(f"{value / 1e6:.4f} ({100 * (value / equilibrium - 1):+.2f} %)")
        jumps = {}
        for sample in run.lines["upper_thickness"]:
            jumps.setdefault(sample["z"], []).append(float(sample["syz"]))
        jump = max(abs(v[0] - v[1]) for v in jumps.values() if len(v) == 2)
        rows.append(row + [f"{100 * jump / 0.2979e6:.1f} %",
                           f"{run.summary['seconds']['total']:.1f}"])
    table(["mesh", "DoFs", "interface, ply 1 side [MPa]", "interface, ply 2 side",
           "mid-plane", "jump at x = 0.05", "seconds"], rows)


def penalty():
    """The contact force over the penalty per node, both strategies."""
    best = Run("laminated_beams.prm", []).contact_force()
    rows = []
    for exponent in range(2, 21, 2):
        row = [f"1e{exponent}"]
        for strategy in ("condensed", "full"):
            run = Run("laminated_beams.prm",
                      [f"Contact strategy={strategy}", "Contact middle/Penalty per=node",
                       f"Contact middle/Penalty=1e{exponent}"])
            row += ([f"fails: {run.failure.splitlines()[0][:60]}", ""]
                    if run.failure else
                    [f"{run.contact_force() / best - 1:+.1e}",
                     run.summary["iterations"][0]])
        rows.append(row)
    print(f"Contact force with Penalty = auto: {best:.6f} N\n")
    table(["penalty [N/m]", "condensed: force off auto by", "iterations",
           "full: force off auto by", "iterations"], rows)


def cost():
    """A run with contact over one linear solution of the same bodies."""
    rows = []
    for across, deep, along in ((2, 8, 9), (6, 4, 8), (10, 4, 16)):
        mesh = [f"Section block/Cells across={across}",
                f"Section block/Cells per ply={deep}"] + axis(along)
        # `full` takes minutes with a thousand rows.
        for strategy in ("condensed", "full") if across < 10 else ("condensed",):
            run = Run("../tests/scenes/blocks_in_contact.prm",
                      mesh + [f"Contact strategy={strategy}"])
            seconds = run.summary["seconds"]
            if strategy == "condensed":
                # What the bodies cost by themselves.
                linear = sum(seconds[phase] for phase in
                             ("setup", "assembly", "factorization", "solve"))
                rows.append([run.summary["dofs"],
                             run.summary["contacts"]["faces"]["active"],
                             f"{linear:.2f}"])
            whole = sum(seconds[phase] for phase in
                        ("setup", "assembly", "factorization", "solve", "contact"))
            rows[-1] += [sum(run.summary["iterations"]), f"{seconds['contact']:.2f}",
                         f"{whole / linear:.2f}"]
    rows[-1] += ["", "", ""]
    table(["DoFs", "active rows", "linear solution [s]",
           "condensed: iterations", "contact [s]", "run / linear",
           "full: iterations", "contact [s]", "run / linear"], rows)


def methods():
    """Which method solved the contact problems of all scenes of the last ctest run."""
    names = ("Newton", "interior point", "compliance")
    counts = {kind: [0] * 4 for kind in ("linear", "large rotations", "friction, linear",
                                         "friction, large rotations")}
    for path in sorted((ROOT / "build" / "tests").rglob("summary.json")):
        try:
            summary = json.loads(path.read_text())
        except ValueError:  # damaged on purpose by a test
            continue
        problems = summary.get("contact_problems", {})
        if not any(problems.values()):
            continue
        rubs = any("friction" in contact for contact in summary["contacts"].values())
        large = summary["rotations"] == "large"
        row = counts[("friction, " if rubs else "") + ("large rotations" if large else "linear")]
        row[0] += 1
        for k, name in enumerate(names):
            row[1 + k] += problems[name]
    table(["scenes with contact", "runs"] + list(names),
          [[kind] + row for kind, row in counts.items()])


def crossed_mesh(degrees, cells):
    """Overrides of crossed_beams.prm: the upper beam turned about the middle of the
    lower one, and so many cells across, deep and in each part of the axis."""
    sine, cosine = (f(math.radians(degrees)) for f in (math.sin, math.cos))
    corner = (0.25 - 0.15 * cosine - 2 * sine, 3 + 0.15 * sine - 2 * cosine)
    return [f"Body upper/Axis={sine!r}, {cosine!r}, 0",
            f"Body upper/Origin={corner[0]!r}, {corner[1]!r}, 0.4",
            f"Section above/Cells across={cells}",
            f"Section below/Cells across={cells + 1}",
            f"Section above/Cells per ply={cells}",
            f"Section below/Cells per ply={cells}",
            f"Body upper/Kinematics/Axis elements={cells}, {cells}, {cells}",
            f"Body lower/Kinematics/Axis elements={cells}, {cells + 1}, {cells}"]


def crossed():
    """The force between crossed beams over the mesh, and how far it is off that by
    surface to surface on the finest."""
    kinds = ("surface to surface", "node to surface")
    rows = []
    for degrees in (90, 45):
        runs = {(cells, kind): Run("../tests/scenes/crossed_beams.prm",
                                   crossed_mesh(degrees, cells) +
                                   [f"Contact cross/Discretization={kind}"])
                for cells in (1, 2, 3, 4, 6, 8) for kind in kinds}
        force = {key: -run.summary["contacts"]["cross"]["force"][2]
                 for key, run in runs.items()}
        finest = force[8, kinds[0]]
        for cells in (1, 2, 3, 4, 6, 8):
            row = [degrees, cells, runs[cells, kinds[0]].summary["dofs"]]
            for kind in kinds:
                contact = runs[cells, kind].summary["contacts"]["cross"]
                off = 100 * (force[cells, kind] / finest - 1)
                row += [contact["active"],
                        f"{force[cells, kind]:.6f}" +
                        (f" ({off:+.2f} %)" if off != 0 else "")]
            rows.append(row)
    table(["degrees", "cells", "DoFs", "surface to surface: active rows", "force",
           "node to surface: active rows", "force"], rows)


def phases():
    """Whole-process seconds with all output, the fastest and the slowest of five."""
    runs = [Run("laminated_beams.prm", [], vtu=True) for _ in range(5)]
    names = ["setup", "assembly", "factorization", "solve", "contact", "output",
             "total"]
    rows = [[name] + [f"{pick(r.summary['seconds'][name] for r in runs):.3f}"
                      for pick in (min, max)] for name in names]
    rows.append(["whole process"] + [f"{pick(r.wall for r in runs):.3f}"
                                     for pick in (min, max)])
    table(["phase", "fastest [s]", "slowest [s]"], rows)
    ratio = [r.summary["seconds"]["contact"] / r.summary["seconds"]["factorization"]
             for r in runs]
    print(f"contact over factorization: {min(ratio):.2f} to {max(ratio):.2f}; "
          f"peak memory {runs[0].summary['peak_memory_mb']:.0f} MB; condition "
          f"estimate {runs[0].summary['condition_estimate']:.1e}\n")


def parallel():
    """Two laminated beams on one and two processes, by phase."""
    mesh = ["Section strip/Cells across=12"] + axis(30)
    alone = Run("laminated_beams.prm", mesh).summary["seconds"]["total"]
    with ThreadPoolExecutor() as pool:
        both = list(pool.map(lambda _: Run("laminated_beams.prm", mesh), range(2)))
    at_once = max(run.summary["seconds"]["total"] for run in both)
    print(f"What two processes can gain here: two separate runs at once take "
          f"{at_once / alone:.2f} times as long as one (1 on two idle cores, 2 where "
          "they get no more than one).\n")
    for across, elements in ((16, 70), (4, 870)):
        mesh = [f"Section strip/Cells across={across}"] + axis(elements)
        rows = []
        for processes, solver in ((1, "cholmod"), (1, "mumps"), (2, "mumps")):
            run = Run("laminated_beams.prm", mesh + [f"Linear solver={solver}"],
                      processes=processes)
            if run.failure:
                rows.append([processes, solver, run.failure.splitlines()[0][:60]])
                continue
            seconds = run.summary["seconds"]
            factors = sum(body["solver"]["factor_non_zeros"]
                          for body in run.summary["bodies"].values())
            rows.append([processes, solver] +
                        [f"{seconds[phase]:.1f}" for phase in
                         ("setup", "assembly", "factorization", "solve", "contact",
                          "output", "total")] +
                        [f"{factors:.2e}"] +
                        [f"{run.summary[key] / 1024:.1f}" for key in
                         ("peak_memory_mb", "peak_memory_of_all_mb")])
            dofs = run.summary["dofs"]
        print(f"{dofs} DoFs, {across} x 3 L9 and {elements} B4 each, seconds:\n")
        table(["processes", "solver", "setup", "assembly", "factorization", "solve",
               "contact", "output", "total", "factors' non-zeros",
               "peak memory, process with most [GB]", "all [GB]"], rows)


def theories():
    """Sec. 4.2 by theory: accuracy, DoFs, seconds and memory (fastest of three)."""
    rows = []
    for theory in ("EBBT", "TBT", "TE-1", "TE-2", "TE-3", "TE-4", "TE-6", "TE-8",
                   "LE-1", "LE-2", "LE-3"):
        runs = [Run("laminated_beams.prm", [f"Theory={theory}"]) for _ in range(3)]
        run = min(runs, key=lambda r: r.wall)
        up, low = run.probes["upper_top"], run.probes["lower_top"]
        shear_mean = [float(row["syz"]) for row in run.lines["upper_thickness"]]
        rows.append([theory, run.summary["dofs"]] +
                    [f"{1e3 * float(p['uz']):.3f}" for p in (up, low)] +
                    [f"{1e3 * float(up['uy']):.5f}",
                     f"{1e-6 * float(up['syy']):.2f}",
                     f"{1e-6 * max(map(abs, shear_mean)):.3f}",
                     f"{run.contact_force():.3f}", f"{run.wall:.2f}",
                     f"{run.summary['peak_memory_mb']:.0f}"])
    table(["theory", "DoFs", "u_z upper [mm]", "u_z lower", "u_y upper [mm]",
           "sigma_yy upper [MPa]", "largest sigma_yz [MPa]", "contact [N]",
           "whole process [s]", "memory [MB]"], rows)


SECTIONS = {"square": (1., 1.), "laminate": (10., 3.), "sandwich": (5., 1.)}


def flexibility(section, theory, load, slenderness):
    """u_z / L^3 of the tip under 1 N, or the twist per length under 1 N mm; the
    first correction of the strain-first refinement; the condition estimate."""
    width, height = SECTIONS[section]
    length = slenderness * height
    if load == "bending":
        force = f"0, 0, {1 / (width * height)!r}"
    else:
        polar = width * height * (width ** 2 + height ** 2) / 12
        force = (f"-(z - {height / 2!r}) / {polar!r}, 0, "
                 f"(x - {width / 2!r}) / {polar!r}")
    z = height / 2
    places = {"tip": (width / 2, length), "quarter_left": (0, length / 4),
              "quarter_right": (width, length / 4), "late_left": (0, 3 * length / 4),
              "late_right": (width, 3 * length / 4)}
    run = Run("cantilever.prm",
              [f"Theory={theory}", f"Body beam/Section={section}",
               f"Body beam/Length={length!r}", f"Load tip/Force={force}",
               "Rotation limit=1e30"] +
              [f"Probe {name}/At=beam: {x!r}, {y!r}, {z!r}"
               for name, (x, y) in places.items()])
    if run.failure:
        return None
    u = {name: float(row["uz"]) for name, row in run.probes.items()}
    value = (u["tip"] / length ** 3 if load == "bending" else
             (u["late_right"] - u["late_left"] - u["quarter_right"] +
              u["quarter_left"]) / (width * length / 2))
    return (value, (run.summary["free_corrections"] or [0.])[0],
            run.summary["condition_estimate"])


def stability():
    """A cantilever of 4 B4 from a block to a hair: what a + b (h/L)^2, fitted at
    L/h = 4e3 and 8e3, does not explain, and (digits lost before refinement).
    Draws doc/pictures/stability.png."""
    lengths = (2, 10, 100, 1e3, 1e4, 1e5, 1e6)
    rows, curves = [], {}
    for section, load, theory in itertools.product(
            SECTIONS, ("bending", "torsion"), ("EBBT", "TBT", "TE-2", "LE-2")):
        if load == "torsion" and theory in ("EBBT", "TBT"):
            continue  # they cannot twist
        near, far = (flexibility(section, theory, load, s)[0] for s in (4e3, 8e3))
        b = (near - far) / (4e3 ** -2 - 8e3 ** -2)
        a = near - b / 4e3 ** 2
        found = [flexibility(section, theory, load, s) for s in lengths]
        off = [None if f is None else abs(f[0] / (a + b / s ** 2) - 1)
               for f, s in zip(found, lengths)]
        curves[section, load, theory] = off
        rows.append([section, load, theory] +
                    ["refused" if f is None else f"{o:.0e} ({f[1]:.0e})"
                     for f, o in zip(found, off)] +
                    [f"{[f for f in found if f][-1][2]:.0e}"])
    table(["section", "load", "theory"] + [f"L/h = {s:g}" for s in lengths] +
          ["condition at the last"], rows)
    draw_stability(lengths, curves)


def draw_stability(lengths, curves):
    plt = drawing()
    figure, panels = plt.subplots(1, 2, figsize=(8.4, 4.2), sharey=True)
    marks = dict(zip(("EBBT", "TBT", "TE-2", "LE-2"), "sv^o"))
    colors = dict(zip(SECTIONS, ("#0072B2", "#D55E00", "#009E73")))
    for panel, load in zip(panels, ("bending", "torsion")):
        for (section, kind, theory), off in curves.items():
            if kind == load:
                # Zero has no place on a logarithmic axis, what was refused on none.
                points = [(s, max(o, 1e-16)) for s, o in zip(lengths, off)
                          if o is not None]
                panel.loglog(*zip(*points),
                             marks[theory] + "-", color=colors[section],
                             markersize=5, linewidth=1.2)
        panel.axhline(1e-6, color="0.4", linestyle=":", linewidth=1)
        panel.set_title(load)
        panel.set_xlabel("length / height")
        panel.grid(color="0.92")
    panels[0].set_ylabel("off $a + b\\,(h/L)^2$, relative")
    panels[0].text(2, 1.6e-6, "1e-6", color="0.4")
    handles = [plt.Line2D([], [], color=c, label=s) for s, c in colors.items()]
    handles += [plt.Line2D([], [], color="0.3", marker=m, linestyle="", label=t)
                for t, m in marks.items()]
    panels[1].legend(handles=handles, frameon=False, fontsize=9, ncols=2)
    figure.savefig(ROOT / "doc" / "pictures" / "stability.png")
    print("doc/pictures/stability.png\n")


def main():
    tables = {f.__name__: f for f in (variants, shear, penalty, cost, methods, crossed, phases,
                                      theories, stability, solids, hanging, calculix,
                                      parallel, million, fields, aims, hairs, walls,
                                      compact, flexure, three_plies, paper,
                                      growth_plies, growth_length, bars, bars_richer, ablation,
                                      ablation_passes, ablation_unseen, corners,
                                      rates, tolerances, templates, indentation, leaves, c3d20r, beyond,
                                      foreseen, plans, friction, rubbing, punch,
                                      cattaneo, coupon, crossed_cylinders, rubbing_cost,
                                      rubbing_full, rubbed, rubbing_turning, rollers, thin,
                                      turning)}
    unknown = [name for name in sys.argv[1:] if name not in tables]
    if unknown:
        sys.exit(f"no table {unknown[0]}; there are: {', '.join(tables)}")
    # A million DoFs take minutes and gigabytes: only when asked for.
    only_asked = ("parallel", "methods", "million", "fields", "aims", "hairs", "walls", "compact",
                  "flexure", "three_plies", "paper", "growth_plies", "growth_length", "bars",
                  "bars_richer", "ablation", "ablation_passes", "ablation_unseen", "corners", "tolerances", "templates", "indentation", "c3d20r", "beyond",
                  "foreseen", "plans", "friction", "rubbing", "punch", "cattaneo",
                  "coupon", "crossed_cylinders", "rubbing_cost", "rubbing_full", "rubbed", "rubbing_turning",
                  "rollers", "thin", "turning")
    for name in sys.argv[1:] or [name for name in tables if name not in only_asked]:
        print(f"## {name}: {tables[name].__doc__}\n")
        tables[name]()


if __name__ == "__main__":
    main()
