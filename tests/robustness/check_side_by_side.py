#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs that share a machine, and a folder.

Usage: check_side_by_side.py LAMELLA SCENE.prm WORKDIR [STARTS]

- STARTS (40) times `--validate`, four at a time: all must start. Runs of a parameter
  study share nothing, least of all a folder of MPI that one of them removes.
- Two runs into one folder at once: one of them ends with 1 and says why.
- A run that is killed leaves nothing that looks finished: no summary beside the
  fields of another run.
- A second scene in the folder of a first one: nothing of the first is left, and
  nothing is touched that no run writes.
- A folder that is removed during the run, a reader of the output that goes away.
"""

import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

faults = []


def check(holds, what):
    print(("ok    " if holds else "FAIL  ") + what)
    if not holds:
        faults.append(what)


def start(program, scene, output, *arguments):
    return subprocess.Popen([program, scene, "--output", str(output), *arguments],
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def end(process):
    out, err = process.communicate(timeout=300)
    return process.returncode, out, err


def check_starts(program, scene, folder, n):
    def one(k):
        return end(start(program, scene, folder / f"start{k}", "--validate"))
    with ThreadPoolExecutor(4) as pool:
        ends = list(pool.map(one, range(n)))
    bad = [e for e in ends if e[0] != 0]
    check(not bad, f"{n} starts, four at a time" + (f": {bad[0][2][:300]}" if bad else ""))


def many_steps(n):
    return ["--set", "Load factors=" + ", ".join(str((k + 1) / n) for k in range(n))]


def wait_for(path, process):
    while process.poll() is None and not path.exists():
        time.sleep(0.005)
    return path.exists()


def check_one_folder(program, scene, folder):
    # Some seconds of work, so that the second run meets the first.
    first = start(program, scene, folder, *many_steps(1000))
    check(wait_for(folder / "solution_0001.vtu", first), "the first run is at work")
    status, _, err = end(start(program, scene, folder))
    check(status == 1 and "[report.folder-in-use]" in err,
          "a second run into the same folder is refused")
    check(end(first)[0] == 0 and (folder / "summary.json").exists(),
          "the first run ends well")


def inode(path):
    """What tells a file from another of the same name; None if there is none."""
    try:
        return path.stat().st_ino
    except FileNotFoundError:
        return None


def check_killed(program, scene, folder):
    check(end(start(program, scene, folder))[0] == 0, "a run that ends")
    earlier = (folder / "summary.json").stat().st_ino
    run = start(program, scene, folder, *many_steps(1000))
    # The first step of the second run replaces that of the first, and has a summary
    # of its own soon after.
    while run.poll() is None and inode(folder / "summary.json") == earlier:
        time.sleep(0.002)
    run.send_signal(signal.SIGKILL)
    run.communicate()
    summary = folder / "summary.json"
    check(not summary.exists() or not json.loads(summary.read_text())["converged"],
          "a killed run leaves no old summary")
    check(end(start(program, scene, folder))[0] == 0
          and json.loads((folder / "summary.json").read_text())["converged"]
          and not list(folder.rglob("*.new")),
          "the next run ends well, and cleans up")


def check_replaced(program, scene, folder):
    note = folder / "notes.txt"
    note.write_text("of the user")
    end(start(program, scene, folder, *many_steps(3)))
    check((folder / "solution_0003.vtu").exists(), "three steps")
    status, _, _ = end(start(program, scene, folder, "--set", "Probes=",
                             "--set", "Lines=", "--set", "Write VTU=false"))
    left = {str(p.relative_to(folder)) for p in folder.rglob("*") if p.is_file()}
    check(status == 0 and not any(name.startswith(("solution", "lines/")) for name in left),
          f"nothing of the first scene is left: {sorted(left)}")
    check(note.read_text() == "of the user", "what no run writes is not touched")


def check_faults_on_the_way(program, scene, folder):
    run = start(program, scene, folder, *many_steps(1000))
    wait_for(folder / "solution_0002.vtu", run)
    shutil.rmtree(folder, ignore_errors=True)
    status, _, err = end(run)
    check(status == 1 and re.search(r"\[(base.cannot-write|report.folder-removed)\]", err),
          f"a folder that is removed: {status} {err[:100]}")
    shutil.rmtree(folder, ignore_errors=True)
    run = subprocess.run(
        ["bash", "-c", 'set -o pipefail; "$0" "$1" --output "$2" | head -1 >&2; '
         'exit ${PIPESTATUS[0]}', program, scene, str(folder)],
        capture_output=True, text=True)
    check(run.returncode == 0 and (folder / "summary.json").exists(),
          "| head -1 ends the reading, not the run")
    limited = subprocess.run(
        ["bash", "-c", 'ulimit -f 20; exec "$0" "$1" --output "$2"',
         program, scene, str(folder / "full")], capture_output=True, text=True)
    check(limited.returncode == 1 and "[base.cannot-write]" in limited.stderr
          and not list(folder.rglob("full/*.vtu*")),
          f"a file beyond its limit: {limited.returncode} {limited.stderr[:100]}")


def main():
    program, scene = str(Path(sys.argv[1]).resolve()), str(Path(sys.argv[2]).resolve())
    work = Path(sys.argv[3])
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    os.environ.update(OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1")
    check_starts(program, scene, work, int(sys.argv[4]) if len(sys.argv) > 4 else 40)
    check_one_folder(program, scene, work / "shared")
    check_killed(program, scene, work / "shared")
    check_replaced(program, scene, work / "shared")
    check_faults_on_the_way(program, scene, work / "gone")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit("Usage: check_side_by_side.py LAMELLA SCENE.prm WORKDIR [STARTS]")
    main()
