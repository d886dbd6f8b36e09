#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Has `lamella new` write a scene and runs it as it is.

Usage: check_new.py LAMELLA KIND WORKDIR

KIND is that of a template, or `refused`: what cannot be written ends with one message.
The run comes to its end with equilibrium and a number that is known: the deflection of
a beam by its EI, the shear stress 3 F / (4 b h) of the short beam.
"""

import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

faults = []


def expect(truth, what):
    print(("ok    " if truth else "FAIL  ") + what)
    if not truth:
        faults.append(what)


def near(value, expected, share, what):
    expect(abs(value / expected - 1.) < share, f"{what}: {value:.6g} beside {expected:.6g}")


def lamella(program, folder, *words):
    return subprocess.run([program, *map(str, words)], capture_output=True, text=True,
                          cwd=folder)


class Run:
    """What a scene called coupon.prm has left."""

    def __init__(self, folder):
        self.folder = folder / "results/coupon"
        self.summary = json.loads((self.folder / "summary.json").read_text())

    def probe(self, name):
        return self.summary["probes"][name][0]

    def stiffness(self, section, key):
        return json.loads((self.folder / f"sections/{section}.json").read_text())[key]

    def force(self, contact):
        return self.summary["contacts"][contact]["force"][2]


def check_three_point(run):
    """w = F (L^3 / (48 EI) + L / (4 kGA)) with L = 64; the rollers share F."""
    F = run.force("c_nose")
    EI, kGA, L = run.stiffness("laminate", "EI_2"), run.stiffness("laminate", "kGA_z"), 64.
    near(run.force("c_left"), -F / 2., 1e-6, "half of the force on a roller")
    near(-run.probe("middle")["uz"], F * (L ** 3 / (48. * EI) + L / (4. * kGA)), 0.02,
         "the deflection, by beam theory")


def check_four_point(run):
    """Between the inner lines M = 50 N times 26 mm, and the strain is M z / EI."""
    EI, M, z = run.stiffness("laminate", "EI_2"), 50. * 26., 1. - 0.125
    outer = run.probe("outer")
    near(outer["eyy"], M * z / EI, 0.01, "the strain of the outer ply")
    expect(abs(run.probe("core")["syz"]) > 1. and
           max(map(abs, run.summary["supports"]["isostatic-coupon"]["reaction"])) < 1e-7,
           "the hold has no reaction")


def check_short_beam(run):
    """The shear stress in the middle of the height; b = 8, h = 4."""
    near(abs(run.probe("shear")["syz"]), 0.75 * run.force("c_nose") / 32., 0.15,
         "the apparent shear strength, 3 F / (4 b h)")


def check_leaf_spring(run):
    expect(run.summary["contacts"]["interleaf-3"]["force"][2] > 0, "leaves touch")
    expect(run.probe("tip")["uz"] < -1., "it goes down")


def check_indentation(run):
    F = run.force("indentation")
    near(run.summary["supports"]["floor"]["reaction"][2], F, 1e-9, "the floor bears it")
    expect(F > 10. and run.probe("core")["szz"] < 0., "the indenter is pushed back")


CHECKS = {"three-point": check_three_point, "four-point": check_four_point,
          "short-beam": check_short_beam, "leaf-spring": check_leaf_spring,
          "indentation": check_indentation}


def check_kind(program, kind, folder):
    done = lamella(program, folder, "new", "coupon", "--kind", kind)
    text = (folder / "coupon.prm").read_text() if done.returncode == 0 else ""
    expect("It runs as it is: lamella coupon.prm" in done.stdout, f"written {done.stderr}")
    expect("lamella coupon.prm" in text and "results/coupon" in text and "NAME" not in text and
           text.count("#") > 10, "comments, with its own name in them")
    done = lamella(program, folder, "coupon.prm")
    expect(done.returncode == 0, f"it runs {done.stderr}")
    expect("Note: " not in done.stdout,
           f"without a warning {re.findall('Note: .*', done.stdout)}")
    run = Run(folder)
    expect(run.summary["converged"] and run.summary["force_balance"] < 1e-6, "equilibrium")
    CHECKS[kind](run)


def check_refused(program, folder):
    (folder / "mine.prm").write_text("my own work\n")
    for words, fragments in (
            (["mine"], ["[run.scene-exists]"]),
            (["mine.prm"], ["[run.scene-exists]"]),
            (["other", "--kind", "threepoint"], ["[run.unknown-kind]", "three-point"]),
            (["/dev/null/other"], ["cannot be written"]),
            ([], ["[run.no-name]"]),
            (["other", "--validate"], ["[run.option-not-for-new]"])):
        done = lamella(program, folder, "new", *words)
        expect(done.returncode == 1 and all(f in done.stderr for f in fragments),
               f"refused: {words} ({done.stderr.strip()})")
    expect((folder / "mine.prm").read_text() == "my own work\n" and
           [p.name for p in folder.iterdir()] == ["mine.prm"], "nothing is overwritten or left")
    done = lamella(program, folder, "mine.prm", "--kind", "three-point")
    expect(done.returncode == 1 and "[run.option-of-new]" in done.stderr,
           "a run has no kind")


def main():
    program, kind, folder = Path(sys.argv[1]).resolve(), sys.argv[2], Path(sys.argv[3])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    if kind == "refused":
        check_refused(program, folder)
    else:
        check_kind(program, kind, folder)
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
