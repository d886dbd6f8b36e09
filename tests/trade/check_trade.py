#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs `lamella trade` on a small scene and checks what it says against the files
of the runs, recomputed here; that it goes on where it was killed; and what happens
to variants that fail.

Usage: check_trade.py LAMELLA SCENE.prm WORKDIR
"""

import csv
import json
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

PHASES = ("setup", "assembly", "factorization", "solve", "contact", "beyond",
          "output")
faults = []


def expect(truth, what):
    print(("ok    " if truth else "FAIL  ") + what)
    if not truth:
        faults.append(what)


def read(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


class Trade:
    """The program, a scene and a folder."""

    def __init__(self, program, scene, folder):
        self.words = [str(program), "trade", str(scene), "--output", str(folder)]
        self.folder = folder

    def run(self, *settings):
        words = self.words + [w for s in settings for w in ("--set", s)]
        return subprocess.run(words, capture_output=True, text=True)

    def start(self):
        return subprocess.Popen(self.words, stdout=subprocess.DEVNULL,
                                stderr=subprocess.DEVNULL)

    def table(self):
        return read(self.folder / "trade.csv")

    def records(self):
        """Path -> content and time of the records of variants that succeeded: one
        that failed is tried again."""
        return {path: (path.read_text(), path.stat().st_mtime_ns)
                for path in sorted(self.folder.glob("variants/*/variant.json"))
                if not json.loads(path.read_text())["failure"]}


def value_of(run, quantity):
    """A quantity in the files of a run, read without the program."""
    name, column = (part.strip() for part in quantity.split(":"))
    summary = json.loads((run / "summary.json").read_text())
    if name in summary["supports"]:
        return summary["supports"][name]["reaction"]["xyz".index(column[1])]
    name, _, ply = name.partition("/")
    rows = [row for row in read(run / "probes.csv") if row["probe"] == name
            and (not ply or row["ply"] == ply)]
    return float(rows[0][column])


def run_folders(trade):
    """Variant -> folder of its run, from the order of the hierarchy."""
    return {re.sub(r"^\d+_", "", path.name): path / "run"
            for path in trade.folder.glob("variants/*")}


def folder_of(trade, variant):
    return run_folders(trade)[re.sub(r"[^A-Za-z0-9.-]", "_", variant)]


def check_errors(trade, reference):
    """Values, references, errors and costs of trade.csv against the runs' files."""
    rows = [row for row in trade.table() if not row["failure"]]
    expect(rows, "trade.csv has rows")
    worst = 0.
    for row in rows:
        run = folder_of(trade, row["variant"])
        value, against = value_of(run, row["quantity"]), reference(row["quantity"])
        summary = json.loads((run / "summary.json").read_text())
        worst = max(worst, abs(float(row["value"]) - value) / abs(value),
                    abs(float(row["reference"]) - against) / abs(against))
        # The files of a variant that makes bars are not those of its fastest run.
        if not (run / "goals.csv").exists() or row["theory"].startswith("tolerance"):
            worst = max(worst, abs(float(row["memory_mb"]) / summary["peak_memory_mb"] - 1),
                        *(abs(float(row[phase]) - summary["seconds"][phase])
                          for phase in PHASES))
            if float(row["seconds"]) < summary["seconds"]["total"]:
                worst = 1.
        if row["error"]:
            error = abs(value - against) / abs(against)
            worst = max(worst, abs(float(row["error"]) - error))
        if int(row["dofs"]) != summary["dofs"]:
            worst = 1.
    expect(worst < 1e-12, f"{len(rows)} errors and costs agree with the runs' files "
           f"(largest difference {worst:.1e})")


def is_richer(one, other):
    """Whether the variant of the row `one` holds that of `other`; none of theirs sets
    an entry."""
    def family(row):
        order = row["theory"].partition("-")[2]
        return {"EBBT": ("TE", 0.), "TBT": ("TE", 0.5)}.get(
            row["theory"], (row["theory"].partition("-")[0], float(order or 0)))

    def factor(row, word):
        found = re.search(rf", {word} ([0-9.]+)", row["variant"])
        return float(found[1]) if found else 1.

    return (family(one)[0] == family(other)[0] and family(one)[1] >= family(other)[1]
            and all(factor(one, word) >= factor(other, word)
                    for word in ("axis", "section"))
            and int(one["dofs"]) > int(other["dofs"]))


def is_accident(row, rows):
    return any(other["quantity"] == row["quantity"] and is_richer(other, row)
               and float(other["error"]) > max(1e-3, 2 * float(row["error"]))
               for other in rows)


