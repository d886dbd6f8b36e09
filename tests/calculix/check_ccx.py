#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solves exported decks with CalculiX and holds them against Lamella's hexahedra on
the same mesh, and both against closed forms.

Usage: check_ccx.py LAMELLA laminate|blocks|roller|rubbed|bonded|modes WORKDIR

Tolerances: on the same mesh C3D20R has 20
nodes and reduced integration where solid-2 has 27 and full integration; both
converge to the same, here within 1 % for displacements and 1.5 % for stresses.
"""

import os
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent


def check(condition, what):
    if not condition:
        sys.exit(f"FAIL: {what}")
    print(f"ok: {what}")


def same(a, b, tolerance, what):
    check(abs(a - b) <= tolerance * abs(b),
          f"{what}: {a:.6g}, {b:.6g} to {100 * tolerance:g} %")


def solved(run):
    check(not run.failure, f"{run.program} solves it {run.failure}")
    return run


def check_laminate(peers, folder):
    """[0/30] and [0/-30], as Lamella has them: the coupling changes its sign."""
    sideways = []
    for layup in ("0/30", "0/-30"):
        scene, change = HERE / "laminate.prm", [f"Section strip/Layup={layup}"]
        ours = solved(peers.lamella_run(scene, change, folder))
        theirs = solved(peers.peer_run(scene, change, folder=folder))
        check(list(theirs.plies["tip"]) == [1, 2], "both plies at the interface")
        for probe in ("tip", "corner", "inside"):
            for name in ("ux", "uy", "uz"):
                a, b = theirs.probes[probe][name], ours.probes[probe][name]
                check(abs(b) > 1e-5, f"{layup}: {probe} moves, {name} = {b:.3g}")
                same(a, b, 0.01, f"{layup}: {name} of {probe}")
        for name in ("sxx", "syy", "sxy"):
            check(abs(theirs.probes["inside"][name] - ours.probes["inside"][name]) <
                  0.015 * abs(ours.probes["inside"]["syy"]),
                  f"{layup}: {name} in the turned ply: "
                  f"{theirs.probes['inside'][name]:.4g}, "
                  f"{ours.probes['inside'][name]:.4g}")
        for c, force in enumerate((0., 0., -4.)):
            check(abs(theirs.supports["clamp"][c] - force) < 1e-6,
                  f"{layup}: reaction {theirs.supports['clamp'][c]:.8g}")
        sideways.append(theirs.probes["tip"]["ux"])
    check(sideways[0] * sideways[1] < 0, f"the coupling has a sign: {sideways}")


def check_blocks(peers, folder):
    """A uniform state; the contact is a spring of stiffness K A between them."""
    stiffness = 1e4
    for element in ("C3D20R", "C3D8I", "C3D8R"):
        run = solved(peers.peer_run(HERE / "blocks.prm", [], element, stiffness,
                                    folder))
        force = 0.01 * 6 / (1 / 100 + 2 / 50 + 1 / stiffness)
        same(run.supports["press"][2], -force, 1e-5, f"{element}: force of the press")
        same(run.supports["floor"][2], force, 1e-5, f"{element}: force of the floor")
        same(run.contacts["faces"][2], -force, 1e-5,
             f"{element}: force on the second body")
        same(run.probes["middle"]["szz"], -force / 6, 1e-4, f"{element}: stress")
    # Without a word on the stiffness the penetration hardly matters.
    for change in ([], ["Contact faces/Slave side=second"],
                   ["Contact faces/First=lower: top",
                    "Contact faces/Second=upper: bottom"]):
        run = solved(peers.peer_run(HERE / "blocks.prm", change, folder=folder))
        sign = 1. if "lower: top" in str(change) else -1.
        same(run.contacts["faces"][2], sign * 1.2, 0.005, f"closed form, {change}")


def check_roller(peers, folder):
    """The roller's force depends on the mesh below it: both have the same one."""
    ours = solved(peers.lamella_run(HERE / "roller.prm", [], folder))
    theirs = solved(peers.peer_run(HERE / "roller.prm", [], folder=folder))
    same(theirs.contacts["nip"][2], ours.contacts["nip"][2], 0.02, "roller")
    same(theirs.contacts["bed"][2], ours.contacts["bed"][2], 0.03, "plane")
    balance = sum(run[2] for run in theirs.supports.values()) - sum(
        run[2] for run in theirs.contacts.values())
    check(abs(balance) < 1e-4 * theirs.contacts["nip"][2],
          f"supports and obstacles are in balance: {balance:.3g}")


