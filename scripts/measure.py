# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of doc/laminated-beams.md and doc/contact.md; see scripts/measure."""

import csv
import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PROGRAM = Path(os.environ.get("LAMELLA_BUILD", ROOT / "build")) / "lamella"
POINT = ["Support press/On=upper: point", "Support press/At=0.05, 1, 0.106"]
ENVIRONMENT = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}


class Run:
    """A scene run with overrides: its summary, probes and lines."""

    def __init__(self, scene, overrides, vtu=False):
        overrides = list(overrides) + ([] if vtu else ["Write VTU=false"])
        with tempfile.TemporaryDirectory() as folder:
            words = [PROGRAM, ROOT / "prm" / scene, "--output", folder]
            for override in overrides:
                words += ["--set", override]
            begin = time.perf_counter()
            done = subprocess.run(words, env=ENVIRONMENT, capture_output=True,
                                  text=True)
            self.wall = time.perf_counter() - begin
            self.failure = done.stderr.strip() if done.returncode else ""
            if self.failure:
                return
            folder = Path(folder)
            self.summary = json.loads((folder / "summary.json").read_text())
            self.probes = {row["probe"]: row
                           for row in read(folder / "probes.csv")}
            self.lines = {path.stem: read(path)
                          for path in (folder / "lines").glob("*.csv")}

    def contact_force(self):
        return -self.summary["contacts"]["middle"]["force"][2]


def read(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def table(header, rows):
    print("| " + " | ".join(header) + " |")
    print("|" + "---|" * len(header))
    for row in rows:
        print("| " + " | ".join(str(cell) for cell in row) + " |")
    print()


def axis(elements, breaks=""):
    """Both beams with these axis meshes."""
    return [f"Body {body}/Kinematics/Axis {what}={value}"
            for body in ("upper", "lower")
            for what, value in (("elements", elements), ("breaks", breaks))]


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


def phases():
    """Whole-process seconds with all output, the fastest and the slowest of five."""
    runs = [Run("laminated_beams.prm", [], vtu=True) for _ in range(5)]
    names = ["setup", "assembly", "factorisation", "solve", "contact", "output",
             "total"]
    rows = [[name] + [f"{pick(r.summary['seconds'][name] for r in runs):.3f}"
                      for pick in (min, max)] for name in names]
    rows.append(["whole process"] + [f"{pick(r.wall for r in runs):.3f}"
                                     for pick in (min, max)])
    table(["phase", "fastest [s]", "slowest [s]"], rows)
    ratio = [r.summary["seconds"]["contact"] / r.summary["seconds"]["factorisation"]
             for r in runs]
    print(f"contact over factorisation: {min(ratio):.2f} to {max(ratio):.2f}; "
          f"peak memory {runs[0].summary['peak_memory_mb']:.0f} MB; condition "
          f"estimate {runs[0].summary['condition_estimate']:.1e}\n")


def main():
    tables = {f.__name__: f for f in (variants, shear, penalty, phases)}
    unknown = [name for name in sys.argv[1:] if name not in tables]
    if unknown:
        sys.exit(f"no table {unknown[0]}; there are: {', '.join(tables)}")
    for name in sys.argv[1:] or tables:
        print(f"## {name}: {tables[name].__doc__}\n")
        tables[name]()


if __name__ == "__main__":
    main()