def check_fronts(trade):
    """The Pareto fronts against the definition, pair by pair."""
    rows = [row for row in trade.table() if row["error"]]
    accidents = [row for row in rows if is_accident(row, rows)]
    expect(all(row["front_seconds"] == row["front_dofs"] == "0" for row in accidents),
           f"{len(accidents)} accidents stand on no front")
    rows = [row for row in rows if row not in accidents]
    wrong = 0
    for cost in ("seconds", "dofs"):
        for row in rows:
            here = float(row[cost]), float(row["error"])
            beaten = False
            for other in rows:
                there = float(other[cost]), float(other["error"])
                if other["quantity"] == row["quantity"] and there != here:
                    beaten |= there[0] <= here[0] and there[1] <= here[1]
            twin = sum(other["quantity"] == row["quantity"] and
                       (float(other[cost]), float(other["error"])) == here
                       for other in rows) > 1
            if not twin:
                wrong += (row[f"front_{cost}"] == "1") == beaten
    expect(wrong == 0, "the Pareto fronts hold who is beaten by none")


def check_sentences(trade, text, tolerances):
    rows = [row for row in trade.table() if row["error"]]
    for per_cent in tolerances:
        for quantity in dict.fromkeys(row["quantity"] for row in rows):
            good = [row for row in rows if row["quantity"] == quantity
                    and float(row["error"]) <= per_cent / 100]
            begin = f"For {per_cent} % in {quantity} "
            said = [line for line in text.splitlines() if line.startswith(begin)]
            if not good:
                expect(len(said) == 1 and "no variant is enough" in said[0],
                       begin + "nothing is enough")
                continue
            least = min(float(row["seconds"]) for row in good)
            equal = [row for row in good
                     if float(row["seconds"]) <= 1.05 * least + 0.1]
            best = min(equal, key=lambda row: int(row["dofs"]))
            expect(len(said) == 1 and
                   f"the cheapest is {best['variant']}: {best['dofs']} DoFs" in said[0],
                   begin + f"it is {best['variant']}")
            sure = [row for row in good if not any(
                other["quantity"] == quantity and is_richer(other, row)
                and float(other["error"]) > per_cent / 100 for other in rows)]
            if best in sure:
                expect("count on" not in said[0], begin + "one can count on it")
                continue
            least = min((float(row["seconds"]) for row in sure), default=0.)
            equal = [row for row in sure
                     if float(row["seconds"]) <= 1.05 * least + 0.1]
            name = min(equal, key=lambda row: int(row["dofs"]))["variant"] if sure else ""
            expect("Do not count on it: " in said[0] and
                   (f"The cheapest to count on is {name}: " if sure else
                    "There is none to count on") in said[0],
                   begin + f"to count on: {name or 'none'}")


def check_ladder(program, scene, workdir):
    trade = Trade(program, scene, workdir / "whole")
    done = trade.run()
    print(done.stdout, done.stderr)
    expect(done.returncode == 0, "the trade succeeds although a variant fails")
    failed = [row for row in trade.table() if row["failure"]]
    expect(len(failed) == 1 and "B9" in failed[0]["failure"] and
           "B2, B3" in failed[0]["failure"], "the variant that fails is a row, and why")
    expect("LE-2, axis 1: the same as LE-2, left out" in done.stdout,
           "a variant that is the same as another is left out")
    last = folder_of(trade, "LE-3, axis 2")
    check_errors(trade, lambda quantity: value_of(last, quantity))
    check_fronts(trade)
    check_sentences(trade, done.stdout, (1, 10))
    drawn = "No pictures" not in done.stdout
    for name, magic in (("trade.png", b"\x89PNG"), ("trade.svg", b"<?xml")):
        path = trade.folder / name
        expect(drawn and path.is_file() and path.read_bytes().startswith(magic),
               name + " is drawn")
    return trade


