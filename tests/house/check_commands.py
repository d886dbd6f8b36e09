#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tries the commands in code blocks of the pages.

Usage: check_commands.py LAMELLA ROOT WORKDIR

`build/lamella SCENE ...`, `scripts/run SCENE ...` with a scene of the project are run with
--validate, which reads the scene with all overrides and solves nothing. Of `lamella new` the scene
is written. The parts of `scripts/measure` and `scripts/benchmark`, the scenes of `scripts/peers`
and the files of `scripts/python` must exist, and the cases of `scripts/test -R` and `ctest -R`.
Commands with words in capitals or shell variables are examples of syntax and not tried.
"""

import re
import shlex
import subprocess
import sys
from pathlib import Path

BLOCK = re.compile(r"^```\w*\n(.*?)^```|((?:^    .*\n)+)", re.MULTILINE | re.DOTALL)
COMMAND = re.compile(r"^(build/lamella|lamella|scripts/\w+|ctest)\s")
OF_SYNTAX = re.compile(r"\$|^[A-Z_]+(\.prm)?$|\.\.\.")


def commands(page):
    for block in BLOCK.finditer(page.read_text()):
        text = re.sub(r"\\\n\s*", " ", block[0])
        for line in text.splitlines():
            line = line.strip().removeprefix("$ ")
            if COMMAND.match(line + " "):
                for part in line.split(" && "):
                    try:
                        words = shlex.split(part, comments=True)
                    except ValueError:
                        continue
                    if words and not any(OF_SYNTAX.search(word) for word in words):
                        yield tuple(words)


def parts_of(script):
    """The names that a script takes as parts, from its own list."""
    text = script.read_text() + "".join(
        path.read_text() for path in script.parent.glob(script.name + "*.py"))
    return set(re.findall(r"\w+", text))


def validate(lamella, root, words):
    """What is wrong with a run of the scene in words[1], or nothing."""
    options, rest = [], iter(words[2:])
    for word in rest:
        if word == "--set":
            options += ["--set", next(rest)]
        elif word == "--output":
            next(rest)
        elif word not in ("--validate", "--resume") and not word.startswith("--output="):
            return ""
    done = subprocess.run([lamella, words[1], *options, "--validate"], cwd=root,
                          capture_output=True, text=True)
    return "" if done.returncode == 0 else done.stderr.strip()


def fault_of(lamella, root, work, words):
    program, *rest = words
    if program in ("build/lamella", "lamella", "scripts/run") and rest:
        if rest[0] == "new" and len(rest) > 1:
            done = subprocess.run([lamella, *rest], cwd=work, capture_output=True, text=True)
            (work / f"{rest[1]}.prm").unlink(missing_ok=True)
            return done.stderr.strip()
        if rest[0] in ("trade", "report", "export"):
            scene = next((word for word in rest if word.endswith(".prm")), None)
            return "" if scene is None or (root / scene).exists() else f"no scene {scene}"
        if rest[0].endswith(".prm") and "/" in rest[0]:
            return validate(lamella, root, words)
    elif program in ("scripts/measure", "scripts/benchmark"):
        known = parts_of(root / program)
        return ", ".join(f"no part {word}" for word in rest
                         if not word.startswith("-") and word not in known)
    elif program in ("scripts/peers", "scripts/python"):
        return ", ".join(f"no file {word}" for word in rest
                         if re.search(r"\.(prm|py)$", word) and not (root / word).exists())
    elif "-R" in rest:
        case = rest[rest.index("-R") + 1].split("/")[-1]
        files = [*root.glob("tests/*/*.expect"), *root.glob("tests/*/*.bad"),
                 *root.glob("tests/unit/*.cc")]
        declared = f"NAME {rest[rest.index('-R') + 1]}" in (root / "tests/CMakeLists.txt").read_text()
        if not declared and not any(path.stem == case or f"case {case}" in path.read_text()
                                    for path in files):
            return f"no test {case}"
    return ""


def main(lamella, root, work):
    work.mkdir(parents=True, exist_ok=True)
    pages = [*root.glob("*.md"), *root.glob("doc/*/*.md"), *root.glob("tutorials/*/README.md")]
    tried, wrong = {}, 0
    for page in sorted(pages):
        for words in commands(page):
            if words not in tried:
                tried[words] = fault_of(lamella, root, work, words)
            if tried[words]:
                wrong += 1
                print(f"{page.relative_to(root)}: {shlex.join(words)}\n    {tried[words]}")
    print(f"{len(tried)} commands tried, {wrong} wrong")
    return wrong > 0 or not tried


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit("Usage: check_commands.py LAMELLA ROOT WORKDIR")
    sys.exit(main(*sys.argv[1:2], *(Path(arg).resolve() for arg in sys.argv[2:])))
