# SPDX-License-Identifier: LGPL-2.1-or-later
"""What --validate foresees of the factors of all scenes in prm/, beside what they take:
the table of doc/verification/model-costs.md; see scripts/measure."""

import re
import subprocess

from measure_tools import ENVIRONMENT, PROGRAM, ROOT, Run, table

PLAN = re.compile(r"^Plan of body (.*?): .* (\d+) DoFs, a factor of some (\S+) MB "
                  r"and (\S+) multiplications$", re.M)
WHOLE_PLAN = re.compile(r"^Plan of body .*?: ([^ ,]+).*? (\d+) DoFs, a factor of some \S+ MB "
                        r"and (\S+) multiplications$", re.M)
# What a run may take that is timed [multiplications].
MOST = 3e10
# Scenes that run for minutes, on a mesh that shows the same.
COARSER = {"short_beam.prm": ["Theory=LE-2"]}


def foreseen():
    rows = []
    for path in sorted((ROOT / "prm").glob("*.prm")):
        overrides = COARSER.get(path.name, [])
        words = [PROGRAM, path, "--validate"]
        for override in overrides:
            words += ["--set", override]
        said = subprocess.run(words, env=ENVIRONMENT, capture_output=True, text=True,
                              check=True).stdout
        run = Run(path.name, overrides)
        if run.failure:
            rows.append([path.stem, run.failure] + [""] * 6)
            continue
        for name, dofs, megabytes, operations in PLAN.findall(said):
            z = run.summary["bodies"][name]["solver"].get("factor_non_zeros", 0)
            if z == 0:
                continue
            rows.append([path.stem, name, dofs, megabytes, f"{8e-6 * z:.2g}",
                         f"{float(megabytes) / (8e-6 * z):.2f}",
                         operations, f"{z * z / int(dofs):.2g}"])
    table(["scene", "body", "DoFs", "foreseen [MB]", "factor [MB]", "ratio",
           "foreseen multiplications", "z^2 / n"], rows)


def plans():
    """What the plan of each scene in prm/ is foreseen to cost, and what each other theory
    would; seconds are those of the run, where no factor takes more than MOST."""
    theories = ["EBBT", "TE-3", "LE-1", "LE-2", "LE-3", "SV-6", "solid-1"]
    rows = []
    for path in sorted((ROOT / "prm").glob("*.prm")):
        rows.append([path.stem, *(costs(path, [])),
                     *(cell for theory in theories
                       for cell in [", ".join(costs(path, [f"Theory={theory}"])[1:])])])
    table(["scene", "plan", "DoFs", "multiplications", "seconds", *theories], rows)


def costs(path, overrides):
    """Theory, DoFs, foreseen multiplications and seconds of a scene; empty if it refuses."""
    words = [PROGRAM, path, "--validate"]
    for override in overrides:
        words += ["--set", override]
    done = subprocess.run(words, env=ENVIRONMENT, capture_output=True, text=True)
    found = WHOLE_PLAN.findall(done.stdout)
    if done.returncode or not found:
        return [""] * 4
    work = sum(float(plan[2]) for plan in found)
    seconds = ""
    if work < MOST:
        run = Run(path.name, overrides)
        seconds = "fails" if run.failure else f"{run.wall:.1f}"
    return [found[0][0], str(sum(int(plan[1]) for plan in found)), f"{work:.1g}", seconds]
