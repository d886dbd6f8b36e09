#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs scenes on several processes and compares them with one process.

Usage: check_parallel.py LAMELLA MPIRUN FILE.parallel WORKDIR

A .parallel file holds comments (#) and the lines

    run SCENE.prm [arguments]    the scene, relative to the file
    processes N [N ...]          on so many, each compared with one process
    with [arguments]             more arguments for these, not for the one
    tolerance X                  of displacements, over the largest of a column's
                                 kind in the file; stresses may differ 100 times
                                 as much, since they are derivatives of them
    compare FILE [FILE ...]      of the results; probes.csv if there is no line

or, for a scene that is to be refused,

    exit STATUS                  on all of the processes
    says FRAGMENT                in the message (a line a fragment)
"""

import csv
import json
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

KINDS = {"displacement": r"(u[xyz]|gap)$", "stress": r"(s[xyz123]{2}|.*pressure)$",
         "force": r".*force.*|.*f[xyz]$", "reserve": r".*reserve_factor$",
         "goal": r"(value|corrected|bar)$",
         "beyond": r"(stiffening|buckling_factor)$"}


def read_case(path):
    case = {"says": [], "processes": [], "compare": [], "with": []}
    for line in path.read_text().splitlines():
        words = shlex.split(line, comments=True)
        if not words:
            continue
        key, rest = words[0], words[1:]
        if key == "run":
            case["run"] = rest
        elif key == "processes":
            case["processes"] = [int(word) for word in rest]
        elif key == "says":
            case["says"].append(line.split(maxsplit=1)[1].strip())
        elif key in ("compare", "with"):
            case[key] += rest
        elif key in ("tolerance", "exit"):
            case[key] = float(rest[0])
        else:
            sys.exit(f"{path}: not understood: {line}")
    if not case.get("run") or not case["processes"]:
        sys.exit(f"{path}: needs the lines `run` and `processes`")
    return case


def run(program, mpirun, words, path, processes, folder):
    scene = (path.parent / words[0]).resolve()
    launcher = [mpirun, "--oversubscribe", "-np", str(processes)]
    return subprocess.run(
        (launcher if processes > 1 else []) +
        [program, str(scene), *words[1:], "--output", str(folder)],
        capture_output=True, text=True, cwd=folder.parent)


def table(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def differences(one, many):
    """Of each kind of columns, the largest difference over the largest value."""
    if len(one) != len(many):
        raise SystemExit(f"FAIL: {len(many)} rows, not {len(one)}")
    if not any(re.match(pattern, c) for pattern in KINDS.values() for c in one[0]):
        raise SystemExit(f"FAIL: nothing to compare among {', '.join(one[0])}")
    for kind, pattern in KINDS.items():
        columns = [c for c in one[0] if re.match(pattern, c)]
        if any(bool(a[c]) != bool(b[c]) for a, b in zip(one, many) for c in columns):
            raise SystemExit(f"FAIL: a {kind} that only some have")
        # Goals have units of their own, and a scale.
        pairs = [(float(a[c]) / float(a.get("scale") or 1.),
                  float(b[c]) / float(a.get("scale") or 1.)) for a, b in zip(one, many)
                 for c in columns if a[c]]
        largest = max((abs(a) for a, _ in pairs), default=0.)
        if largest > 0.:
            yield kind, max(abs(a - b) for a, b in pairs) / largest


def faults_of_files(workdir, processes):
    """The parts that ParaView is pointed to are there, cells in each or not."""
    folder = workdir / str(processes)
    for collection in folder.glob("solution*.pvd"):
        for name in re.findall(r'file="([^"]+)"', collection.read_text()):
            parts = re.findall(r'Source="([^"]+)"', (folder / name).read_text(
                errors="replace"))
            if processes > 1 and len(parts) != processes:
                yield f"{name} has {len(parts)} parts"
            for part in parts:
                if not (folder / part).is_file():
                    yield f"{part} is missing"
    summary = json.loads((folder / "summary.json").read_text())
    if summary["processes"] != processes:
        yield f"summary.json says {summary['processes']} processes"


def check_results(done, case, workdir, processes):
    if done.returncode != 0:
        yield f"exit status {done.returncode}\n{done.stderr}"
        return
    if done.stdout.count("Results are in") != 1:
        yield "the report is printed more than once"
    for name in case["compare"] or ["probes.csv"]:
        one, many = (table(workdir / folder / name)
                     for folder in ("one", str(processes)))
        for kind, difference in differences(one, many):
            allowed = case["tolerance"] * (1. if kind == "displacement" else 100.)
            print(f"{processes} processes, {name}, {kind}: {difference:.1e}")
            if not difference <= allowed:
                yield f"more than {allowed:.1e}"
    yield from faults_of_files(workdir, processes)


def check_refusal(done, case):
    # What the launcher adds begins otherwise.
    if done.returncode != case["exit"]:
        yield f"exit status {done.returncode}, not {case['exit']:.0f}"
    if done.stderr.count("lamella: ") != 1:
        yield f"not one message:\n{done.stderr}"
    flat = " ".join(done.stderr.split())
    for fragment in case["says"]:
        if fragment not in flat:
            yield f"the message does not say: {fragment}\n{done.stderr}"


def main():
    if len(sys.argv) != 5:
        sys.exit("Usage: check_parallel.py LAMELLA MPIRUN FILE.parallel WORKDIR")
    program, mpirun = str(Path(sys.argv[1]).resolve()), sys.argv[2]
    path, workdir = Path(sys.argv[3]), Path(sys.argv[4]).resolve()
    case = read_case(path)
    shutil.rmtree(workdir, ignore_errors=True)
    workdir.mkdir(parents=True)
    faults = []
    if "exit" not in case:
        done = run(program, mpirun, case["run"], path, 1, workdir / "one")
        if done.returncode != 0:
            sys.exit(f"one process: exit status {done.returncode}\n{done.stderr}")
    for processes in case["processes"]:
        done = run(program, mpirun, case["run"] + case["with"], path, processes,
                   workdir / str(processes))
        faults += (check_refusal(done, case) if "exit" in case else
                   check_results(done, case, workdir, processes))
        if "exit" in case and (workdir / str(processes)).exists():
            faults.append("an output folder is left behind")
    for fault in faults:
        print("FAIL:", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
