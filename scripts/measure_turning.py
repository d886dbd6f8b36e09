# SPDX-License-Identifier: LGPL-2.1-or-later
"""Beams that turn by any angle against planar rods by shooting (doc/verification/large-rotations.md);
see scripts/measure."""

import math

import numpy as np

from measure_bars import BarRun
from measure_tools import ROOT, table

ROLLER = ROOT / "tests/scenes/large_roller.prm"
COUPON = ROOT / "prm/flexure_large.prm"
SLIDE = ROOT / "tests/scenes/large_slide.prm"
BELT = ROOT / "tests/scenes/turning_capstan.prm"
CORNERS = ROOT / "tests/scenes/large_corners.prm"
HEATED = ROOT / "tests/scenes/large_heated_strip.prm"
THROUGH = ROOT / "tests/scenes/large_through_strip.prm"
CORNER_PULL = ROOT / "tests/scenes/large_corner_pull.prm"
THIN = ROOT / "tests/scenes/large_thin_strip.prm"


class Section:
    """What a rod has of a rectangle, nu = 0: stretch, shear (no factor: LE-1 has none),
    bending."""

    def __init__(self, modulus, width, height):
        self.stretch = modulus * width * height
        self.shear = 0.5 * self.stretch
        self.bending = modulus * width * height ** 3 / 12.
        self.half = 0.5 * height


def along(angle):
    return np.array([math.cos(angle), math.sin(angle)])


def across(angle):
    return np.array([-math.sin(angle), math.cos(angle)])


def arm(x, force):
    return x[0] * force[1] - x[1] * force[0]


def shoot(section, start, length, force, steps=400):
    """From (y, z, angle, moment) at the start of a piece of Reissner's rod that carries the
    force from the rest of the rod to the state at its end, by Runge and Kutta; a negative
    length goes back."""
    def rate(state):
        t, n = along(state[2]), across(state[2])
        tangent = (1. + force @ t / section.stretch) * t + force @ n / section.shear * n
        return np.array([*tangent, state[3] / section.bending, -arm(tangent, force)])

    state, h = np.array(start, float), length / steps
    for _ in range(steps):
        a = rate(state)
        b = rate(state + 0.5 * h * a)
        c = rate(state + 0.5 * h * b)
        state = state + h / 6. * (a + 2. * b + 2. * c + rate(state + h * c))
    return state


def solve(residual, guess, rounds=40):
    """Newton with differences."""
    q = np.array(guess, float)
    for _ in range(rounds):
        r = residual(q)
        steps = 1e-7 * np.maximum(np.abs(q), 1.)
        jacobian = np.column_stack([(residual(q + s * e) - r) / s
                                    for s, e in zip(steps, np.eye(len(q)))])
        change = np.linalg.solve(jacobian, -r)
        q = q + change
        if np.max(np.abs(change)) < 1e-9:
            return q
    raise RuntimeError(f"The rod was not found: {r}")


def on_roller(section, half_span, radius, mu=0.):
    """Half a strip whose middle goes down on a roller, over which it slides inwards: the
    angle where it touches, the normal force, how far along the strip. Its middle section
    stays upright."""
    center = np.array([half_span, -section.half - radius])

    def rod(down, guess):
        def residual(q):
            angle, force, at = q
            # The face is normal to the section's director, the rod's shear is not.
            push = force * (across(angle) + mu * along(angle))
            x = center + (radius + section.half) * across(angle)
            couple = arm(-section.half * across(angle), push)
            end = shoot(section, [*x, angle, couple], -at, push)
            return np.array([end[0], end[1] + down, 100. * end[2]])

        return solve(residual, guess)

    return rod


