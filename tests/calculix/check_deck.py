#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads an exported deck as CalculiX would and checks it by hand calculation.

Usage: check_deck.py LAMELLA SCENE.prm WORKDIR

SCENE is deck.prm beside this file; what is expected is derived from the numbers in
it. Needs no CalculiX. For each of the three elements: counts, positive Jacobians,
volumes; materials and fibers; nodes of supports in their planes and the values
there; forces and moments of the loads; areas and normals of contact surfaces, and
that obstacles are where the scene has them. From modes.prm: the steps of modes, and
the axes of plies in a curved wall.
"""

import json
import math
import re
import subprocess
import sys
from pathlib import Path

# Faces of CalculiX' hexahedra by corners (from 1), as its manual lists them.
FACES = {1: (1, 2, 3, 4), 2: (5, 8, 7, 6), 3: (1, 5, 6, 2), 4: (2, 6, 7, 3),
         5: (3, 7, 8, 4), 6: (4, 8, 5, 1)}
CORNERS = [(-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1),
           (-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1)]
EDGES = [(1, 2), (2, 3), (3, 4), (4, 1), (5, 6), (6, 7), (7, 8), (8, 5),
         (1, 5), (2, 6), (3, 7), (4, 8)]
PLACES = CORNERS + [tuple((a + b) / 2 for a, b in zip(CORNERS[i - 1], CORNERS[j - 1]))
                    for i, j in EDGES]
GAUSS = [(-math.sqrt(0.6), 5 / 9), (0., 8 / 9), (math.sqrt(0.6), 5 / 9)]


def check(condition, what):
    if not condition:
        sys.exit(f"FAIL: {what}")
    print(f"ok: {what}")


def near(value, expected, tolerance, what):
    check(abs(value - expected) <= tolerance,
          f"{what}: {value:.10g}, expected {expected:.10g} to {tolerance:g}")


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0])


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def plus(a, b):
    return tuple(x + y for x, y in zip(a, b))


def times(factor, a):
    return tuple(factor * x for x in a)


class Deck:
    """The cards of a deck: nodes, elements (type, nodes), sets, and all else."""

    def __init__(self, path):
        self.nodes, self.elements = {}, {}
        self.nsets, self.elsets, self.surfaces = {}, {}, {}
        self.materials, self.axes, self.sections, self.pairs = {}, {}, {}, []
        self.steps, self.densities, self.distributions = [], {}, {}
        text = re.sub(r"^\*\*.*\n", "", path.read_text(), flags=re.MULTILINE)
        check(all(len(field.strip()) <= 20 for line in text.splitlines()
                  if not line.startswith("*") for field in line.split(",")),
              "no number is longer than CalculiX reads")
        for card in re.split(r"^\*(?=[A-Z])", text, flags=re.MULTILINE)[1:]:
            head, _, body = card.partition("\n")
            name, *options = [word.strip() for word in head.split(",")]
            options = dict((word.split("=") + [""])[:2] for word in options)
            # A line that ends in a comma goes on.
            rows = [[word.strip() for word in line.split(",") if word.strip()]
                    for line in body.replace(",\n", ",").splitlines()]
            self.take(name, options, rows, body)

    def take(self, name, options, rows, body):
        if name == "NODE":
            for n, *x in rows:
                self.nodes[int(n)] = tuple(map(float, x))
                self.nsets.setdefault(options["NSET"], []).append(int(n))
        elif name == "ELEMENT":
            for n, *nodes in rows:
                self.elements[int(n)] = [int(k) for k in nodes]
                self.elsets.setdefault(options["ELSET"], []).append(int(n))
        elif name in ("NSET", "ELSET"):
            sets = self.nsets if name == "NSET" else self.elsets
            sets[options[name]] = [int(n) for row in rows for n in row]
        elif name == "SURFACE":
            self.surfaces[options["NAME"]] = [(int(e), int(f[1])) for e, f in rows]
        elif name == "MATERIAL":
            self.material = options["NAME"]
        elif name == "ELASTIC":
            self.materials[self.material] = [float(x) for x in
                                             body.replace("\n", ",").split(",")
                                             if x.strip()]
        elif name == "DENSITY":
            self.densities[self.material] = float(body)
        elif name == "DISTRIBUTION":
            self.distributions[options["NAME"]] = {int(n): tuple(map(float, axes))
                                           for n, *axes in rows[1:]}
        elif name == "ORIENTATION":
            self.axes[options["NAME"]] = rows[0][0] if len(rows[0]) == 1 else [
                float(x) for x in rows[0]]
        elif name == "SOLID SECTION":
            self.sections[options["ELSET"]] = options
        elif name == "CONTACT PAIR":
            self.pairs.append(rows[0])
        elif name == "STEP":
            self.steps.append({"BOUNDARY": {}, "CLOAD": {}, "options": set(options)})
        elif name in ("STATIC", "FREQUENCY", "BUCKLE"):
            self.steps[-1][name] = [float(x) for x in rows[0]]
        elif name == "BOUNDARY":
            for where, first, last, value in rows:
                for n in self.nsets.get(where) or [int(where)]:
                    for c in range(int(first), int(last) + 1):
                        self.steps[-1]["BOUNDARY"][n, c] = float(value)
        elif name == "CLOAD":
            for n, c, value in rows:
                self.steps[-1]["CLOAD"][int(n), int(c)] = float(value)

    def shape(self, element, place):
        """Position and Jacobian of an element at a natural place."""
        nodes = self.elements[element]
        x, jacobian = (0., 0., 0.), [(0., 0., 0.)] * 3
        for k, n in enumerate(nodes):
            at = PLACES[k]
            factors = [(1 + a * r) / 2 if a else 1 - r * r for a, r in zip(at, place)]
            slopes = [a / 2 if a else -2 * r for a, r in zip(at, place)]
            last = dot(at, place) - 2 if len(nodes) == 20 and all(at) else 1.
            x = plus(x, times(math.prod(factors) * last, self.nodes[n]))
            for d in range(3):
                slope = slopes[d] * math.prod(factors[:d] + factors[d + 1:]) * last
                if len(nodes) == 20 and all(at):
                    slope += math.prod(factors) * at[d]
                jacobian[d] = plus(jacobian[d], times(slope, self.nodes[n]))
        return x, jacobian

    def volume(self, elements):
        """The volume, and the smallest Jacobian over the mean of its element."""
        total, smallest = 0., math.inf
        for e in elements:
            here = [(dot(cross(*j[:2]), j[2]), a * b * c)
                    for r, a in GAUSS for s, b in GAUSS for t, c in GAUSS
                    for _, j in [self.shape(e, (r, s, t))]]
            volume = sum(d * w for d, w in here)
            smallest = min([smallest] + [8 * d / volume for d, _ in here])
            total += volume
        return total, smallest

    def face_points(self, element, face):
        """Places on a face with outward area vectors."""
        corners = [CORNERS[k - 1] for k in FACES[face]]
        d = next(d for d in range(3) if len({corner[d] for corner in corners}) == 1)
        side, (s, t) = corners[0][d], [k for k in range(3) if k != d]
        for a, wa in GAUSS:
            for b, wb in GAUSS:
                place = [0.] * 3
                place[d], place[s], place[t] = side, a, b
                x, jacobian = self.shape(element, place)
                area = cross(jacobian[s], jacobian[t])
                if dot(area, jacobian[d]) * side < 0:
                    area = times(-1, area)
                yield x, times(wa * wb, area)


# ---- the scene, by hand

LENGTH, WIDTH, PLIES, R = 6., 2., (0.5, 0.25), 3.
ORIGIN = (1., 2., 3.)
ALONG = times(1 / 3, (1., 2., 2.))
UP = times(1 / math.sqrt(2), (0., -1., 1.))
ACROSS = cross(ALONG, UP)


def rectangle_load(force):
    """Force and moment about the scene's origin of a traction that is linear in
    position on the plate's top: three Gauss points each way."""
    total, moment = (0., 0., 0.), (0., 0., 0.)
    for a, wa in GAUSS:
        for b, wb in GAUSS:
            x = plus(ORIGIN, times(sum(PLIES), UP))
            x = plus(x, times((1 + a) / 2 * WIDTH, ACROSS))
            x = plus(x, times((1 + b) / 2 * LENGTH, ALONG))
            f = times(wa * wb / 4 * WIDTH * LENGTH, force(x))
            total, moment = plus(total, f), plus(moment, cross(x, f))
    return total, moment


