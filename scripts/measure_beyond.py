# SPDX-License-Identifier: LGPL-2.1-or-later
"""doc/verification/beyond-linear.md: stiffening and buckling factors beside closed forms, and what
they cost; see scripts/measure."""

import math

from measure_tools import ROOT, Run, table

SCENES = ROOT / "tests/scenes"
THEORIES = ("EBBT", "TBT", "TE-3", "LE-2", "SV-4", "solid-2")


def strip():
    """A strip between clamps under a uniform pressure: r = 0.696686 (W/h)^2."""
    rows = []
    for theory in THEORIES:
        more = ["Body strip/Kinematics/Axis elements=64"] if theory == "solid-2" else []
        run = Run(SCENES / "deflected_strip.prm",
                  [f"Theory={theory}", "Load factors=1, 2, 4, 8, 16"] + more)
        steps = run.summary["beyond_linear"]["steps"]
        rows.append([theory, run.summary["dofs"]] + [f"{s['stiffening']:.5g}" for s in steps])
    rows.append(["closed form", ""] +
                [f"{0.696686 * (0.5 * t) ** 2:.5g}" for t in (1, 2, 4, 8, 16)])
    table(["theory", "DoFs"] + [f"W/h = {0.5 * t:g}" for t in (1, 2, 4, 8, 16)], rows)


def columns():
    """Euler's column, L/h = 200, of steel and of a [0/90/0] laminate."""
    euler = {"strip": math.pi ** 2 * 2.7e6 / (4. * 600. ** 2),
             "laminate": math.pi ** 2 * 1.82797e6 / (4. * 600. ** 2)}
    rows = []
    for theory in THEORIES:
        row = [theory]
        for section, load in euler.items():
            more = ["Body column/Kinematics/Axis elements=40"] if theory == "solid-2" else []
            run = Run(SCENES / "column.prm",
                      [f"Theory={theory}", f"Body column/Section={section}",
                       "Beyond linear range=accept"] + more)
            force = -run.summary["loads"]["weight"]["force"][2]
            factor = run.summary["beyond_linear"]["buckling_factor"]
            row += [f"{factor * force:.4f}", f"{100. * (factor * force / load - 1.):+.2f} %"]
        rows.append(row)
    rows.append(["Euler"] + [cell for load in euler.values() for cell in (f"{load:.4f}", "")])
    table(["theory", "steel [N]", "off", "[0/90/0] [N]", "off"], rows)


# Entry overrides of tests/scenes/sandwich_line_load.prm; the loads buckle none of them.
PATCH = ["Load p/On=beam: top", "Load p/At=", "Load p/Total force=",
         "Load p/Force=0, 0, (y > 80) * (y < 120) * -0.335"]
SANDWICHES = {
    "honeycomb 12, faces 1, line load": [],
    "foam 12, faces 1, line load": ["Material core/Library=Rohacell-71-WF"],
    "foam 12, faces 0.3, pressure on 40 mm": [
        "Material core/Library=Rohacell-71-WF", "Section sandwich/Ply thickness=0.3, 12, 0.3",
        *PATCH],
    "foam 20, faces 3, pressure on 40 mm": [
        "Material core/Library=Rohacell-71-WF", "Section sandwich/Ply thickness=3, 20, 3",
        *PATCH],
    "honeycomb 12, faces 0.5, point load": [
        "Section sandwich/Ply thickness=0.5, 12, 0.5", "Load p/On=beam: point",
        "Load p/At=10, 100, 13", "Load p/Total force=", "Load p/Force=0, 0, -100"],
}
MESHES = {"LE-2": (60, 2), "LE-3": (60, 1), "SV-6": (60, 1), "solid-2": (120, 2)}


def sandwiches():
    """First factors of sandwiches on two lines by theories that follow every ply."""
    rows = []
    for name, overrides in SANDWICHES.items():
        row = [name]
        for theory, (elements, cells) in MESHES.items():
            run = Run(SCENES / "sandwich_line_load.prm",
                      [f"Theory={theory}", f"Body beam/Kinematics/Axis elements={elements}",
                       f"Section sandwich/Cells per ply=1, {2 * cells}, 1",
                       "Goals/Error bars=false", *overrides])
            factor = run.failure or run.summary["beyond_linear"]["buckling_factor"]
            row.append(f"{factor:.3g}" if isinstance(factor, float) else factor or "-")
        rows.append(row)
    table(["sandwich", *MESHES], rows)