def slide(down, guess, mu=0.):
    """Two cantilevers that touch where their faces are tangent, the upper one sliding
    towards its clamp: of the lower one there (y, z, angle), the normal force, how far along
    the lower one and the upper one from its tip, the upper one's angle."""
    lower, upper = Section(2e3, 10., 6.), Section(2e3, 10., 5.)

    def residual(q):
        y, z, angle, force, at, from_tip, other = q
        # A face is a material line: with the shear of a force that starts to act there,
        # half of it on the mean.
        face = angle - force / 2. / lower.shear
        push = force * (mu * along(face) - across(face))
        x = np.array([y, z])
        end = shoot(lower, [*x, angle, arm(lower.half * across(angle), push)], -at, push)
        y2 = x + lower.half * across(angle) + upper.half * across(other)
        far = shoot(upper, [*y2, other, arm(-upper.half * across(other), push)],
                    240. - from_tip, push)
        return np.array([end[0], end[1], 100. * end[2], far[0] - 420., far[1] - 6.5 + down,
                         100. * far[2], 1e3 * (face - other + force / 2. / upper.shear)])

    return solve(residual, guess)


def corners(down, guess):
    """The same beams where faces may sink into each other and the edge of either end is
    held on the other's face: of the lower one's tip (y, z, angle), the force there, where
    on the upper one from its tip; where on the lower one the upper's tip is, the force
    there, the upper one's angle at its tip; the angles of the lower and the upper face
    where they are touched."""
    lower, upper = Section(2e3, 10., 6.), Section(2e3, 10., 5.)

    def residual(q):
        y, z, angle, at_tip, s_upper, s_lower, at_face, other, face, upper_face = q
        on_tip, on_face = -at_tip * across(upper_face), -at_face * across(face)
        out = lower.half * across(angle)
        here = shoot(lower, [y, z, angle, arm(out, on_tip)], s_lower - 300., on_tip)
        up = lower.half * across(here[2])
        clamp = shoot(lower, [*here[:3], here[3] + arm(up, on_face)], -s_lower,
                      on_tip + on_face)
        tip = here[:2] + up + upper.half * across(other)
        there = shoot(upper, [*tip, other, -arm(-upper.half * across(other), -on_face)],
                      s_upper, on_face)
        down_there = -upper.half * across(there[2])
        far = shoot(upper, [*there[:3], there[3] - arm(down_there, -on_tip)],
                    240. - s_upper, on_face + on_tip)
        # Faces are material lines: with the mean shear of both sides of a force.
        tilt = here[2] + (2. * on_tip + on_face) @ across(here[2]) / 2. / lower.shear
        tilt_upper = (there[2] + (2. * on_face + on_tip) @ across(there[2])
                      / 2. / upper.shear)
        return np.array([clamp[0], clamp[1], 100. * clamp[2], far[0] - 420.,
                         far[1] - 6.5 + down, 100. * far[2],
                         *(np.array([y, z]) + out - there[:2] - down_there),
                         100. * (tilt - face), 100. * (tilt_upper - upper_face)])

    return solve(residual, guess)


def path(rod, ways, guess):
    """The rod at each of the ways, from the last two."""
    found = []
    for way in ways:
        start = 2. * found[-1] - found[-2] if len(found) > 1 else found[-1] if found else guess
        found.append(rod(way, start))
    return dict(zip(ways, found))


def rollers(mu=0.):
    rods = path(on_roller(Section(3e3, 12., 1.6), 90., 7., mu), np.arange(5., 75., 5.),
                [0.08, 3. * 12288. / 90. ** 3 * 5., 90.])
    rows = []
    for down in (20., 40., 60.):
        angle, force, at = rods[down]
        push = force * (across(angle) + mu * along(angle))
        up, along_it = push[1], -push[0]
        row = [f"{down:g}", f"{up:.5f}", f"{along_it:.5f}", f"{at:.3f}"]
        for theory in ("LE-1", "TBT", "SV"):
            run = BarRun(ROLLER, [f"Theory={theory}", f"Contact face/Friction={mu or 'none'}",
                                  f"Load factors={down / 140.},{down / 70.}"])
            mine = run.summary["contacts"]["face"]["force"]
            row += [f"{-mine[2] / up - 1.:.1e}", f"{mine[1] / along_it - 1.:.1e}"]
        rows.append(row)
    table(["middle down", "force up, rod", "along, rod", "touches at", "LE-1: up", "along",
           "TBT: up", "along", "SV: up", "along"], rows)


