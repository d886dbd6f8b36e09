#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A scene by Lamella and by CalculiX, side by side; see scripts/peers.

As a module: lamella_run() and peer_run() solve a scene with either program, one
thread, and return a Run; find_ccx() says whether there is a CalculiX.
"""

import argparse
import csv
import json
import math
import os
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PROGRAM = Path(os.environ.get("LAMELLA_BUILD", ROOT / "build")) / "lamella"
ENVIRONMENT = {**os.environ, **{name: "1" for name in (
    "OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "CCX_NPROC_EQUATION_SOLVER",
    "CCX_NPROC_RESULTS", "CCX_NPROC_STIFFNESS", "NUMBER_OF_CPUS")}}
DISPLACEMENTS = ("ux", "uy", "uz")
STRESSES = ("sxx", "syy", "szz", "sxy", "sxz", "syz")
FORCES = ("fx", "fy", "fz")
# Sound states have a few places that pull, by some per cent of the largest pressure.
LARGEST_PULL = 0.25
MISSING = ("CalculiX (ccx) is not in PATH. Install it: apt-get install calculix-ccx")


@dataclass
class Run:
    """A scene solved once; forces of contacts are those on the second side."""
    program: str
    failure: str = ""
    #: 1 a fault of the scene, 2 one of the numerics.
    status: int = 0
    #: Of the whole process that solves: wall time, and the processor's, which a busy
    #: machine lengthens less.
    seconds: float = 0.
    cpu_seconds: float = 0.
    memory_mb: float = 0.
    dofs: int = 0
    #: Name -> values, of a point between plies those below; and all of them.
    probes: dict = field(default_factory=dict)
    plies: dict = field(default_factory=dict)
    supports: dict = field(default_factory=dict)
    contacts: dict = field(default_factory=dict)
    #: Natural frequencies [Hz] without rigid motions and buckling factors, ascending.
    modes: list = field(default_factory=list)
    buckling_modes: list = field(default_factory=list)
    #: What the scene gives: (quantity, value, source) by probe.
    references: dict = field(default_factory=dict)


# A small process of its own between us and the program: a child counts the memory
# of the one that it was forked from, too, and ours may be a large one.
LAUNCHER = """
import os, sys, time
begin = time.perf_counter()
child = os.spawnvp(os.P_NOWAIT, sys.argv[2], sys.argv[2:])
_, status, usage = os.wait4(child, 0)
with open(sys.argv[1], "w") as file:
    print(time.perf_counter() - begin, usage.ru_utime + usage.ru_stime,
          usage.ru_maxrss / 1024, file=file)