def expected_loads():
    loads = [((1., -2., 3.), cross((3., 6., 7.), (1., -2., 3.)))]
    # (x, 0, -1/2) along the edge, x from 1 to 3.
    line = [(plus(ORIGIN, times((1 + a) / 2 * LENGTH, ALONG)), w * LENGTH / 2)
            for a, w in GAUSS]
    loads += [(times(w, (x[0], 0., -0.5)), cross(x, times(w, (x[0], 0., -0.5))))
              for x, w in line]
    loads.append(rectangle_load(lambda x: (x[1], 0., x[2])))
    # Pressure 2 on the arc of length 2: the normals add up to the diameter, and
    # on each facet, symmetric, the pressure points to the axis.
    down = (0., 0., -2. * 2. * R * 2.)
    loads.append((down, cross((23., 1., 0.), down)))
    return (tuple(map(sum, zip(*(f for f, _ in loads)))),
            tuple(map(sum, zip(*(m for _, m in loads)))))


def check_mesh(deck, meaning, curved):
    n_nodes, n_elements = meaning["nodes"], meaning["elements"]
    check([len(deck.nsets["BODY1"]) + len(deck.nsets["BODY2"]),
           meaning["dofs"]] == [n_nodes, 3 * n_nodes], "nodes and DoFs")
    sizes = [len(deck.elsets[name]) for name in
             ("BODY1_PLY1", "BODY1_PLY2", "BODY2_PLY1")]
    check(sizes[:2] == [6, 6] and sum(sizes) == n_elements,
          f"elements of the plies: {sizes}")
    used = {n for e in deck.elements.values() for n in e}
    check(used == set(deck.nodes), "elements use all nodes, and no others")
    places = {tuple(round(c, 7) for c in deck.nodes[n])
              for n in range(1, n_nodes + 1)}
    check(len(places) == n_nodes, "no two nodes of the bodies are at one place")
    for name, expected, tolerance in (
            ("BODY1_PLY1", LENGTH * WIDTH * PLIES[0], 1e-10),
            ("BODY1_PLY2", LENGTH * WIDTH * PLIES[1], 1e-10),
            ("BODY2_PLY1", math.pi * R ** 2, curved * math.pi * R ** 2)):
        volume, smallest = deck.volume(deck.elsets[name])
        near(volume, expected, tolerance, f"volume of {name}")
        check(smallest > 0.05, f"Jacobians of {name} are positive: {smallest:.3f}")