def slides(mu=0.):
    rods = path(lambda down, guess: slide(down, guess, mu), np.arange(10., 250., 10.),
                [240., -2., -0.02, 0.8, 240., 60., -0.02])
    rows = []
    for down in (60., 120., 180., 240.):
        angle, force, at = (rods[down][k] for k in (2, 3, 4))
        factors = ",".join(str(way / 240.) for way in np.arange(30., down + 1., 30.))
        force *= math.sqrt(1. + mu ** 2)
        row = [f"{down:g}", f"{force:.5f}", f"{at:.3f}", f"{angle:.4f}"]
        for theory, elements in (("LE-1", 12), ("TBT", 12), ("TBT", 24)):
            run = BarRun(SLIDE, [f"Load factors={factors}", f"Theory={theory}",
                                 f"Contact faces/Friction={mu or 'none'}"] +
                         [f"Body {body}/Kinematics/Axis elements={elements}"
                          for body in ("lower", "upper")])
            mine = np.linalg.norm(run.summary["contacts"]["faces"]["force"])
            row += [f"{mine / force - 1.:.1e}",
                    f"{np.mean(run.summary['iterations']):.1f}"]
        rows.append(row)
    table(["clamp down", "force, rods", "touches at", "turn there", "LE-1, 12", "iterations",
           "TBT, 12", "iterations", "TBT, 24", "iterations"], rows)


def dissipated(of_rods, ways, guess, mu, slid, force):
    """Of a path of rods that slide all the way, by the trapezoidal rule."""
    rods = path(of_rods, ways, guess)
    energy, last = 0., None
    for way in ways:
        here = (slid(rods[way]), force(rods[way]))
        if last is not None:
            energy += mu * 0.5 * (here[1] + last[1]) * (here[0] - last[0])
        last = here
    return energy


def belts(mu=0.2):
    """The force that hauls a belt over a quarter of a drum, and that lets it down."""
    rows = []
    for name, way, sign in (("hauled", -6., 1.), ("let down", 6., -1.)):
        known = 20. * math.exp(sign * mu * math.pi / 2.)
        for theory in ("TBT", "SV"):
            run = BarRun(BELT, [f"Theory={theory}", f"Support haul/u=0, {way}, 0"])
            force = -run.summary["supports"]["haul"]["reaction"][1]
            rows.append([name, theory, f"{known:.4f}", f"{force:.4f}",
                         f"{force / known - 1.:.1e}", str(sum(run.summary["iterations"]))])
    table(["belt", "theory", "Euler", "force", "off", "iterations"], rows)


def rubbing_turning(mu=0.3):
    """Friction with large rotations beside rods whose forces are off the normal by the angle
    of friction (tests/scenes/large_roller.prm, large_slide.prm), and beside Euler's belt
    (turning_capstan.prm)."""
    rollers(mu)
    slides(mu)
    print("dissipated over the roller to 60:", f"""{dissipated(
        on_roller(Section(3e3, 12., 1.6), 90., 7., mu), np.arange(0.5, 60.1, 0.5),
        [0.008, 0.025, 90.], mu, lambda q: q[2] + 7. * q[0], lambda q: q[1]):.4f}""")
    print("dissipated on the face to 240:", f"""{dissipated(
        lambda down, guess: slide(down, guess, mu), np.arange(2.5, 240.1, 2.5),
        [240., -0.5, -0.005, 0.2, 240., 60., -0.005], mu, lambda q: q[4] - q[5],
        lambda q: q[3]):.3f}""")
    belts()