def check_rubbed(peers, folder):
    """To, back and to the other side. CalculiX sticks as a spring: Q comes to Coulomb's with
    the stiffness of the contact, 0.7 % off with its own, 0.2 with this one."""
    for factors, push in (("0, 0.5, 1", 1.), ("0, 0.5, 1, 0", 0.), ("0, 0.5, 1, 0, -1", -1.)):
        change = [f"Load factors={factors}"]
        ours = solved(peers.lamella_run(HERE / "rubbed.prm", change, folder))
        theirs = solved(peers.peer_run(HERE / "rubbed.prm", change, contact_stiffness=1e5,
                                       folder=folder))
        a, b = theirs.contacts["faces"], ours.contacts["faces"]
        same(a[2], b[2], 0.003, f"pressed, at {push:g}")
        # What Coulomb's bound is not reached by, so that it sticks in the middle.
        check(abs(b[0]) < 0.7 * 0.3 * abs(b[2]), f"Q = {b[0]:.6g} in part")
        largest = 0.0665
        check(abs(a[0] - b[0]) < 0.003 * largest,
              f"pushed, at {push:g}: {a[0]:.6g}, {b[0]:.6g}")
        if push == 0.:
            check(b[0] < -0.01 * largest, "it is not where it was")


def check_bonded(peers, folder):
    """Ties (*TIE) and adhesive layers (tied contact of a stiffness)."""
    layer = ["Contact bond/Adhesive thickness=0.1", "Contact bond/Adhesive moduli=100, 40"]
    for change in ([], layer):
        ours = solved(peers.lamella_run(HERE / "bonded.prm", change, folder))
        theirs = solved(peers.peer_run(HERE / "bonded.prm", change, folder=folder))
        for probe in ("p", "q", "r"):
            for name in ("ux", "uz"):
                same(theirs.probes[probe][name], ours.probes[probe][name], 0.01,
                     f"{change}: {name} of {probe}")
        for c, force in enumerate((-6., -30., 6.)):
            check(abs(theirs.supports["left"][c] + theirs.supports["left2"][c] - force) <
                  1e-4, f"reaction {c}")


def check_modes(peers, folder):
    """Frequencies and buckling factors agree to the 0.5 % of doc/verification/calculix-modes.md.
    Without their contact the strips would have each of the modes of one strip twice."""
    middle = [f"Support {name}/{entry}" for name, entry in (
        ("fixed", "On=strut: line"), ("sliding", "On=strut: line"),
        ("fixed", "At=0, 0, 5; 15, 0, 5"), ("sliding", "At=0, 1000, 5; 15, 1000, 5"))]
    strips = ["Bodies=lower, upper", "Supports=strips"]
    finer = ["Theory=solid-2", "Body lower/Kinematics/Refinements=1",
             "Body upper/Kinematics/Refinements=1"]
    strut = HERE.parent.parent / "prm" / "buckling_strut.prm"
    for scene, change, deck, stiffness in (
            (HERE / "modes.prm", ["Loads=", "Contacts=", "Bodies=tube", "Supports=tube",
                                  "Modes=3"], ["Section tube/Cells around=24"], None),
            (HERE / "modes.prm", ["Loads=", "Contacts=", "Bodies=turned", "Supports=turned"],
             [], None),
            (HERE / "modes.prm", strips, finer, None),
            (HERE / "modes.prm", [*strips, "Contact strips/Friction=0.5"], finer, 2e7),
            (strut, [*middle, "Theory=LE-2", "Modes=2", "Section bar/Cells across=2",
                     "Section bar/Cells per ply=2"], [], None)):
        ours = solved(peers.lamella_run(scene, [*change, "Goals/Error bars=false"], folder))
        theirs = solved(peers.peer_run(scene, change + deck, contact_stiffness=stiffness,
                                       folder=folder))
        first, second = (run.modes + run.buckling_modes for run in (ours, theirs))
        check(len(first) == len(second) >= 2, f"{len(first)} modes of {change}")
        for n, (a, b) in enumerate(zip(second, first), 1):
            same(a, b, 0.005, f"mode {n}")


def main(program, case, folder):
    os.environ["LAMELLA_BUILD"] = str(program.parent)
    sys.path.insert(0, str(HERE.parent.parent / "scripts"))
    import peers
    check(peers.find_ccx() is not None, peers.MISSING)
    {"laminate": check_laminate, "blocks": check_blocks, "roller": check_roller,
     "rubbed": check_rubbed, "bonded": check_bonded, "modes": check_modes}[case](peers, folder)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit("Usage: check_ccx.py LAMELLA laminate|blocks|roller|rubbed|bonded|modes WORKDIR")
    main(Path(sys.argv[1]).resolve(), sys.argv[2], Path(sys.argv[3]))
