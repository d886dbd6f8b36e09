# SPDX-License-Identifier: LGPL-2.1-or-later
"""LE against C3D20R of CalculiX on the paper's scenes; see scripts/benchmark."""

import statistics
from functools import partial

from benchmark_scenes import HERTZ, LAMINATED, SANDWICH, beam
from benchmark_tools import ROOT, number, table, wanted
from measure_tools import axis

# Nothing said of theory and mesh; the goals are what the scenes have references for.
TO_A_TOLERANCE = ["Theory=auto", "Goals/Tolerance=1"]

# Ours and theirs, coarse to fine: name, overrides. Both model the whole scene.
# A B4 is cubic, a C3D20R quadratic: theirs want more elements along the axis.
OURS = {
    "hertz": [
        ("5 B4, cells of 0.02", []),
        ("3 B4, cells of 0.04",
         ["Section half/Finest cell=0.04"] + axis("1,1,1", "0.1,0.9")),
        ("2 B4, cells of 0.05", ["Section half/Finest cell=0.05"] + axis(2)),
        ("Tolerance = 1", TO_A_TOLERANCE + axis("auto"))],
    "laminated_beams": [
        ("20 B4, 4 x 3 L9", []),
        ("20 B4, 2 x 3 L9", ["Section strip/Cells across=2"]),
        ("10 B4, 2 x 3 L9", ["Section strip/Cells across=2"] + axis(10)),
        ("4 B4, 1 x 3 L9", ["Section strip/Cells across=1"] + axis(4)),
        ("Tolerance = 1", TO_A_TOLERANCE + axis("auto"))],
    "sandwich": [
        ("18 B4, 4 x 10 L9", []),
        ("18 B4, 1 x 8 L9", ["Section sandwich/Cells across=1",
                             "Section sandwich/Cells per ply=1,1,1,2,1,1,1"]),
        ("18 B4, 2 x 8 L9", ["Section sandwich/Cells across=2",
                             "Section sandwich/Cells per ply=1,1,1,2,1,1,1"]),
        ("Tolerance = 1", TO_A_TOLERANCE + beam("auto", ""))]}
# Penalties (force/length^3) no stiffer than it takes: CalculiX iterates less then.
STIFFNESS = {"hertz": "3e5", "laminated_beams": "3e11", "sandwich": "1e5"}
THEIRS = {
    "hertz": [
        ("cells of 0.06, 2 along", ["Section half/Finest cell=0.06"] + axis(2)),
        ("cells of 0.04, 1, 2, 1 along",
         ["Section half/Finest cell=0.04"] + axis("1,2,1", "0.15,0.85")),
        ("cells of 0.03, 1, 2, 1 along",
         ["Section half/Finest cell=0.03"] + axis("1,2,1", "0.1,0.9")),
        ("cells of 0.03, 1, 4, 1 along",
         ["Section half/Finest cell=0.03"] + axis("1,4,1", "0.1,0.9"))],
    "laminated_beams": [
        ("1 x 3, 8 along", ["Section strip/Cells across=1"] + axis(8)),
        ("1 x 3, 20 along", ["Section strip/Cells across=1"] + axis(20)),
        ("2 x 3, 20 along", ["Section strip/Cells across=2"]),
        ("2 x 3, 40 along", ["Section strip/Cells across=2"] + axis(40))],
    "sandwich": [
        ("2 x 9, 18 along", ["Section sandwich/Cells per ply=1,1,1,3,1,1,1",
                             "Section sandwich/Cells across=2"]),
        ("2 x 10, 38 along", ["Section sandwich/Cells across=2"] +
         beam("12,4,6,4,12", "235,247,253,265")),
        ("4 x 9, 40 along", ["Section sandwich/Cells per ply=1,1,1,3,1,1,1"] +
         beam("12,4,8,4,12", "235,248,252,265")),
        ("4 x 10, 54 along", beam("16,6,10,6,16", "235,247,253,265"))]}


class Variant:
    """A mesh of one of the two programs and what its runs gave."""

    def __init__(self, scene, program, name, overrides, solve):
        self.scene, self.program, self.name = scene, program, name
        self.overrides, self.solve = overrides, solve
        self.runs = []

    def again(self):
        self.runs.append(self.solve(ROOT / "prm" / self.scene.file, self.overrides))

    @property
    def failure(self):
        return next((run.failure for run in self.runs if run.failure), "")

    @property
    def last(self):
        return self.runs[-1]

    @property
    def seconds(self):
        return statistics.median(run.seconds for run in self.runs)

    def error(self):
        """The largest over the quantities."""
        return max(q.error(self.runs[-1]) for q in self.scene.quantities)

    def row(self):
        if self.failure:
            return [self.program, self.name, "-", f"{self.seconds:.2f}", "-", "-"] + \
                [self.failure.splitlines()[0][:60]]
        last = self.runs[-1]
        return [self.program, self.name, f"{last.dofs:,}", f"{self.seconds:.2f}",
                f"{last.memory_mb:.0f}", f"{100 * self.error():.2f} %"] + \
            [f"{100 * q.error(last):.2f} %" for q in self.scene.quantities]


