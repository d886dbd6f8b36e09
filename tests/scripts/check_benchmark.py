#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the reduced benchmark and reads the page that it wrote.

Usage: check_benchmark.py SCRIPT FOLDER

Every section is there; no cell of a table is empty or no number where it should be
one; requirements are marked by what was measured; every picture exists and is none
of doc/.
"""

import re
import shutil
import subprocess
import sys
from pathlib import Path

SECTIONS = ("The paper's tables", "Hierarchies of theories", "Growth",
            "Contact over a linear solution", "Where the seconds go",
            "Against CalculiX")
REQUIREMENT = re.compile(r"^- .*: wanted (at least|at most) (\S+), measured (\S+): "
                         r"(met|NOT MET)$")
PICTURE = re.compile(r"!\[[^\]]*\]\(([^)]*)\)")
# Sections without CalculiX have no table, and not all have requirements.
FREE_OF_REQUIREMENTS = ("Where the seconds go", "Against CalculiX")


def sections_of(text):
    pieces = re.split(r"^## ", text, flags=re.MULTILINE)[1:]
    return {piece.splitlines()[0]: piece for piece in pieces}


def faults_of_cells(lines):
    for line in lines:
        if not line.startswith("|"):
            continue
        for cell in line.strip("|").split("|"):
            if not cell.strip():
                yield f"an empty cell: {line}"
            if re.search(r"\b(nan|inf|None)\b", cell):
                yield f"not a number: {line}"


def faults_of_requirements(lines):
    for line in lines:
        if "wanted" not in line or not line.startswith("- "):
            continue
        found = REQUIREMENT.match(line)
        if not found:
            yield f"not understood: {line}"
            continue
        side, bound, value = found[1], float(found[2]), float(found[3])
        met = value >= bound if side == "at least" else value <= bound
        # Four digits may hide on which side of the bound a value is.
        if value != bound and met != (found[4] == "met"):
            yield f"marked wrongly: {line}"


def faults(folder):
    page = folder / "benchmarks.md"
    text = page.read_text()
    sections = sections_of(text)
    for title in SECTIONS:
        if title not in sections:
            yield f"no section: {title}"
            continue
        if not any(map(REQUIREMENT.match, sections[title].splitlines())) and \
                title not in FREE_OF_REQUIREMENTS:
            yield f"no requirement in: {title}"
        if "This part failed" in sections[title]:
            yield f"failed: {sections[title]}"
    yield from faults_of_cells(text.splitlines())
    yield from faults_of_requirements(text.splitlines())
    pictures = PICTURE.findall(text)
    for name in pictures:
        if not (folder / name).is_file():
            yield f"no picture: {name}"
    for name in ("benchmark_growth.png", "benchmark_profile.png"):
        if f"pictures/{name}" not in pictures:
            yield f"not shown: {name}"


def main(script, folder):
    folder = Path(folder)
    shutil.rmtree(folder, ignore_errors=True)
    done = subprocess.run([sys.executable, script, "--reduced", "--output", folder],
                          capture_output=True, text=True)
    found = [] if done.returncode == 0 else [done.stderr]
    if (folder / "benchmarks.md").is_file():
        found += faults(folder)
    else:
        found.append("no page was written")
    print("\n".join(found) or "The reduced benchmark wrote its page.")
    return 1 if found else 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("Usage: check_benchmark.py SCRIPT FOLDER")
    sys.exit(main(*sys.argv[1:]))
