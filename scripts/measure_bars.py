# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bars of errors (Goals/Error bars) against true errors, those to a much finer run of the
same scene; see scripts/measure."""

import json
import re
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from statistics import median

from measure_bar_scenes import cantilevers, paganos, shipped, singular, unseen
from measure_fields import scene_text
from measure_tools import ENVIRONMENT, PROGRAM, read, table

# Errors below this share of the scale are not compared, nor those below so many times
# what the finer run itself leaves open: its change from a theory that is one poorer. Of
# a goal in a singular place this is large, however fine the run.
SMALL, ABOVE_FLOOR = 1e-3, 3.


class BarRun:
    """A scene run with overrides: its summary and probes, by the names of quantities. @p limits
    is a command that runs the program within limits."""

    def __init__(self, scene, overrides, limits=()):
        self.failure = ""
        with tempfile.TemporaryDirectory() as folder:
            path = scene
            if isinstance(scene, dict):
                path = Path(folder) / "scene.prm"
                path.write_text(scene_text(scene))
            words = [*limits, PROGRAM, path, "--output", Path(folder) / "out"]
            for override in ["Write VTU=false", *overrides]:
                words += ["--set", override]
            begin = time.perf_counter()
            done = subprocess.run(words, env=ENVIRONMENT, capture_output=True,
                                  text=True)
            self.wall = time.perf_counter() - begin
            if done.returncode:
                self.failure = done.stderr.strip() or f"status {done.returncode}"
                return
            self.summary = json.loads((Path(folder) / "out/summary.json").read_text())
            self.tables = {path.name: read(path)
                           for path in (Path(folder) / "out").glob("*.csv")}
            # Goals are of the last load step.
            rows = self.tables["probes.csv"]
            self.probes = [row for row in rows if row["step"] == rows[-1]["step"]]

    def value(self, quantity):
        name, column = quantity.split(": ")
        name, _, ply = name.partition("/")
        for row in self.probes:
            if row["probe"] == name and ply in ("", row["ply"]):
                return float(row[column])
        for kind, key in (("contacts", "force"), ("supports", "reaction")):
            if name in self.summary[kind]:
                return self.summary[kind][name][key]["xyz".index(column[1])]
        raise KeyError(quantity)


# Comparison.

def quantities_of(scene):
    """Those that the scene has References for."""
    run = BarRun(scene, ["Goals/Error bars=richer"])
    return list(run.summary["goals"])


def poorer(overrides):
    """The same with a theory that is one poorer: LE-3 for LE-4, SV-10 for SV-14."""
    def less(found):
        step = 4 if found[1] == "SV" else 1
        return f"Theory={found[1]}-{int(found[2]) - step}"
    return [re.sub(r"^Theory=(\w+)-(\d+)$", less, override) for override in overrides]


def run_with_bars(scene, theory, quantities, how):
    return BarRun(scene, [f"Theory={theory}", f"Goals/Error bars={how}",
                          "Goals/Quantities=" + " | ".join(quantities)])


@dataclass
class Bar:
    """A goal of a run: over its scale the error, the estimate, the bar (None without one),
    and what the truth leaves open."""

    scene: str
    theory: str
    goal: str
    error: float
    estimate: float
    bar: float
    floor: float

    def is_compared(self):
        return abs(self.error) > max(SMALL, ABOVE_FLOOR * self.floor)

    def holds(self):
        return abs(self.error) <= self.bar + 1e-12


def bar_of(run, quantity, name, theory, true=None, nearly_true=None):
    # A run that has no bars since they would cost too much has no goals.
    value = run.value(quantity)
    goal = run.summary.get("goals", {}).get(quantity, {
        "value": value, "scale": abs(value), "estimate": 0., "trusted": False})
    scale = goal["scale"]
    bar = goal["bar"] / scale if goal["trusted"] else None
    if true is None:
        return Bar(name, theory, quantity, 0., goal["estimate"] / scale, bar, 0.)
    exact = true.value(quantity)
    return Bar(name, theory, quantity, (exact - goal["value"]) / scale,
               goal["estimate"] / scale, bar, abs(exact - nearly_true.value(quantity)) / scale)


class Judged:
    """The bars of many runs, what these cost, and runs without a result."""

    def __init__(self):
        self.bars, self.failures = [], []
        # Of each run (scene, theory) the seconds of its bars over those without them.
        self.costs = {}

    def judge(self, name, scene, quantities, theories, finer, how):
        """Appends a bar for each theory and quantity; @p finer makes the truth."""
        quantities = quantities or quantities_of(scene)
        true, nearly_true = BarRun(scene, finer), BarRun(scene, poorer(finer))
        if true.failure or nearly_true.failure:
            self.failures.append([name, "the truth", true.failure or nearly_true.failure])
            return
        for theory in theories:
            print(f"{name}: {theory}", file=sys.stderr)
            run = run_with_bars(scene, theory, quantities, how)
            if run.failure:
                self.failures.append([name, theory, run.failure])
                continue
            self.costs[name, theory] = cost_of_bars(run)
            self.bars += [bar_of(run, quantity, name, theory, true, nearly_true)
                          for quantity in quantities]

    def print(self):
        table(["scene", "theory", "goal", "error, %", "truth open, %", "estimate, %",
               "bar, %", "effectivity", "holds"],
              [cells(bar) for bar in self.bars]
              + [failure[:2] + 6 * [""] + [failure[2][:160]] for failure in self.failures])
        print(summary(self.bars, self.failures) + "\n")
        table(["theory", "goal values", "median error, %", "with a bar", "bars that hold",
               "bar over error, median", "bars' seconds over the run's: median", "worst"],
              [by_theory(theory, self) for theory in
               dict.fromkeys(bar.theory for bar in self.bars)])
        for label, of in (("LE-3 and more", True), ("the others", False)):
            costs = [cost for (_, theory), cost in self.costs.items()
                     if is_from_below(theory) == of]
            if costs:
                print(f"Bars take {median(costs):.2f} times the run without them in the "
                      f"median of {len(costs)} runs of {label}, {max(costs):.2f} at most.\n")


def is_from_below(theory):
    """Whether its bars are made of what the run has: LE-3 and more."""
    return theory.startswith("LE-") and int(theory[3:]) > 2


def cost_of_bars(run):
    """Seconds by the clock, of the whole program over the run's own, which end when its
    results are written, before its bars; less the program's start."""
    return (run.wall - start_of_program()) / run.summary["seconds"]["total"] - 1.


