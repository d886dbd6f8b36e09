# SPDX-License-Identifier: LGPL-2.1-or-later
"""What --validate foresees of the factors of all scenes in prm/, beside what they take:
the table of doc/choosing-a-theory.md; see scripts/measure."""

import re
import subprocess

from measure_tools import ENVIRONMENT, PROGRAM, ROOT, Run, table

PLAN = re.compile(r"^Plan of body (.*?): .* (\d+) DoFs, a factor of some (\S+) MB "
                  r"and (\S+) multiplications$", re.M)
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