def ends():
    rods = path(corners, np.arange(10., 190., 10.),
                [300., -3.9, -0.022, 0.11, 120., 180., 0.11, -0.022, -0.011, -0.011])
    theories = ("LE-1", "TBT", "SV", "solid-2")
    rows = []
    for down in (60., 120., 180.):
        rod = rods[down]
        factors = ",".join(str(way / 240.) for way in np.arange(30., down + 1., 30.))
        row = [f"{down:g}", f"{rod[6]:.5f}", f"{rod[3]:.5f}"]
        for theory in theories:
            run = BarRun(CORNERS, ["Contacts=upper_end, lower_end",
                                   f"Load factors={factors}", f"Theory={theory}"])
            for contact, force in (("upper_end", rod[6]), ("lower_end", rod[3])):
                mine = np.linalg.norm(run.summary["contacts"][contact]["force"])
                row.append(f"{mine / force - 1.:.1e}")
            row.append(f"{np.mean(run.summary['iterations']):.1f}")
        rows.append(row)
    table(["clamp down", "upper end, rods", "lower end, rods"]
          + [f"{theory}: {what}" for theory in theories
             for what in ("upper", "lower", "iterations")], rows)


def pulled_over_corner():
    """A strip pulled over the frictionless edge of a block by a dead force at its free end."""
    section, length, corner = Section(3e3, 10., 1.), 90., np.array([60., 0.])
    pull = np.array([5., 0.])   # of the rest of the rod on the piece before the corner

    def pieces(q):
        start_y, start_z, angle, at, normal = q
        free = shoot(section, (start_y, start_z, angle, 0.), at, pull)
        n = across(free[2])
        return free, corner + section.half * n, normal * n

    def residual(q):
        free, touched, force = pieces(q)
        clamp = shoot(section, free, length - q[3], pull - force)
        return np.array([*(free[:2] - touched), clamp[0] - 120., clamp[1] + 29.5, clamp[2]])

    force = pieces(solve(residual, (39., 8., -0.3, 22., 4.)))[2]
    run = BarRun(CORNER_PULL, ["Contacts=face"])
    mine = -np.array(run.summary["contacts"]["face"]["force"])[1:]
    table(["corner, rod: y", "z", "Discretization = auto, TBT: y", "z"],
          [[f"{value:.5f}" for value in (*force, *mine)]])


def pressed_by_end():
    """A cantilever pressed by the edge of a rigid block, 39.5 from the clamp and 5 down."""
    section, edge = Section(3e3, 6., 1.), np.array([39.5, -4.5])

    def residual(q):
        moment, at, normal, angle = q
        touched = shoot(section, (0., 0., 0., moment), at, -normal * across(angle))
        return np.array([*(touched[:2] - edge + section.half * across(angle)),
                         touched[2] - angle, touched[3]])

    _, _, normal, angle = solve(residual, (-14., 40., 0.36, -0.19))
    run = BarRun(THROUGH, [])
    table(["block, rod: y", "z", "Discretization = auto, LE-1: y", "z"],
          [[f"{value:.5f}" for value in (*(-normal * across(angle)),
                                         *run.summary["contacts"]["face"]["force"][1:])]])


def coupon():
    """prm/flexure_large.prm beside a rod of its bending stiffness and the formulas of the
    standards for large deflections (ISO 14125, ASTM D7264), which have no roller."""
    span, height, radius, full = 128., 2., 3., 12.8
    run = BarRun(COUPON, [])
    history = run.tables["history.csv"]
    strains = [row for row in run.probes if row["probe"] == "bottom"]
    force = [-float(row["contact:roller:fz"]) for row in history]
    stress = [float(row["syy"]) for row in strains]
    ways = [full * float(row["load_factor"]) for row in history]
    # Its own stiffness, from the first step.
    section = Section(1., 13., height)
    section.bending = force[0] * (span / 2.) ** 3 / (3. * ways[0])
    section.stretch = section.shear = 1e3 * section.bending
    rods = path(on_roller(section, span / 2., radius), np.array(ways),
                [3. * ways[0] / span, force[0], span / 2.])
    first = rods[ways[0]]
    rows = []
    for k, down in enumerate(ways):
        angle, push, _ = rods[down]
        rod = push * math.cos(angle) / (first[1] * math.cos(first[0])) * ways[0] / down
        by_force = stress[k] / force[k] / (stress[0] / force[0])
        share = down / span
        rows.append([f"{share:.4f}", f"{force[k] / force[0] * ways[0] / down:.4f}", f"{rod:.4f}",
                     f"{by_force:.4f}", f"{1. + 6. * share ** 2 - 3. * share * height / span:.4f}"])
    table(["deflection / span", "force over linear", "rod", "stress over 3 P s / (2 b h^2)",
           "standards"], rows)


