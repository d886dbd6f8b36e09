#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables and the picture of doc/verification/solids.md; see scripts/measure."""

import csv
import math
import subprocess
import tempfile
from pathlib import Path

from measure_tools import ENVIRONMENT, PROGRAM, ROOT, Run, axis, drawing, table

PLANE = "hertz_plane_strain.prm"
BOTH = ("upper", "lower")


def kinematics(bodies, **entries):
    return [f"Body {body}/Kinematics/{name.replace('_', ' ')}={value}"
            for body in bodies for name, value in entries.items()]


def solids():
    """The paper's scenes as beams and as hexahedra: off the converged 3D values."""
    def press(run):
        return run.summary["supports"]["press"]["reaction"][2]

    def roller(run):
        return run.summary["contacts"]["indentation"]["force"][2]

    def of(probe, column):
        return lambda run: float(run.probes[probe][column])

    scenes = [
        ("hertz.prm", [("force", press, -0.3241),
                       ("sigma_zz", of("lower_center", "szz"), -1.728)],
         [("LE-2", []), ("solid-2", []), ("solid-1", kinematics(BOTH, Refinements=1))]),
        (PLANE, [("force", press, -0.3559),
                 ("sigma_zz", of("lower_center", "szz"), -1.7646)],
         [("LE-2", []), ("solid-2", []),
          ("solid-2", ["Section half/Finest cell=0.01"])]),
        ("laminated_beams.prm",
         [("force", press, -172.461), ("u_z", of("upper_top", "uz"), -0.134357),
          ("sigma_yy", of("upper_top", "syy"), -133.82e6)],
         [("LE-2", []), ("solid-2", []), ("solid-2", axis(40)), ("solid-1", axis(80))]),
        ("sandwich.prm",
         [("force", roller, 754.5), ("u_y", of("quarter", "uy"), 0.05529),
          ("sigma_yy", of("bottom", "syy"), 32.08),
          ("sigma_yz", of("core", "syz"), -0.2278)],
         [("LE-2", []), ("solid-2", []),
          ("solid-2", kinematics(("beam",), Axis_elements="16, 6, 8, 6, 16"))])]
    for scene, quantities, cases in scenes:
        rows = []
        for theory, overrides in cases:
            run = Run(scene, [f"Theory={theory}"] + overrides)
            if run.failure:
                rows.append([theory, run.failure.splitlines()[0]])
                continue
            rows.append([theory, next(iter(run.summary["theory"].values())),
                         run.summary["dofs"]] +
                        [f"{100 * (value(run) / reference - 1):+.2f} %"
                         for _, value, reference in quantities] +
                        [f"{run.wall:.1f}", f"{run.summary['peak_memory_mb']:.0f}"])
        print(f"prm/{scene}\n")
        table(["theory", "mesh of a body", "DoFs"] + [q[0] for q in quantities] +
              ["whole process [s]", "memory [MB]"], rows)


def pressure(overrides):
    """Across the middle of the strip: x - 8, pressure over the p0 of the force, the
    same of Hertz."""
    with tempfile.TemporaryDirectory() as folder:
        words = [PROGRAM, ROOT / "prm" / PLANE, "--output", folder]
        for override in overrides + ["Theory=solid-2", "Write VTU=false"]:
            words += ["--set", override]
        subprocess.run(words, env=ENVIRONMENT, check=True, capture_output=True)
        with open(Path(folder) / "contact_nip.csv", newline="") as file:
            rows = list(csv.DictReader(file))
    force = sum(float(row["force"]) for row in rows)
    modulus, radius = 200 / (2 * (1 - 0.09)), 4.
    p0 = math.sqrt(force * modulus / (math.pi * radius))
    width = math.sqrt(4 * force * radius / (math.pi * modulus))
    points = sorted((float(row["x"]) - 8, float(row["pressure"]) / p0) for row in rows
                    if abs(float(row["y"]) - 0.5) < 1e-6)
    return [(x, p, math.sqrt(max(0, 1 - (x / width) ** 2))) for x, p in points
            if abs(x) < 1.3 * width], width


def hanging():
    """Hanging nodes in the middle of Hertz' contact: what the pressure is off within
    three quarters of the half width. Draws doc/pictures/hanging_nodes.png."""
    near = "8.06, 0.5, 8: 0.06: 1"
    cases = {"no hexahedra divided": [],
             "right half of both divided": kinematics(BOTH, Refine_near=near),
             "right half of one divided": kinematics(("lower",), Refine_near=near)}
    profiles, rows = {}, []
    for name, overrides in cases.items():
        profile, width = pressure(overrides)
        inner = [(x, p - h) for x, p, h in profile if abs(x) < 0.75 * width]
        at_seam = [d for x, d in inner if -0.045 < x < 0.005]
        rows.append([name, f"{100 * max(abs(d) for _, d in inner):.2f} %",
                     f"{100 * max(map(abs, at_seam)):.2f} %"])
        profiles[name] = profile
    table(["mesh", "largest error of p, over p0", "next to the hanging nodes"], rows)
    draw_hanging(profiles, width)


