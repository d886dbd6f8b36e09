# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs, tables, requirements, the machine: shared by the parts of scripts/benchmark."""

import functools
import os
import platform
import re
import shutil
import subprocess
import textwrap
from dataclasses import dataclass
from pathlib import Path

from measure_tools import ENVIRONMENT, PROGRAM, ROOT, Run, drawing


class Failed(Exception):
    """A run that a part cannot do without has failed."""


@dataclass
class Bench:
    """What is asked for: tiny meshes or not, and where the page goes."""
    reduced: bool
    output: Path

    def times(self, n):
        """How often a run is repeated for the fastest."""
        return 1 if self.reduced else n

    def picture(self, name):
        """Where the picture benchmark_NAME.png goes, and how a page shows it."""
        folder = self.output / "pictures"
        folder.mkdir(parents=True, exist_ok=True)
        return folder / f"benchmark_{name}.png"

    def plot(self):
        return drawing()


def show(title, name):
    return f"![{title}](pictures/benchmark_{name}.png)"


def run(scene, overrides):
    """One run, which must succeed."""
    result = Run(scene, overrides)
    if result.failure:
        raise Failed(f"{scene} {overrides}: {result.failure.splitlines()[0]}")
    result.supports = {name: support["reaction"]
                       for name, support in result.summary["supports"].items()}
    result.contacts = {name: contact["force"]
                       for name, contact in result.summary["contacts"].items()}
    return result


def best(scene, overrides, times=3):
    """The fastest of some runs of a scene, by the wall clock of the process."""
    return min((run(scene, overrides) for _ in range(times)), key=lambda r: r.wall)


def seconds_of(result, *phases):
    return sum(result.summary["seconds"][phase] for phase in phases)


def linear_seconds(result):
    """One linear solution of the bodies, without contact and output."""
    return seconds_of(result, "setup", "assembly", "factorization", "solve")


# ---- text

def table(header, rows):
    """A table in markdown; what does not apply is a dash, and nothing is empty."""
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    for row in rows:
        row = [str(cell) for cell in row] + ["-"] * (len(header) - len(row))
        lines.append("| " + " | ".join(cell or "-" for cell in row) + " |")
    return "\n".join(lines)


def off(value, reference):
    """How far a value is off, in per cent with its sign."""
    return f"{round(100 * (value / reference - 1), 2) + 0.:+.2f} %"  # no -0.00


def number(value):
    """Five digits, those of the converged values."""
    return f"{value:.5g}"


def wanted(what, bound, measured, at_least=False):
    """A line that says whether a requirement is met."""
    met = measured >= bound if at_least else measured <= bound
    side = "at least" if at_least else "at most"
    return (f"- {what}: wanted {side} {bound:g}, measured {measured:.4g}: "
            f"{'met' if met else 'NOT MET'}")


def wrapped(block):
    """Prose in lines of the page's width; all else as it is."""
    if block.startswith(("|", "- ", ">", "!", "#")):
        return block
    return textwrap.fill(block, 88, break_long_words=False, break_on_hyphens=False)


def page(title, *blocks):
    """A section of the page: blocks between empty lines, lists of lines as one."""
    blocks = ["\n".join(block) if isinstance(block, list) else wrapped(block)
              for block in blocks]
    return "\n\n".join([f"## {title}"] + [block for block in blocks if block])


# ---- the machine

def output_of(words):
    """What a program prints, or nothing."""
    try:
        done = subprocess.run([str(word) for word in words], env=ENVIRONMENT,
                              capture_output=True, text=True)
    except OSError:
        return ""
    return (done.stdout + done.stderr).strip()


def first_match(pattern, text, otherwise="unknown"):
    found = re.search(pattern, text, re.MULTILINE)
    return found[1].strip() if found else otherwise


def text_of(path):
    return path.read_text() if path.is_file() else ""


def deal_ii_version():
    cache = text_of(PROGRAM.parent / "CMakeCache.txt")
    folder = Path(first_match(r"^deal\.II_DIR:PATH=(.*)$", cache, ""))
    return first_match(r'PACKAGE_VERSION "?([\d.]+\d)',
                       text_of(folder / "deal.IIConfigVersion.cmake"))


def compiler():
    cache = text_of(PROGRAM.parent / "CMakeCache.txt")
    program = first_match(r"^CMAKE_CXX_COMPILER:\w+=(.*)$", cache, "c++")
    return output_of([program, "--version"]).splitlines()[0]


def blas():
    """The library behind libblas.so, by the name of its file."""
    path = first_match(r"libblas\S* => (\S+)", output_of(["ldd", PROGRAM]), "")
    if not path:
        return "unknown"
    file = Path(path).resolve()
    # OpenBLAS puts its version into the name of the file beside it.
    beside = sorted(found.name for found in file.parent.glob("libopenblas*-r*.so"))
    return beside[0] if beside else file.name


def calculix_version():
    ccx = shutil.which("ccx")
    return first_match(r"Version (\S+)", output_of([ccx, "-v"])) if ccx else \
        "not installed"


@functools.cache
def machine():
    """CPU, cores, memory and versions, as a table."""
    cpu = first_match(r"^model name\s*:\s*(.*)$", text_of(Path("/proc/cpuinfo")),
                      platform.processor() or platform.machine())
    memory = first_match(r"^MemTotal:\s*(\d+)", text_of(Path("/proc/meminfo")), "0")
    rows = [("processor", cpu), ("cores", os.cpu_count()),
            ("memory", f"{int(memory) / 2 ** 20:.0f} GB"),
            ("lamella", output_of([PROGRAM, "--version"]).split()[1]),
            ("deal.II", deal_ii_version()), ("compiler", compiler()),
            ("BLAS", blas()), ("CalculiX", calculix_version())]
    return table(["machine", "and versions"], rows)


@functools.cache
def commit():
    """Of the sources, and whether they were changed since; nothing without git."""
    def git(*words):
        return output_of(["git", "-C", ROOT, *words])

    head = git("rev-parse", "--short", "HEAD")
    if not re.fullmatch(r"[0-9a-f]+", head):
        return ""
    changed = git("status", "--porcelain", "--untracked-files=no", "source", "include",
                  "prm", "scripts", "tests/scenes")
    return f", commit {head}" + (" with changes" if changed else "")
