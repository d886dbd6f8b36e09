# SPDX-License-Identifier: LGPL-2.1-or-later
"""Error bars with each of their rules off in turn, over all scenes of scripts/measure bars and
random ones of tests/robustness/hunt.py; see scripts/measure."""

import csv
import io
import json
import random
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from statistics import median

from measure_bar_scenes import cantilevers, paganos, shipped, unseen
from measure_bars import ABOVE_FLOOR, SMALL, BarRun, poorer, quantities_of
from measure_fields import scene_text
from measure_tolerances import SCENES, graded
from measure_tools import ENVIRONMENT, ROOT, table

sys.path.insert(0, str(ROOT / "tests/robustness"))
import hunt  # pylint: disable=wrong-import-position

# Notes of a run whose model is wrong whatever its mesh.
BEYOND = {"contact.large-sliding", "solve.large-rotation"}
THEORIES = ("EBBT", "TE-3", "LE-1", "LE-2", "LE-3", "SV-6")
FIRST = "as it is"


def fixed():
    """Name, scene, goals, theories, and the overrides of two truths."""
    for name, scene, goals, theories, finer in [*shipped(), *unseen(), *paganos(),
                                                *cantilevers()]:
        yield name, scene, goals or quantities_of(scene), theories, finer, poorer(finer)


def randoms(seeds, count):
    """@p count scenes of each of @p seeds, each with one theory. The truth is LE-4 on a fine
    graded axis, beside LE-3 on one half as fine."""
    for seed in seeds:
        for number in range(count):
            scene = hunt.Scene(seed, number)
            theory = random.Random(f"theory {seed}.{number}").choice(THEORIES)
            goals = [f"probe: {column}" for column in ("ux", "uy", "uz", "syy")]
            goals += ["touch: fz"] if scene.touched else []
            finer, less = ([f"Theory={of_truth}"] + [f"Body {body}/Kinematics/Axis elements={axis}"
                                                   for body in scene.bodies]
                           for of_truth, axis in (("LE-4", "auto 2"), ("LE-3", "auto")))
            yield f"random {seed}.{number} ({scene.words})", scene, goals, [theory], finer, less


def file_of(scene, folder):
    """The path of @p scene, which is written into @p folder if it is no file."""
    if isinstance(scene, Path):
        return scene
    path = Path(folder) / "scene.prm"
    path.write_text(scene.text if isinstance(scene, hunt.Scene) else scene_text(scene))
    return path


def rows_of(case, program):
    """A row for each theory, rule and goal of @p case, or with the reason that there is none."""
    name, scene, goals, theories, finer, less = case
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        path = file_of(scene, folder)
        limits = ("timeout", "300")
        truth, nearly = (BarRun(path, ["Goals/Error bars=false", *entries], limits)
                         for entries in (finer, less))
        notes = {note["identifier"] for note in nearly.summary["warnings"]
                 } if not nearly.failure else set()
        if notes & BEYOND and getattr(scene, "touched", None):
            return [{"scene": name, "beyond": True}]
        for theory in theories:
            words = [program, path, f"Theory={theory}", "Goals/Error bars=auto",
                     "Goals/Quantities=" + " | ".join(goals)]
            done = subprocess.run([*limits, *words], env=ENVIRONMENT, capture_output=True,
                                  text=True)
            failure = truth.failure or nearly.failure or done.stderr.strip()
            if done.returncode or failure:
                rows.append({"failure": failure[:200] or f"status {done.returncode}"})
                continue
            found = list(csv.DictReader(io.StringIO(done.stdout)))
            rows += found or [{"goals": len(goals)}]
            for row in found:
                exact = truth.value(row["goal"])
                scale = float(row["scale"])
                row.update(theory=theory, error=(exact - float(row["value"])) / scale,
                           floor=abs(exact - nearly.value(row["goal"])) / scale,
                           bar=float(row["bar"]) / scale)
    return [{"scene": name, **row} for row in rows]


class Bars:
    """The bars of one rule."""

    def __init__(self, rows):
        self.rows = [row for row in rows if row["has_limit"] == "1"]
        self.trusted = [row for row in self.rows if row["trusted"] == "1"]
        self.compared = [row for row in self.trusted
                         if abs(row["error"]) > max(SMALL, ABOVE_FLOOR * row["floor"])]
        self.misses = [row for row in self.trusted
                       if abs(row["error"]) > row["bar"] + row["floor"] + 1e-12]
        self.mattering = [row for row in self.misses if row in self.compared]

    def cells(self):
        if not self.compared:
            return [len(self.trusted)] + 6 * [""]
        ratios = sorted(row["bar"] / abs(row["error"]) for row in self.compared)
        worst = max((abs(row["error"]) / row["bar"] for row in self.mattering if row["bar"]),
                    default=0.)
        return [len(self.trusted), f"{100 * (1 - len(self.trusted) / len(self.rows)):.1f}",
                f"{100 * (1 - len(self.misses) / len(self.trusted)):.2f}",
                len(self.mattering), f"{worst:.2g}", f"{median(ratios):.2g}",
                f"{ratios[len(ratios) * 9 // 10]:.2g}"]


def report(rows):
    """Tables of scenes without and with a line support inside the span, below which displacements
    have no limit: the truth grows with the logarithm of the elements' number."""
    for is_inside in (False, True):
        chosen = [row for row in rows if ("held inside" in row["scene"]) == is_inside]
        if any("rule" in row for row in chosen):
            print("Line supports inside the span:" if is_inside else "Other scenes:")
            report_of(chosen)


