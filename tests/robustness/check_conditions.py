#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every kind of load with every kind of support, axis and theory, against beam theory.

Usage: check_conditions.py LAMELLA WORKDIR [--all]

A square bar of nu = 0, ten times as long as thick. The reference integrates Timoshenko's beam
    M = M0 + V0 y - int int q,   theta' = kappa_T - M / EI,   w' = theta + V / (kappa G A),
w downwards, with V0, M0, theta0 from the supports, so that it knows nothing of elements. Asserted: the deflection
to TOLERANCE of the largest of the bar (clamps and lines of LE-1 and SV-4 are up to 0.8 % off beam theory),
forces that balance, and reactions that are the load. By default each load meets the automatic axis
and one other, and over them each support and theory; --all is the product.
"""

import itertools
import json
import subprocess
import sys
from pathlib import Path

E, G, H, L, DENSITY, ALPHA = 70000., 35000., 10., 100., 2.7e-9, 2e-5
EI, GA = E * H ** 4 / 12., G * H * H
TOLERANCE, BALANCE = 1e-2, 1e-6
STEPS = 1000
# Theory: what divides the shear force by GA gamma.
THEORIES = {"EBBT": None, "TBT": 1., "LE-1": 1., "SV-4": 5. / 6.}
AXES = {"auto": "auto", "auto 2": "auto 2", "number": "8", "list": "3, 5"}
SUPPORTS = ("cantilever", "clamped", "hinged")
Q, P, M, K = 0.4, 30., 2000., 20.
TOP = f"0, 0, {H}"


def at(y, z=0.5 * H):
    return f"{0.5 * H}, {y}, {z}"


# On, what, and of the reference q(y) downwards, a force and a moment at the end, kappa_T(y).
def load(on, what, q=None, force=0., moment=0., heat=None, gravity=0., where=""):
    return {"on": on, "what": what, "q": q or (lambda y: 0.), "force": force, "moment": moment,
            "heat": heat or (lambda y: 0.), "gravity": gravity, "where": where}


AT_END = {
    "force at a point": load("point", f"Force = 0, 0, {-P}", force=P, where=at(L)),
    "force on the end": load("end", f"Force = 0, 0, {-P / H ** 2}", force=P),
    "total force on the end": load("end", f"Total force = 0, 0, {-P}", force=P),
    "couple on the end": load("end", f"Couple = {-M}, 0, 0", moment=M),
}
ALONG = {
    "pressure": load("top", f"Pressure = {Q / H}", q=lambda y: Q),
    "pressure that varies": load("top", f"Pressure = {Q / H}*(y/{L})^2", q=lambda y: Q * (y / L) ** 2),
    "force on a side": load("top", f"Force = 0, 0, {-Q / H}", q=lambda y: Q),
    "total force on a side": load("top", f"Total force = 0, 0, {-Q * L}", q=lambda y: Q),
    "force along a line": load("line", f"Force = 0, 0, {-Q}", q=lambda y: Q,
                               where=f"{at(0., H)}; {at(L, H)}"),
    "total force along a line": load("line", f"Total force = 0, 0, {-Q * L}", q=lambda y: Q,
                                     where=f"{at(0., H)}; {at(L, H)}"),
    "couple on a side": load("top", f"Couple = {-M}, 0, 0",
                             q=lambda y: 12. * M / L ** 3 * (y - 0.5 * L)),
    "heat": load("body", f"Temperature = {K}*(z - {0.5 * H})*(y/{L})^2",
                 heat=lambda y: ALPHA * K * (y / L) ** 2),
    "weight": load("", "", q=lambda y: 1e7 * DENSITY * H * H, gravity=-1e7),
}


def scene(one, support, axis, theory):
    held = {"cantilever": [("start", "", "0, 0, 0")], "clamped": [("ends", "", "0, 0, 0")],
            "hinged": [("line", f"0, 0, {0.5 * H}; {H}, 0, {0.5 * H}", "0, 0, 0"),
                       ("line", f"0, {L}, {0.5 * H}; {H}, {L}, {0.5 * H}", "free, free, 0")]}[support]
    text = f"""set Units = mm, N
set Theory = {theory}
set Materials = m
set Sections = s
set Bodies = b
set Write VTU = false
set Gravity = 0, 0, {one['gravity']}
set Supports = {', '.join(f's{k}' for k in range(len(held)))}
set Probes = {', '.join(f'p{k}' for k in range(1, 5))}
subsection Goals
  set Error bars = false
end
subsection Material m
  set Isotropic = {E}, 0
  set Density = {DENSITY}
  set Thermal expansion = {ALPHA}
end
subsection Section s
  set Width = {H}
  set Layup = 0
  set Ply thickness = {H}
  set Cells per ply = 2
  set Cells across = 2