def turned_about_middle(angle, guess):
    """A rod of tests/scenes/turning_grip.prm whose end a grip turns about its middle: force
    and moment at its start, as the clamp has them."""
    section = Section(1.2e6, 1., 0.1)
    end = 6. * (along(0.) + along(angle))

    def residual(q):
        x = shoot(section, [0., 0., 0., q[2]], 12., q[:2])
        return np.array([*(x[:2] - end), 10. * (x[2] - angle)])

    return solve(residual, guess)


def twisted_strip(length=120., width=12., height=0.6, modulus=3e3, by=2.4, n=1200, warm=0.):
    """The pull N and the torque T of tests/scenes/large_twist.prm, nu = 0: with the twist k,
      N = E A eps + E I_p k^2 / 2,    eps less the strain warm that heat has free of stress,
      T = G J k + k (E I_p eps + E I_4 k^2 / 2) - E Gamma k'',
    k = 0 at the ends, int k = by, int eps + warm = 0 (Wagner; Vlasov), by differences."""
    b, t, h = width, height, length / n
    area, warping, shear = b * t, b ** 3 * t ** 3 / 144., 0.5 * modulus
    polar = (b ** 3 * t + b * t ** 3) / 12.
    fourth = (b ** 5 * t + b * t ** 5) / 80. + 2. * b ** 3 * t ** 3 / 144.
    torsion = b * t ** 3 / 3. * (1. - 192. * t / math.pi ** 5 / b * sum(
        math.tanh(m * math.pi * b / 2. / t) / m ** 5 for m in range(1, 40, 2)))
    weights = np.full(n + 1, h)
    weights[[0, n]] = 0.5 * h
    k = np.full(n + 1, by / length)
    k[[0, n]] = 0.
    force = torque = 0.
    for _ in range(20):
        eps = (force - 0.5 * modulus * polar * k ** 2) / (modulus * area)
        off_axis = modulus * (polar * eps + 0.5 * fourth * k ** 2)
        residual = np.zeros(n + 3)
        jacobian = np.zeros((n + 3, n + 3))
        for i in range(1, n):
            residual[i] = (shear * torsion * k[i] + k[i] * off_axis[i] - torque
                           - modulus * warping * (k[i - 1] - 2. * k[i] + k[i + 1]) / h ** 2)
            jacobian[i, i - 1] = jacobian[i, i + 1] = -modulus * warping / h ** 2
            jacobian[i, i] = (2. * modulus * warping / h ** 2 + shear * torsion + off_axis[i]
                              + k[i] ** 2 * modulus * (fourth - polar ** 2 / area))
            jacobian[i, n + 1] = k[i] * polar / area
            jacobian[i, n + 2] = -1.
        jacobian[0, 0] = jacobian[n, n] = 1.
        residual[n + 1], residual[n + 2] = weights @ k - by, weights @ eps + warm * length
        jacobian[n + 1, :n + 1] = weights
        jacobian[n + 2, :n + 1] = -weights * polar * k / area
        jacobian[n + 2, n + 1] = length / (modulus * area)
        change = np.linalg.solve(jacobian, -residual)
        k, force, torque = k + change[:n + 1], force + change[n + 1], torque + change[n + 2]
        if np.max(np.abs(change)) < 1e-9:
            return force, torque
    raise RuntimeError("The twisted strip was not found.")