def check_plies(deck):
    carbon = deck.materials["MATERIAL1"]
    # E1, E2, E3, nu12, nu13, nu23, G12, G13, G23.
    check(carbon == [140, 9, 10, 0.31, 0.32, 0.41, 5, 4, 3],
          f"engineering constants in CalculiX' order: {carbon}")
    check(deck.materials["MATERIAL2"] == [200, 0.3], "E and nu of the steel")
    for name, degrees in (("BODY1_PLY1", 0), ("BODY1_PLY2", 30)):
        section = deck.sections[name]
        check(section["MATERIAL"] == "MATERIAL1", f"material of {name}")
        axes = deck.axes[section["ORIENTATION"]]
        one, two = axes[:3], axes[3:]
        angle = math.radians(degrees)
        # From +y towards +x; 3 is up.
        fiber = plus(times(math.cos(angle), ALONG), times(math.sin(angle), ACROSS))
        near(dot(one, fiber), 1., 1e-12, f"fiber of {name} at {degrees} degrees")
        near(dot(cross(one, two), UP), 1., 1e-12, f"axes 1, 2, 3 of {name}")
    check("ORIENTATION" not in deck.sections["BODY2_PLY1"], "steel has no fibers")


def check_supports(deck, meaning):
    sets = {name: {axis: deck.nsets[what["set"]] for axis, what in support.items()}
            for name, support in meaning["supports"].items()}
    x = deck.nodes
    clamp = [n for n in deck.nsets["BODY1"]
             if abs(dot(minus(x[n], ORIGIN), ALONG)) < 1e-9]
    check(all(sets["clamp"][axis] == clamp for axis in "xyz"), "clamped nodes")
    bed = [n for n in deck.nsets["BODY2"] if abs(x[n][2]) < 1e-9]
    check(sets["bed"] == {"z": bed}, "nodes of the flat, along z alone")
    wall = [n for n in deck.nsets["BODY2"] if abs(x[n][1]) < 1e-9]
    check(sets["wall"] == {"y": wall}, "nodes of the start")
    pin = [n for n in bed if abs(x[n][0] - 23) < 1e-9]
    check(sets["pin"] == {"x": pin} and len(pin) > 2, "nodes of the line")
    for step, factor in zip(deck.steps, (0.5, 1.)):
        held = step["BOUNDARY"]
        # The outward normal of the flat is -z.
        for nodes, c, value in ((clamp, 1, 0.), (bed, 3, -0.125), (wall, 2, 0.),
                                (pin, 1, 0.25), (deck.nsets["OBSTACLE1"], 3, 0.02),
                                (deck.nsets["OBSTACLE2"], 3, -0.5)):
            check(all(abs(held[n, c] - factor * value) < 1e-12 for n in nodes),
                  f"load factor {factor}: component {c} is {factor * value}")
        check(len(held) == sum(len(nodes) for support in sets.values()
                               for nodes in support.values()) +
              3 * len(deck.nsets["OBSTACLE1"]) + 3 * len(deck.nsets["OBSTACLE2"]),
              "nothing else is prescribed")