def check_other_questions(trade):
    """Other quantities and references of the same runs: nothing is run again."""
    before = trade.records()
    given = {"end: uz": 0.02, "clamp: fz": -1.}
    done = trade.run("Trade/Reference=given", "Trade/Quantities=end: uz | clamp: fz")
    expect(done.returncode == 0, "errors against given values")
    check_errors(trade, given.get)
    expect(trade.records() == before, "no variant was run again for it")
    done = trade.run("Trade/Quantities=interface: syy")
    expect(done.returncode == 1 and "interface/1: syy" in done.stderr,
           "a stress on an interface wants its ply named")
    done = trade.run("Trade/Reference=solid")
    expect(done.returncode == 2 and "no variant with hexahedra" in done.stderr,
           "no solid, no reference")
    done = trade.run("Load tip/Force=0, 0, 0.25")
    expect(done.returncode == 0 and
           not set(before.values()) & set(trade.records().values()),
           "another load: every variant is run again")
    forces = [float(row["value"]) for row in trade.table()
              if row["quantity"] == "clamp: fz"]
    expect(forces and all(abs(force + 2) < 1e-9 for force in forces),
           "and gives twice the reaction")
    done = trade.run("Trade/Reference=LE-2, axis 1", "Trade/Quantities=end: uz",
                     "Load tip/Force=0, 0, 0.25")
    expect(done.returncode == 0 and "Errors are against LE-2." in done.stdout,
           "a reference that is the same as another variant is that one")
    done = trade.run("Trade/Quantities=interface/9: syy")
    expect(done.returncode == 1 and "[recover.wrong-ply]" in done.stderr and
           not (trade.folder / "trade.csv").exists(),
           "a ply that is not there: no table of an earlier trade stays")


