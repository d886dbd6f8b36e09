#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the bending scenes of `lamella new` with laminates of any coupling, held by `Isostatic support`
and held by supports at points, and compares the two.

Usage: layups.py LAMELLA WORKDIR [--only KIND:LAYUP:THEORY ...]

Each scene is run as `lamella new` writes it, with another layup and theory, and once more
as its twin: in place of `Isostatic support` supports at points of the middle section, one component for
each rigid motion that the hold takes out, with the displacement of the first run. Motions
that contact holds have the same springs in both (Stabilization = 1e-6). A moment about z,
which rollers have on a coupon that twists, is put on the twin's middle section as the hold
has it, so that the reactions of the supports vanish.

Both agree to 1e-6 in displacements and stresses at probes and in contact forces, each over
the largest. With SV-N supports and loads at points bring fields of their own into the
twin, which is another model then: displacements and contact forces agree to 1e-3, and no
stress is compared. The horizontal force of the hold is below 1e-6 of the largest force.

Exit status 1 if a scene is refused or a difference is above its tolerance.
"""

import argparse
import csv
import itertools
import json
import re
import subprocess
import sys
from pathlib import Path

CORE = "subsection Material core\n  set Library = Nomex-48\nend\n"
SANDWICH = {"Ply thickness": (0.25, 1.5, 0.25), "Ply materials": "carbon, core, carbon"}
LAYUPS = {
    "10": {"Layup": "[10]8"},
    "20": {"Layup": "[20]8"},
    "30": {"Layup": "[30]8"},
    "45": {"Layup": "[45]8"},
    "60": {"Layup": "[60]8"},
    "80": {"Layup": "[80]8"},
    "angle-ply": {"Layup": "[45/-45]2s"},
    "cross-ply": {"Layup": "[0/90]4"},
    "unsymmetric": {"Layup": "[30/-60]4"},
    "three": {"Layup": "0/45/90", "Ply thickness": (2 / 3,)},
    "turned-faces": dict(SANDWICH, Layup="45/0/45"),
    "turned-core": dict(SANDWICH, Layup="0/2/0"),
}
THEORIES = ("EBBT", "TBT", "TE-3", "LE-1", "LE-2", "LE-3", "SV-6")
# Of the templates: width, length and thickness of the coupon.
SIZES = {"three-point": (12, 80, 2), "four-point": (12, 100, 2), "short-beam": (8, 24, 4)}
# Places in the middle section, as shares of its width and height, and the components that
# the twin prescribes there: what contact does not hold, and all of a coupon without.
PLACES = {"p0": (0.5, 0.5, "x"), "p1": (0, 0.5, "y"), "p2": (1, 0.5, "y")}
ALL_PLACES = {"p0": (0.5, 0.5, "x"), "p1": (0, 0.5, "yz"), "p2": (1, 0.5, "yz"),
              "p3": (0.5, 0, "y")}


def with_entry(text, name, value):
    """`text` with the first entry `name` changed, or put before the section's Layup."""
    entry = f"set {name} = {value}"
    changed, found = re.subn(rf"(?m)^(\s*)set {name}\s*=.*$", rf"\g<1>{entry}", text, count=1)
    return changed if found else text.replace("  set Layup ", f"  {entry}\n  set Layup ", 1)


def block(kind, name, at, entry):
    place = ", ".join(f"{c:.10g}" for c in at)
    on = "" if kind == "Probe" else "  set On = coupon: point\n"
    at = f"coupon: {place}" if kind == "Probe" else place
    return f"subsection {kind} {name}\n{on}  set At = {at}\n{entry}end\n"


