# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rates of convergence of a contact whose solution is known; see scripts/measure."""

import math

from measure_bars import BarRun
from measure_tools import ROOT, table

# Of tests/scenes/manufactured_contact.prm; tests/unit/manufactured_contact.cc derives
# the solution.
K, HEIGHT, YOUNG, POISSON, MEAN, WAVE, GAP = math.pi / 2, 1., 1000., 0.3, 2., 1., 0.01


def solution():
    """Amplitude of the pressure on the face, shortening of a strip: its amplitude and
    its mean."""
    kh = K * HEIGHT
    sinh, cosh = math.sinh(kh), math.cosh(kh)
    b = WAVE / K ** 2 / (kh * sinh - (1 + kh * cosh / sinh) * cosh)
    a = -b * (1 + kh * cosh / sinh)
    integral = a * sinh / K + b * (HEIGHT * cosh - sinh / K)
    amplitude = -(1 + POISSON) * (1 - POISSON) / YOUNG * K ** 2 * integral
    mean = -MEAN * (1 + POISSON) * (1 - 2 * POISSON) / (YOUNG * (1 - POISSON)) * HEIGHT
    return K ** 2 * a, amplitude, mean


def errors(degree, discretization, n):
    """The pressure's in L2, relative; the largest of the deflections at the probes."""
    pressure, amplitude, mean = solution()
    other = n if discretization == "node to node" else 3 * n // 2
    overrides = [f"Theory=LE-{degree}", f"Contact faces/Discretization={discretization}",
                 f"Section strip/Cells per ply={n}"]
    for body, elements in (("upper", n), ("lower", other)):
        overrides += [f"Body {body}/Kinematics/Axis element=B{degree + 1}",
                      f"Body {body}/Kinematics/Axis elements={elements}"]
    run = BarRun(ROOT / "tests/scenes/manufactured_contact.prm", overrides)
    total = off = 0.
    for row in run.tables["contact_faces.csv"]:
        exact = MEAN + pressure * math.cos(K * float(row["y"]))
        off += float(row["area"]) * (float(row["pressure"]) - exact) ** 2
        total += float(row["area"]) * exact ** 2
    worst = max(abs(float(row["uz"]) + GAP - 2 * mean
                    - amplitude * (1 + math.cos(K * float(row["y"]))))
                for row in run.probes if row["probe"] != "held")
    return math.sqrt(off / total), worst


def rates():
    """doc/verification/contact.md: errors of pressure and deflection for 2, 4, 8 elements."""
    rows = []
    for discretization in ("node to node", "surface to surface", "node to surface"):
        row = [f"`{discretization}`"]
        for degree in (1, 2):
            found = [errors(degree, discretization, n) for n in (2, 4, 8)]
            row += [", ".join(f"{100 * error[0]:.2g}" for error in found),
                    ", ".join(f"{error[1]:.1e}" for error in found)]
        rows.append(row)
    table(["", "LE-1, B2: pressure, %", "deflection", "LE-2, B3: pressure, %",
           "deflection"], rows)
