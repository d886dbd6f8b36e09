# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the tables of scripts/measure are made with: runs of the program, Markdown."""

import csv
import json
import os
import subprocess
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PROGRAM = Path(os.environ.get("LAMELLA_BUILD", ROOT / "build")) / "lamella"
POINT = ["Support press/On=upper: point", "Support press/At=0.05, 1, 0.106"]
# Root in a container has to tell Open MPI that it means it.
ENVIRONMENT = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1",
               "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}


class Run:
    """A scene run with overrides: its summary, probes and lines."""

    def __init__(self, scene, overrides, vtu=False, processes=1):
        overrides = list(overrides) + ([] if vtu else ["Write VTU=false"])
        with tempfile.TemporaryDirectory() as folder:
            words = ["mpirun", "-np", str(processes)] if processes > 1 else []
            words += [PROGRAM, ROOT / "prm" / scene, "--output", folder]
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


def drawing():
    """pyplot in the style of the pages' pictures, without a screen."""
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    plt.rcParams.update({"font.size": 11, "figure.dpi": 150,
                         "figure.constrained_layout.use": True,
                         "axes.spines.top": False, "axes.spines.right": False})
    return plt