def turned_by(q, v):
    """R(q) v of a unit quaternion."""
    return v + 2. * np.cross(q[1:], np.cross(q[1:], v) + q[0] * v)


def measures(law, of_section, tilt):
    """Gamma and kappa that bear the force and moment of_section in the axes of the section, y
    along the rod: of the matrix law of the seven strains of frame_strains(), or with no tilt
    of fibers of Reissner's six."""
    e = of_section / np.diag(law)[:6]
    for _ in range(30):
        (g_x, _, g_z), (_, k_y, _) = e[:3], e[3:]
        strains, slopes = np.append(e, 0.), np.eye(7, 6)
        if tilt:
            strains += [0., 0.5 * (g_x ** 2 + g_z ** 2), 0., -k_y * g_x, 0., -k_y * g_z,
                        0.5 * k_y ** 2]
            slopes[1, [0, 2]] += [g_x, g_z]
            slopes[3, [0, 4]] -= [k_y, g_x]
            slopes[5, [2, 4]] -= [k_y, g_z]
            slopes[6, 4] = k_y
        change = (of_section - slopes.T @ (law @ strains)) / np.diag(law)[:6]
        e = e + change
        if np.max(np.abs(change)) < 1e-14:
            return e
    raise RuntimeError("The measures were not found.")


def rod_in_space(law, length, force, tilt, steps=100):
    """Where the tip of a rod goes, clamped at its start, that a force at the tip turns, by
    shooting."""
    def rate(state, moment, pull):
        r, q = state[:3], state[3:] / np.linalg.norm(state[3:])
        back = q * [1., -1., -1., -1.]
        e = measures(law, np.concatenate([turned_by(back, pull),
                                          turned_by(back, moment - np.cross(r, pull))]), tilt)
        k = e[3:]
        return np.array([*turned_by(q, [0., 1., 0.] + e[:3]), *(0.5 * np.array(
            [-q[1:] @ k, *(q[0] * k + np.cross(q[1:], k))]))])

    def end(*at_start):
        state, h = np.array([0., 0., 0., 1., 0., 0., 0.]), length / steps
        for _ in range(steps):
            a = rate(state, *at_start)
            b = rate(state + 0.5 * h * a, *at_start)
            c = rate(state + 0.5 * h * b, *at_start)
            state = state + h / 6. * (a + 2. * b + 2. * c + rate(state + h * c, *at_start))
        return state[:3]

    tip = np.array([0., length, 0.])
    moment = np.zeros(3)
    for share in (0.25, 0.5, 0.75, 1.):
        pull = share * force
        moment = solve(lambda m: m - np.cross(end(m, pull), pull), moment)
    return end(moment, force) - tip


def in_space():
    """Rods beside tests/scenes/turning_spatial.prm."""
    b, h, modulus, nu = 8., 5., 9e3, 0.3
    area, about_x, about_z = b * h, b * h ** 3 / 12., b ** 3 * h / 12.
    polar = about_x + about_z
    fourth = (b ** 5 * h + b * h ** 5) / 80. + 2. * b ** 3 * h ** 3 / 144.
    shear = 0.5 * modulus / (1. + nu)
    law = np.diag([shear * area, modulus * area, shear * area, modulus * about_x,
                   shear * polar, modulus * about_z, modulus * fourth])
    law[1, 6] = law[6, 1] = modulus * polar
    for name, tilt in (("fibers tilt", True), ("Reissner's", False)):
        print(f"turning_spatial: the tip of a rod, {name}")
        print(rod_in_space(law, 260., np.array([22., -9., 14.]), tilt))


def grips():
    print("turning_grip: force along, across, moment of a rod")
    print(-turned_about_middle(1., [-13., -7.1, -15.]))
    print("large_twist: pull, torque of a rod with warping")
    print(twisted_strip())
    print("the same, warmer by a strain of 5e-4")
    print(twisted_strip(warm=5e-4))


