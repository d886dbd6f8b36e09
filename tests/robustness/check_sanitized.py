#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Unit tests and sixty scenes under AddressSanitizer and UBSan: nothing to report.

Usage: check_sanitized.py ROOT BUILD WORKDIR

Builds the project once more in the folder BUILD (cmake -DLAMELLA_SANITIZE=ON), then
runs the unit tests and the scenes of tests/scenes and tests/bad_input, sixty in all,
spread evenly. What a sanitizer finds ends the process with the status 99.
"""

import os
import shlex
import subprocess
import sys
from pathlib import Path

SCENES = 60
FOUND = 99
# What libraries keep until the end is not lost by us; and Open MPI's own threads
# unload libraries before the leaks are looked for.
OPTIONS = {"ASAN_OPTIONS": f"detect_leaks=0:exitcode={FOUND}:"
                           "detect_odr_violation=0:alloc_dealloc_mismatch=0",
           "UBSAN_OPTIONS": f"halt_on_error=1:exitcode={FOUND}:print_stacktrace=1",
           "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}


def build(root, folder):
    subprocess.run(["cmake", "-G", "Ninja", "-S", root, "-B", folder,
                    "-DLAMELLA_SANITIZE=ON"], check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", folder, "--target", "lamella", "unit_tests"],
                   check=True, stdout=subprocess.DEVNULL)


def runs_of(root):
    """Sixty runs of the scene and bad-input tests, spread evenly."""
    cases = []
    for path in sorted(root.glob("tests/scenes/*.expect")) + sorted(
            root.glob("tests/bad_input/*.bad")):
        for line in path.read_text().splitlines():
            words = shlex.split(line) if line.startswith("run ") else []
            if words and words[1] not in ("export", "trade") and not words[1].startswith("new:") \
                    and "{workdir}" not in line:
                cases.append((path, words[1:]))
    step = max(1, len(cases) // SCENES)
    return cases[::step][:SCENES]


def run(command, what, where):
    done = subprocess.run(command, capture_output=True, text=True, cwd=where,
                          env={**os.environ, **OPTIONS})
    reported = done.returncode in (FOUND, -6) or "Sanitizer" in done.stderr \
        or "runtime error:" in done.stderr
    if reported:
        print(f"FAIL  {what}\n{done.stderr[-3000:]}")
    return not reported


def main():
    root, folder, work = (Path(word).resolve() for word in sys.argv[1:4])
    build(root, folder)
    work.mkdir(parents=True, exist_ok=True)
    clean = run([folder / "tests/unit_tests"], "unit tests", work)
    cases = runs_of(root)
    for number, (path, words) in enumerate(cases):
        clean &= run([folder / "lamella", path.parent / words[0], *words[1:],
                      "--output", work / f"run{number}"], path.name, work)
    print(f"{len(cases)} scenes and the unit tests: {'clean' if clean else 'reports above'}")
    sys.exit(0 if clean else 1)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit("Usage: check_sanitized.py ROOT BUILD WORKDIR")
    main()
