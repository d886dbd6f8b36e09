#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Holds what scripts/figures.py finds out about a contact against Hertz.

Usage: check_pictures.py FIGURES.py WORKDIR

Two cylinders, R* = 4, E and nu of both given, 0.3 N/mm over 2 mm along y: the
pairs of contact_NAME.csv carry Hertz's pressure, times areas that add up to the
force. From the points, forces and materials the half-width
a = sqrt(4 F' R* / (pi E*)) and the peak p0 = 2 F' / (pi a) must come back; a
laminate, or a flat contact, must give no ellipse. Then all pictures are drawn.
Exit status 77 (skipped) without numpy or matplotlib.
"""

import csv
import importlib.util
import math
import shutil
import subprocess
import sys
from pathlib import Path

RADIUS, FORCE, LENGTH, E, NU = 4., 0.3, 2., 200., 0.3
MODULUS = E / (2. * (1. - NU**2))
HALF_WIDTH = math.sqrt(4. * FORCE * RADIUS / (math.pi * MODULUS))
PEAK = 2. * FORCE / (math.pi * HALF_WIDTH)
COLUMNS = ("step,x,y,z,x2,y2,z2,nx,ny,nz,area,initial_gap,gap,force,pressure,"
           "active").split(",")

SCENE = """
subsection Material soft
  set Isotropic = {E}, {NU}
end
subsection Material ply
  set Isotropic             =
  set Engineering constants = 1, 1, 1, 1, 1, 1, 0, 0, 0
end
subsection Section half
  set Material = soft
end
subsection Section strip
  set Ply materials = ply
end
subsection Body lower
  set Section = half
end
subsection Body upper
  set Section = half
end
subsection Body laminate
  set Section = strip
end
subsection Contact arcs
  set First  = lower: arc
  set Second = {SECOND}
end
"""


def check(condition, what):
    if not condition:
        sys.exit(f"FAIL: {what}")
    print(f"ok: {what}")


def rows(curvature, across="x"):
    """A grid of pairs over two half-widths, ends of y with half the area."""
    n, m = 81, 9
    dx, dy = 4. * HALF_WIDTH / (n - 1), LENGTH / (m - 1)
    for j in range(m):
        for i in range(n):
            t, y = -2. * HALF_WIDTH + i * dx, j * dy
            area = dx * dy * (0.5 if j in (0, m - 1) else 1.)
            # The mean over the tributary width, so that forces add up exactly.
            force = (primitive(t + dx / 2) - primitive(t - dx / 2)) * area / dx
            gap = 0.5 * curvature * t * t
            at = (7. + t, y, 8.) if across == "x" else (y, 7. + t, 8.)
            yield dict(zip(COLUMNS, (1, *at, *at[:2], 8. + gap, 0, 0, 1, area, gap, gap,
                                     force, force / area, int(force > 0.))))


def primitive(x):
    """Of Hertz's pressure."""
    t = max(-1., min(1., x / HALF_WIDTH))
    return 0.5 * PEAK * HALF_WIDTH * (t * math.sqrt(1. - t * t) + math.asin(t))


def results_of(figures, folder, second, curvature, across="x"):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    (folder / "scene.prm").write_text(SCENE.format(E=E, NU=NU, SECOND=second))
    with open(folder / "contact_arcs.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS)
        writer.writeheader()
        writer.writerows(rows(curvature, across))
    results = figures.Results(folder)
    return results, figures.ContactPatch(results.contacts["arcs"])


def main():
    if len(sys.argv) != 3:
        sys.exit("Usage: check_pictures.py FIGURES.py WORKDIR")
    try:
        import matplotlib  # noqa: F401
        import numpy  # noqa: F401
    except ImportError:
        print("numpy or matplotlib is not here: skipped")
        sys.exit(77)
    spec = importlib.util.spec_from_file_location("figures", sys.argv[1])
    figures = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(figures)
    folder = Path(sys.argv[2])

    for across in "xy":
        results, patch = results_of(figures, folder, "upper: arc", 1. / RADIUS, across)
        check(patch.across == across, f"the width lies along {across}")
        found = figures.hertz_ellipse(results, "arcs", patch)
        for value, wanted, what in zip(found, (HALF_WIDTH, PEAK, FORCE),
                                       ("half-width", "peak", "force a length")):
            check(abs(value / wanted - 1.) < 1e-9, f"{what} {value:.9g}")
    # A rigid partner: E* is that of the one body, twice as large.
    results, patch = results_of(figures, folder, "roller", 1. / RADIUS)
    found = figures.hertz_ellipse(results, "arcs", patch)
    check(abs(found[0] / HALF_WIDTH - 0.5**0.5) < 1e-9, "half-width on a rigid body")
    results, patch = results_of(figures, folder, "laminate: top", 1. / RADIUS)
    check(figures.hertz_ellipse(results, "arcs", patch) is None,
          "no ellipse on an anisotropic body")
    results, patch = results_of(figures, folder, "upper: arc", 0.)
    check(figures.hertz_ellipse(results, "arcs", patch) is None,
          "no ellipse in a flat contact")

    results_of(figures, folder, "upper: arc", 1. / RADIUS)
    subprocess.run([sys.executable, sys.argv[1], folder], check=True)
    drawn = sorted(path.name for path in (folder / "pictures").glob("*.png"))
    check(drawn == ["contact_arcs_map.png", "contact_arcs_pressure.png"],
          f"pictures: {', '.join(drawn)}")


if __name__ == "__main__":
    main()
