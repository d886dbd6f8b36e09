# SPDX-License-Identifier: LGPL-2.1-or-later
"""Friction against closed forms, boundary elements and CalculiX, and what it costs
(doc/verification/friction.md); see scripts/measure."""

import math
import re
import statistics
import subprocess
import tempfile
from pathlib import Path

import numpy as np
import peers

from measure_bars import BarRun
from measure_tolerances import Timed
from measure_tools import PROGRAM, ROOT, table

PUNCH = ROOT / "tests/scenes/friction_punch.prm"
CATTANEO = ROOT / "tests/scenes/friction_cattaneo.prm"
FLEXURE = ROOT / "prm/flexure_test.prm"
CROSSED = ROOT / "tests/scenes/friction_crossed.prm"
RUBBED = ROOT / "tests/calculix/rubbed.prm"
# Of all of them.
POISSON = 0.3


def elliptic(k):
    """The complete integral of the first kind, by the arithmetic-geometric mean."""
    a, b = 1., math.sqrt(1. - k * k)
    while abs(a - b) > 1e-15 * a:
        a, b = 0.5 * (a + b), math.sqrt(a * b)
    return 0.5 * math.pi / a


def bisect(f, low, high, rounds=60):
    for _ in range(rounds):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if f(middle) > 0. else (low, middle)
    return 0.5 * (low + high)


def spence(mu):
    """Spence (1975): K(c/a) / K'(c/a) = mu / beta; what shear does to pressure is left out."""
    beta = (1. - 2. * POISSON) / (2. * (1. - POISSON))
    return bisect(lambda k: mu / beta - elliptic(k) / elliptic(math.sqrt(1. - k * k)),
                  1e-9, 1. - 1e-12)


def boundary_elements(mu, n):
    """c / a of the punch on a half plane (Johnson, Contact Mechanics, 2.25), with n constant
    tractions on the right half, shear and pressure coupled: the slip at the end of what
    sticks is zero."""
    beta = (1. - 2. * POISSON) / (2. * (1. - POISSON))
    ends = 1. - (1. - np.linspace(0., 1., n + 1)) ** 2
    a, b = ends[:-1], ends[1:]
    x, width = 0.5 * (a + b), b - a

    def potential(left, right):
        def antiderivative(t):
            return t * np.log(np.abs(t)) - t
        return antiderivative(x[:, None] - left) - antiderivative(x[:, None] - right)

    even = potential(a, b) + potential(-b, -a)
    odd = potential(a, b) - potential(-b, -a)
    integral = np.tril(np.ones((n, n)), -1) * width + np.diag(0.5 * width)

    def slip(sticking):
        """Of the first element that slips."""
        pressure = np.hstack([np.eye(n), np.zeros((n, sticking))])
        shear = np.zeros((n, n + sticking))
        shear[:sticking, n:] = np.eye(sticking)
        shear[range(sticking, n), range(sticking, n)] = mu
        down = -even @ pressure / math.pi + beta * integral @ shear
        along = -beta * integral @ pressure - odd @ shear / math.pi
        matrix = np.vstack([np.diff(down, axis=0), np.append(width, np.zeros(sticking)),
                            along[:sticking]])
        right = np.zeros(n + sticking)
        right[n - 1] = 1.
        return along[sticking] @ np.linalg.solve(matrix, right)

    low, high = 2, n - 3
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if slip(middle) > 0. else (low, middle)
    at_low, at_high = slip(low), slip(high)
    return ends[low] + (ends[high] - ends[low]) * at_low / (at_low - at_high)


def punch():
    """doc/verification/friction.md: the share of Spence's punch that sticks."""
    rows = []
    for mu in (0.1, 0.2, 0.3, 0.5):
        run = BarRun(PUNCH, [f"Contact pad/Friction={mu}"])
        coarse, fine = boundary_elements(mu, 200), boundary_elements(mu, 400)
        sticks = run.summary["contacts"]["pad"]["friction"]["sticking_area"] / 0.1
        rows.append([mu, f"{spence(mu):.3f}", f"{2. * fine - coarse:.3f}", f"{sticks:.3f}"])
    table(["mu", "Spence, uncoupled", "boundary elements, to h = 0", "run"], rows)


