#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs that end before their time, and go on.

Usage: check_resume.py LAMELLA SCENE.prm WORKDIR [KILLS] [SEED]

SCENE is run in 20 load steps, once without interruption and then KILLS (4) times with
kill -9 at a random moment. What a killed run leaves is whole: rows of as many load
steps as its summary says, in every table, and their VTU files in the collection. Then
it goes on with --resume, and every table is that of the uninterrupted run number by number
to 1e-12 (numdiff). So does one that is killed behind its load steps, while it looks
for the first failure or makes error bars, a loop with friction in its middle, and bodies that slide and
turn far, whose tables are the same to the last byte. --resume on what cannot go on is refused,
and a file that reaches its limit at a later step leaves the steps before it; a step
that fails fails again when resumed.
"""

import csv
import json
import os
import random
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
STEPS, TOLERANCE = 20, "1e-12"
faults = []


def check(holds, what):
    print(("ok    " if holds else "FAIL  ") + what)
    if not holds:
        faults.append(what)


def command(program, scene, folder, *arguments):
    factors = ", ".join(str((k + 1) / STEPS) for k in range(STEPS))
    return [program, scene, "--output", str(folder), "--set", f"Load factors={factors}",
            *arguments]


def run(*arguments):
    done = subprocess.run(command(*arguments), capture_output=True, text=True)
    return done.returncode, done.stdout, done.stderr


def tables(folder):
    """The tables that have rows, of load steps."""
    found = {str(path.relative_to(folder)): list(csv.DictReader(path.open()))
             for path in sorted(folder.rglob("*.csv")) if "sections" not in path.parts}
    return {name: rows for name, rows in found.items() if rows and "step" in rows[0]}


def whole_steps(folder):
    """The load steps that all of what a run left agrees on; None if nothing is left."""
    if not (folder / "summary.json").exists():
        return None
    steps = json.loads((folder / "summary.json").read_text())["load_steps"]
    for name, rows in tables(folder).items():
        found = {int(row["step"]) for row in rows if row["step"]}
        if not set(range(1, steps + 1)) <= found:
            return f"{name} has steps {sorted(found)} of {steps}"
    listed = re.findall(r'file="([^"]*)"', (folder / "solution.pvd").read_text())
    if len(listed) < steps or any(not (folder / name).exists() for name in listed):
        return f"solution.pvd lists {len(listed)} of {steps} steps"
    return steps


def same_numbers(one, other):
    """What numdiff says of two files; empty if they are equal."""
    done = subprocess.run(["numdiff", "--quiet", "--separators= \\t\\n,",
                           "--relative-tolerance", TOLERANCE, one, other],
                          capture_output=True, text=True)
    return f"{one.name}: {done.stdout or done.stderr}; " if done.returncode else ""


def differences(folder, other):
    """The same of the tables of two runs."""
    names = sorted(tables(folder).keys() | tables(other).keys())
    return "".join(same_numbers(folder / name, other / name) for name in names)


def check_kills(program, scene, work, kills, seed):
    whole = work / "whole"
    seconds = float("inf")
    for _ in range(2):
        start = time.monotonic()
        check(run(program, scene, whole)[0] == 0, "the uninterrupted run")
        seconds = min(seconds, time.monotonic() - start)
    numbers = random.Random(seed)
    for k in range(kills):
        folder = work / f"killed{k}"
        process = subprocess.Popen(command(program, scene, folder),
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        time.sleep(seconds * numbers.uniform(0.2, 0.95))
        process.kill()
        process.wait()
        steps = whole_steps(folder)
        check(steps is None or isinstance(steps, int),
              f"killed after step {steps}: what is there is whole")
        status, _, err = run(program, scene, folder, *(["--resume"] if steps else []))
        if steps == STEPS and "finished" in err:
            print("      (it had ended before)")
            continue
        off = differences(whole, folder)
        check(status == 0 and not off, f"  goes on to the same tables {off} {err[:200]}")
        summaries = [json.loads((path / "summary.json").read_text())
                     for path in (whole, folder)]
        check(all(summaries[0][key] == summaries[1][key]
                  for key in ("iterations", "load_steps", "warnings", "converged")),
              "  and says the same in its summary")


def check_kills_behind_steps(program, work):
    """All load steps are there, and what comes behind them is not: error bars, and the
    search for the first failure before that."""
    def words(folder):
        return [program, str(ROOT / "prm/cantilever.prm"), "--output", str(folder),
                "--set", "Body beam/Section=laminate", "--set", "Load factors=0.5, 1",
                "--set", "Strength/Criteria=maximum stress",
                "--set", "Find=first failure", "--set", "Goals/Error bars=richer",
                "--set", "Goals/Quantities=tip: uz | clamp: mx"]

    whole = work / "whole_behind"
    done = subprocess.run(words(whole), capture_output=True, text=True)
    check(done.returncode == 0, f"a run with Find and bars {done.stderr[:200]}")
    for number, (stop, times) in enumerate((("smallest reserve factor", 4),
                                            ("richer in axis", 1))):
        folder = work / f"killed_behind{number}"
        process = subprocess.Popen(words(folder), stdout=subprocess.PIPE,
                                   stderr=subprocess.DEVNULL, text=True)
        for line in process.stdout:
            times -= stop in line
            if times == 0:
                break
        process.kill()
        process.wait()
        summary = json.loads((folder / "summary.json").read_text())
        # While bars are made all else is there.
        bars = stop.startswith("richer")
        check(summary["load_steps"] == 2 and summary["converged"] == bars and
              (folder / "failure.csv").exists() == bars,
              f"killed at '{stop}': all steps are there")
        done = subprocess.run([*words(folder), "--resume"], capture_output=True, text=True)
        check(done.returncode == 0, f"  it goes on: {done.returncode} {done.stderr[:200]}")
        off = differences(whole, folder)
        for name in ("failure.csv", "goals.csv"):
            off += same_numbers(whole / name, folder / name)
        check(not off, f"  to the same tables {off}")
        ends = [json.loads((path / "summary.json").read_text())
                for path in (whole, folder)]
        check(all(ends[0].get(key) == ends[1].get(key) and key in ends[0] for key in
                  ("first_failure", "supports", "strength", "warnings", "converged")),
              "  and says the same in its summary")


# Friction: scene, overrides, the steps in which it is killed, their number.
PATHS = {
    "loop": ("prm/leaf_spring_loop.prm", ["Theory=EBBT"], (5, 9), 16),
    # Nearly unloaded: forces are measured by those of the step before.
    "unloaded": ("tests/scenes/friction_leaves.prm",
                 ["Load factors=1, 1, 0.001, 0.001", "Load push/Factors=0, 1, 0, 0",
                  "Body lower/Kinematics/Axis elements=10",
                  "Body upper/Kinematics/Axis elements=10"], (3,), 4)}


# Large rotations, the same: bodies that slide, a roller, contacts that pair anew, ends on faces,
# and a run that its linear one asks for.
LARGE = {
    "slide": ("tests/scenes/large_slide.prm", [], (2, 5, 7), 8),
    "roller": ("tests/scenes/large_roller.prm", [], (7, 12), 14),
    "pairs": ("tests/scenes/large_roller.prm",
              ["Theory=TBT", "Contact face/Discretization=surface to surface",
               "Contact face/Search distance=2"], (10,), 14),
    "corners": ("tests/scenes/large_corners.prm", [], (3, 5), 6),
    "friction": ("tests/scenes/large_slide.prm",
                 ["Contact faces/Friction=0.3", "Theory=TBT", "Contact faces/Search distance=2"],
                 (3, 6), 8),
    # Points that leave the contact and come back.
    "dragged": ("tests/scenes/large_friction_drag.prm",
                ["Supports=drag, bottom", "Load weight/Pressure=1.25", "Support drag/Factors=0, 1, 0, 1",
                 "Contact foot/Slave side=second"], (3,), 4),
    "follower": ("tests/scenes/large_follower.prm", ["Rotations=auto"], (2,), 4)}


def killed_in_step(words, folder, stop, n_steps):
    """Kills what `words` say for the folder in that load step."""
    process = subprocess.Popen(words(folder), stdout=subprocess.PIPE,
                               stderr=subprocess.DEVNULL, text=True)
    for line in process.stdout:
        # The linear run before has steps, too, but leaves nothing.
        if line.startswith(f"Load step {stop} of") and (folder / "summary.json").exists():
            break
    process.kill()
    process.wait()
    steps = json.loads((folder / "summary.json").read_text())["load_steps"]
    check(0 < steps < n_steps, f"killed in step {stop}: {steps}")


def resumed(program, work, name, path, *more):
    """Of a row of PATHS or LARGE the folders of the whole run and, for each step in which it is
    killed, of the one that went on."""
    scene, overrides, stops, n_steps = path

    def words(folder):
        return [program, str(ROOT / scene), "--output", str(folder),
                *(word for override in (*overrides, *more) for word in ("--set", override))]

    whole = work / f"whole_{name}"
    done = subprocess.run(words(whole), capture_output=True, text=True)
    check(done.returncode == 0, f"{name} {done.stderr[:200]}")
    for stop in stops:
        folder = work / f"killed_{name}{stop}"
        killed_in_step(words, folder, stop, n_steps)
        done = subprocess.run([*words(folder), "--resume"], capture_output=True, text=True)
        check(done.returncode == 0, f"  goes on: {done.returncode} {done.stderr[:200]}")
        yield whole, folder


def check_path(program, work, name):
    """Friction remembers: a path that ends in its middle goes on as if it had not, each
    step in as many substeps."""
    for whole, folder in resumed(program, work, name, PATHS[name], "Substeps=auto"):
        off = differences(whole, folder) + same_numbers(whole / "goals.csv",
                                                        folder / "goals.csv")
        check(not off, f"  to the same {off}")
        ends = [json.loads((path / "summary.json").read_text())["path"]
                for path in (whole, folder)]
        check(ends[0] == ends[1], f"  to the last bit: {ends}")


def check_large(program, work, name):
    """Bodies that turn go on from the places that their surfaces have slid to."""
    for whole, folder in resumed(program, work, name, LARGE[name]):
        off = [table for table in sorted(tables(whole).keys() | tables(folder).keys())
               if (whole / table).read_bytes() != (folder / table).read_bytes()]
        check(not off, f"  to the same bytes {off}")
        ends = [json.loads((path / "summary.json").read_text()) for path in (whole, folder)]
        check(all(ends[0][key] == ends[1][key] for key in
                  ("iterations", "contacts", "supports", "warnings", "energy", "converged")),
              "  and says the same in its summary")


def check_refused(program, scene, work):
    def refused(what, words, *arguments):
        status, _, err = run(program, scene, *arguments)
        check(status == 1 and words in err, f"{what}: {status} {err[:120]}")
    refused("a finished run", "[report.restart-finished]", work / "whole", "--resume")
    refused("another scene", "[report.restart-of-other-scene]", work / "whole", "--resume", "--set",
            "Title=another")
    refused("no folder", "[report.no-restart]", work / "nowhere", "--resume")
    check(not (work / "nowhere").exists(), "and none is made")
    (work / "strange").mkdir()
    (work / "strange/restart").write_text("of somebody else")
    refused("a strange folder", "is damaged", work / "strange", "--resume")


def check_full_disk(program, scene, work):
    folder = work / "full"
    # Rows of one step fit, those of all steps do not.
    table = max((path for path in (work / "whole").glob("**/*.csv")),
                key=lambda path: path.stat().st_size)
    limit = table.stat().st_size // 3 // 1024
    line = " ".join(f"'{word}'" for word in command(program, scene, folder,
                                                    "--set", "Write VTU=false"))
    done = subprocess.run(["bash", "-c", f"ulimit -f {limit}; exec {line}"],
                          capture_output=True, text=True)
    steps = json.loads((folder / "summary.json").read_text())["load_steps"]
    found = [{int(row["step"]) for row in rows} for rows in tables(folder).values()]
    check(done.returncode == 1 and "[base.cannot-write]" in done.stderr and 0 < steps < STEPS
          and all(set(range(1, steps + 1)) <= numbers for numbers in found),
          f"a full disk at step {steps + 1} of {STEPS}: {done.returncode} "
          f"{done.stderr[:150]}")
    status, _, err = run(program, scene, folder, "--set", "Write VTU=false", "--resume")
    off = differences(work / "whole", folder)
    check(status == 0 and not off, f"goes on to the same tables {off} {err[:200]}")


def check_fails_again(program, work):
    """A load step that fails fails again, in words, and those before it stay."""
    scene = str(Path(__file__).resolve().parents[1] / "scenes/crossed_beams.prm")
    folder = work / "fails"
    for more in ([], ["--resume"]):
        done = subprocess.run(
            [program, scene, "--output", str(folder), "--set", "Load factors=1, 100",
             "--set", "Write VTU=false", *more], capture_output=True, text=True)
        steps = json.loads((folder / "summary.json").read_text())["load_steps"]
        check(done.returncode == 2 and "otations reach" in done.stderr and steps == 1
              and all({row["step"] for row in rows} == {"1"}
                      for rows in tables(folder).values()),
              f"a second step that fails, {more or 'at first'}: {done.returncode} "
              f"{done.stderr[:100]}")


def main():
    program, scene = str(Path(sys.argv[1]).resolve()), str(Path(sys.argv[2]).resolve())
    work = Path(sys.argv[3])
    kills = int(sys.argv[4]) if len(sys.argv) > 4 else 4
    seed = int(sys.argv[5]) if len(sys.argv) > 5 else 1
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    os.environ.update(OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1")
    check_kills(program, scene, work, kills, seed)
    check_kills_behind_steps(program, work)
    for name in PATHS:
        check_path(program, work, name)
    for name in LARGE:
        check_large(program, work, name)
    check_refused(program, scene, work)
    check_full_disk(program, scene, work)
    check_fails_again(program, work)
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit("Usage: check_resume.py LAMELLA SCENE.prm WORKDIR [KILLS] [SEED]")
    main()