end
subsection Body b
  set Section = s
  set Length = {L}
  subsection Kinematics
    set Axis elements = {AXES[axis]}
    set Axis breaks = {0.3 * L if axis == 'list' else ''}
  end
end
"""
    for k, (on, place, u) in enumerate(held):
        text += f"subsection Support s{k}\n  set On = b: {on}\n  set At = {place}\n  set u = {u}\nend\n"
    for k in range(1, 5):
        text += f"subsection Probe p{k}\n  set At = b: {at(0.25 * k * L)}\nend\n"
    if one["what"]:
        text += (f"set Loads = l\nsubsection Load l\n  set On = b: {one['on']}\n"
                 f"  set At = {one['where']}\n  set {one['what']}\nend\n")
    return text


def shot(one, theory, start, loads=1.):
    """w, theta and M at each step and at the end, from V0, M0, theta0 at the start."""
    shear = THEORIES[theory] and THEORIES[theory] * GA
    (V, m, theta), w, step = start, 0., L / STEPS
    ws = [w]
    for k in range(STEPS):
        middle = (k + 0.5) * step
        q = loads * one["q"](middle)
        V_mid, m_mid = V - 0.5 * step * q, m + 0.5 * step * V - step ** 2 / 8. * q
        bend = -m_mid / EI + loads * one["heat"](middle)
        w += step * (theta + 0.5 * step * bend + (V_mid / shear if shear else 0.))
        theta += step * bend
        m += step * V_mid
        V -= step * q
        ws.append(w)
    return ws, theta, m, V


def reference(one, support, theory):
    """Deflections downwards at the quarters."""
    if support == "cantilever":
        # V and M at the start from what is on the bar.
        _, _, m, V = shot(one, theory, (0., 0., 0.))
        V0 = one["force"] - V
        M0 = -one["moment"] - m - V0 * L
        ws = shot(one, theory, (V0, M0, 0.))[0]
        return [ws[STEPS * k // 4] for k in range(1, 5)]
    free = 1 if support == "clamped" else 2
    own = shot(one, theory, (0., 0., 0.))
    units = [shot(one, theory, tuple(float(i == j) for i in range(3)), 0.) for j in (0, free)]
    wanted = [lambda s: s[0][-1], (lambda s: s[1]) if support == "clamped" else (lambda s: s[2])]
    (a, b), (c, d) = [[f(u) for u in units] for f in wanted]
    r, s = [-f(own) for f in wanted]
    x, y = (r * d - b * s) / (a * d - b * c), (a * s - r * c) / (a * d - b * c)
    return [own[0][n] + x * units[0][0][n] + y * units[1][0][n]
            for n in (STEPS * k // 4 for k in range(1, 5))]


def faults(lamella, folder, name, one, support, axis, theory):
    path = folder / "scene.prm"
    path.write_text(scene(one, support, axis, theory))
    done = subprocess.run([lamella, path, "--output", folder / "run"], capture_output=True, text=True)
    what = f"{name}, {support}, axis {axis}, {theory}"
    if done.returncode:
        return [f"{what}: status {done.returncode}, {done.stderr.strip()[:200]}"]
    summary = json.loads((folder / "run" / "summary.json").read_text())
    wanted = reference(one, support, theory)
    found = [-summary["probes"][f"p{k}"][0]["uz"] for k in range(1, 5)]
    largest = max(map(abs, wanted))
    off = max(abs(a - b) for a, b in zip(wanted, found)) / largest
    result = []
    if not off <= TOLERANCE:
        result.append(f"{what}: deflections {found} for {wanted}, off by {100. * off:.3f} %")
    total = one["force"] + sum(one["q"]((k + 0.5) * L / STEPS) for k in range(STEPS)) * L / STEPS
    held = sum(s["reaction"][2] for s in summary["supports"].values())
    if not abs(held - total) <= 1e-5 * max(total, P):
        result.append(f"{what}: supports bear {held}, loads are {total}")
    if not max(summary["force_balance"], summary["moment_balance"]) <= BALANCE:
        result.append(f"{what}: forces do not balance")
    return result


def main():
    lamella, folder = sys.argv[1], Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    loads = [(name, one, supports) for kind, supports in ((AT_END, SUPPORTS[:1]), (ALONG, SUPPORTS))
             for name, one in kind.items()]
    theories, axes = list(THEORIES), list(AXES)
    table = []
    for k, (name, one, supports) in enumerate(loads):
        if "--all" in sys.argv:
            table += [(name, one, *row) for row in itertools.product(supports, axes, theories)]
            continue
        for a, axis in ((0, axes[0]), (1, axes[1 + k % 3])):
            table.append((name, one, supports[(k + a) % len(supports)], axis,
                          theories[(k + 2 * a + k // 4) % 4]))
    found = [fault for row in table for fault in faults(lamella, folder, *row)]
    for fault in found:
        print(fault)
    print(f"{len(table)} scenes, {len(found)} faults")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