def cattaneo():
    """doc/verification/friction.md: round bodies pressed and pushed to and fro, beside Cattaneo's shear."""
    e_star, radius, friction = 200. / (1. - POISSON ** 2) / 2., 4., 0.4
    lines = []
    for fine in (1, 2, 4):
        with tempfile.TemporaryDirectory() as folder:
            mesh = f"{folder}/half.msh"
            subprocess.run(["gmsh", "-2", "-setnumber", "fine", str(fine), CATTANEO.with_suffix(".geo"),
                            "-o", mesh, "-format", "msh41"], check=True, capture_output=True)
            run = BarRun(CATTANEO, [f"Section half/File={mesh}"])
        rows = {step: [row for row in run.tables["contact_nip.csv"] if row["step"] == str(step)]
                for step in (2, 4)}
        x, area, shear, force, lost = (
            np.array([float(row[column]) for row in rows[2]])
            for column in ("x", "area", "shear_x", "force", "dissipated"))
        a = math.sqrt(4. * force.sum() * radius / math.pi / e_star)
        left = 1. - shear.sum() / friction / force.sum()
        c = a * math.sqrt(left)

        def root(half, x=x, a=a, force=force):
            return (friction * 2. * force.sum() / math.pi / a ** 2
                    * np.sqrt(np.maximum(0., half ** 2 - x ** 2)))

        exact, found = root(a) - root(c), np.where(area > 0., shear / np.where(area > 0., area, 1.), 0.)
        off = math.sqrt((area * (found - exact) ** 2).sum() / (area * exact ** 2).sum())
        stuck = max(float(row["x"]) for row in rows[2] if row["state"] == "stick")
        cycle = ((friction * force.sum()) ** 2 / math.pi / e_star
                 * (4. * left * math.log(left) + 2. * (1. - left ** 2)))
        after = sum(float(row["dissipated"]) * float(row["area"]) for row in rows[4])
        lines.append([f"{0.02 / 13. / fine:.6f}", f"{1. - left:.4f}", f"{c:.5f}", f"{stuck:.5f}",
                      f"{100. * off:.2f} %", f"{(after - (lost * area).sum()) / cycle:.4f}",
                      run.summary["dofs"], f"{run.wall:.0f}"])
    table(["nodes apart", "Q / (mu P)", "c, Cattaneo", "sticks to", "shear, L2",
           "energy of a cycle over the closed form", "DoFs", "s"], lines)


def mindlin(rows, force, pushed, friction=0.4, radius=8., young=200.):
    """Stick radius, tractions and energy of a cycle of spheres (Mindlin 1949, Mindlin and
    Deresiewicz 1953), with those of the @p rows of a contact pushed by the force @p pushed."""
    shear_modulus = young / (2. * (1. + POISSON))
    radius_of_contact = (0.75 * force * radius
                         * 2. * (1. - POISSON ** 2) / young) ** (1. / 3.)
    ratio = math.hypot(*pushed) / (friction * force)
    sticks = radius_of_contact * (1. - ratio) ** (1. / 3.)
    cycle = (0.9 * (friction * force) ** 2 / radius_of_contact
             * 2. * (2. - POISSON) / shear_modulus
             * (1. - (1. - ratio) ** (5. / 3.)
                - 5. * ratio / 6. * (1. + (1. - ratio) ** (2. / 3.))))
    largest = 1.5 * friction * force / (math.pi * radius_of_contact ** 2)

    def cap(r, c):
        return math.sqrt(max(0., 1. - (r / c) ** 2))

    off = size = 0.
    for row in rows:
        r, area = math.hypot(float(row["x"]), float(row["y"])), float(row["area"])
        exact = largest * (cap(r, radius_of_contact)
                           - sticks / radius_of_contact * cap(r, sticks))
        found = (float(row["shear_x"]) * pushed[0] + float(row["shear_y"]) * pushed[1]) / (
            area * math.hypot(*pushed))
        off, size = off + (found - exact) ** 2 * area, size + exact ** 2 * area
    return radius_of_contact, ratio, sticks, cycle, math.sqrt(off / size)