def draw_hanging(profiles, width):
    plt = drawing()
    figure, (top, bottom) = plt.subplots(2, 1, figsize=(7.2, 5.2), sharex=True,
                                         height_ratios=(2, 1))
    fine = [width * k / 400 for k in range(-400, 401)]
    top.plot([x / width for x in fine],
             [math.sqrt(max(0, 1 - (x / width) ** 2)) for x in fine],
             color="0.6", linewidth=3, label="Hertz, of the same force")
    for (name, profile), mark, color in zip(profiles.items(), "sox",
                                             ("#009E73", "#0072B2", "#D55E00")):
        x = [point[0] / width for point in profile]
        top.plot(x, [point[1] for point in profile], mark, color=color,
                 markersize=4, label=name)
        bottom.plot(x, [100 * (p - h) for _, p, h in profile], mark + "-",
                    color=color, markersize=4, linewidth=0.8)
    for panel in (top, bottom):
        panel.axvline(-0.02 / width, color="0.4", linestyle=":", linewidth=1)
        panel.grid(color="0.92")
    top.text(-0.02 / width - 0.02, 0.5, "hanging nodes", rotation=90, color="0.4",
             ha="right")
    top.set_ylabel("pressure / $p_0$")
    top.legend(frameon=False, fontsize=9, loc="lower left",
               bbox_to_anchor=(0.47, 0.05))
    bottom.set_ylabel("off Hertz [% of $p_0$]")
    bottom.set_ylim(-12, 12)
    bottom.set_xlabel("$x / a$")
    figure.savefig(ROOT / "doc" / "pictures" / "hanging_nodes.png")
    print("doc/pictures/hanging_nodes.png\n")


def calculix():
    """prm/cantilever.prm, square section, as hexahedra of Lamella and of CalculiX
    (C3D20R) on the same mesh; needs the package calculix-ccx."""
    from peers import MISSING, find_ccx, peer_run
    if find_ccx() is None:
        print(MISSING + "\n")
        return
    rows = []
    for length, cells, elements in ((10., 2, 10), (10., 4, 20), (50., 4, 40)):
        mesh = [f"Body beam/Length={length!r}", f"Section square/Cells across={cells}",
                f"Section square/Cells per ply={cells}",
                f"Body beam/Kinematics/Axis elements={elements}",
                f"Probe tip/At=beam: 0.5, {length!r}, 0.5"]
        peer = peer_run(ROOT / "prm" / "cantilever.prm", mesh)
        theirs = float(peer.probes["tip"]["uz"])
        for theory in ("solid-2", "solid-1"):
            run = Run("cantilever.prm", [f"Theory={theory}"] + mesh)
            ours = float(run.probes["tip"]["uz"])
            rows.append([f"{length:g}", f"{cells} x {cells} x {elements}", theory,
                         run.summary["dofs"], f"{ours:.6g}", peer.dofs,
                         f"{theirs:.6g}", f"{100 * (ours / theirs - 1):+.3f} %",
                         f"{run.wall:.2f}", f"{peer.seconds:.2f}"])
    table(["length", "mesh", "theory", "DoFs", "u_z of the tip", "C3D20R: DoFs",
           "u_z", "difference", "seconds", "C3D20R: seconds"], rows)


def million():
    """A cantilever of 40,000 Q2 hexahedra, conjugate gradients, by phase."""
    mesh = ["Theory=solid-2", "Section square/Cells across=20",
            "Section square/Cells per ply=20", "Body beam/Kinematics/Axis elements=100"]
    rows = []
    for processes in (1, 2):
        run = Run("cantilever.prm", mesh, processes=processes)
        seconds, solver = run.summary["seconds"], run.summary["bodies"]["beam"]["solver"]
        rows.append([processes, run.summary["dofs"]] +
                    [f"{seconds[phase]:.1f}" for phase in
                     ("setup", "assembly", "factorization", "solve", "output", "total")] +
                    [solver["solutions"], solver["iterations"]] +
                    [f"{run.summary[key] / 1024:.1f}" for key in
                     ("peak_memory_mb", "peak_memory_of_all_mb")])
    table(["processes", "DoFs", "setup", "assembly", "multigrid", "solve", "output",
           "total", "solutions", "iterations", "memory of a process [GB]", "of all"],
          rows)