def ring(alpha, radius=15., wall=0.5, nu=0.3, n=400, harmonics=6):
    """M / (E I k) of a tube that is bent to alpha = k R^2 / t sqrt(1 - nu^2) (Brazier): its section is
    a ring whose wall does not stretch, of the shape in which
      E t k^2 / 2 int z^2 ds + D / 2 int (theta' - 1 / R)^2 ds,  D = E t^3 / 12 / (1 - nu^2),
    is least among those that `harmonics` of the wall's angle make."""
    curvature = alpha * wall / radius ** 2 / math.sqrt(1. - nu ** 2)
    plate = wall ** 3 / 12. / (1. - nu ** 2)
    s = (np.arange(n) + 0.5) * 2. * np.pi / n
    ds = radius * 2. * np.pi / n
    orders = 2 * np.arange(1, harmonics + 1)

    def heights(amplitudes):
        angle = s + 0.5 * np.pi + np.sin(np.outer(s, orders)) @ amplitudes
        steps = np.sin(angle) * ds
        z = np.cumsum(steps) - 0.5 * steps
        return z - z.mean()

    def energy(amplitudes):
        bent = np.cos(np.outer(s, orders)) @ (orders * amplitudes) / radius
        return ds * np.sum(0.5 * wall * curvature ** 2 * heights(amplitudes) ** 2
                           + 0.5 * plate * bent ** 2)

    by = 1e-5 * np.eye(harmonics)
    shape = np.zeros(harmonics)
    for _ in range(20):
        slope = [(energy(shape + a) - energy(shape - a)) / 2e-5 for a in by]
        bend = [[(energy(shape + a + b) - energy(shape + a - b) - energy(shape - a + b)
                  + energy(shape - a - b)) / 4e-10 for b in by] for a in by]
        shape = shape - np.linalg.solve(bend, slope)
    return ds * np.sum(heights(shape) ** 2) / (math.pi * radius ** 3)


def frame(section, up, guess, leg=120., pushed_at=24.):
    """Lee's frame of tests/scenes/large_frame.prm, of rods: the angle at the hinge of the upright
    leg, the force there, and what pushes the other leg up by so much."""
    def residual(q):
        force = q[1:3]
        corner = shoot(section, [0., leg, q[0] - 0.5 * math.pi, 0.], leg, force)
        corner[2] += 0.5 * math.pi
        pushed = shoot(section, corner, pushed_at, force)
        end = shoot(section, pushed, leg - pushed_at, force - np.array([0., q[3]]))
        return np.array([pushed[1] - up, end[0] - leg, end[1], end[3]])

    return solve(residual, guess)


def frames():
    print("large_frame: pushed up by, force of rods 1 and (Lee's) 2 thick")
    for height in (1., 2.):
        section, size = Section(720., 3., height), 0.125 * height ** 3
        found = path(lambda up, guess: frame(section, up, guess), np.arange(2.5, 56., 2.5),
                     np.array([0.02, 0.02 * size, 0.1 * size, 0.2 * size]))
        for up in (10., 20., 40., 47.5, 50., 55.):
            print(height, up, f"{found[up][3]:.7f}")


def rings():
    print("large_tube: M / (E I k) of a ring, and of Brazier's first term")
    for alpha in (0.1, 0.2, 0.3, 0.4, 0.47):
        print(alpha, f"{ring(alpha):.5f} {1. - 1.5 * alpha ** 2:.3f}")


