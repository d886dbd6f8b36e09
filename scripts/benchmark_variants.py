# SPDX-License-Identifier: LGPL-2.1-or-later
"""lamella trade on six scenes: which theory is enough; see scripts/benchmark."""

import csv
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

from benchmark_scenes import SCENES
from benchmark_tools import ENVIRONMENT, PROGRAM, ROOT, Failed, show, table, wanted

# Scenes of ours: title, file, overrides.
OWN = {
    "crossed_beams": ("Crossed beams of one soft material",
                      "tests/scenes/crossed_beams.prm",
                      ["Trade/Quantities=press: fz"]),
    "double_t": ("A double-T, clamped, bent and twisted",
                 "tests/scenes/double_t.prm", []),
    "soft_core": ("A sandwich cantilever with a soft core",
                  "tests/scenes/soft_core.prm", [])}


def trade(scene, overrides, folder):
    """Runs a trade: its closing lines, its rows, seconds."""
    words = [PROGRAM, "trade", ROOT / scene, "--output", folder]
    for override in overrides:
        words += ["--set", override]
    begin = time.perf_counter()
    done = subprocess.run(words, env=ENVIRONMENT, capture_output=True, text=True)
    seconds = time.perf_counter() - begin
    if done.returncode != 0:
        raise Failed(f"lamella trade {scene}: {done.stderr.strip().splitlines()[0]}")
    with open(Path(folder) / "trade.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    said = [line for line in done.stdout.splitlines()
            if line.startswith(("Errors are", "For "))]
    return said, rows, seconds


def variants(rows):
    """Of a trade's rows, one list a variant that succeeded, in the hierarchy's order."""
    result = {}
    for row in rows:
        if not row["failure"]:
            result.setdefault(row["variant"], []).append(row)
    return result


def per_cent(error):
    """Two digits, of large errors all before the point."""
    return f"{100 * error:.2g} %" if error < 0.0995 else f"{100 * error:.0f} %"


def reasons(rows):
    """Why variants have no result: the first sentence of each."""
    found = {row["variant"]: row["failure"].split(". ")[0].rstrip(".")
             for row in rows if row["failure"]}
    return "; ".join(f"{variant}: {why}" for variant, why in found.items())


def errors_table(rows):
    """Costs and errors; * stands on the front of error against seconds."""
    found = variants(rows)
    quantities = [row["quantity"] for row in next(iter(found.values()))]
    lines = []
    for name, row in found.items():
        first = row[0]
        lines.append([name, first["dofs"], f"{float(first['seconds']):.2f}",
                      f"{float(first['memory_mb']):.0f}"] +
                     [per_cent(float(r["error"])) +
                      (" *" if r["front_seconds"] == "1" else "")
                      if r["error"] else "-" for r in row])
    return table(["variant", "DoFs", "seconds", "MB"] + quantities, lines)


def quoted(said):
    return "\n>\n".join("> " + line for line in said)


def climb(bench, name, title, scene, overrides, given):
    """A scene's blocks, and how many variants and seconds it took."""
    with tempfile.TemporaryDirectory() as folder:
        said, rows, seconds = trade(scene, overrides, folder)
        picture = Path(folder) / "trade.png"
        if picture.is_file():
            shutil.copy(picture, bench.picture(f"trade_{name}"))
        blocks = [f"### {title}", f"`{scene}`: {len(variants(rows))} variants in "
                  f"{seconds:.1f} s.", errors_table(rows)]
        if reasons(rows):
            blocks.append(f"No result: {reasons(rows)}.")
        if picture.is_file():
            blocks.append(show(f"{title}: error against cost", f"trade_{name}"))
        blocks.append(quoted(said))
        if given:
            # The records of the hierarchy are there: nothing runs again.
            again, _, _ = trade(scene, overrides + ["Trade/Reference=given"], folder)
            blocks += ["Against the converged values that the scene gives:",
                       quoted(again)]
    return blocks, len(variants(rows)), seconds


def cases(bench):
    """Name, title, file, overrides, whether it is the paper's."""
    short = "Trade/Variants=EBBT | LE-1"
    for name, scene in SCENES.items():
        yield name, scene.title, f"prm/{scene.file}", \
            [short] + scene.tiny if bench.reduced else [], True
    for name, (title, file, overrides) in OWN.items():
        yield name, title, file, overrides + ([short] if bench.reduced else []), False


def hierarchy(bench):
    """`lamella trade`: a hierarchy of theories and meshes, each a process of its own."""
    blocks = ["Seconds are of each variant's whole process; errors are relative; * is on "
              "the front: nothing is cheaper and closer. Three scenes of the paper, "
              "three others."]
    demands = []
    for name, title, scene, overrides, of_paper in cases(bench):
        if bench.reduced and name in ("hertz", "sandwich", "crossed_beams", "double_t"):
            continue
        text, count, seconds = climb(bench, name, title, scene, overrides, of_paper)
        blocks += text
        if of_paper:
            demands += [wanted(f"{scene}, variants of the hierarchy", 12, count, True),
                        wanted(f"{scene}, its seconds", 120, seconds)]
    return blocks + [demands]