def check_loads(deck, meaning):
    force, moment = expected_loads()
    for step, factor in zip(deck.steps, (0.5, 1.)):
        total, turn = [0.] * 3, [0.] * 3
        for (n, c), value in step["CLOAD"].items():
            f = tuple(value if c == d + 1 else 0. for d in range(3))
            total, turn = plus(total, f), plus(turn, cross(deck.nodes[n], f))
        for d in range(3):
            near(total[d], factor * force[d], 1e-9, f"force {'xyz'[d]}")
            near(turn[d], factor * moment[d], 1e-8, f"moment {'xyz'[d]}")
    for name, support in meaning["supports"].items():
        for c, axis in enumerate("xyz"):
            if axis in support:
                there = sum(deck.steps[-1]["CLOAD"].get((n, c + 1), 0.)
                            for n in deck.nsets[support[axis]["set"]])
                near(support[axis]["load"], there, 1e-9,
                     f"load on support {name} along {axis}")


def check_contacts(deck, meaning, curved):
    check(deck.pairs == [["CONTACT1_SLAVE", "CONTACT1_MASTER"],
                         ["CONTACT2_SLAVE", "CONTACT2_MASTER"]], "contact pairs")
    points = {name: [p for e, f in faces for p in deck.face_points(e, f)]
              for name, faces in deck.surfaces.items()}
    area = {name: sum(math.sqrt(dot(a, a)) for _, a in here)
            for name, here in points.items()}
    near(area["CONTACT1_SLAVE"], WIDTH * LENGTH, 1e-9, "area of the plate's bottom")
    near(area["CONTACT2_SLAVE"], math.pi * R * 2, math.pi * R * 2 * curved,
         "area of the arc")
    check(all(dot(a, UP) < 0 and abs(dot(minus(x, ORIGIN), UP)) < 1e-9
              for x, a in points["CONTACT1_SLAVE"]), "the bottom looks down")
    check(all(dot(a, (x[0] - 23, 0., x[2])) > 0 for x, a in points["CONTACT2_SLAVE"]),
          "the arc looks outwards")
    check(all(abs(dot(minus(x, (1., 2.01, 2.99)), UP)) < 1e-9 and dot(a, UP) > 0
              for x, a in points["CONTACT1_MASTER"]),
          "the floor's layer is in its plane and looks up")
    check(area["CONTACT1_MASTER"] > WIDTH * LENGTH, "the floor is larger than the plate")
    radii = [math.hypot(x[0] - 23, x[2] - 8.25) for x, _ in points["CONTACT2_MASTER"]]
    near(max(radii) - min(radii) + abs(radii[0] - 5), 0., 5e-8, "the roller's radius")
    check(all(dot(a, (x[0] - 23, 0., x[2] - 8.25)) > 0
              for x, a in points["CONTACT2_MASTER"]), "the roller looks outwards")
    check(min(x[2] for x, _ in points["CONTACT2_MASTER"]) < 3.2501,
          "the roller's lowest line is there")