def alive(pid):
    """Whether it runs; what has ended and waits for its parent does not."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except OSError:
        return False


def check_bars(trade, text):
    """Bars of trade.csv against the goals of the runs, and how many hold."""
    rows = [row for row in trade.table() if not row["failure"]]
    worst, holding, bars, more, none = 0., 0, 0, 0, 0
    references = {row["quantity"]: float(row["bar"] or 0) for row in rows
                  if not row["error"]}
    for row in rows:
        goals = {goal["goal"]: goal for goal in
                 read(folder_of(trade, row["variant"]) / "goals.csv")}
        bar = goals[row["quantity"]]["bar"]
        if bool(bar) != bool(row["bar"]):
            worst = 1.
        elif bar:
            relative = float(bar) / abs(float(row["reference"]))
            worst = max(worst, abs(float(row["bar"]) / relative - 1))
        if row["error"]:
            bars += bool(bar)
            none += not bar
            holds = bool(bar) and float(row["error"]) <= float(row["bar"])
            holding += holds
            more += bool(bar) and not holds and float(row["error"]) <= (
                float(row["bar"]) + references[row["quantity"]])
    expect(worst < 1e-12 and bars, f"{bars} bars are those of goals.csv (largest "
           f"difference {worst:.1e})")
    added = f" ({more} more with the reference's own bar added)" if more else ""
    expect(f"at most the bar: {holding} of {bars}{added}; values without a bar: "
           f"{none}." in text, f"{holding} of {bars} hold")


def check_tolerance(program, scene, workdir):
    """A run to a tolerance among variants that make bars of their own; then it alone
    has them; then of goals that the scene leaves open."""
    trade = Trade(program, scene, workdir / "tolerance")
    hierarchy = "Trade/Variants=TBT | tolerance 4 | LE-2 | LE-3, axis 2"
    quantities = "Trade/Quantities=end: uz | interface/2: syy | clamp: fz"
    done = trade.run(hierarchy, quantities, "Trade/Error bars=true")
    print(done.stdout, done.stderr)
    expect(done.returncode == 0 and not any(row["failure"] for row in trade.table()),
           "a tolerance is a variant")
    run = folder_of(trade, "tolerance 4")
    passes = read(run / "passes.csv")
    last = [row for row in passes if row["pass"] == passes[-1]["pass"]]
    rows = [row for row in trade.table() if row["variant"] == "tolerance 4"]
    expect([row["goal"] for row in last] == [row["quantity"] for row in rows] and
           all(row["met"] == "1" for row in last), "the trade's quantities are its goals")
    expect(all(row["dofs"] == one["dofs"] and row["value"] == one["value"]
               for row, one in zip(rows, last)), "its row is its last pass")
    expect(float(rows[0]["seconds"]) >= float(last[0]["seconds"]),
           "it costs all of its passes")
    expect(all(float(row["error"]) < 0.06 for row in rows),
           "it is off by less than 4 %, and 2 % of the reference")
    finest = folder_of(trade, "LE-3, axis 2")
    check_errors(trade, lambda quantity: value_of(finest, quantity))
    check_bars(trade, done.stdout)
    before = trade.records()
    done = trade.run(hierarchy, quantities, "Trade/Error bars=true",
                     "Trade/Reference=tolerance 4")
    expect(done.returncode == 0 and trade.records() == before and
           "Errors are against tolerance 4." in done.stdout,
           "it may be the reference, and nothing is run again")
    done = trade.run(hierarchy, quantities)
    table = trade.table()
    expect(done.returncode == 0 and
           all(bool(row["bar"]) == (row["variant"] == "tolerance 4") for row in table),
           "without Error bars it alone has bars")
    after = trade.records()
    expect([before[path] == after[path] for path in sorted(before)] ==
           [False, True, False, False], "and it alone was not run again")
    done = trade.run("Trade/Variants=TBT | tolerance 30", "Trade/Quantities=",
                     "Probe interface/At=beam: 1, 7, 0.5")
    rows = [row for row in trade.table() if row["variant"] == "tolerance 30"]
    expect(done.returncode == 0 and len(rows) == 4 and rows[-1]["error"] == "" and
           all(row["bar"] for row in rows), "goals that the scene leaves open")


def check_killed(program, scene, workdir):
    """kill -9 after two variants: they stay, the rest is run, nothing else lives on."""
    trade = Trade(program, scene, workdir / "killed")
    process = trade.start()
    until = time.monotonic() + 60
    while len(trade.records()) < 2 and time.monotonic() < until:
        time.sleep(0.005)
    second = Trade(program, scene, trade.folder).run()
    expect(second.returncode == 1 and "[trade.folder-in-use]" in second.stderr,
           "a second trade in the same folder is refused")
    running = [pid for children in Path(f"/proc/{process.pid}/task").glob("*/children")
               for pid in children.read_text().split()]
    process.send_signal(signal.SIGKILL)
    process.wait()
    until = time.monotonic() + 5
    while any(alive(pid) for pid in running) and time.monotonic() < until:
        time.sleep(0.01)
    expect(not any(alive(pid) for pid in running),
           f"the variant that ran ({len(running)} process) does not outlive the trade")
    before = trade.records()
    expect(len(before) >= 2 and not (trade.folder / "trade.csv").exists(),
           f"killed after {len(before)} variants")
    done = trade.run()
    after = trade.records()
    expect(done.returncode == 0 and len(after) == 6, "the trade went on to its end")
    expect(all(after[path] == before[path] for path in before),
           "the variants that had ended were not run again")
    expect(done.stdout.count("(of an earlier trade)") == len(before),
           "and it says so")
    # A record that was cut off is none.
    victim = list(after)[2]
    victim.write_text(victim.read_text()[:100])
    done = trade.run()
    expect(done.stdout.count("(of an earlier trade)") == 5 and
           json.loads(victim.read_text())["failure"] == "",
           "a record that is not whole is made again")


def check_time_limit(program, scene, workdir):
    trade = Trade(program, scene, workdir / "limit")
    done = trade.run("Trade/Variants=TBT | LE-4, axis 10, section 4",
                     "Trade/Time limit=1", "Trade/Reference=TBT")
    failed = [row["failure"] for row in trade.table() if row["failure"]]
    expect(done.returncode == 0 and len(failed) == 1 and "time limit of 1 s"
           in failed[0], "a variant beyond the time limit is a row")
    title = "A `touch INJECTED` it's \"b\""
    done = subprocess.run(trade.words + ["--set", f"Title={title}", "--set",
                                         "Trade/Variants=EBBT | TBT", "--output",
                                         str(workdir / "it's a folder")],
                          capture_output=True, text=True, cwd=workdir)
    expect(done.returncode == 0 and not (workdir / "INJECTED").exists() and
           "No pictures" not in done.stdout,
           "titles and folders are no commands of the script that draws")


def check_changed(program, scene, workdir):
    """The scene's file is written while a variant of it runs."""
    copy = workdir / "changing.prm"
    copy.write_text(scene.read_text())
    trade = Trade(program, copy, workdir / "changed")
    process = subprocess.Popen(trade.words, stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE, text=True)
    until = time.monotonic() + 60
    while len(trade.records()) < 1 and time.monotonic() < until:
        time.sleep(0.005)
    copy.write_text(scene.read_text().replace("0, 0, 0.125", "0, 0, 1.25"))
    _, errors = process.communicate()
    expect(process.returncode == 1 and "[trade.scene-changed]" in errors,
           "a scene that changes under the trade ends it")
    expect(trade.run().returncode == 0, "and the next one is all of the new scene")
    forces = [float(row["value"]) for row in trade.table()
              if row["quantity"] == "clamp: fz"]
    expect(forces and all(abs(force + 10) < 1e-8 for force in forces),
           "with its load in every variant")


