# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes a page of benchmarks and its pictures; see scripts/benchmark."""

import argparse
import datetime
import os
import re
import sys
import time
from pathlib import Path

from benchmark_calculix import calculix
from benchmark_growth import contact, growth
from benchmark_variants import hierarchy
from benchmark_paper import paper
from benchmark_profile import profile
from benchmark_tools import ROOT, Bench, Failed, commit, machine, page

PARTS = {f.__name__: f for f in (paper, hierarchy, growth, contact, profile, calculix)}
TITLES = {"paper": "The paper's tables", "hierarchy": "Hierarchies of theories",
          "growth": "Growth", "contact": "Contact over a linear solution",
          "profile": "Where the seconds go", "calculix": "Against CalculiX"}
INTRODUCTION = """\
# Benchmarks

Written by `scripts/benchmark{how}`: every figure here is measured by it or, where
a source is named, from there. One thread. Seconds are wall seconds of the whole
process, start to end, unless a phase is named: all probes, lines and cuts are written,
the files for ParaView are not (`Write VTU = false`). The paper is Nagaraj, Kaleel,
Carrera and Petrolo, Eur. J. Mech. A/Solids 80 (2020); its seconds are of its machine.
Converged values are C3D20R of CalculiX 2.20 on series of meshes
([laminated-beams.md](laminated-beams.md), [hertz.md](hertz.md),
[sandwich.md](sandwich.md)).
"""


def introduction(bench):
    text = INTRODUCTION.format(how=" --reduced" if bench.reduced else "")
    if bench.output != ROOT / "doc/verification":
        # The other pages are not beside it.
        text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text)
    if bench.reduced:
        text += "\n**Tiny meshes: a test of the script, no measurement.**\n"
    return text + "\n" + machine() + "\n"


def sections_of(path):
    """The sections of a page that was written before: part -> text."""
    if not path.is_file():
        return {}
    pieces = re.split(r"^(?=## )", path.read_text(), flags=re.MULTILINE)[1:]
    by_title = {title: part for part, title in TITLES.items()}
    return {by_title[title]: piece.strip() for piece in pieces
            if (title := piece.splitlines()[0][3:]) in by_title}


def measured(part, bench):
    """The section of a part, and whether it could be measured."""
    begin, load = time.perf_counter(), os.getloadavg()[0]
    done = True
    try:
        blocks = PARTS[part](bench)
    except Failed as failure:
        # Messages of the program name files, pages do not name folders.
        failure = str(failure).replace(f"{ROOT}/", "")
        done, blocks = False, [f"This part failed: {failure}"]
        print(f"scripts/benchmark: {part}: {failure}", file=sys.stderr)
    seconds = time.perf_counter() - begin
    note = (f"`scripts/benchmark {part}`, {datetime.date.today()}{commit()}: "
            f"{seconds:.0f} s. Load average of the machine as it began: {load:.1f}.")
    print(f"{part}: {seconds:.0f} s", file=sys.stderr)
    return page(TITLES[part], note, *blocks), done


def verdict(sections):
    """How many requirements there are, and which are not met."""
    lines = [line for text in sections.values() for line in text.splitlines()
             if line.startswith("- ") and ": wanted " in line]
    missed = [line for line in lines if line.endswith("NOT MET")]
    text = (f"Of {len(lines)} requirements that close the sections, "
            f"{len(lines) - len(missed)} are met{', all but' if missed else '.'}")
    blank = [TITLES[part] for part in PARTS if part not in sections or
             re.search("^(Not measured|This part failed):", sections[part], re.M)]
    return "\n\n".join(
        [text] + (["\n".join(missed)] if missed else []) +
        ([f"Without figures: {', '.join(blank)}."] if blank else []))


def write(path, bench, sections):
    parts = [sections[part] for part in PARTS if part in sections]
    path.write_text("\n\n".join([introduction(bench).strip(), verdict(sections)] +
                                parts) + "\n")


def arguments():
    parser = argparse.ArgumentParser(prog="scripts/benchmark")
    parser.add_argument("--reduced", action="store_true")
    parser.add_argument("--output", type=Path)
    parser.add_argument("parts", nargs="*", metavar="PART",
                        help=", ".join(PARTS) + " (default: all)")
    asked = parser.parse_args()
    for part in asked.parts:
        if part not in PARTS:
            parser.error(f"no part {part}; there are: {', '.join(PARTS)}")
    if asked.reduced and asked.output is None:
        parser.error("--reduced says nothing about speed: "
                     "name another folder with --output")
    return asked


def main():
    asked = arguments()
    output = (asked.output or ROOT / "results/benchmarks").resolve()
    output.mkdir(parents=True, exist_ok=True)
    bench = Bench(asked.reduced, output)
    path = output / "benchmarks.md"
    kept = sections_of(path) if asked.parts else {}
    if kept and machine() not in path.read_text():
        sys.exit(f"{path.name} is of another machine or other versions: run all "
                 "parts, or name another folder with --output.")
    failed = False
    for part in asked.parts or PARTS:
        kept[part], done = measured(part, bench)
        failed |= not done
        write(path, bench, kept)  # at once: the rest may be interrupted
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