def thin_strip(height, load, places, length=100., width=10., modulus=70e3):
    """The strip of tests/scenes/large_thin_strip.prm, `height` thick, under P L^2 / (E I) = load,
    as a rod by shooting: sigma_yz in the middle of the section and sigma_yy on top at each of
    `places`, in the section's axes."""
    section = Section(modulus, width, height)
    section.shear *= 5. / 6.
    force = np.array([0., -load * section.bending / length ** 2])
    unit = section.bending / length
    moment = [0.]
    for share in np.arange(0.1, 1.01, 0.1):
        moment = solve(lambda m: shoot(section, [0., 0., 0., unit * m[0]], length,
                                       share * force)[3:] / unit, moment)
    moment = unit * moment
    stresses = []
    for place in places:
        angle, here = shoot(section, [0., 0., 0., moment[0]], place, force)[2:]
        stresses.append((1.5 * force @ across(angle) / (width * height),
                         force @ along(angle) / (width * height)
                         - 6. * here / (width * height ** 2)))
    return -force[1], stresses


def thin():
    """Stresses of tests/scenes/large_thin_strip.prm on the default axis, and their error bars;
    and stresses of tests/scenes/large_heated_strip.prm that should be zero."""
    rows = []
    for slenderness in (10, 100, 500, 2000):
        for load in (0.5, 3., 10.):
            height = 100. / slenderness
            force, ((near, _), (half, _), (_, above)) = thin_strip(height, load, (10., 50., 12.5))
            row = [slenderness, f"{load:g}"]
            for theory in ("SV-6", "LE-3"):
                run = BarRun(THIN, [
                    f"Theory={theory}", f"Section strip/Ply thickness={height}",
                    f"Load p/Total force=0, 0, {-force}", "Goals/Error bars=true",
                    "Goals/Quantities=near: syz | half: syz | above: syy"] + [
                        f"Probe {name}/At=beam: 5, {y}, {share * height}" for name, y, share in (
                            ("tip", 100, 0.5), ("near", 10, 0.5), ("half", 50, 0.5),
                            ("above", 12.5, 1), ("quarter", 25, 1))])
                for quantity, true in (("near: syz", near), ("half: syz", half),
                                       ("above: syy", above)):
                    if run.failure:
                        row.append("no result")
                        continue
                    goal = run.summary["goals"].get(quantity, {})
                    row.append(f"{100 * (run.value(quantity) / true - 1):+.2f} "
                               f"({100 * abs(goal.get('bar', math.nan) / true):.2f})")
            rows.append(row)
    table(["L / h", "P L^2 / EI"] + [
        f"{theory}: {what}" for theory in ("SV-6", "LE-3")
        for what in ("s_yz at 10 [%] (bar)", "s_yz at 50", "s_yy at 12.5")], rows)
    heated()


def heated():
    """s_zz on the free faces of tests/scenes/large_heated_strip.prm over the largest s_yy."""
    places = [(y, z) for z in (0, 1) for y in np.arange(20., 80.1, 1.25)]
    names = [f"p{k}" for k in range(len(places))]
    probes = ["Probes=" + ", ".join(names)] + [
        f"Probe {name}/At=strip: 5, {y:g}, {z}" for name, (y, z) in zip(names, places)]
    rows = []
    for elements in ("10", "auto", "40"):
        row = [elements]
        for theory in ("SV-6", "LE-2", "LE-3"):
            for rotations in ("linear", "large"):
                run = BarRun(HEATED, [*probes, f"Theory={theory}", f"Rotations={rotations}",
                                      f"Body strip/Kinematics/Axis elements={elements}"])
                largest = [max(abs(run.value(f"{name}: {stress}")) for name in names)
                           for stress in ("szz", "syy")]
                row.append(f"{100 * largest[0] / largest[1]:.2f}")
        rows.append(row)
    table(["Axis elements"] + [f"{theory}, {rotations} [%]" for theory in ("SV-6", "LE-2", "LE-3")
                               for rotations in ("linear", "large")], rows)


def turning():
    """Rods beside tests/scenes/large_roller.prm, large_slide.prm, large_corners.prm,
    large_corner_pull.prm, large_through_strip.prm, turning_grip.prm, large_twist.prm,
    turning_spatial.prm and large_frame.prm; rings beside large_tube.prm."""
    rollers()
    slides()
    ends()
    pulled_over_corner()
    pressed_by_end()
    coupon()
    grips()
    in_space()
    rings()
    frames()