def check_probes(deck, meaning):
    for name, probe in meaning["probes"].items():
        for ply in probe["plies"]:
            for where in ply["elements"]:
                check(where["nodes"] == deck.elements[where["element"]],
                      f"nodes of {name}'s element")
                x, _ = deck.shape(where["element"], where["natural"])
                check(name == "mean" or math.dist(x, probe["at"]) < 1e-5,
                      f"the place of {name}")
                check(set(where["nodes"]) <= set(deck.nsets["PROBES"]) and
                      where["element"] in deck.elsets["PROBES"], "it is printed")
    check([ply["ply"] for ply in meaning["probes"]["middle"]["plies"]] == [1, 2],
          "a probe between two plies is in both")
    # A box of 0.4 x 1 x 0.2 over two elements along y.
    (row,) = meaning["probes"]["mean"]["plies"]
    places = [(where["weight"], deck.shape(where["element"], where["natural"])[0])
              for where in row["elements"]]
    at, edges = meaning["probes"]["mean"]["at"], (0.4, 1., 0.2)
    near(sum(w for w, _ in places), 1., 1e-12, "the weights of a mean")
    for c in range(3):
        check(all(abs(x[c] - at[c]) <= 0.5 * edges[c] + 1e-5 for _, x in places),
              "its points are in the box")
        near(sum(w * x[c] for w, x in places), at[c], 1e-5, "its middle")
        near(sum(w * (x[c] - at[c]) ** 2 for w, x in places), edges[c] ** 2 / 12, 1e-5,
             "the mean of a square")


