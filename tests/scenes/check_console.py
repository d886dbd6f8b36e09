#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs a scene and reads its numbers on the console, in summary.json, in its tables and
in its report: they are the same everywhere.

Usage: check_console.py LAMELLA SCENE.prm WORKDIR

The scene is that of the report's test: probes, two of them on an interface, and goals with
bars. Without bars the run says so and why.
"""

import csv
import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent / "report"))
from check_report import Page, expect, faults  # noqa: E402


def read(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def run(program, scene, output, *words):
    return subprocess.run([program, scene, "--output", output, *words], check=True,
                          capture_output=True, text=True).stdout


def table_behind(console, heading):
    """The lines of the table below @p heading, each as its cells."""
    lines = console.split(heading, 1)[1].split("\n")[1:]
    rows = []
    for line in lines:
        if not line.startswith("  "):
            break
        rows.append([cell for cell in re.split(r"\s{2,}", line.strip()) if cell])
    return rows


def six_digits(value):
    return f"{float(value):.6g}"


def check_probes(console, output):
    last = [row for row in read(output / "probes.csv") if row["step"] == "2"]
    rows = table_behind(console, "Stresses in the scene's axes [MPa]")
    names = rows[0][2:]
    expect(names == ["sxx", "syy", "szz", "sxy", "sxz", "syz"] and
           [(r[0], r[1]) for r in rows[1:]] == [(p["probe"], p["ply"]) for p in last],
           "a row a probe and ply")
    largest = max(abs(float(p[n])) for p in last for n in names)
    expect(all(cell.split(" +- ")[0] == six_digits(p[name]) or
               (cell == "0" and abs(float(p[name])) < 1e-9 * largest)
               for r, p in zip(rows[1:], last) for name, cell in zip(names, r[2:])),
           "stresses are those of probes.csv")
    shown = table_behind(console, "Probes at the last load step, displacements [mm]:")
    expect([r[0] for r in shown[1:]] == ["end", "interface"], "a row a probe")
    summary = json.loads((output / "summary.json").read_text())
    rows = [(name, row) for name, all_rows in summary["probes"].items() for row in all_rows]
    expect([(name, str(row["ply"])) for name, row in rows] ==
           [(p["probe"], p["ply"]) for p in last] and
           all(abs(row[c] - float(p[c])) <= 1e-14 * abs(row[c])
               for (_, row), p in zip(rows, last) for c in ("x", "uz", "gyz", "s23")),
           "summary.json has the probes")
    return summary, shown


def check_value(console, output, summary, shown):
    """end: ux, the goal with a bar, in four places."""
    goal = summary["goals"]["end: ux"]
    value = goal["value"]
    expect(goal["trusted"] and abs(goal["estimate"]) > 1e-6 * abs(value),
           "value and corrected value differ")
    bar = f"{100. * goal['bar'] / goal['scale']:.2g} %"
    ux = shown[1][2:][shown[0][2:].index("ux")]
    expect(ux == f"{six_digits(value)} +- {bar}", f"the probe has its bar: {ux}")
    expect(float(read(output / "probes.csv")[-3]["ux"]) == float(f"{value:.15g}"),
           "the goal is the probe's number")
    page = Page((output / "report.html").read_text())
    glance = next(row for row in page.tables["glance"] if row[0][0] == "end: ux")
    expect(float(glance[1][1][0][0]) == float(f"{value:.15g}"), "the report's value is it, too")
    expect(summary["probes"]["end"][0]["ux"] == value, "and so is that of summary.json")


def main():
    program, scene, folder = sys.argv[1], sys.argv[2], Path(sys.argv[3])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    output = folder / "run"
    console = run(program, scene, output, "--set", "Goals/Quantities=end: ux | clamp: fz")
    subprocess.run([program, "report", output], check=True, stdout=subprocess.DEVNULL)
    check_value(console, output, *check_probes(console, output))
    expect("No error bars:" not in console, "there are bars, and it does not say otherwise")

    console = run(program, scene, folder / "without", "--set", "Goals/Error bars=auto",
                  "--set", "Theory=solid-1")
    expect("No error bars: they would cost more than half of what the run does" in console and
           "--set \"Goals/Error bars=true\" makes them" in console, "bars left out, and why")
    console = run(program, scene, folder / "never", "--set", "Goals/Error bars=false")
    expect("No error bars: Error bars = false" in console, "bars that nobody wants")
    subprocess.run([program, "report", folder / "never"], check=True,
                   stdout=subprocess.DEVNULL)
    page = Page((folder / "never/report.html").read_text())
    expect("There are no error bars: Error bars = false" in page.text["numbers"],
           "so says the report")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