@cache
def start_of_program():
    def once():
        begin = time.perf_counter()
        subprocess.run([PROGRAM, "--version"], env=ENVIRONMENT, capture_output=True,
                       check=True)
        return time.perf_counter() - begin
    return min(once() for _ in range(3))


def by_theory(theory, judged):
    bars = [bar for bar in judged.bars if bar.theory == theory]
    with_bar = [bar for bar in bars if bar.bar is not None]
    ratios = [bar.bar / abs(bar.error) for bar in with_bar if bar.is_compared()]
    costs = [cost for (_, of), cost in judged.costs.items() if of == theory]
    return [theory, len(bars), f"{100 * median(abs(bar.error) for bar in bars):.2g}",
            len(with_bar), sum(bar.holds() for bar in with_bar),
            f"{median(ratios):.2g}" if ratios else "", f"{median(costs):.2f}",
            f"{max(costs):.2f}"]


def cells(bar):
    return [bar.scene, bar.theory, bar.goal, f"{100 * bar.error:.3g}",
            f"{100 * bar.floor:.2g}", f"{100 * bar.estimate:.3g}",
            "none" if bar.bar is None else f"{100 * bar.bar:.3g}",
            f"{bar.estimate / bar.error:.2f}" if bar.is_compared() else "",
            "" if bar.bar is None else "yes" if bar.holds() else
            f"no ({abs(bar.error) / bar.bar:.2g})"]


def share(some, of):
    return f"{100 * sum(some) / len(of):.3g} % of {len(of)}" if of else "none"


def summary(bars, failures):
    """A paragraph of what @p bars come to."""
    with_bar = [bar for bar in bars if bar.bar is not None]
    compared = [bar for bar in with_bar if bar.is_compared()]
    text = (f"{len(bars)} goal values of {len({bar.scene for bar in bars})} scenes, "
            f"{len(failures)} runs without a result. The truth leaves "
            f"{100 * max((bar.floor for bar in bars), default=0.):.2g} % open at most; "
            f"{sum(bar.is_compared() for bar in bars)} errors are above {100 * SMALL:g} % of the "
            f"scale and {ABOVE_FLOOR:g} times that. ")
    ratios = [bar.estimate / bar.error for bar in compared]
    text += (f"Of these, with a bar, the effectivity (estimate over error) is within 0.5 to 2 in "
             f"{share([0.5 <= r <= 2. for r in ratios], ratios)}. ")
    lengths = sorted(bar.bar / abs(bar.error) for bar in compared)
    if lengths:
        text += (f"The bar over the error is {median(lengths):.2g} in the median, "
                 f"{lengths[len(lengths) * 9 // 10]:.2g} or more in a tenth. ")
    misses = [bar for bar in with_bar if not bar.holds()]
    text += (f"{len(with_bar)} values have a bar "
             f"({100 * (1. - len(with_bar) / len(bars)):.2g} % are without); it holds in "
             f"{share([bar.holds() for bar in with_bar], with_bar)}")
    if misses:
        worst = max(misses, key=lambda bar: abs(bar.error) / bar.bar)
        matter = [abs(bar.error) / bar.bar for bar in misses if bar.is_compared()]
        text += (f"; {len(matter)} that do not are of errors that matter (above "
                 f"{100 * SMALL:g} %), the worst of these is "
                 f"{max(matter, default=0.):.2g} times too small, of all "
                 f"{worst.scene}, {worst.theory}, {worst.goal}: "
                 f"{abs(worst.error) / worst.bar:.2g} times")
    return text + "."


def judge(cases, how):
    judged = Judged()
    for case in cases:
        judged.judge(*case, how)
    judged.print()


def places(cases):
    """Bars of numbers that have no limit: none should be there."""
    rows = []
    for name, scene, quantities, theories in cases:
        for theory in theories:
            run = run_with_bars(scene, theory, quantities, "true")
            rows += [[name, theory, quantity, "none" if of.bar is None else
                      f"{100 * of.bar:.3g}"] for quantity in quantities
                     for of in [bar_of(run, quantity, name, theory)]]
    table(["place without a limit", "theory", "goal", "bar, %"], rows)
    print(f"Withheld in {share([row[3] == 'none' for row in rows], rows)}.\n")


def bars(pick=""):
    """Every bar beside the error that it is of; doc/verification/error-bars.md sums it up."""
    judge([case for case in [*shipped(), *unseen(), *paganos(), *cantilevers()]
           if pick in case[0]], "auto")
    places([case for case in singular() if pick in case[0]])


def bars_richer(pick=""):
    """The same of bars from richer models."""
    judge([case for case in [*shipped(), *paganos(), *cantilevers()] if pick in case[0]],
          "richer")
