#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs spoiled scenes and checks how the program refuses them.

Usage: check_bad_input.py LAMELLA FILE.bad WORKDIR [CASE...]

A .bad file is a table of cases, with comments (#), for what needs the program itself:
an exit status, files, a task, a failure of the numerics. (Other cases are in a .table,
see check_table.cc.) A case is a test of its own, of the name bad_input/NAME. Without CASE
all cases of the file are run. A case has the lines

    case NAME
    run [export | trade | report] PATH [arguments]
                           the scene, relative to the file (of a report the
                           folder); {workdir} in a word stands for WORKDIR; the
                           program's working directory is WORKDIR, its output
                           folder WORKDIR/output (its deck WORKDIR/output.inp,
                           its report WORKDIR/output.html) unless the arguments
                           name another one
    exit STATUS            the exit status that is due
    id IDENTIFIER          what the message is, as contact.no-pairs; one of several between
                           blanks, where rounding decides which is first
    says FRAGMENT          must occur in the message (a line a fragment): an entry, a value;
                           never mind the wording
    never FRAGMENT         must not occur
    file NAME [TEXT]       an ordinary file with this text, made in WORKDIR
                           beforehand
    leaves NAMES           the files that may be left in WORKDIR; none otherwise

The message is one, on stderr, of at most twelve lines, in the user's words.
"""

import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

LONGEST_MESSAGE = 12
# Words of the machinery: a user can do nothing with them.
OF_THE_MACHINERY = ("Exception", "Stack trace", "Stacktrace", "terminate called")


def add_line(line, case):
    """Adds a line to its case. Returns whether it is understood."""
    word, _, rest = line.partition(" ")
    rest = rest.strip()
    if word in ("says", "never"):
        case[word].append(rest)
    elif word == "id":
        case["id"] = rest.split()
    elif word == "leaves":
        case[word] += rest.split()
    elif word == "file":
        name, _, text = rest.partition(" ")
        case[word].append((name, text))
    elif word in ("run", "exit") and word not in case:
        case[word] = shlex.split(rest) if word == "run" else int(rest)
    else:
        return False
    return True


def read_cases(path):
    """Returns the cases of the file by name."""
    cases, case = {}, None
    for line in path.read_text().splitlines():
        line = line.strip()
        if not line or line.startswith("#"):
            continue
        if line.startswith("case ") and line[5:] not in cases:
            case = cases[line[5:]] = {"id": [], "says": [], "never": [], "file": [], "leaves": []}
        elif case is None or not add_line(line, case):
            sys.exit(f"{path}: not understood, or twice: {line}")
    for name, case in cases.items():
        for needed in ("run", "exit", "id"):
            if not case.get(needed):
                sys.exit(f"{path}: case {name}: no line `{needed}`")
    return cases


def run_case(program, case, path, workdir):
    words = [word.replace("{workdir}", str(workdir)) for word in case["run"]]
    tasks = {"export": ["export", "--calculix"], "trade": ["trade"],
             "report": ["report"]}
    endings = {"export": "output.inp", "report": "output.html"}
    task = tasks[words.pop(0)] if words[0] in tasks else []
    scene = path.parent.resolve() / words[0]
    output = [] if any(word.startswith("--output") for word in words) else [
        "--output", str(workdir / endings.get(task[0] if task else "", "output"))]
    return subprocess.run(
        [str(Path(program).resolve()), *task, str(scene), *words[1:], *output],
        capture_output=True, text=True, cwd=workdir)


def files_in(folder):
    return {str(path.relative_to(folder)): path.read_bytes()
            for path in folder.rglob("*") if path.is_file()}


def faults_of_message(message, case):
    lines = message.strip().splitlines()
    if not lines:
        yield "nothing on stderr"
        return
    if len(lines) > LONGEST_MESSAGE:
        yield f"{len(lines)} lines on stderr, more than {LONGEST_MESSAGE}"
    # Messages begin alike ("lamella: ..."), so a second one shows itself.
    beginning = re.match(r"[^\s:]+:", lines[0])
    if beginning and any(line.startswith(beginning[0]) for line in lines[1:]):
        yield "more than one message on stderr"
    for word in OF_THE_MACHINERY:
        if word in message:
            yield f"the message has the word {word}"
    # A fragment may be broken over two lines of the message.
    flat = " ".join(message.split())
    if not any(f"[{identifier}]" in flat for identifier in case["id"]):
        yield f"the message is not {' or '.join(case['id'])}"
    for fragment in case["says"]:
        if " ".join(fragment.split()) not in flat:
            yield f"the message does not say: {fragment}"
    for fragment in case["never"]:
        if " ".join(fragment.split()) in flat:
            yield f"the message says: {fragment}"


def check(program, name, case, path, workdir):
    shutil.rmtree(workdir, ignore_errors=True)
    workdir.mkdir(parents=True)
    for name, text in case["file"]:
        (workdir / name).write_text(text)
    before = files_in(workdir)
    done = run_case(program, case, path, workdir)
    after = files_in(workdir)

    faults = list(faults_of_message(done.stderr, case))
    if done.returncode != case["exit"]:
        faults.append(f"exit status {done.returncode}, not {case['exit']}")
    left = {name for name in after if after[name] != before.get(name)}
    if left != set(case["leaves"]):
        faults.append(f"left behind: {', '.join(sorted(left)) or 'nothing'}")
    if not before.keys() <= after.keys():
        faults.append("removed a file that it did not make")
    print(done.stderr.strip())
    for fault in faults:
        print(f"FAIL: {name}: {fault}")
    return not faults


def main():
    if len(sys.argv) < 4:
        sys.exit("Usage: check_bad_input.py LAMELLA FILE.bad WORKDIR [CASE...]")
    program, path = sys.argv[1], Path(sys.argv[2])
    workdir, cases = Path(sys.argv[3]).resolve(), read_cases(path)
    names = sys.argv[4:] or list(cases)
    if not names or not set(names) <= cases.keys():
        sys.exit(f"{path}: no case {', '.join(sorted(set(names) - cases.keys()))}")
    good = [check(program, name, cases[name], path,
                  workdir if len(names) == 1 else workdir / name) for name in names]
    sys.exit(0 if all(good) else 1)


if __name__ == "__main__":
    main()