def check_goals(program, scene, workdir):
    """The quantities of Goals, where Trade names none; a hierarchy in which no variant is near
    the reference."""
    trade = Trade(program, scene, workdir / "goals")
    done = trade.run("Trade/Variants=EBBT | TE-2", "Trade/Quantities=",
                     "Goals/Quantities=end: ux | clamp: fz", "Goals/Error bars=false")
    expect(done.returncode == 0 and list(dict.fromkeys(
        row["quantity"] for row in trade.table())) == ["end: ux", "clamp: fz"],
        f"the quantities of Goals {done.stderr}")
    # EBBT knows no coupling: the reference has no ux beside it.
    error = max(float(row["error"]) for row in trade.table() if row["error"])
    expect(error > 0.05 and "Errors are against TE-2. No other variant comes near it in all "
           "quantities (the nearest, EBBT, is off by up to" in done.stdout,
           f"nothing is called sure by a variant that is {100 * error:.0f} % off")


def check_given_models(program, scene, workdir):
    """A scene to a tolerance: variants are its given models. Records are of their own plies."""
    trade = Trade(program, scene, workdir / "given")
    done = trade.run("Trade/Variants=EBBT | TBT", "Trade/Quantities=interface/1: syy",
                     "Trade/Error bars=true", "Goals/Tolerance=2", "Goals/Budget DoFs=100000")
    expect(done.returncode == 0 and {row["dofs"] for row in trade.table()} == {"35"},
           f"a Tolerance of the scene refines no variant {done.stderr}")
    values = []
    for ply in (1, 2):
        done = trade.run("Trade/Variants=EBBT | TBT", f"Trade/Quantities=interface/{ply}: syy",
                         "Goals/Tolerance=2", "Goals/Budget DoFs=100000")
        values.append(trade.table()[0]["value"])
    expect(done.returncode == 0 and values[0] != values[1],
           f"another ply is another quantity {values} {done.stderr}")
    words = [*trade.words, "--jobs", "2", "--output", str(workdir / "jobs"), "--set",
             "Trade/Variants=EBBT | TBT | TE-2", "--set", "Trade/Quantities=interface/2: syy"]
    done = subprocess.run(words, capture_output=True, text=True)
    rows = read(workdir / "jobs/trade.csv")
    expect(done.returncode == 0 and [row["variant"] for row in rows] == ["EBBT", "TBT", "TE-2"]
           and rows[0]["value"] == values[1], f"two at a time are the same {done.stderr}")


def check_mesh_file(program, scene, workdir):
    """A record is of the mesh file that it was made with."""
    guide = scene.parents[2] / "prm/guides"
    for name in ("section-from-gmsh.prm", "section-from-gmsh.msh"):
        shutil.copy(guide / name, workdir)
    trade = Trade(program, workdir / "section-from-gmsh.prm", workdir / "mesh")
    said = []
    for _ in range(3):
        said.append(trade.run("Trade/Variants=TBT | LE-1").stdout.count("(of an earlier trade)"))
        if len(said) == 2:
            (workdir / "section-from-gmsh.msh").touch()
    expect(said == [0, 2, 0], f"another mesh file is another scene {said}")


def check_large(program, scene, workdir):
    """Variants that turn by any angle, and one that cannot."""
    bends = scene.parents[1] / "scenes/turning_spatial.prm"
    trade = Trade(program, bends, workdir / "large")
    done = trade.run("Trade/Variants=TE-1 | TBT | SV | SV, axis 2",
                     "Load factors=1", "Trade/Tolerance=1")
    rows = {row["variant"]: row for row in trade.table() if row["quantity"] == "tip: uz"}
    expect(done.returncode == 0 and "All of it with Rotations = large." in done.stdout,
           f"large rotations are said {done.stderr}")
    expect("TE-1: failed" in done.stdout and "Rotations = large" in done.stdout,
           "a theory that cannot turn says so")
    expect(abs(float(rows["SV"]["value"]) - 113.361) < 0.1,
           "the reference of scene/turning_spatial")
    bars = trade.run("Trade/Variants=TBT | SV", "Trade/Error bars=true")
    expect(bars.returncode == 1 and "Trade/Error bars = true" in bars.stderr,
           "there are no bars of them")


def main():
    program, scene, workdir = (Path(word).resolve() for word in sys.argv[1:4])
    shutil.rmtree(workdir, ignore_errors=True)
    workdir.mkdir(parents=True)
    check_other_questions(check_ladder(program, scene, workdir))
    check_tolerance(program, scene, workdir)
    check_killed(program, scene, workdir)
    check_time_limit(program, scene, workdir)
    check_changed(program, scene, workdir)
    check_goals(program, scene, workdir)
    check_given_models(program, scene, workdir)
    check_mesh_file(program, scene, workdir)
    check_large(program, scene, workdir)
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
