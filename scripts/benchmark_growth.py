# SPDX-License-Identifier: LGPL-2.1-or-later
"""How seconds and memory grow with the mesh and with contact; see scripts/benchmark."""

import math
from dataclasses import dataclass

from benchmark_scenes import LAMINATED, SCENES
from benchmark_tools import best, linear_seconds, run, seconds_of, show, table, wanted
from measure_tools import axis

BEAMS = "laminated_beams.prm"
BLOCKS = "../tests/scenes/blocks_in_contact.prm"
# A process that computes next to nothing.
NOTHING = ("cantilever.prm", ["Theory=EBBT", "Body beam/Kinematics/Axis elements=1"])
# What is fitted, its mark and color.
QUANTITIES = {"assembly, factorization, solve": ("o", "#0072B2"),
              "contact": ("s", "#D55E00"), "whole process": ("^", "#009E73"),
              "memory": ("D", "#CC79A7")}


@dataclass
class Sweep:
    """A mesh that grows in one direction: the counts, and the overrides of each."""
    name: str
    unit: str
    scene: str
    counts: list
    overrides: object
    #: What the exponents are taken over: the counts, or the active rows.
    over_rows: bool = False


def block_mesh(across, deep, along):
    return [f"Section block/Cells across={across}",
            f"Section block/Cells per ply={deep}"] + axis(along)


def sweeps(reduced):
    """Axis, section and contact rows."""
    few = 2 if reduced else 8
    return [
        Sweep("along the axis", "B4 a beam, 4 x 3 L9", BEAMS,
              [4, 8] if reduced else [20, 40, 80, 160, 320, 640], axis),
        Sweep("across the section", f"cells across, 3 L9 deep, {few} B4", BEAMS,
              [2, 4] if reduced else [4, 8, 16, 32, 64],
              lambda n: [f"Section strip/Cells across={n}"] + axis(few)),
        Sweep("through the thickness", f"cells a ply of three, 4 L9 across, {few} B4",
              BEAMS, [1, 2] if reduced else [1, 2, 4, 8, 16],
              lambda n: [f"Section strip/Cells per ply={n}"] + axis(few)),
        Sweep("contact rows", "part of the blocks pressed [%]", BLOCKS,
              [50, 100] if reduced else [4, 6, 12, 25, 100],
              lambda n: (block_mesh(2, 2, 4) if reduced else block_mesh(10, 2, 16)) +
              [f"Load press/Pressure=if(y<{n / 25},100,-1)"], True)]


def measure_sweep(sweep, bench, empty):
    """Per count: DoFs, rows, active rows, and the four quantities."""
    points = []
    for count in sweep.counts:
        # Long runs say enough once.
        first = run(sweep.scene, sweep.overrides(count))
        again = bench.times(3) - 1 if first.wall < 15 else 0
        fastest = min([first] + [run(sweep.scene, sweep.overrides(count))
                                 for _ in range(again)], key=lambda r: r.wall)
        rows, active = (sum(c[key] for c in fastest.summary["contacts"].values())
                        for key in ("rows", "active"))
        points.append((count, fastest.summary["dofs"], rows, active,
                       [seconds_of(fastest, "assembly", "factorization", "solve"),
                        seconds_of(fastest, "contact"), fastest.wall,
                        fastest.summary["peak_memory_mb"] - empty]))
    return points


def fitted(x, y):
    """The exponent of y = c x^e through the last four points, and c."""
    import numpy
    pairs = [(a, b) for a, b in list(zip(x, y))[-4:] if a > 0 and b > 0]
    if len(pairs) < 2 or len({a for a, _ in pairs}) < 2:
        return float("nan"), float("nan")
    exponent, factor = numpy.polyfit(*numpy.log(pairs).T, 1)
    return float(exponent), float(numpy.exp(factor))


def abscissae(sweep, points):
    return [point[3] if sweep.over_rows else point[0] for point in points]


def fits(sweep, points):
    """Of each quantity (exponent, factor)."""
    x = abscissae(sweep, points)
    return [fitted(x, [point[4][k] for point in points])
            for k in range(len(QUANTITIES))]