def report_of(rows):
    bars = [row for row in rows if "rule" in row]
    rules = list(dict.fromkeys(row["rule"] for row in bars))
    base = {(row["scene"], row["theory"], row["goal"]): row for row in bars
            if row["rule"] == FIRST}
    lines = []
    for rule in rules:
        own = [row for row in bars if row["rule"] == rule]
        changed = sum(abs(row["bar"] - base[key]["bar"]) > 1e-6 * base[key]["bar"]
                      or row["trusted"] != base[key]["trusted"] for row in own
                      for key in [(row["scene"], row["theory"], row["goal"])])
        lines.append([rule, changed, *Bars(own).cells()])
    table(["rule", "bars changed", "with a bar", "withheld, %", "hold, %",
           "misses that matter", "worst", "bar over error, median", "a tenth above"], lines)
    none = sum(row.get("goals", 0) for row in rows)
    print(f"Scenes beyond linear kinematics: {sum('beyond' in row for row in rows)}.")
    print(f"Goals of runs without `auto` bars, for their cost: {none}. Runs without a result: "
          f"{sum('failure' in row for row in rows)}.\n")
    table(["scene", "theory", "goal", "error, %", "truth open, %", "bar, %"],
          [[row["scene"], row["theory"], row["goal"], f"{100 * row['error']:.3g}",
            f"{100 * row['floor']:.2g}", f"{100 * row['bar']:.3g}"]
           for row in Bars(list(base.values())).mattering])


def program_of(program):
    """build/tests/ablation, built now, unless @p program is another one."""
    if program is None:
        subprocess.run([ROOT / "scripts/build", "ablation"], check=True, stdout=sys.stderr)
    return program or ROOT / "build/tests/ablation"


def ablation(pick="", program=None, kept=None, jobs=2, count=150, seeds=(6501, 6502)):
    """The first table of doc/verification/error-bar-rules.md. With @p kept, a file of JSON lines,
    rows of scenes that it has are not made again."""
    program = program_of(program)
    cases = [case for case in [*fixed(), *randoms(seeds, count)] if pick in case[0]]
    known = {}
    if kept and Path(kept).exists():
        for line in Path(kept).read_text().splitlines():
            rows = json.loads(line)
            known[rows[0]["scene"]] = rows

    def make(case):
        if case[0] not in known:
            known[case[0]] = rows_of(case, program)
            print(case[0], file=sys.stderr)
            if kept:
                with open(kept, "a", encoding="utf-8") as file:
                    file.write(json.dumps(known[case[0]]) + "\n")
        return known[case[0]]
    with ThreadPoolExecutor(jobs) as pool:
        report([row for rows in pool.map(make, cases) for row in rows])


def ablation_unseen():
    """The same for 100 random scenes of two other seeds."""
    ablation("random", count=50, seeds=(6503, 6504))


# Runs to a tolerance.

def pass_rows(case, program):
    """A row for each rule: whether all goals are met, the largest error, DoFs and seconds."""
    (name, scene, bodies, goals, _, finer), per_cent = case
    with tempfile.TemporaryDirectory() as folder:
        path = file_of(scene, folder)
        truth = BarRun(path, [*finer, "Goals/Error bars=false"])
        words = [program, path, "Theory=auto", *graded(bodies), f"Goals/Tolerance={per_cent}",
                 "Goals/Quantities=" + " | ".join(goals), "Write VTU=false"]
        done = subprocess.run(words, env=ENVIRONMENT, capture_output=True, text=True, cwd=folder)
    rows = {}
    if done.returncode:
        print(f"{name}, {per_cent} %: {done.stderr.strip()}", file=sys.stderr)
    for row in csv.DictReader(io.StringIO(done.stdout)):
        exact = truth.value(row["goal"])
        met, error, _, _ = rows.get(row["rule"], (True, 0., 0, 0.))
        rows[row["rule"]] = (met and row["trusted"] == "1",
                             max(error, abs(float(row["value"]) / exact - 1.)),
                             int(row["has_limit"]), float(row["seconds"]))
    return f"{name}, {per_cent} %", rows


def ablation_passes(pick="", program=None, jobs=2):
    """Runs to a tolerance with each rule of refinement changed in turn: seconds, * where not all goals
    are met, ! where the largest error of a goal is beyond the tolerance."""
    program = program_of(program)
    cases = [(scene, per_cent) for scene in SCENES for per_cent in (1, 0.1) if pick in scene[0]]
    with ThreadPoolExecutor(jobs) as pool:
        found = dict(pool.map(lambda case: pass_rows(case, program), cases))
    rules = list(dict.fromkeys(rule for rows in found.values() for rule in rows))

    def cell(name, rule):
        if rule not in found[name]:
            return "failed"
        met, error, _, seconds = found[name][rule]
        beyond = error > float(name.split(", ")[-1].split()[0]) / 100.
        return f"{seconds:.1f}" + ("" if met else "*") + ("!" if beyond else "")
    table(["rule", *found, "sum"],
          [[rule, *(cell(name, rule) for name in found),
            f"{sum(rows[rule][3] for rows in found.values() if rule in rows):.0f}"] for rule in rules])
