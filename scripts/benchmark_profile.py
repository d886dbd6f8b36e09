# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the seconds of the paper's scenes go; see scripts/benchmark."""

import statistics
import subprocess
import time

from benchmark_scenes import SCENES
from benchmark_tools import ENVIRONMENT, PROGRAM, best, show, table

# In the order of the work; start-up and the rest are what the phases leave.
PHASES = ("start-up", "setup", "assembly", "factorization", "solve", "contact",
          "beyond", "output", "rest")
COLOURS = ("#999999", "#E69F00", "#56B4E9", "#0072B2", "#009E73", "#D55E00",
           "#F0E442", "#CC79A7", "#DDDDDD")


def shares(result):
    """The seconds of a run by phase; their sum is the wall clock's."""
    seconds = result.summary["seconds"]
    inner = {phase: seconds[phase] for phase in PHASES[1:-1]}
    return {"start-up": result.wall - seconds["total"], **inner,
            "rest": seconds["total"] - sum(inner.values())}


def start(times):
    """Seconds of `lamella --version`: loading libraries and no more."""
    def once():
        begin = time.perf_counter()
        subprocess.run([PROGRAM, "--version"], env=ENVIRONMENT, check=True,
                       capture_output=True)
        return time.perf_counter() - begin

    found = [once() for _ in range(times)]
    return min(found), statistics.median(found)


def draw(bench, parts):
    plt = bench.plot()
    figure, panel = plt.subplots(figsize=(8.4, 3.2))
    names = list(parts)[::-1]
    left = [0.] * len(names)
    for phase, color in zip(PHASES, COLOURS):
        widths = [max(0., parts[name][phase]) for name in names]
        panel.barh(names, widths, left=left, color=color, label=phase, height=0.6)
        for k, width in enumerate(widths):
            if width > 0.05 * max(sum(p.values()) for p in parts.values()):
                panel.text(left[k] + width / 2, k, f"{width:.2f}", ha="center",
                           va="center", fontsize=9)
        left = [a + b for a, b in zip(left, widths)]
    panel.set_xlabel("seconds, whole process")
    panel.legend(frameon=False, fontsize=9, loc="lower left", ncols=len(PHASES),
                 bbox_to_anchor=(-0.12, 1.), columnspacing=1., handlelength=1.)
    figure.savefig(bench.picture("profile"))
    plt.close(figure)


def profile(bench):
    """The paper's scenes at the paper's meshes, the fastest of five each."""
    parts = {}
    for name, scene in SCENES.items():
        mesh = scene.tiny if bench.reduced else scene.mesh + scene.contact
        parts[name.replace("_", " ")] = shares(best(scene.file, mesh, bench.times(5)))
    rows = [[phase] + [f"{p[phase]:.3f} ({100 * p[phase] / sum(p.values()):.0f} %)"
                       for p in parts.values()] for phase in PHASES]
    rows.append(["whole process"] + [f"{sum(p.values()):.3f}" for p in parts.values()])
    draw(bench, parts)
    least, middle = start(bench.times(9))
    longest = {name: max(PHASES, key=p.get) for name, p in parts.items()}
    return [
        "The paper's meshes and its contact at nodes (" +
        ", ".join(f"{scene.dofs:,}" for scene in SCENES.values()) +
        " DoFs), the fastest of five runs. *start-up*: from the call to the "
        "program's first line, and after its last; *setup*: sections, axes, rows of "
        "the supports; *contact*: search and active set; *output*: probes, lines, "
        "cuts; *rest*: reading the scene and what no phase counts.",
        table(["seconds"] + list(parts), rows),
        show("Seconds by phase", "profile"),
        f"`lamella --version` takes {least:.3f} s (median {middle:.3f} s): loading "
        "the libraries. Longest: " +
        ", ".join(f"{phase} ({name})" for name, phase in longest.items()) + "."]