def wrinkling_factor(n, layers, length, degree=8):
    """The factor of the mode u_y = V(z) cos(k y), u_z = W(z) sin(k y), k = n pi / length, of
    layers (thickness, E, G, stress s), Poisson's ratio 0, plane strain: with the strain
    energy of e_yy = -k V, e_zz = W', g_yz = V' + k W it is the least -U / U_G, where
    U_G = int s k^2 (V^2 + W^2) dz / 2 (Biot, Mechanics of Incremental Deformations, 1965)."""
    import numpy as np
    from numpy.polynomial import polynomial
    k = n * math.pi / length
    points, weights = np.polynomial.legendre.leggauss(degree + 2)
    nodes = np.cos(np.pi * np.arange(degree, -1, -1) / degree)
    inverse = np.linalg.inv(polynomial.polyvander(nodes, degree))
    N = polynomial.polyvander(points, degree) @ inverse
    dN = polynomial.polyvander(points, degree - 1) @ (
        np.arange(1, degree + 1)[:, None] * inverse[1:])
    pieces = [(t / m, E, G, s) for t, E, G, s in layers for m in [math.ceil(t / 2.)]
              for _ in range(m)]
    size = len(pieces) * degree + 1
    K, K_G = np.zeros((2 * size, 2 * size)), np.zeros((2 * size, 2 * size))
    for e, (h, E, G, s) in enumerate(pieces):
        v = e * degree + np.arange(degree + 1)
        w, (dz, weight) = size + v, (2. / h, weights * h / 2.)
        M, S, A = ((a.T * weight) @ b * scale for a, b, scale in
                   ((N, N, 1.), (dN, dN, dz * dz), (N, dN, dz)))
        K[np.ix_(v, v)] += E * k * k * M + G * S
        K[np.ix_(w, w)] += E * S + G * k * k * M
        K[np.ix_(w, v)] += G * k * A
        K[np.ix_(v, w)] += G * k * A.T
        for d in (v, w):
            K_G[np.ix_(d, d)] += s * k * k * M
    inverse = np.linalg.inv(np.linalg.cholesky(K))
    return -1. / np.linalg.eigvalsh(inverse @ K_G @ inverse.T)[0]


def wrinkling():
    """Wrinkling of a sandwich under end compression beside elasticity."""
    layers = [(1., 70e3, 35e3, -300.), (30., 200., 100., -300. / 350.), (1., 70e3, 35e3, -300.)]
    exact, n = min((wrinkling_factor(n, layers, 60.), n) for n in range(1, 20))
    rows = []
    for theory in ("LE-1", "LE-2", "LE-3", "TE-4", "solid-2"):
        run = Run(SCENES / "wrinkling.prm", [f"Theory={theory}", "Goals/Error bars=false"])
        factor = run.summary["beyond_linear"]["buckling_factor"]
        rows.append([theory, run.summary["dofs"], f"{factor:.4f}",
                     f"{100. * (factor / exact - 1.):+.2f} %"])
    rows.append([f"elasticity, {n} half waves", "", f"{exact:.4f}", ""])
    table(["theory", "DoFs", "factor", "off"], rows)


def shipped():
    """What the shipped scenes say, and what it costs of a linear step."""
    rows = []
    for scene in sorted((ROOT / "prm").glob("*.prm")):
        run = Run(scene, ["Write VTU=false"])
        # Runs with large rotations have no such numbers.
        if run.failure or "beyond_linear" not in run.summary:
            continue
        seconds = run.summary["seconds"]
        steps = run.summary["load_steps"]
        step = (seconds["assembly"] + seconds["factorization"] +
                (seconds["solve"] + seconds["contact"]) / steps)
        found = run.summary["beyond_linear"]
        factor = found["buckling_factor"]
        rows.append([f"`{scene.name}`", run.summary["dofs"],
                     f"{100. * found['stiffening']:.2g} %",
                     "-" if factor is None else f"{factor:.3g}",
                     f"{step:.3f}", f"{seconds['beyond'] / steps / step:.3f}"])
    table(["scene", "DoFs", "stiffening", "buckling factor", "a linear step [s]",
           "share of both checks"], rows)


def beyond():
    """Stiffening, buckling, and what they cost."""
    strip()
    columns()
    sandwiches()
    wrinkling()
    shipped()
