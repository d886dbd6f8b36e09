#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs a tutorial and compares the numbers it prints with those pinned.

Usage: check_tutorial.py PROGRAM FILE.expect

The program prints lines `KEY: NUMBER` and tables, a head and rows between bars
(deal.II's org_mode_table), whose numbers have the keys `ROW, COLUMN`. FILE.expect
holds comments (#) and rows `KEY | VALUE | TOLERANCE | SOURCE` with the tolerances
of check_scene.py.
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "scenes"))
from check_scene import compare, print_table  # noqa: E402


def printed_numbers(text):
    """All that is printed, by key."""
    numbers = dict(re.findall(r"^([^:\n]+): (\S+)$", text, re.MULTILINE))
    head = None
    for line in text.splitlines():
        if not line.startswith("|"):
            head = None
            continue
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if head:
            numbers.update((f"{cells[0]}, {column}", cell)
                           for column, cell in zip(head[1:], cells[1:]))
        head = head or cells
    return numbers


def main():
    if len(sys.argv) != 3:
        sys.exit("Usage: check_tutorial.py PROGRAM FILE.expect")
    program, path = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run([program], cwd=folder, capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"{program.name} ended with {run.returncode}:\n{run.stderr}")
    printed = printed_numbers(run.stdout)

    table = []
    for line in path.read_text().splitlines():
        if not line.strip() or line.startswith("#"):
            continue
        key, value, tolerance, source = [c.strip() for c in line.rsplit("|", 3)]
        if key not in printed:
            sys.exit(f"{program.name} does not print '{key}':\n{run.stdout}")
        good, deviation = compare(printed[key], value, tolerance)
        table.append([key, printed[key], value, deviation, tolerance, source,
                      "ok" if good else "FAIL"])
    if not table:
        sys.exit(f"{path}: no row to compare")
    print_table(table)
    sys.exit(0 if all(row[-1] == "ok" for row in table) else 1)


if __name__ == "__main__":
    main()