def check_modes(program, scene, folder):
    def deck_of(*changes):
        path = folder / "modes.inp"
        subprocess.run([program, "export", "--calculix", scene, "--output", path] + [
            word for change in changes for word in ("--set", change)], check=True)
        return Deck(path), json.loads(path.with_suffix(".json").read_text())

    def kinds(deck):
        return [next(kind for kind in ("STATIC", "FREQUENCY", "BUCKLE") if kind in step)
                for step in deck.steps]

    # No loads: one step. The ends have no u_z, so that three motions are rigid.
    without = ["Loads=", "Contacts="]
    turned = [*without, "Bodies=turned", "Supports=turned"]
    deck, meaning = deck_of(*turned)
    check(kinds(deck) == ["FREQUENCY"] and meaning["steps"] == [], "no static step")
    check(deck.steps[0]["FREQUENCY"] == [6 + 3] and meaning["modes"]["rigid"] == 3,
          "three rigid motions")
    check("PERTURBATION" not in deck.steps[0]["options"], "no stresses")
    check({c for _, c in deck.steps[0]["BOUNDARY"]} == {3} and
          set(deck.steps[0]["BOUNDARY"].values()) == {0.}, "supports of the modes")
    check(set(deck.densities.values()) == {2.7e-9, 1.6e-9}, "densities")
    deck, meaning = deck_of(*turned, "Modes=100 to 500")
    check(deck.steps[0]["FREQUENCY"] == [meaning["modes"]["number"] + 3, 100, 500], "a range")
    deck, meaning = deck_of(*turned, "Supports=")
    check(deck.steps[0]["FREQUENCY"] == [6 + 6] and not deck.steps[0]["BOUNDARY"],
          "a free body is free")
    # Loads and contacts: modes about the state of the static step.
    strips = ["Bodies=lower, upper", "Supports=strips"]
    deck, meaning = deck_of(*strips)
    check(kinds(deck) == ["STATIC", "FREQUENCY"] and meaning["steps"] == [1.],
          "modes after a static step")
    check("PERTURBATION" in deck.steps[1]["options"], "of whose stresses they are")
    deck, meaning = deck_of(*strips, "Contacts=", "Find=modes, buckling", "Load factors=1, 2")
    check(kinds(deck) == ["STATIC", "STATIC", "FREQUENCY", "BUCKLE"], "both kinds of modes")
    check(deck.steps[3]["BUCKLE"] == [6] and deck.steps[3]["CLOAD"] and
          deck.steps[3]["CLOAD"] == deck.steps[1]["CLOAD"] and
          deck.steps[3]["BOUNDARY"] == deck.steps[1]["BOUNDARY"], "factors of the last loads")

    # Fibers at 45 and -45 degrees to the axis in the wall of a tube around (10, y, 10).
    deck, _ = deck_of(*without, "Bodies=tube", "Supports=tube")
    for ply, sign in ((1, 1.), (2, -1.)):
        name = f"BODY1_PLY{ply}"
        axes_of = deck.distributions[deck.axes[name + "_AXES"]]
        check(sorted(axes_of) == sorted(deck.elsets[name]), f"axes of all elements of ply {ply}")
        worst = 0.
        for e, axes in axes_of.items():
            x, _ = deck.shape(e, (0., 0., 0.))
            r = math.hypot(x[0] - 10, x[2] - 10)
            normal = ((x[0] - 10) / r, 0., (x[2] - 10) / r)
            fiber = plus(times(math.sqrt(0.5), (0., 1., 0.)),
                         times(sign * math.sqrt(0.5), cross((0., 1., 0.), normal)))
            worst = max(worst, math.dist(axes[:3], fiber),
                        math.dist(cross(axes[:3], axes[3:]), normal))
        near(worst, 0., 1e-9, f"fibers and normals of ply {ply}")


def main(program, scene, folder):
    folder.mkdir(parents=True, exist_ok=True)
    # How far the geometry may be off a circle: parabolas, or chords.
    for element, curved in (("C3D20R", 2e-3), ("C3D8I", 0.1), ("C3D8R", 0.1)):
        path = folder / f"{element}.inp"
        subprocess.run([program, "export", "--calculix", scene, "--output", path,
                        "--element", element], check=True)
        deck, meaning = Deck(path), json.loads(
            path.with_suffix(".json").read_text())
        check(f"TYPE={element}," in path.read_text(), element)
        check_mesh(deck, meaning, curved)
        check_plies(deck)
        check_supports(deck, meaning)
        check_loads(deck, meaning)
        check_contacts(deck, meaning, curved)
        check_probes(deck, meaning)
        # Of large rotations it differs by a word: elements are those of CalculiX.
        subprocess.run([program, "export", "--calculix", scene, "--output", path,
                        "--element", element, "--set", "Rotations=large"], check=True)
        check(path.read_text().count(", NLGEOM") == path.read_text().count("*STEP"), "NLGEOM")
    check_modes(program, scene.parent / "modes.prm", folder)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit("Usage: check_deck.py LAMELLA SCENE.prm WORKDIR")
    main(Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve(), Path(sys.argv[3]))
