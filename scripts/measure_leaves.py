# SPDX-License-Identifier: LGPL-2.1-or-later
"""The leaf spring: closed form, meshes, enforcement, number of leaves; see
scripts/measure."""

import numpy as np

from measure_tolerances import Timed
from measure_tools import ROOT, table

SCENE = ROOT / "prm/leaf_spring.prm"
LAST = ["Load factors=1"]


def closed_form(leaves, first=150., step=70., gap=0.2, load=300.,
                bending=39000. * 50. * 8. ** 3 / 12.):
    """Contact forces from the lowest leaf up and the tip's deflection, of cantilevers in
    bending (Euler and Bernoulli) that press on the next one with their ends."""
    lengths = [first + step * k for k in range(leaves)]

    def deflection(at, y):
        return (y * y * (3. * at - y) if y <= at else at * at * (3. * y - at)) / (
            6. * bending)

    n = leaves - 1
    matrix, right = np.zeros((n, n)), np.full(n, gap)
    for k in range(n):  # Between leaves k and k + 1, at the end of the former.
        y = lengths[k]
        matrix[k, k] -= 2. * deflection(y, y)
        if k > 0:
            matrix[k, k - 1] += deflection(lengths[k - 1], y)
        if k + 1 < n:
            matrix[k, k + 1] += deflection(lengths[k + 1], y)
        else:
            right[k] -= load * deflection(lengths[-1], y)
    # They close from the loaded one down; the lowest may not be reached.
    forces = np.zeros(n)
    for touching in range(n, 0, -1):
        forces[:] = 0.
        forces[-touching:] = np.linalg.solve(matrix[-touching:, -touching:],
                                             right[-touching:])
        if np.all(forces[-touching:] > 0.):
            break
    end = lengths[-1]
    return forces, load * deflection(end, end) - forces[-1] * deflection(
        lengths[-2], end)


def row_of(run, name):
    forces = [contact["force"][2] for contact in run.summary["contacts"].values()]
    open_gaps = max(contact["max_penetration"]
                    for contact in run.summary["contacts"].values())
    return [name, run.summary["dofs"], f"{-run.value('tip: uz'):.5g}",
            f"{forces[-1]:.5g}", f"{forces[0]:.5g}", f"{open_gaps:.1e}",
            f"{run.seconds:.2f}"]


def leaves():
    """doc/verification/leaf-spring.md: meshes and theories, exact against penalty, 2 to 32 leaves."""
    forces, tip = closed_form(6)
    rows = [["closed form, bending only", "", f"{tip:.5g}", f"{forces[-1]:.5g}",
             f"{forces[0]:.5g}", "0", ""]]
    header = ["model", "DoFs", "deflection of the end, mm", "force on leaf-6, N",
              "force on leaf-1, N", "penetration, mm", "seconds"]
    axis = "Body leaf/Kinematics/Axis elements="
    for theory in ("EBBT", "LE-1", "LE-2", "LE-3"):
        for elements in ("5", "10", "20"):
            run = Timed(SCENE, LAST + [f"Theory={theory}", axis + elements])
            rows.append(row_of(run, f"{theory}, {elements} elements a leaf"))
    run = Timed(SCENE, LAST + ["Theory=SV-6", axis + "10"])
    rows.append(row_of(run, "SV-6, 10 elements a leaf"))
    for penalty in ("1e3", "1e4", "1e5"):
        run = Timed(SCENE, LAST + ["Contact interleaf/Enforcement=penalty",
                                   f"Contact interleaf/Penalty={penalty}"])
        rows.append(row_of(run, f"LE-2, penalty {penalty} N/mm^3"))
    table(header, rows)

    rows, before = [], None
    for n in (2, 4, 8, 16, 32):
        # As many, shorter from one to the next so that all fit.
        step = 350. / (n - 1)
        run = Timed(SCENE, LAST + [f"Body leaf/Copies={n}", f"Body leaf/Length step={step}",
                                   f"Load wheel/On=leaf-{n}: end",
                                   f"Probe tip/At=leaf-{n}: 25, 500, {8.2 * (n - 1)}"])
        forces, tip = closed_form(n, step=step)
        touching = sum(c["force"][2] > 0. for c in run.summary["contacts"].values())
        rows.append([n, f"{touching} ({np.count_nonzero(forces)})",
                     run.summary["dofs"], f"{-run.value('tip: uz'):.5g}", f"{tip:.5g}",
                     sum(c["rows"] for c in run.summary["contacts"].values()),
                     sum(run.summary["iterations"]), f"{run.seconds:.2f}",
                     f"{run.seconds / before:.2f}" if before else ""])
        before = run.seconds
    table(["leaves", "contacts that touch (closed form)", "DoFs", "deflection, mm",
           "closed form", "gap rows", "iterations", "seconds", "times the last"], rows)