def compare(scene, ours, theirs):
    """Alternates: all of ours, one of theirs, and so on."""
    for peer in theirs:
        for variant in ours:
            variant.again()
        peer.again()


def front(variants):
    """Those that no other one beats in seconds and in error."""
    good = [variant for variant in variants if not variant.failure]
    return [variant for variant in good
            if not any(other.seconds < variant.seconds and other.error() <= variant.error()
                       for other in good)]


def pairs_of(ours, theirs):
    """Each mesh of theirs with our cheapest that is at most as far off, or None."""
    pairs = []
    for peer in sorted(front(theirs), key=lambda r: r.seconds):
        close = [variant for variant in front(ours) if variant.error() <= peer.error()]
        pairs.append((min(close, key=lambda r: r.seconds) if close else None, peer))
    return pairs


def constraint(variant, peer):
    row = [peer.name, f"{peer.last.dofs:,}", f"{100 * peer.error():.2f} %",
           f"{peer.seconds:.1f}"]
    if variant is None:
        return row + ["none is as close"] + ["-"] * 5
    return row + [variant.name, f"{variant.last.dofs:,}", f"{100 * variant.error():.2f} %",
                  f"{variant.seconds:.2f}", f"{peer.seconds / variant.seconds:.1f}",
                  f"{peer.last.memory_mb / variant.last.memory_mb:.2f}"]


def section(scene, ours, theirs):
    """A scene's blocks and its requirement."""
    compare(scene, ours, theirs)
    rows = [variant.row() for variant in ours + theirs]
    head = ["program", "mesh", "DoFs", "seconds", "MB", "largest error"] + \
        [f"{q.name} (converged: {number(q.converged)})" for q in scene.quantities]
    pairs = pairs_of(ours, theirs)
    ratios = [peer.seconds / variant.seconds for variant, peer in pairs if variant]
    blocks = [f"### {scene.title}", table(head, rows), table(
        ["C3D20R", "DoFs", "largest error", "seconds",
         "our cheapest at most as far off", "DoFs", "largest error", "seconds",
         "seconds, theirs over ours", "memory, theirs over ours"],
        [constraint(*pair) for pair in pairs])]
    if ratios:
        blocks.append(f"From {min(ratios):.2g} to {max(ratios):.2g} times our seconds.")
    # Where one of theirs is closer than all of ours, no ratio can be claimed.
    return blocks, [wanted(f"prm/{scene.file}, seconds of C3D20R no closer than ours "
                           "over ours, least of its meshes", 50,
                           min(ratios, default=0.), True)]


def calculix(bench):
    """Against C3D20R with an equal or a larger error, one thread, taking turns."""
    try:
        from peers import find_ccx, lamella_run, peer_run
    except ImportError:
        return ["Not measured: this version has no export for CalculiX."]
    if find_ccx() is None:
        return ["Not measured: there is no CalculiX. To install it: "
                "`apt-get install calculix-ccx`."]
    blocks = ["Whole processes on one thread, taking turns; both model the whole "
              "scene. Errors are against the converged values (C3D20R on mesh series, "
              "in halves and quarters of the scenes); *largest error* is over the "
              "quantities of the table. Seconds of ours are the median, those of "
              "C3D20R of one run, without its export. A mesh that a cheaper and closer "
              "one of the same program beats is left out of the comparison. The penalties of "
              "the decks are no stiffer than it takes, since CalculiX iterates less "
              "with soft ones."]
    demands = []
    for name, scene in (("hertz", HERTZ), ("laminated_beams", LAMINATED),
                        ("sandwich", SANDWICH)):
        meshes = (OURS[name], THEIRS[name])
        if bench.reduced:
            if name != "laminated_beams":
                continue
            meshes = ([("tiny", scene.tiny)],) * 2
        ours, theirs = (
            [Variant(scene, program, mesh, overrides, solve)
             for mesh, overrides in chosen]
            for program, chosen, solve in (
                ("Lamella, LE-2 or as said", meshes[0], lamella_run),
                ("C3D20R", meshes[1], partial(peer_run,
                                              contact_stiffness=STIFFNESS[name]))))
        text, lines = section(scene, ours, theirs)
        blocks += text
        demands += lines
    return blocks + [demands, "Aimed at, beyond what is wanted: 200."]
