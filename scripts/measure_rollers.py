# SPDX-License-Identifier: LGPL-2.1-or-later
"""Discretizations of a contact with a roller beside rods by shooting (doc/verification/contact.md); see
scripts/measure."""

import numpy as np

from measure_bars import BarRun
from measure_tools import table
from measure_turning import ROLLER, Section, across, along, on_roller, path

KINDS = ("auto", "line to roller", "node to surface", "surface to surface")
# Thickness, radius, span over thickness; an element over the radius; the theory.
COUPONS = ((1., 3., 60., 0.25, "TBT"), (1., 3., 60., 0.5, "SV"), (1., 3., 60., 1., "LE-2"),
           (1., 10., 280., 0.5, "TBT"), (1., 10., 280., 1., "TBT"), (2., 5., 140., 0.5, "TBT"),
           (4., 3., 60., 2., "TBT"), (4., 10., 140., 0.5, "TBT"), (4., 10., 140., 2., "TBT"))
# Deflection over span.
SHARE = 0.15


def overrides(thickness, radius, half_span, elements, down):
    """Of tests/scenes/large_roller.prm: a strip that ends a fifth of its half span and a
    radius behind its roller."""
    face = -0.5 * thickness
    return [f"Section strip/Ply thickness={thickness}", f"Body strip/Origin=0, 0, {face}",
            f"Body strip/Length={1.2 * half_span + radius}",
            f"Body strip/Kinematics/Axis elements={elements}",
            f"Obstacle roller/Radius={radius}",
            f"Obstacle roller/Through=0, {half_span}, {face - radius}",
            f"Support ram/u=0, 0, {-down}",
            "Load factors=0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1"]


def force_of_rod(thickness, radius, half_span, down, mu):
    section = Section(3e3, 12., thickness)
    first = down / 20.
    rods = path(on_roller(section, half_span, radius, mu), np.linspace(first, down, 20),
                [first / half_span, 3. * section.bending / half_span ** 3 * first, half_span])
    angle, force, _ = rods[down]
    return force * (across(angle) + mu * along(angle))


def off(settings, known):
    """How far the force of a run is off the known one, in per cent of that, and what the
    discretization came to."""
    run = BarRun(ROLLER, settings)
    if run.failure:
        return "none", ""
    face = run.summary["contacts"]["face"]
    mine = np.array([-face["force"][1], -face["force"][2]])
    return (f"{100. * np.linalg.norm(mine - known) / np.linalg.norm(known):.1g}",
            face["discretization"])


def rollers():
    """Half a strip over a roller, by all discretizations."""
    rows = []
    for thickness, radius, slenderness, size, theory in COUPONS:
        half_span = 0.5 * slenderness * thickness
        down = 2. * half_span * SHARE
        elements = round((1.2 * half_span + radius) / (size * radius))
        for mu in (0., 0.3):
            known = force_of_rod(thickness, radius, half_span, down, mu)
            found = [off([f"Theory={theory}", f"Contact face/Friction={mu or 'none'}",
                          f"Contact face/Discretization={kind}",
                          *overrides(thickness, radius, half_span, elements, down)], known)
                     for kind in KINDS]
            rows.append([f"{thickness:g}, {radius:g}, {slenderness:g}", f"{size:g}", theory,
                         f"{mu:g}", found[0][1]] + [one for one, _ in found])
    table(["thickness, radius, span / thickness", "element / radius", "theory", "mu", "`auto` is",
           *KINDS], rows)