def crossed_cylinders():
    """doc/verification/friction.md: crossed cylinders as solids, a cycle beside Mindlin's closed forms."""
    lines = []
    ball = "0, 0, 8: 1.5: 1 | 0, 0, 8: 1: 1 | 0, 0, 8: 0.6: 1 | "
    for name, balls in (("h / a = 0.10", "0, 0, 8: 0.3: 1 | 0, 0, 8: 0.15: 1"),
                        ("h / a = 0.05", "0, 0, 8: 0.35: 1 | 0, 0, 8: 0.175: 1 | "
                                         "0, 0, 8: 0.125: 1")):
        run = BarRun(CROSSED, [f"Body {body}/Kinematics/Refine near={ball}{balls}"
                               for body in ("upper", "lower")])
        rows = run.tables["contact_nip.csv"]
        steps = {step: [row for row in rows if row["step"] == str(step)] for step in (2, 4)}

        def sum_of(column, step, steps=steps):
            return sum(float(row[column]) for row in steps[step])

        pushed = [sum_of("shear_x", 2), sum_of("shear_y", 2)]
        a, ratio, c, cycle, off = mindlin(steps[2], sum_of("force", 2), pushed)
        area = sum(float(row["area"]) for row in steps[2] if row["state"] == "stick")
        lost = [sum(float(row["dissipated"]) * float(row["area"]) for row in steps[step])
                for step in (2, 4)]
        lines.append([name, sum(row["active"] == "1" for row in steps[2]), f"{ratio:.4f}",
                      f"{c:.4f}", f"{math.sqrt(area / math.pi):.4f}",
                      f"{math.degrees(math.atan2(pushed[1], pushed[0])):.3f}",
                      f"{100. * off:.0f} %", f"{(lost[1] - lost[0]) / cycle:.4f}",
                      run.summary["dofs"], f"{run.wall:.0f}"])
    table(["nodes apart", "rows that touch", "Q / (mu P)", "c, Mindlin", "c, run",
           "direction (28.369)", "shear, L2", "energy of a cycle over the closed form", "DoFs",
           "s"], lines)


def bent(thrust, turned, stiffness):
    """Deflection by a unit force of a coupon on rollers that push its ends together with @p thrust
    times what they bear, and touch it where it has turned by @p turned: Timoshenko's beam."""
    height, radius = 4., 3.
    span = 128. - 2. * radius * math.sin(turned)
    bending, shear = stiffness
    return (span ** 3 / (48. * bending) * (1. - 1.5 * thrust * height / span)
            + span / (4. * shear))


def coupon():
    """doc/verification/friction.md: what rollers that rub do to a bending test, loading and unloading; beside
    the formula, and a beam with shear that leans on the rollers as much as the run's does."""
    validated = subprocess.run([PROGRAM, FLEXURE, "--validate"], check=True, text=True,
                               capture_output=True).stdout
    stiffness = [float(re.search(pattern, validated).group(1))
                 for pattern in (r"EI_2 (\S+)", r"kGA_z (\S+)")]
    slenderness, rows = 4. / 128., []
    finer = "Body coupon/Kinematics/Axis elements=2, 16, 8, 16, 8, 16, 2"
    for theory, cells, more in (("SV-6", "as shipped", []), ("SV-6", "more at rollers", [finer]),
                                ("LE-2", "2 across", ["Section laminate/Cells across=2"])):
        found = {}
        for mu in (0., 0.1, 0.3, 0.5):
            rubs = [f"Contact {name}/Friction={mu or 'none'}"
                    for name in ("c_nose", "c_left", "c_right")]
            run = BarRun(FLEXURE, rubs + [
                f"Theory={theory}", "Load factors=0.5, 1, 0.95, 0.6", "Supports=guide",
                "Support guide/u=0, free, free", "Goals/Error bars=false",
                "Beyond linear range=accept"] + more)
            steps = run.tables["history.csv"]
            found[mu] = [[float(steps[k][f"contact:{of}"]) for of in
                          ("c_nose:fz", "c_left:fy", "c_left:fz")] for k in (1, 3)]
        for mu in (0.1, 0.3, 0.5):
            line = []
            for k, sign in ((0, -1.), (1, 1.)):
                (free, free_y, free_z), (force, y, z) = found[0.][k], found[mu][k]
                ratio, thrust = force / free, y / z
                formula = 1. / (1. + sign * 1.5 * mu * slenderness)
                turned = math.atan(thrust) + sign * math.atan(mu)
                beam = (bent(free_y / free_z, math.atan(free_y / free_z), stiffness)
                        / bent(thrust, turned, stiffness))
                line += [f"{formula:.5f}", f"{ratio:.5f}",
                         f"{100. * (ratio / formula - 1.):+.3f} %",
                         f"{100. * (ratio / beam - 1.):+.3f} %"]
            rows.append([theory, cells, mu, *line])
    table(["theory", "cells", "mu", "loading, formula", "run", "off", "off the beam",
           "unloading, formula", "run", "off", "off the beam"], rows)