sys.exit(os.waitstatus_to_exitcode(status) & 255)
"""


def timed(words, folder, run=None):
    """Runs a program in a folder and returns what it did; time and memory go to the
    run."""
    usage = Path(folder) / "usage"
    done = subprocess.run([sys.executable, "-S", "-c", LAUNCHER, str(usage.resolve())] +
                          [str(word) for word in words], cwd=folder, env=ENVIRONMENT,
                          capture_output=True, text=True)
    if run is not None:
        run.seconds, run.cpu_seconds, run.memory_mb = map(
            float, usage.read_text().split())
    return done


def settings(overrides):
    return [word for override in overrides for word in ("--set", override)]


def in_folder(name, work):
    """Does the work in the folder, or in one that vanishes if it has no name."""
    if name is not None:
        Path(name).mkdir(parents=True, exist_ok=True)
        return work(Path(name).resolve())
    with tempfile.TemporaryDirectory() as folder:
        return work(Path(folder))


# ---- Lamella

def lamella_run(scene, overrides, folder=None):
    """The scene by Lamella; pictures are left out."""
    scene = Path(scene).resolve()

    def work(folder):
        run = Run("Lamella")
        done = timed([PROGRAM, scene, "--output", "lamella"] +
                     settings([*overrides, "Write VTU=false"]), folder, run)
        if done.returncode != 0:
            run.failure, run.status = done.stderr.strip(), done.returncode
            return run
        summary = json.loads((folder / "lamella/summary.json").read_text())
        run.dofs = summary["dofs"]
        run.supports = {name: support["reaction"]
                        for name, support in summary["supports"].items()}
        run.contacts = {name: contact["force"]
                        for name, contact in summary["contacts"].items()}
        run.modes = [mode["frequency"] for mode in summary.get("modes", [])]
        run.buckling_modes = [mode["factor"] for mode in summary.get("buckling_modes", [])]
        with open(folder / "lamella/probes.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        for row in rows:
            if row["step"] == rows[-1]["step"]:
                run.plies.setdefault(row["probe"], {})[int(row["ply"])] = {
                    name: float(row[name]) for name in DISPLACEMENTS + STRESSES}
        run.probes = {name: plies[min(plies)] for name, plies in run.plies.items()}
        return run

    return in_folder(folder, work)


# ---- CalculiX

def find_ccx():
    """The program, or None."""
    return shutil.which("ccx")


def number(text):
    """Fortran leaves out the E of exponents of three digits."""
    return float(re.sub(r"(?<=\d)([+-]\d{3})$", r"E\1", text))


def read_dat(path):
    """The last table of each kind and set that CalculiX printed: {(kind, set):
    (time, rows)}, kinds displacements, stresses, total (forces), statistics (of a
    contact), and of all contacts (set None) contact (stress)."""
    title = re.compile(r"^ *(displacements|stresses|total|statistics|contact)\b.*?"
                       r"(?:(?:for|slave) set (\w+).*)?\band time +(\S+)$")
    tables, rows = {}, None
    for line in MODES.split(path.read_text())[0].splitlines():
        found = title.match(line)
        if found:
            rows = []
            tables[found[1], found[2]] = (number(found[3]), rows)
        elif rows is not None:
            words = line.split()
            try:
                rows += [[number(word) for word in words]] if words else []
            except ValueError:  # headings within a table
                pass
    return tables


# Tables of modes begin so; displacements after them are those of modes.
MODES = re.compile(r"^ *(E I G E N V A L U E   O U T P U T|B U C K L I N G)", re.MULTILINE)


def read_modes(path, rigid):
    """Frequencies [Hz] of the modes after the rigid ones, and positive buckling factors."""
    values = {"E I G E N V A L U E   O U T P U T": [], "B U C K L I N G": []}
    pieces = MODES.split(path.read_text())
    for kind, text in zip(pieces[1::2], pieces[2::2]):
        rows = re.search(r"(?:^ *\d+(?: +[-+.\dE]+)+ *\n)+", text, re.MULTILINE)
        for n, *row in map(str.split, rows[0].splitlines() if rows else []):
            if len(row) == 1:
                values[kind] += [number(row[0])] if number(row[0]) > 0. else []
            elif int(n) > rigid:
                # With friction the matrices are unsymmetric, and eigenvalues left out.
                values[kind].append(number(row[-2]))
    return values.values()


def modes_missing(run, meaning):
    """In words, if a range may have more modes than the deck asks for, or one has fewer."""
    asked, n = meaning.get("modes"), len(run.modes)
    if asked and n < asked["number"] and not asked["range"]:
        return f"CalculiX found {n} of {asked['number']} natural modes."
    if asked and n >= asked["number"] and asked["range"]:
        return f"The range has more than {n - 1} modes. Use a smaller range in Modes."
    return ""


def shape_functions(natural, n_nodes):
    """Of CalculiX' hexahedron with 8 or 20 nodes at natural coordinates."""
    corners = [(r, s, t) for t in (-1, 1)
               for r, s in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    pairs = [(first + k, first + (k + 1) % 4) for first in (0, 4) for k in range(4)]
    pairs += [(k, k + 4) for k in range(4)]
    nodes = corners + [tuple((a + b) / 2 for a, b in zip(corners[i], corners[j]))
                       for i, j in pairs]
    values = []
    for node in nodes[:n_nodes]:
        value = math.prod(0.5 * (1 + a * r) if a else 1 - r * r
                          for a, r in zip(node, natural))
        if n_nodes == 20 and all(node):
            value *= sum(a * r for a, r in zip(node, natural)) - 2
        values.append(value)
    return values


def extrapolated(points, natural):
    """The values at 1 or 2 x 2 x 2 integration points (first coordinate running
    fastest), continued to natural coordinates."""
    if len(points) == 1:
        return points[0]
    weights = [math.prod(0.5 * (1 + (1 if k >> d & 1 else -1) * math.sqrt(3) * r)
                         for d, r in enumerate(natural)) for k in range(8)]
    return [sum(w * values[c] for w, values in zip(weights, points))
            for c in range(6)]


def probe_values(plies, displacements, stresses):
    """Ply -> values at a probe: means over the points of its box, or over the
    elements that share its point. Ply 0: several."""
    result = {}
    for ply in plies:
        sums = [0.] * len(DISPLACEMENTS + STRESSES)
        for element in ply["elements"]:
            N = shape_functions(element["natural"], len(element["nodes"]))
            u = [sum(N[i] * displacements[node][c]
                     for i, node in enumerate(element["nodes"])) for c in range(3)]
            values = u + extrapolated(stresses[element["element"]],
                                      element["natural"])
            sums = [a + element["weight"] * b for a, b in zip(sums, values)]
        result[ply["ply"]] = dict(zip(DISPLACEMENTS + STRESSES, sums))
    return result


def what_went_wrong(folder, done, n_steps):
    """In words, or nothing if all steps were solved."""
    errors = [line.strip() for line in done.stdout.splitlines() if "*ERROR" in line]
    if errors:
        return "CalculiX: " + " ".join(errors[:3])
    status = folder / "deck.sta"
    last = status.read_text().split("\n")[2:] if status.exists() else []
    steps = [line.split() for line in last if line.split()]
    if done.returncode != 0 or "best solution and residuals" in done.stdout:
        return (f"CalculiX did not converge (exit status {done.returncode}, "
                f"{len(steps)} increments). Try another --contact-stiffness or mesh.")
    tables = read_dat(folder / "deck.dat") if (folder / "deck.dat").exists() else {}
    times = [time for time, _ in tables.values()]
    if n_steps and (not times or min(times) < n_steps - 1e-4):
        return (f"CalculiX stopped before the end of step {n_steps}. Try another "
                "--contact-stiffness or mesh.")
    return ""


def contact_that_pulls(tables):
    """In words, if the contacts pull at some place by a good part of what they press
    with at most."""
    pressures = [row[2] for row in tables.get(("contact", None), (0, []))[1]]
    if pressures and -min(pressures) > LARGEST_PULL * max(pressures):
        return ("CalculiX ended in a state in which surfaces pull each other, by up to "
                f"{-min(pressures):.4g} where they press with {max(pressures):.4g}. "
                "Use a smaller --contact-stiffness.")
    return ""


def read_static(run, folder, meaning):
    tables = read_dat(folder / "deck.dat")
    displacements, stresses = {}, {}
    for row in tables.get(("displacements", "PROBES"), (0, []))[1]:
        displacements[int(row[0])] = row[1:4]
    for row in tables.get(("stresses", "PROBES"), (0, []))[1]:
        stresses.setdefault(int(row[0]), []).append(row[2:8])
    for name, probe in meaning["probes"].items():
        run.plies[name] = probe_values(probe["plies"], displacements, stresses)
        run.probes[name] = run.plies[name][min(run.plies[name])]
        run.references[name] = [(r["quantity"], r["value"], r["source"])
                                for r in probe.get("references", [])]
    factor = meaning["steps"][-1]
    for name, support in meaning["supports"].items():
        # CalculiX counts the loads on these nodes as reactions.
        run.supports[name] = [
            tables["total", support[axis]["set"]][1][0][c] -
            factor * support[axis]["load"] if axis in support else 0.
            for c, axis in enumerate("xyz")]
    for name, contact in meaning["contacts"].items():
        # No table of *TIE, and while nothing touches.
        if contact["tied"] and ("statistics", contact["slave"]) not in tables:
            continue
        table = tables.get(("statistics", contact["slave"]), (0, [[0.] * 3]))[1]
        sign = 1. if contact["slave_is_second"] else -1.
        run.contacts[name] = [sign * force for force in table[0][:3]]
    if not any(contact["tied"] for contact in meaning["contacts"].values()):
        run.failure = contact_that_pulls(tables)


def read_results(run, folder, meaning):
    if meaning["steps"]:
        read_static(run, folder, meaning)
    run.modes, run.buckling_modes = read_modes(folder / "deck.dat",
                                               meaning.get("modes", {}).get("rigid", 0))
    run.failure = run.failure or modes_missing(run, meaning)


def peer_run(scene, overrides, element="C3D20R", contact_stiffness=None, folder=None):
    """The scene by CalculiX; seconds and memory are those of ccx alone."""
    scene, ccx = Path(scene).resolve(), find_ccx()

    def work(folder):
        run = Run("CalculiX")
        if ccx is None:
            run.failure, run.status = MISSING, 1
            return run
        words = [PROGRAM, "export", "--calculix", scene, "--output", "deck.inp",
                 "--element", element]
        if contact_stiffness is not None:
            words += ["--contact-stiffness", contact_stiffness]
        done = timed(words + settings(overrides), folder)
        if done.returncode != 0:
            run.failure, run.status = done.stderr.strip(), done.returncode
            return run
        for old in ("deck.dat", "deck.sta"):
            (folder / old).unlink(missing_ok=True)
        meaning = json.loads((folder / "deck.json").read_text())
        run.program, run.dofs = f"CalculiX {element}", meaning["dofs"]
        done = timed([ccx, "deck"], folder, run)
        (folder / "deck.log").write_text(done.stdout + done.stderr)
        run.failure = what_went_wrong(folder, done, len(meaning["steps"]))
        if not run.failure:
            read_results(run, folder, meaning)
        run.status = 2 if run.failure else 0
        return run

    return in_folder(folder, work)


# ---- side by side

def table(header, rows):
    if not rows:
        return
    rows = [[str(cell) for cell in row] for row in [header, *rows]]
    widths = [max(len(row[c]) for row in rows) for c in range(len(header))]
    rows.insert(1, ["-" * width for width in widths])
    for row in rows:
        print("| " + " | ".join(cell.ljust(width)
                                for cell, width in zip(row, widths)) + " |")
    print()


def percent(value, reference):
    return f"{100 * (value / reference - 1):+.2f} %" if reference else ""


def quantities_of(values, references):
    """Those with references, or the largest displacement and stress."""
    if references:
        return list(dict.fromkeys(quantity for quantity, _, _ in references
                                  if quantity in values))
    return [max(names, key=lambda name: abs(values[name]))
            for names in (DISPLACEMENTS, STRESSES)]


def print_probes(ours, theirs):
    rows = []
    for probe, plies in ours.plies.items():
        references = theirs.references.get(probe)
        for ply, values in plies.items():
            if ply not in theirs.plies.get(probe, ()):
                continue
            where = f"{probe}, ply {ply}" if len(plies) > 1 else probe
            for name in quantities_of(values, references):
                a, b = values[name], theirs.plies[probe][ply][name]
                known = [(v, s) for q, v, s in references if q == name] or [(0, "")]
                for value, source in known:
                    rows.append([where, name, f"{a:.6g}", f"{b:.6g}", percent(a, b)] +
                                ([f"{value:.6g} ({source})", percent(a, value),
                                  percent(b, value)] if value else [""] * 3))
    table(["probe", "", ours.program, theirs.program, "difference", "reference",
           ours.program, theirs.program], rows)


def print_resultants(ours, theirs):
    rows = []
    both = (("support", ours.supports, theirs.supports),
            ("contact", ours.contacts, theirs.contacts))
    largest = max((abs(f) for _, first, _ in both for force in first.values()
                   for f in force), default=0.)
    for kind, first, second in both:
        for name in filter(second.__contains__, first):
            for c, force in enumerate(FORCES):
                a, b = first[name][c], second[name][c]
                if max(abs(a), abs(b)) > 1e-6 * largest:
                    rows.append([f"{kind} {name}", force, f"{a:.6g}", f"{b:.6g}",
                                 percent(a, b)])
    table(["resultant", "", ours.program, theirs.program, "difference"], rows)


def print_modes(ours, theirs):
    rows = [[f"{kind}{n}", f"{a:.6g}", f"{b:.6g}", percent(a, b)]
            for kind, first, second in (
                ("mode-", ours.modes, theirs.modes),
                ("buckling-", ours.buckling_modes, theirs.buckling_modes))
            for n, (a, b) in enumerate(zip(first, second), 1)]
    table(["mode", ours.program, theirs.program, "difference"], rows)


def print_costs(runs):
    rows = []
    for same in zip(*runs):
        seconds = [run.seconds for run in same]
        spread = f" ({min(seconds):.2f} to {max(seconds):.2f})" if len(same) > 1 else ""
        rows.append([same[0].program, same[0].dofs,
                     f"{statistics.median(seconds):.2f}{spread}",
                     f"{statistics.median(run.cpu_seconds for run in same):.2f}",
                     f"{statistics.median(run.memory_mb for run in same):.0f}"])
    table(["program", "DoFs", "seconds", "CPU seconds", "memory [MB]"], rows)


def main():
    parser = argparse.ArgumentParser(prog="scripts/peers")
    parser.add_argument("scene")
    parser.add_argument("--set", action="append", default=[], metavar="PATH=VALUE")
    parser.add_argument("--peer-set", action="append", default=[],
                        metavar="PATH=VALUE")
    parser.add_argument("--element", default="C3D20R")
    parser.add_argument("--contact-stiffness", metavar="K")
    parser.add_argument("--repeat", type=int, default=1, metavar="N")
    parser.add_argument("--output", metavar="DIR")
    asked = parser.parse_args()
    if find_ccx() is None:
        print("scripts/peers: " + MISSING, file=sys.stderr)
        return 1
    runs = []
    for _ in range(max(1, asked.repeat)):
        pair = [lamella_run(asked.scene, asked.set, asked.output)]
        if not pair[0].failure:
            pair.append(peer_run(asked.scene, asked.set + asked.peer_set,
                                 asked.element, asked.contact_stiffness,
                                 asked.output))
        if pair[-1].failure:
            print("scripts/peers: " + pair[-1].failure, file=sys.stderr)
            return pair[-1].status
        runs.append(pair)
    print_probes(*runs[-1])
    print_resultants(*runs[-1])
    print_modes(*runs[-1])
    print_costs(runs)
    return 0


if __name__ == "__main__":
    sys.exit(main())