def draw(bench, results):
    plt = bench.plot()
    figure, panels = plt.subplots(2, 2, figsize=(9.2, 8.2))
    for panel, (sweep, points) in zip(panels.flat, results):
        x = abscissae(sweep, points)
        for k, (name, (mark, color)) in enumerate(QUANTITIES.items()):
            # Memory in GB has about the size of the seconds.
            scale = 1 / 1024 if name == "memory" else 1
            y = [scale * point[4][k] for point in points]
            exponent, factor = fits(sweep, points)[k]
            label = f"{name}{' [GB]' if name == 'memory' else ''}: {exponent:.2f}"
            panel.loglog(x, y, mark, color=color, markersize=5, label=label)
            if factor > 0:
                ends = [x[-4:][0], x[-1]]
                panel.loglog(ends, [scale * factor * e ** exponent for e in ends],
                             color=color, linewidth=1.2)
        panel.set_title(sweep.name)
        panel.set_xlabel("active rows" if sweep.over_rows else sweep.unit)
        panel.set_xticks(x, [f"{value:g}" for value in x])
        panel.minorticks_off()
        panel.grid(color="0.92")
        low, high = panel.get_ylim()
        panel.set_ylim(low, high * (high / low) ** 0.45)  # room for the legend
        panel.legend(frameon=False, fontsize=8.5, loc="upper left",
                     title="exponents", title_fontsize=8.5)
    for panel in panels[:, 0]:
        panel.set_ylabel("seconds, GB")
    figure.savefig(bench.picture("growth"))
    plt.close(figure)


def growth(bench):
    """Exponents of seconds and of memory over the mesh and the contact rows."""
    empty = run(*NOTHING).summary["peak_memory_mb"]
    results = [(sweep, measure_sweep(sweep, bench, empty))
               for sweep in sweeps(bench.reduced)]
    draw(bench, results)
    blocks = ["Two laminated beams over the number of their elements along the axis "
              "and of their section's cells; two blocks of the same mesh of which a "
              "growing part is pressed together. Memory is the peak less the "
              f"{empty:.0f} MB that a process has that computes next to nothing. "
              "Exponents are fitted over the last four points.",
              show("Seconds and memory over the mesh, with fits", "growth")]
    summary, demands = [], []
    for sweep, points in results:
        found = [exponent for exponent, _ in fits(sweep, points)]
        # Tiny meshes may take no more memory than the process that computes nothing.
        summary.append([f"{sweep.name} ({sweep.unit})"] +
                       ["too small to fit" if math.isnan(e) else f"{e:.2f}"
                        for e in found])
        if sweep.name == "along the axis":
            demands = [wanted(f"exponent along the axis, {name}", 1.1, exponent)
                       for name, exponent in zip(QUANTITIES, found)]
    blocks.append(table(["exponents"] + list(QUANTITIES), summary))
    for sweep, points in results:
        rows = [[count, f"{dofs:,}", n_rows, active] +
                [f"{value:.3f}" for value in values[:3]] + [f"{values[3]:.0f}"]
                for count, dofs, n_rows, active, values in points]
        blocks.append(table([sweep.unit, "DoFs", "rows", "active"] +
                            [f"{name} [{'MB' if name == 'memory' else 's'}]"
                             for name in QUANTITIES], rows))
    return blocks + [demands]


def contact_cases(reduced):
    """Name, scene, overrides: the blocks by rising rows, and the paper's scenes."""
    meshes = [(2, 8, 1), (2, 8, 2)] if reduced else \
        [(2, 32, 1), (2, 32, 2), (2, 8, 7), (6, 4, 8), (10, 4, 16)]
    yield from (("blocks, {} x {} L9, {} B4".format(*mesh), BLOCKS, block_mesh(*mesh))
                for mesh in meshes)
    for scene in [LAMINATED] if reduced else SCENES.values():
        yield f"prm/{scene.file}", scene.file, scene.tiny if reduced else []


def contact(bench):
    """A run with contact over one linear solution of the same bodies."""
    rows, demands = [], []
    for name, scene, overrides in contact_cases(bench.reduced):
        result = best(scene, overrides, bench.times(4))
        linear, extra = linear_seconds(result), seconds_of(result, "contact")
        candidates, active = (sum(c[key] for c in result.summary["contacts"].values())
                              for key in ("rows", "active"))
        ratio = (linear + extra) / linear
        rows.append([name, candidates, active, f"{result.summary['dofs']:,}",
                     f"{linear:.3f}", f"{extra:.3f}",
                     sum(result.summary["iterations"]), f"{ratio:.2f}"])
        demands.append(wanted(f"run over linear solution, {name}, {active} active rows",
                              1.3 if active <= 100 else 2, ratio))
    return ["Two blocks pressed together over their whole faces "
            "(`tests/scenes/blocks_in_contact.prm`), and the paper's scenes as shipped, "
            "strategy `condensed`. The linear solution is setup, assembly, "
            "factorization and solve of the same run; the run is that and contact. "
            "The fastest of four.",
            table(["scene", "rows", "active", "DoFs", "linear solution [s]",
                   "contact [s]", "iterations", "run over linear"], rows), demands]