class Case:
    def __init__(self, lamella, workdir, kind, layup, theory):
        self.lamella, self.kind, self.theory = lamella, kind, theory
        self.folder = workdir / f"{kind}_{layup}_{theory}"
        self.folder.mkdir(parents=True, exist_ok=True)
        (self.folder / "made.prm").unlink(missing_ok=True)
        self.call("new", "made", "--kind", kind)
        text = with_entry((self.folder / "made.prm").read_text(), "Theory", theory)
        for name, value in LAYUPS[layup].items():
            if name == "Ply thickness":
                value = ", ".join(f"{h * SIZES[kind][2] / 2:.15g}" for h in value)
            text = with_entry(text, name, value)
        if "Ply materials" in LAYUPS[layup]:
            text = with_entry(text, "Materials", "carbon, core") + CORE
        if theory == "LE-3":
            text = with_entry(text, "Cells across", "1")
        text += "set Write VTU = false\nsubsection Goals\n  set Error bars = false\nend\n"
        if kind == "four-point":
            # 100 N turn a sandwich by more than linear kinematics takes.
            text = re.sub(r"(Total force = 0, 0, -?)50", r"\g<1>5", text)
        self.places = ALL_PLACES if kind == "four-point" else PLACES
        probes = re.search(r"set Probes\s*=\s*(.*)", text).group(1)
        self.text = with_entry(text, "Probes", ", ".join([probes, *self.places]))
        for name, (x, z, _) in self.places.items():
            self.text += block("Probe", name, self.at(x, z), "")

    def at(self, x, z):
        width, length, thickness = SIZES[self.kind]
        return x * width, length / 2, z * thickness

    def call(self, *arguments):
        run = subprocess.run([self.lamella, *arguments], cwd=self.folder,
                             capture_output=True, text=True, check=False)
        if run.returncode != 0:
            raise RuntimeError(run.stderr.strip())

    def solved(self, name, text):
        """The rows of probes.csv and summary.json of a run."""
        (self.folder / f"{name}.prm").write_text(text)
        self.call(f"{name}.prm", "--output", name)
        with open(self.folder / name / "probes.csv", encoding="utf-8") as table:
            rows = list(csv.DictReader(table))
        return rows, json.loads((self.folder / name / "summary.json").read_text())

    def twin(self, displacements, moment):
        """The scene with supports at points, which prescribe `displacements`, in place of
        `Isostatic support`, and with `moment` about z on the middle section."""
        springs = "" if self.kind == "four-point" else "  set Stabilization = 1e-6\n"
        text = re.sub(r"(?m)^\s*set Isostatic support .*\n", springs, self.text)
        text += f"set Supports = {', '.join(self.places)}\n"
        for name, (x, z, components) in self.places.items():
            u = ", ".join(displacements[name][c] if c in components else "free"
                          for c in "xyz")
            text += block("Support", name, self.at(x, z), f"  set u = {u}\n")
        if self.kind == "four-point":
            return text
        text += "set Loads = c0, c1, c2, c3\n"
        for k, (x, z) in enumerate(itertools.product((0, 1), (0, 1))):
            force = (2 * x - 1) * 0.5 * moment / SIZES[self.kind][0]
            text += block("Load", f"c{k}", self.at(x, z), f"  set Force = 0, {force!r}, 0\n")
        return text

    def check(self):
        """The largest difference of the two, and the horizontal force of the hold, over the
        largest force."""
        held, held_summary = self.solved("held", self.text)
        hold = held_summary["supports"]["isostatic-coupon"]
        # Numbers below 1e-30 are refused, and those below 1e-20 are rounding.
        displacements = {row["probe"]: {c: row["u" + c] if abs(float(row["u" + c])) > 1e-20
                                        else "0" for c in "xyz"} for row in held}
        twin, twin_summary = self.solved("twin", self.twin(displacements, hold["moment"][2]))
        pairs = []
        for columns in ("ux uy uz", "sxx syy szz sxy sxz syz"):
            pairs.append([[float(row[c]) for row in rows if row["probe"] not in self.places
                           for c in columns.split()] for rows in (held, twin)])
        if self.theory.startswith("SV"):
            pairs.pop()
        pairs.append([[f for contact in summary["contacts"].values() for f in contact["force"]]
                      for summary in (held_summary, twin_summary)])
        sizes = [max(map(abs, a), default=0.0) for a, _ in pairs]
        difference = max(abs(x - y) / size
                         for size, (a, b) in zip(sizes, pairs) for x, y in zip(a, b))
        largest = sizes[-1] if self.kind != "four-point" else 5.0
        return difference, max(map(abs, hold["reaction"][:2])) / largest


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("lamella", type=Path)
    parser.add_argument("workdir", type=Path)
    parser.add_argument("--only", nargs="*")
    options = parser.parse_args()
    cases = ([case.split(":") for case in options.only] if options.only else
             itertools.product(SIZES, LAYUPS, THEORIES))
    failed = 0
    for kind, layup, theory in cases:
        try:
            difference, hold = Case(options.lamella.resolve(), options.workdir.resolve(),
                                    kind, layup, theory).check()
            tolerance = 1e-3 if theory.startswith("SV") else 1e-6
            bad = not (difference < tolerance and hold < 1e-6)
            text = f"differs by {difference:.1e}, the hold bears {hold:.1e}"
        except RuntimeError as error:
            bad, text = True, str(error)
        failed += bad
        print("FAILED" if bad else "ok", f"{kind}:{layup}:{theory}", text, flush=True)
    print(f"{failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
