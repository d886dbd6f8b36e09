# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws u_y and sigma_yz at the bearing beside the exact solution.

plot.py FOLDER PICTURE.PNG; FOLDER holds a run of step-2.prm for each theory, in a
folder of the theory's name.
"""

import csv
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

STYLES = {"TBT": "#e69f00", "TE-3": "#009e73", "TE-7": "#cc79a7", "LE-3": "#0072b2"}
E, NU, PLY, SPAN = 7000.0, 0.25, 1.0, 12.0


def exact(samples=31):
    """(z, u_y, sigma_yz) at y = 0, after Pagano (1969), ply by ply.

    u_y = U(z) cos(p y), u_z = W sin, sigma_yz = T cos, sigma_zz = N sin make
    (U, W, T, N)' = A (U, W, T, N) in each ply; T = N = 0 at the bottom, T = 0 and
    N = 1 MPa on top fix the rest.
    """
    p, plies, total = np.pi / SPAN, [], np.eye(4)
    for along in (True, False, True):
        # Compliance of yy, xx, zz with the fiber along y or x, eps_xx = 0.
        E_y, E_x = (25 * E, E) if along else (E, 25 * E)
        s = np.array([[1 / E_y, -NU / max(E_x, E_y), -NU / E_y],
                      [-NU / max(E_x, E_y), 1 / E_x, -NU / E_x],
                      [-NU / E_y, -NU / E_x, 1 / E]])
        c = np.linalg.inv(s)[np.ix_((0, 2), (0, 2))]
        shear = (0.5 if along else 0.2) * E
        coupling, plane = c[0, 1] / c[1, 1], c[0, 0] - c[0, 1] ** 2 / c[1, 1]
        A = np.array([[0, -p, 1 / shear, 0],
                      [p * coupling, 0, 0, 1 / c[1, 1]],
                      [p * p * plane, 0, 0, -p * coupling],
                      [0, 0, p, 0]])
        values, vectors = np.linalg.eig(A)
        plies.append((values, vectors, total))
        total = advance(values, vectors, PLY) @ total
    start = np.zeros(4)
    start[:2] = np.linalg.solve(total[2:, :2], (0, 1))
    for k, (values, vectors, below) in enumerate(plies):
        z = np.linspace(0, PLY, samples)
        state = np.array([advance(values, vectors, s) @ below @ start for s in z])
        yield k * PLY + z, state[:, 0], state[:, 2]


def advance(values, vectors, z):
    """exp(A z)."""
    return (vectors * np.exp(values * z) @ np.linalg.inv(vectors)).real


def computed(path):
    """(z, u_y, sigma_yz) ply by ply."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    for ply in sorted({row["ply"] for row in rows}):
        yield tuple(np.array([float(row[name]) for row in rows if row["ply"] == ply])
                    for name in ("z", "uy", "syz"))


def draw(panels, plies, label, **style):
    """Against z, with a gap in the line at each interface, where sigma_yz may
    jump."""
    gap = [np.nan]
    z, u, syz = (np.concatenate([np.r_[ply[k], gap] for ply in plies])
                 for k in range(3))
    panels[0].plot(1e3 * u, z, label=label, **style)
    panels[1].plot(syz, z, label=label, **style)


figure, panels = plt.subplots(1, 2, figsize=(8.4, 4.6), layout="constrained",
                              sharey=True)
draw(panels, list(exact()), "exact", color="0.75", linewidth=7,
     solid_capstyle="butt")
for theory, color in STYLES.items():
    path = Path(sys.argv[1]) / theory / "lines" / "at_bearing.csv"
    draw(panels, list(computed(path)), theory, color=color, linewidth=1.8)
for axes in panels:
    for k, angle in enumerate((0, 90, 0)):
        axes.axhspan(k * PLY, (k + 1) * PLY, zorder=0,
                     color="0.95" if k % 2 else "white", linewidth=0)
    axes.axvline(0, color="0.6", linewidth=0.8)
    axes.spines[["top", "right"]].set_visible(False)
for k, angle in enumerate((0, 90, 0)):
    panels[1].annotate(f"{angle}°", (1.01, (k + 0.5) * PLY), color="0.35", va="center",
                       xycoords=("axes fraction", "data"))
panels[0].set_xlabel("$u_y$ [µm]")
panels[1].set_xlabel(r"$\sigma_{yz}$ [MPa]")
panels[0].set_ylabel("z [mm]")
panels[0].set_ylim(0, 3 * PLY)
panels[1].set_xlim(left=0)
panels[1].legend(frameon=False, loc="center left", bbox_to_anchor=(1.1, 0.5))
figure.suptitle("At the bearing, through the thickness")
figure.savefig(sys.argv[2], dpi=150)
