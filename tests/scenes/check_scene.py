#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs scenes and compares their results with the numbers of a .expect file.

Usage: check_scene.py LAMELLA FILE.expect WORKDIR [CASE...]

A .expect file is a table of variants, with comments (#). A variant begins with a line

    case NAME: WHAT IS VARIED

and is a test of its own, of the name scene/NAME (a file without such lines is one case,
named after the file). Without CASE all cases of the file are run. A case holds one or
more runs. A run is a line `run SCENE.prm [arguments]` (the path relative to the file;
`new:KIND` is the scene that `lamella new --kind KIND` writes), at most one line
`again [arguments]` (the same scene once more, with other arguments), and rows

    KEY | VALUE | TOLERANCE | SOURCE

Comments directly before a run say what it varies and are printed with it. A line
`all [arguments]` before the first run of a case gives arguments that its runs share.
SOURCE says where the expected number comes from and is never empty. TOLERANCE
is `0.1%` (relative), `abs 1e-9`, `exact`, `below` (|result| <= VALUE), `limit`
(result <= VALUE) or `above` (result >= VALUE). KEY is one of

    summary:contacts.middle.force.2   an entry of summary.json; `#` as the last
                                      part counts the entries of a list
    section:NAME:compliance.4.3       the same of sections/NAME.json
    coupling:NAME                     the largest coupling in the stiffness of
                                      sections/NAME.json: |k_ij| over
                                      sqrt(k_ii k_jj), i and j different
    probe:NAME:uz                     at the last step; probe:NAME/PLY:uz where
                                      the point has a row a ply
    line:NAME:COLUMN:mean             over the arc length, at the last step;
                                      also max, min, maxabs; line:NAME/PLY:... of
                                      one ply, as in an interface
    contact:NAME:COLUMN:sum           over all pairs at the last step; also max,
                                      min
    kkt_residual:NAME                  how far the pairs of a contact are from
                                      Eq. 18, pair by pair out of its table: a
                                      force that pulls over the largest force,
                                      a gap that is the wrong way (open under a
                                      force, or closed without one) over the
                                      largest way that gaps have changed by
    difference:ux,uy,uz               `run` against `again`: the largest
                                      difference in all probes and lines over
                                      the largest magnitude of these columns
    history:COLUMN                    of history.csv at the last step; history:COLUMN@2 at
                                      the second
    goal:NAME                         a goal's value, as in goal:tip: uz; with the
                                      tolerance `bar` it is within the run's own
                                      bar, which is trusted, and with `no bar` it
                                      has none
    ply:BODY/PLY:CRITERION:COLUMN     of plies.csv at the last step; `mode` is a text,
                                      an empty cell `none`
    along:BODY/PLY:max                inverse_reserve_factor of plies_along.csv at the
                                      last step; also min, and count of stations
    file:NAME                         `present` or `absent` in the output folder
    exit                              the exit status (0 where not named)
    stdout:REGEX, stderr:REGEX        `present` or `absent`, tolerance `exact`
"""

import csv
import json
import math
import os
import re
import shlex
import shutil
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path


class Fault(Exception):
    """What makes a row, or the whole file, impossible to compare."""


# ---- the .expect file


@dataclass
class CaseRun:
    """One `run` line of a case with what follows it."""

    run: list
    comments: list
    again: list = None
    rows: list = field(default_factory=list)


@dataclass
class Case:
    """A variant of a scene, what it varies, and its runs."""

    name: str
    what: str = ""
    shared: list = None
    runs: list = field(default_factory=list)


def begin_case(line, cases):
    name, colon, what = (part.strip() for part in line.partition(" ")[2].partition(":"))
    if not re.fullmatch(r"[\w.-]+", name) or not what:
        raise Fault("not `case NAME: WHAT IS VARIED`")
    if any(case.name == name for case in cases):
        raise Fault(f"a second case {name}")
    return Case(name, what)


def add_line(line, case, comments):
    """Adds a line that is no comment to its case."""
    word = line.split(maxsplit=1)[0]
    if word in ("all", "run", "again"):
        arguments = shlex.split(line)[1:]
        if word == "all" and case.shared is None and not case.runs:
            case.shared = arguments
        elif word == "run" and arguments:
            case.runs.append(CaseRun(arguments + (case.shared or []), comments))
        elif word == "again" and case.runs and case.runs[-1].again is None:
            case.runs[-1].again = arguments + (case.shared or [])
        else:
            raise Fault(f"`{word}` is out of place")
        return
    # From the right, since a regular expression may hold the separator.
    cells = [cell.strip() for cell in line.rsplit("|", 3)]
    if len(cells) != 4 or not all(cells):
        raise Fault("not KEY | VALUE | TOLERANCE | SOURCE")
    if not case.runs:
        raise Fault("a row before the first `run SCENE.prm`")
    case.runs[-1].rows.append(cells)


def read_expectations(path):
    """Returns the cases of the file."""
    cases, comments = [], []
    for number, line in enumerate(path.read_text().splitlines(), 1):
        line = line.strip()
        if line.startswith("#"):
            comments.append(line)
            continue
        try:
            if line.startswith("case "):
                cases.append(begin_case(line, cases))
            elif line:
                if not cases:
                    cases.append(Case(path.stem))
                add_line(line, cases[-1], comments)
        except Fault as fault:
            raise Fault(f"line {number}: {fault}") from None
        comments = []
    if len(cases) > 1 and not cases[0].what:
        raise Fault("lines before the first `case NAME: WHAT IS VARIED`")
    for case in cases or [Case(path.stem)]:
        if not case.runs:
            raise Fault(f"case {case.name}: no line `run SCENE.prm`")
        for run in case.runs:
            if not run.rows:
                raise Fault(f"no row to compare for `run {shlex.join(run.run)}`")
    return cases


# ---- what a run left behind


class Run:
    """One run of the program and its output, read on demand."""

    def __init__(self, program, scene, arguments, folder):
        shutil.rmtree(folder, ignore_errors=True)
        self.folder = folder
        threads = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}
        done = subprocess.run(
            [program, str(scene), "--output", str(folder), *arguments],
            capture_output=True, text=True, env={**threads, **os.environ})
        self.status, self.stdout, self.stderr = (
            done.returncode, done.stdout, done.stderr)

    def table(self, name, step=None):
        """The rows of a CSV file at a step, the last one by default."""
        path = self.folder / name
        if not path.is_file():
            raise Fault(f"{name} was not written")
        with path.open(newline="") as file:
            rows = list(csv.DictReader(file))
        if not rows:
            raise Fault(f"{name} is empty")
        step = int(step or max(int(row["step"]) for row in rows))
        found = [row for row in rows if int(row["step"]) == step]
        if not found:
            raise Fault(f"{name} has no step {step}")
        return found

    def lines(self):
        return sorted(path.name for path in (self.folder / "lines").glob("*.csv"))


def number(row, column):
    """A finite number: a NaN would slip through max() and min()."""
    if column not in row:
        raise Fault(f"no column {column}")
    try:
        value = float(row[column])
    except (TypeError, ValueError):
        raise Fault(f"{column} is not a number: {row[column]!r}") from None
    if not math.isfinite(value):
        raise Fault(f"{column} is {value}")
    return value


def numbers(rows, column):
    return [number(row, column) for row in rows]


# ---- the keys


def json_value(run, name, path):
    file = run.folder / name
    if not file.is_file():
        raise Fault(f"{name} was not written")
    value = json.loads(file.read_text())
    for part in path.split("."):
        if part == "#" and isinstance(value, (list, dict)):
            value = len(value)
        elif isinstance(value, list) and part.isdigit() and int(part) < len(value):
            value = value[int(part)]
        elif isinstance(value, dict) and part in value:
            value = value[part]
        else:
            raise Fault(f"{name} has no {path} (at {part})")
    return value


def goal(run, name):
    goals = json_value(run, "summary.json", "goals")
    if name not in goals:
        raise Fault(f"no goal {name}; there are {', '.join(goals)}")
    return goals[name]


def coupling(run, section):
    k = json_value(run, f"sections/{section}.json", "stiffness")
    return max(abs(k[i][j]) / math.sqrt(k[i][i] * k[j][j])
               for i in range(6) for j in range(6) if i != j)


def probe_value(run, name, column):
    name, _, ply = name.partition("/")
    rows = [row for row in run.table("probes.csv") if row["probe"] == name
            and (not ply or row["ply"] == ply)]
    if not rows:
        raise Fault(f"probes.csv has no such probe: {name} {ply}".rstrip())
    if len(rows) > 1:
        plies = ", ".join(row["ply"] for row in rows)
        raise Fault(f"several rows; name one of the plies {plies}")
    return number(rows[0], column)


def ply_value(run, ply, criterion, column):
    rows = [row for row in run.table("plies.csv")
            if f"{row['body']}/{row['ply']}" == ply and row["criterion"] == criterion]
    if len(rows) != 1 or column not in rows[0]:
        raise Fault(f"plies.csv has no such cell: {ply} {criterion} {column}")
    text = rows[0][column]
    return text or "none" if column == "mode" or not text else float(text)


def along_value(run, ply, what):
    values = [number(row, "inverse_reserve_factor") for row in run.table("plies_along.csv")
              if f"{row['body']}/{row['ply']}" == ply and row["inverse_reserve_factor"]]
    if not values or what not in ("min", "max", "count"):
        raise Fault(f"plies_along.csv has no such rows: {ply} {what}")
    return {"min": min, "max": max, "count": len}[what](values)


def mean(abscissae, values):
    """Trapezoidal: the two sides of a ply interface have no length between."""
    length = abscissae[-1] - abscissae[0]
    if not length > 0:
        raise Fault("the line has no length")
    pairs = list(zip(abscissae, values))
    return sum((b[0] - a[0]) * (a[1] + b[1]) / 2
               for a, b in zip(pairs, pairs[1:])) / length


def line_value(run, name, column, how):
    name, _, ply = name.partition("/")
    rows = [row for row in run.table(f"lines/{name}.csv")
            if not ply or row["ply"] == ply]
    if not rows:
        raise Fault(f"lines/{name}.csv has no ply {ply}")
    values = numbers(rows, column)
    if how == "mean":
        return mean(numbers(rows, "s"), values)
    return reduce_column(values, how, ("max", "min", "maxabs"))


def contact_value(run, name, column, how):
    values = numbers(run.table(f"contact_{name}.csv"), column)
    return reduce_column(values, how, ("sum", "max", "min"))


def kkt_residual(run, name):
    rows = run.table(f"contact_{name}.csv")
    forces, gaps = numbers(rows, "force"), numbers(rows, "gap")
    largest = max(map(abs, forces))
    way = max(abs(gap - first) for gap, first in zip(gaps, numbers(rows, "initial_gap")))
    if not largest > 0. or not way > 0.:
        raise Fault(f"nothing touches in contact_{name}.csv")
    wrong = [gap / way if force else -gap / way for force, gap in zip(forces, gaps)]
    return max(max(wrong), -min(forces) / largest)


def reduce_column(values, how, known):
    if how not in known:
        raise Fault(f"unknown reduction {how}; known: {', '.join(known)}")
    return {"max": max, "min": min, "sum": math.fsum,
            "maxabs": lambda v: max(map(abs, v))}[how](values)


def difference(run, again, columns):
    if again is None:
        raise Fault("needs a line `again`")
    if run.lines() != again.lines():
        raise Fault("the two runs wrote different lines")
    files = [f"lines/{name}" for name in run.lines()]
    if (run.folder / "probes.csv").exists():
        files.append("probes.csv")
    if not files:
        raise Fault("neither probes nor lines to compare")
    largest_difference = largest = 0.0
    for file in files:
        a, b = run.table(file), again.table(file)
        if len(a) != len(b):
            raise Fault(f"{file}: {len(a)} rows against {len(b)}")
        for column in columns:
            for p, q in zip(numbers(a, column), numbers(b, column)):
                largest_difference = max(largest_difference, abs(p - q))
                largest = max(largest, abs(p))
    if largest == 0:
        raise Fault("all values are zero")
    return largest_difference / largest


def evaluate(key, run, again):
    kind, _, rest = key.partition(":")
    if kind in ("stdout", "stderr"):
        found = re.search(rest, getattr(run, kind), re.MULTILINE)
        return "present" if found else "absent"
    parts = rest.split(":")
    if key == "exit":
        return run.status
    if kind == "summary" and rest:
        return json_value(run, "summary.json", rest)
    if kind == "file" and rest:
        return "present" if (run.folder / rest).is_file() else "absent"
    if kind == "section" and len(parts) == 2:
        return json_value(run, f"sections/{parts[0]}.json", parts[1])
    if kind == "coupling" and rest:
        return coupling(run, rest)
    if kind == "probe" and len(parts) == 2:
        return probe_value(run, *parts)
    if kind == "ply" and len(parts) == 3:
        return ply_value(run, *parts)
    if kind == "along" and len(parts) == 2:
        return along_value(run, *parts)
    if kind == "line" and len(parts) == 3:
        return line_value(run, *parts)
    if kind == "contact" and len(parts) == 3:
        return contact_value(run, *parts)
    if kind == "kkt_residual" and rest:
        return kkt_residual(run, rest)
    if kind == "history" and rest:
        column, _, step = rest.partition("@")
        return number(run.table("history.csv", step)[-1], column)
    if kind == "goal" and rest:
        return goal(run, rest)["value"]
    if kind == "difference" and rest:
        return difference(run, again, rest.split(","))
    raise Fault("unknown key")


# ---- the comparison


def as_number(text):
    try:
        value = float(text)
    except (TypeError, ValueError):
        raise Fault(f"not a number: {text}") from None
    if not math.isfinite(value):
        raise Fault(f"not finite: {text}")
    return value


def same(result, text):
    try:
        return float(result) == float(text)
    except (TypeError, ValueError):
        shown = result if isinstance(result, str) else json.dumps(result)
        return shown == text


def compare(result, text, tolerance):
    """Whether the result is as expected, and the difference as text."""
    if tolerance == "exact":
        return same(result, text), ""
    value, expected = as_number(result), as_number(text)
    if tolerance == "below":
        return abs(value) <= expected, ""
    if tolerance == "limit":
        return value <= expected, ""
    if tolerance == "above":
        return value >= expected, ""
    error = abs(value - expected)
    relative = re.fullmatch(r"(\S+?)\s*%", tolerance)
    if relative:
        if expected == 0:
            raise Fault("a relative tolerance on zero; use abs")
        error *= 100 / abs(expected)
        return error <= as_number(relative[1]), f"{error:.2g}%"
    absolute = re.fullmatch(r"abs\s+(\S+)", tolerance)
    if absolute:
        return error <= as_number(absolute[1]), f"{error:.2g}"
    raise Fault(f"unknown tolerance {tolerance}")


def compare_bar(of_run, value, text, tolerance):
    """The same with the bar that the run holds of its goal."""
    if not of_run["trusted"]:
        return tolerance == "no bar", "no bar"
    error = abs(as_number(value) - as_number(text))
    deviation = f"{error / of_run['bar']:.2g} of the bar"
    return tolerance == "bar" and error <= of_run["bar"], deviation


def shown(result):
    return f"{result:.8g}" if isinstance(result, float) else str(result)


def compare_row(row, run, again):
    """The row of the printed table; its last cell is `ok` or begins FAIL."""
    key, expected, tolerance, source = row
    result = deviation = ""
    try:
        result = evaluate(key, run, again)
        if tolerance in ("bar", "no bar"):
            of_run = goal(run, key.partition(":")[2])
            good, deviation = compare_bar(of_run, result, expected, tolerance)
        else:
            good, deviation = compare(result, expected, tolerance)
        verdict = "ok" if good else "FAIL"
    except (Fault, re.error) as fault:
        verdict = f"FAIL: {fault}"
    return [key, shown(result), expected, deviation, tolerance, source, verdict]


def print_table(rows):
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    for row in rows:
        print("  ".join(cell.ljust(w) for cell, w in zip(row, widths)).rstrip())


def scene_of(program, name, path, workdir):
    """The path of the scene that the word after `run` names."""
    if not name.startswith("new:"):
        return path.parent / name
    workdir.mkdir(parents=True, exist_ok=True)
    scene = workdir / "new.prm"
    scene.unlink(missing_ok=True)
    subprocess.run([program, "new", scene.stem, "--kind", name[4:]], cwd=workdir,
                   check=True, capture_output=True)
    return scene


def check_run(program, case_run, path, workdir):
    """Returns the rows that fail, printed in a table with all others."""
    scene, extra = scene_of(program, case_run.run[0], path, workdir), case_run.run[1:]
    runs = [Run(program, scene, extra, workdir / "run")]
    if case_run.again is not None:
        runs.append(Run(program, scene, case_run.again, workdir / "again"))
    failed = []
    status_is_a_row = any(row[0] == "exit" for row in case_run.rows)
    for number, run in enumerate(runs):
        if run.status != 0 and not (status_is_a_row and number == 0):
            print(f"lamella ended with exit status {run.status} and said:")
            print(run.stderr or run.stdout[-2000:])
            failed.append(f"exit status {run.status}")
    again = runs[1] if len(runs) > 1 else None
    table = [compare_row(row, runs[0], again) for row in case_run.rows]
    print_table([["key", "result", "expected", "difference", "tolerance",
                  "source", ""]] + table)
    return failed + [row[0] for row in table if row[-1] != "ok"]


def check(program, case, path, workdir):
    """Returns what fails in the runs of a case, a line a row with the case's name."""
    if case.what:
        print(f"case {case.name}: {case.what}")
    failed = []
    for number, case_run in enumerate(case.runs, 1):
        name, folder = case.name, workdir
        if len(case.runs) > 1:
            name, folder = f"{case.name} {number}", workdir / str(number)
            print("\n".join([*case_run.comments, f"{name}: {shlex.join(case_run.run)}"]))
        failed += [f"FAIL  {name}{case.what and f' ({case.what})'}: {row}"
                   for row in check_run(program, case_run, path, folder)]
    return failed


def main():
    if len(sys.argv) < 4:
        sys.exit("Usage: check_scene.py LAMELLA FILE.expect WORKDIR [CASE...]")
    program, path = str(Path(sys.argv[1]).resolve()), Path(sys.argv[2])
    workdir, names = Path(sys.argv[3]).resolve(), sys.argv[4:]
    failed = []
    try:
        cases = read_expectations(path)
        unknown = set(names) - {case.name for case in cases}
        if unknown:
            raise Fault(f"no case {', '.join(sorted(unknown))}")
        for case in cases:
            if not names or case.name in names:
                folder = workdir if len(names) == 1 or len(cases) == 1 else workdir / case.name
                folder.mkdir(parents=True, exist_ok=True)
                failed += check(program, case, path, folder)
    except Fault as fault:
        sys.exit(f"{path}: {fault}")
    for line in failed:
        print(line)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
