#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs a scene with a load of each kind and reads what its report and its console say of
them.

Usage: check_loads.py LAMELLA SCENE.prm WORKDIR

Couple, pressure, total force, point force, temperature and weight stand in words, with
force and moment as statics gives them; density and expansion stand beside the materials;
load factors do not multiply temperatures, nor loads with factors of their own; a temperature
is no force of the balance. Of a scene with friction the contact's chapter has its numbers and
those of the path.
"""

import json
import shutil
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
import check_report  # noqa: E402
from check_report import Page, expect, faults  # noqa: E402


def main():
    program, scene, folder = sys.argv[1], sys.argv[2], Path(sys.argv[3])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    output = folder / "run"
    console = subprocess.run([program, scene, "--output", output], check=True,
                             capture_output=True, text=True).stdout
    subprocess.run([program, "report", output], check=True, stdout=subprocess.DEVNULL)
    page = Page((output / "report.html").read_text())
    check_report.check_form(page)
    words = " ".join(page.text["scene"].split())
    # Statics about the origin: pressure 0.01 on 20 at (1, 5, 1); 3 at (1, 10, 0.5) along
    # y; 0.5 at (1, 10, 0); weight 2e-9 * 10000 * 20 = 4e-4 at (1, 5, 0.5).
    for sentence in (
            "turn acts on the end of beam: a couple of (0.3, 0, −0.2) [N mm], as tractions "
            "without a resultant force, in all a moment of (0.3, 0, −0.2) [N mm] about the "
            "scene's origin.",
            "pressure 0.01 against the outward normal [N/mm²], in all (0, 0, −0.2) N, a moment "
            "of (−1, 0.2, 0) [N mm] about the scene's origin.",
            "pull acts on the end of beam: a force of (0, 3, 0) N, spread evenly over it, in "
            "all (0, 3, 0) N, a moment of (−1.5, 0, 3) [N mm]",
            "push acts on a point of beam, at (1, 10, 0) mm: force (0, 0, 0.5) [N], in all "
            "(0, 0, 0.5) N, a moment of (5, −0.5, 0) [N mm]",
            "warm makes the whole of beam warmer than without stress by 20*y K, in full at "
            "every load step.",
            "All bodies have weight: the acceleration of gravity is (0, 0, −10000) [mm/s²], in all "
            "(0, 0, −0.0004) N, a moment of (−0.002, 0.0004, 0) [N mm]",
            "plain: density [t/mm³] = (2·10⁻⁹)", "plain: thermal expansion",
            "what multiplies all forces and all prescribed displacements. Temperatures act in "
            "full at every load step"):
        expect(sentence in words, sentence)
    names = [row[0][0] for row in page.tables["forces"][1:]]
    expect("load warm" not in names and "load turn" in names,
           "a temperature is no force of the balance")
    summary = json.loads((output / "summary.json").read_text())
    expect([row[0][0] for row in page.tables["loads"][1:]] ==
           [name for name in summary["loads"] if name != "warm"] and
           page.values("loads")[0] == [*summary["loads"]["turn"]["force"],
                                       *summary["loads"]["turn"]["moment"]],
           "loads with their moments")
    for line in ("Load turn: resultant (0, 0, 0) N in all, moment (0.3, 0, -0.2) N mm about "
                 "the origin", "Load warm: a temperature, which has no resultant"):
        expect(line in console, line)
    rows = {row[0][0]: [float(data[0][0]) for _, data in row[1:]]
            for row in page.tables["forces"][1:]}
    expect(rows["load push"] == [0., 0., -1.] and rows["load pull"][1] == 3. and
           "its own: 1, -2." in words, "a load with factors of its own")
    check_friction(program, folder)
    sys.exit(1 if faults else 0)


def check_friction(program, folder):
    output = folder / "friction"
    leaves = Path(__file__).resolve().parents[1] / "scenes/friction_leaves.prm"
    subprocess.run([program, leaves, "--output", output, "--set", "Substeps=2",
                    *(word for body in ("lower", "upper") for word in
                      ("--set", f"Body {body}/Kinematics/Axis elements=6"))], check=True,
                   stdout=subprocess.DEVNULL)
    subprocess.run([program, "report", output], check=True, stdout=subprocess.DEVNULL)
    page = Page((output / "report.html").read_text())
    check_report.check_form(page)
    summary = json.loads((output / "summary.json").read_text())
    friction = summary["contacts"]["face"]["friction"]
    expect(page.values("friction-of-face") == [
        [friction["coefficient"]], friction["force"], [friction["sticking_area"]],
        [friction["slipping_area"]], [friction["dissipated"]]] and
        friction["slipping_area"] > 0., f"what rubs: {page.values('friction-of-face')}")
    expect([row[1][0] for row in page.tables["path"][1:]] == ["2"] * 4, "substeps")
    words = " ".join(page.text["scene"].split())
    expect("has no friction" not in words, "nothing says that there is none")
    for sentence in ("with a coefficient of friction of 0.3 (surface to surface, exact)",
                     "what rubs obeys Coulomb's law",
                     "the way to each of them is done in parts (2)"):
        expect(sentence in words, sentence)


if __name__ == "__main__":
    main()
