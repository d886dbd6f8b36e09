#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ends a run as Ctrl-C does and reads what it says of its folder; then goes on with it.

Usage: check_interrupted.py LAMELLA SCENE.prm TOLERANCE.prm TRADE.prm WORKDIR

Ended while bodies are made it says that the folder is as it was; before its first load
step that nothing is there; later how many load steps are, which are those of summary.json,
and that --resume goes on, which it does; while error bars are made that all else is there,
and --resume makes them. It ends by
the signal, 130 to a shell. A run that is done says nothing of the kind. A run to a
tolerance names the pass whose results are there, a trade the variants.
"""

import json
import re
import shutil
import signal
import subprocess
import sys
from pathlib import Path

STEPS = 60
faults = []


def expect(truth, what):
    print(("ok    " if truth else "FAIL  ") + what)
    if not truth:
        faults.append(what)


def interrupted(words, line, signal_number):
    """Starts the run, waits for @p line, sends the signal: status and error output."""
    run = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    for said in run.stdout:
        if said.startswith(line):
            break
    run.send_signal(signal_number)
    _, errors = run.communicate()
    return run.returncode, errors


def check_setup(program, scene, output):
    """Ended as soon as it may be, while bodies are made: an earlier run is still there."""
    words = [program, scene, "--output", str(output)]
    subprocess.run(words, check=True, capture_output=True)
    before = {path: path.read_bytes() for path in output.rglob("*") if path.is_file()}
    run = subprocess.Popen([*words, "--set", "Theory=LE-8"], stdout=subprocess.PIPE,
                           stderr=subprocess.PIPE, text=True)
    caught = 0
    while run.poll() is None and not caught & 1 << signal.SIGINT - 1:
        status = Path(f"/proc/{run.pid}/status").read_text()
        caught = int(re.search(r"SigCgt:\s*(\w+)", status)[1], 16)
    run.send_signal(signal.SIGINT)
    _, errors = run.communicate()
    expect(run.returncode == -signal.SIGINT and
           f"interrupted before anything was solved. {output} is as it was." in errors,
           errors.strip())
    expect(before == {path: path.read_bytes() for path in output.rglob("*") if path.is_file()},
           "so it is")


def check_bars(program, scene, output):
    """Ended while bars are made it has all else, and makes them when it goes on."""
    words = [program, scene, "--output", str(output), "--set", "Goals/Error bars=richer"]
    status, errors = interrupted(words, "Error bars, from richer", signal.SIGINT)
    expect(status == -signal.SIGINT, f"bars end by the signal ({status})")
    told = (f"interrupted while error bars were made. {output} has all results but these. The "
            "same command with --resume makes them; a run with --set \"Goals/Error bars=false\" "
            "makes none.")
    expect(told in errors, errors.strip())
    summary = json.loads((output / "summary.json").read_text())
    expect(summary["converged"] and not (output / "goals.csv").exists(), "all but bars")
    rows = (output / "probes.csv").read_text()
    done = subprocess.run([*words, "--resume"], capture_output=True, text=True)
    expect(done.returncode == 0 and (output / "goals.csv").exists() and
           rows == (output / "probes.csv").read_text(), f"--resume makes them {done.stderr}")


def check_tolerance_run(program, scene, output):
    """Ended in the bars of its second pass it has the first, in those of that nothing."""
    words = [program, scene, "--output", str(output), "--set", "Goals/Tolerance=0.0001"]
    _, errors = interrupted(words, "Pass 1", signal.SIGINT)
    expect("interrupted in the first pass: nothing of this run is in " in errors,
           errors.strip())
    status, errors = interrupted(words, "Pass 2", signal.SIGINT)
    expect(status == -signal.SIGINT, f"a run to a tolerance ends by the signal ({status})")
    told = f"{output} has the results of pass 1. A run to a Tolerance begins anew."
    expect(told in errors and (output / "summary.json").exists(), errors.strip())


def check_trade(program, scene, output):
    for number in (signal.SIGINT, signal.SIGTERM):
        folder = output / number.name
        words = [program, "trade", scene, "--output", str(folder)]
        status, errors = interrupted(words, "Variant 2 ", number)
        expect(status == -number, f"a trade ends by the signal ({status})")
        told = (f"{folder}/variants has the variants before this one. The same command goes on "
                "with it.")
        expect(told in errors and list(folder.glob("variants/01_*/variant.json")), errors.strip())
        expect(len(errors.strip().splitlines()) == 1, "one line")


def check_revised(program, folder):
    """A run that has changed the contacts of its scene."""
    scene = Path(__file__).resolve().parents[1] / "scenes/large_corner_pull.prm"
    words = [program, str(scene), "--set", "Contacts=face", "--output", str(folder)]
    _, errors = interrupted(words, "Load step 7 ", signal.SIGINT)
    expect("No run can go on from there" in errors, errors.strip())
    done = subprocess.run([*words, "--resume"], capture_output=True, text=True)
    expect(done.returncode == 1 and "[report.restart-revised]" in done.stderr,
           done.stderr.strip())


def main():
    program, scene, to_tolerance, trade = sys.argv[1:5]
    folder = Path(sys.argv[5])
    shutil.rmtree(folder, ignore_errors=True)
    output = folder / "run"
    words = [program, scene, "--output", str(output), "--set", "Load factors=" +
             ", ".join(str((k + 1) / STEPS) for k in range(STEPS))]
    status, errors = interrupted(words, "Load step 1 ", signal.SIGINT)
    expect(status == -signal.SIGINT, f"it ends by the signal ({status})")
    before_first = "interrupted before the first load step was done" in errors
    expect(before_first or "has load step 1 of" in errors, errors.strip())

    for signal_number in (signal.SIGINT, signal.SIGTERM):
        status, errors = interrupted(words, "Load step 6 ", signal_number)
        expect(status == -signal_number, f"it ends by the signal ({status})")
        done = json.loads((output / "summary.json").read_text())["load_steps"]
        told = (f"{output} has load steps 1 to {done} of {STEPS}. The same command with "
                "--resume goes on from there.")
        expect(5 <= done < STEPS and told in errors, errors.strip())
        expect(len(errors.strip().splitlines()) == 1, "one line")
    done = subprocess.run([*words, "--resume"], capture_output=True, text=True)
    expect(done.returncode == 0 and "interrupted" not in done.stderr and
           json.loads((output / "summary.json").read_text())["load_steps"] == STEPS,
           f"--resume goes on {done.stderr}")
    check_revised(program, folder / "revised")
    check_setup(program, to_tolerance, folder / "setup")
    check_bars(program, to_tolerance, folder / "bars")
    check_tolerance_run(program, to_tolerance, folder / "tolerance")
    check_trade(program, trade, folder / "trade")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