# Scenes that come with the program, in one load step, with their contacts; not the short
# beam, whose search for its first failure is most of its run.
SHIPPED = {
    "hertz": ["nip"], "hertz_plane_strain": ["nip"], "laminated_beams": ["middle"],
    "laminated_beams_shear": ["middle"], "leaf_spring": ["interleaf"],
    "flexure_test": ["c_nose", "c_left", "c_right"], "sandwich": ["indentation"]}


def rubbing_cost():
    """doc/verification/friction.md: processor seconds with mu = 0.3 over those without friction, one load
    step, three of each in turn."""
    rows = []
    for scene, contacts in SHIPPED.items():
        plain = ["Load factors=1", "Goals/Error bars=false"]
        rubs = plain + [f"Contact {name}/Friction=0.3" for name in contacts]
        pairs = [[Timed(ROOT / f"prm/{scene}.prm", more) for more in (plain, rubs)]
                 for _ in range(3)]
        seconds = [statistics.median(pair[k].seconds for pair in pairs) for k in (0, 1)]
        rows.append([scene, pairs[0][0].summary["dofs"],
                     sum(c["rows"] for c in pairs[0][1].summary["contacts"].values()),
                     f"{seconds[0]:.2f}", f"{seconds[1]:.2f}",
                     f"{statistics.median(b.seconds / a.seconds for a, b in pairs):.2f}"])
    table(["scene", "DoFs", "pairs", "without [s]", "with [s]", "ratio"], rows)


# Scenes whose friction both strategies are to find, and what is set in them.
BOTH_WAYS = (
    ("tests/scenes/friction_pushed.prm", []),
    ("tests/scenes/friction_leaves.prm", []),
    ("tests/scenes/friction_punch.prm", []),
    ("tests/scenes/friction_wedge.prm", []),
    ("tests/calculix/rubbed.prm", []),
    ("tutorials/step-13/step-13.prm", []),
    ("prm/leaf_spring_loop.prm", []),
    ("tests/scenes/friction_slope.prm", ["Gravity=0, 0.29, -1"]),
    ("tests/scenes/friction_slope.prm", ["Gravity=0, 0.299, -1"]),
    ("tests/scenes/friction_leaves.prm", ["Theory=TBT"]))


def rubbing_full():
    """doc/verification/friction.md: `Contact strategy = full` beside `condensed`, with friction."""
    rows = []
    for scene, more in BOTH_WAYS:
        ways = [Timed(ROOT / scene, more + ["Goals/Error bars=false",
                                           f"Contact strategy={strategy}"])
                for strategy in ("condensed", "full")]
        name = " ".join([Path(scene).name, *more])
        if ways[1].failure:
            rows.append([name, ways[0].summary["dofs"], ways[1].failure[:60], "", ""])
            continue
        history = [way.tables["history.csv"] for way in ways]
        forces = [column for column in history[0][0] if column.startswith(("contact:", "support:"))
                  and column.split(":")[-1] in ("fx", "fy", "fz")]
        pairs = [[float(row[column]) for row in steps for column in forces] for steps in history]
        largest = max(map(abs, pairs[0]))
        off = max(abs(a - b) for a, b in zip(*pairs)) / largest
        rows.append([name, ways[0].summary["dofs"], f"{off:.1e}", f"{ways[0].seconds:.1f}",
                     f"{ways[1].seconds / ways[0].seconds:.1f}"])
    table(["scene", "DoFs", "forces of contacts and supports in all steps, off the largest",
           "condensed [s]", "full over it"], rows)


def rubbed():
    """doc/verification/friction.md: blocks that are rubbed to and fro, beside CalculiX, in turn."""
    rows = []
    for name, more in (("one substep", ["Substeps=1"]), ("as shipped, four", [])):
        runs = [(peers.lamella_run(RUBBED, more), peers.peer_run(RUBBED, more,
                                                                contact_stiffness=1e5))
                for _ in range(3)]
        ours, theirs = runs[0]
        rows.append([name, *(f"{abs(b / a - 1):.1e}" for a, b in zip(
            ours.contacts["faces"][::2], theirs.contacts["faces"][::2])),
            f"{statistics.median(a.cpu_seconds for a, _ in runs):.2f}",
            f"{statistics.median(b.cpu_seconds for _, b in runs):.2f}",
            f"{statistics.median(b.cpu_seconds / a.cpu_seconds for a, b in runs):.1f}"])
    table(["path", "Q, difference", "P, difference", "Lamella [s]", "CalculiX [s]", "ratio"],
          rows)
