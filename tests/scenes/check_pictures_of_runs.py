#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Holds the pictures of loads, shapes, scales and strength against what is known.

Usage: check_pictures_of_runs.py FIGURES.py WORKDIR

Tables of known numbers, and the figures of scripts/figures*.py made of them before they
become pictures: which curve stands on which axis, with which unit, and where each label
is. Exit status 77 (skipped) without numpy or matplotlib.
"""

import json
import math
import re
import subprocess
import sys
import warnings
from pathlib import Path

from check_pictures import (MESH, PAIR, Figures, Run, all_axes, brick, check,
                            title_of)

# ---- the load history


HISTORY = (["step", "load_factor"]
           + [f"support:clamp:f{c}" for c in "xyz"]
           + [f"contact:{name}:f{c}" for name in ("nip", "far-1") for c in "xyz"]
           + [f"probe:{name}:u{c}" for name in ("tip", "mid_1") for c in "xyz"]
           + [f"{name}:m{c}" for name in ("support:clamp", "contact:nip") for c in "xyz"]
           + ["measure:twist"])


def steps(with_contact=True):
    """Loads 1, 2, 3 of a cantilever of length 500: 10 N, and 5 N m at its clamp; what
    touches carries 4 N at y = 400, so 1.6 N m about the origin."""
    for k in (1, 2, 3):
        row = {"step": k, "load_factor": k, "support:clamp:fz": 10. * k,
               "support:clamp:fx": 1e-9 * k, "support:clamp:mx": -5e3 * k,
               "support:clamp:my": 1e-3 * k, "probe:tip:uz": -2. * k,
               "probe:mid_1:uz": -k, "measure:twist": 1e5 * k}
        if with_contact:
            row.update({"contact:nip:fz": 4. * k, "contact:nip:mx": 1.6e3 * k})
        yield row


def curves_of(axis):
    """The label of each curve of an axis, and its last value."""
    return {line.get_label(): round(float(line.get_ydata()[-1]), 9)
            for line in axis.lines}


def history_of(figures, folder, rows, **summary):
    run = Run(folder)
    told = json.loads((folder / "summary.json").read_text())
    (folder / "summary.json").write_text(json.dumps({**told, **summary}))
    run.write("history.csv", HISTORY, rows)
    (name, figure), = figures.history.load_history(figures.data.Results(folder))
    check(name == "history", name)
    return figure


def check_history(figures, folder):
    failure = {"ply": 2, "body": "beam", "mode": "tension", "load_factor": 2.}
    figure = history_of(figures, folder, steps(), first_failure=failure)
    forces, moments = figure.axes
    check(forces.get_ylabel() == "force [N]" and moments.get_ylabel() == "moment [N m]",
          f"two axes: {forces.get_ylabel()}, {moments.get_ylabel()}")
    mark = "first failure: ply 2 of beam, tension"
    drawn = curves_of(forces)
    check(drawn == {"$F_z$ of contact nip": 12., mark: 8.},
          f"forces, and the first failure on one: {drawn}")
    drawn = curves_of(moments)
    check(drawn == {"$-M_x$ of support clamp": 15.}, f"moments of supports: {drawn}")
    check(moments.get_xlabel() == "$-u_z$ of tip [mm]", moments.get_xlabel())

    forces, _ = history_of(figures, folder, steps(with_contact=False)).axes
    drawn = curves_of(forces)
    check(drawn == {"$F_z$ of support clamp": 30.},
          f"forces of supports where nothing touches: {drawn}")

    def only(*columns):
        """What else the clamp holds is rounding."""
        return ({c: value if c in columns or "clamp" not in c else 1e-9 * row["step"]
                 for c, value in row.items()} for row in steps(with_contact=False))

    axis, = history_of(figures, folder, only("support:clamp:fz")).axes
    check(axis.get_ylabel() == "force [N]", "no axis for moments that are rounding")
    axis, = history_of(figures, folder, only("support:clamp:mx"),
                       first_failure=failure).axes
    check(axis.get_ylabel() == "moment [N m]" and mark in curves_of(axis),
          "a couple alone: no axis for forces that are rounding")


# ---- sections


DRAWN = """
subsection Section drawn
  set Shape = file
  set File  = drawn.msh
end
subsection Body blade
  set Section = drawn
end
"""


def check_proportions(figures, folder):
    """A flat section that Gmsh has meshed is as flat in its pictures; a laminate's plies
    are enlarged so that they are seen."""
    for body, section, is_true in (("blade", "drawn", True), ("lower", "half", False)):
        run = Run(folder)
        with open(folder / "scene.prm", "a") as scene:
            scene.write(DRAWN)
        run.section(section, 120., 3.)
        run.cut("cut", 120., (1., 0.2, 1.8), lambda z, ply: {"syy": 10. * z + 1.},
                body=body)
        results = figures.data.Results(folder)
        for draw in (figures.sections.section_meshes, figures.sections.section_cuts):
            (name, figure), = draw(results)
            figure.canvas.draw()
            corners = figure.axes[0].transData.transform([(0., 0.), (120., 3.)])
            across, up = corners[1] - corners[0]
            found = across / up / (120. / 3.)
            check(abs(found - 1.) < 1e-6 if is_true else found < 0.5,
                  f"{name} of {section}: its width over its height is {found:.3f} times "
                  "what it should be")
            check(("enlarged" in figure.axes[0].get_ylabel()) != is_true,
                  "and the label says so")
            check(not outside(figure), f"all labels are in the picture {outside(figure)}")


def bars_of(panel):
    """The label and the (low, high) of each color bar of a panel."""
    return {bar.get_ylabel(): tuple(float(v) for v in bar.get_ylim())
            for bar in panel.child_axes}


def check_scales(figures, folder):
    """A core that bears a thousandth of what its faces do, and as much shear."""
    thickness = (1., 8., 1.)

    def sandwich(z, ply):
        soft = 1e-3 if ply == 2 else 1.
        return {"syy": 200. * (z - 5.) * soft, "syz": 0.5 + 0.01 * z}

    run = Run(folder)
    run.cut("cut", 50., thickness, sandwich)
    mesh = [{"cell": k, "ply": k + 1, "material": material, "angle": 0, **{
        f"side_{s + 1}": ";".join(f"{x} {z}" for x, z in (a, b))
        for s, (a, b) in enumerate(zip(corners, corners[1:] + corners[:1]))}}
        for k, (material, low, high) in enumerate((
            ("carbon", 0, 1), ("foam", 1, 9), ("carbon", 9, 10)))
        for corners in [[(0, low), (50, low), (50, high), (0, high)]]]

    run.write("sections/strip.csv", MESH, mesh)
    (_, figure), = figures.sections.section_cuts(figures.data.Results(folder))
    shear, axial = (bars_of(panel) for panel in figure.axes)
    check(list(axial) == ["carbon: $\\sigma_{yy}$ [MPa]", "foam: $\\sigma_{yy}$ [MPa]"],
          f"two bars: {axial}")
    faces, core = axial.values()
    check(faces[1] >= 1000. and -1. < core[0] < -0.8 < core[1] < 1.,
          f"from {core[0]:g} to {core[1]:g} in the core, {faces[1]:g} in the faces")
    check(list(shear) == ["$\\sigma_{yz}$ [MPa]"], "shear that both bear is on one")
    places = [bar.get_window_extent() for bar in figure.axes[1].child_axes]
    check(not places[0].overlaps(places[1]) and not outside(figure),
          f"one above the other, with labels in the picture {outside(figure)}")
    for row in mesh:
        row["material"] = "carbon"
    run.write("sections/strip.csv", MESH, mesh)
    (_, figure), = figures.sections.section_cuts(figures.data.Results(folder))
    check(len(figure.axes[1].child_axes) == 1, "plies of one material are on one scale")


# ---- stress on the deformed shape


TWIST = 0.02  # from one end to the other


def bar():
    """Of 4 x 100 x 3, two elements along y: a face of 0.5, a core of 2, a face of 0.5;
    numbers of cells ascend with the ply, then with y."""
    return [brick(1, (0., y, z), (4., 50., height)) for y in (0., 50.)
            for z, height in ((0., 0.5), (0.5, 2.), (2.5, 0.5))]


def twisted(point):
    """About (2, y, 1.5), clockwise as seen along +y."""
    angle = TWIST * point[1] / 100.
    return angle * (point[2] - 1.5), 0., -angle * (point[0] - 2.)


def stressed(cell, point):
    """sigma_yy: 10 y, and 10 less in the first of both elements of the faces; a
    thousandth of it in the core."""
    ply = cell % 3 + 1
    syy = 10. * point[1] - (10. if cell < 3 else 0.)
    return ply, (0., 1e-3 * syy if ply == 2 else syy, 0., 0.1, 0., 0.)


def drawn_places(axis):
    """The corners of all facets of the bodies, in the picture."""
    shapes = max(axis.collections, key=lambda part: len(part.get_paths()))
    return [tuple(vertex) for path in shapes.get_paths() for vertex in path.vertices]


def check_projection(figures):
    np = figures.stress.np
    for extents, longer in (((1., 2., 1.), 1), ((2., 1., 1.), 0)):
        corners = np.array([np.zeros(3), *np.diag(extents)])
        view = figures.stress.Isometric(corners)
        x, y, z = (view(axis)[:2] for axis in np.eye(3) / view.stretch)
        lengths = [float(np.linalg.norm(axis)) for axis in (x, y, z)]
        angles = [float(a @ b) for a, b in ((x, y), (y, z), (z, x))]
        check(np.allclose(lengths, 1.) and np.allclose(np.abs(angles), 0.5),
              f"three axes of one length, 120 or 60 degrees apart: {lengths}, {angles}")
        seen = float(np.cross(x, y))
        check(seen > 0., "not as in a mirror: from above, y is to the left of x")
        check((x, y)[longer][1] > 0. and (x, y)[longer][0] > 0.,
              "the longer one goes up to the right")


def check_stress(figures, folder):
    np = figures.stress.np
    check_projection(figures)
    run = Run(folder).bodies(bar(), twisted, stressed)
    results = figures.data.Results(folder)
    surface = figures.surface.surface_of(results)
    values = figures.surface.continuous(surface, surface.stress("syy"))
    joint = np.isclose(surface.places[:, :, 1], 50.)
    face = np.repeat((surface.plies != 2)[:, None], 4, axis=1)
    check(np.allclose(values[joint & face], 495.) and np.allclose(
        values[joint & ~face], 0.495), "where elements meet their mean, ply by ply")
    inside = ~joint & face
    check(np.allclose(values[inside], surface.stress("syy")[inside]), "else as they are")

    (name, figure), = figures.stress.stress_on_the_shape(results)
    check(name == "deformed_stress" and "sigma_{yy}" in title_of(figure), title_of(figure))
    told = figure._supxlabel.get_text()
    factors = [int(n) for n in re.findall(r"(\d+) times", told)]
    check("isometric" in told and len(factors) == 3 and factors[:2] == [5, 5],
          f"it says what is enlarged: {told}")
    # The corner at the end that goes down most, by hand.
    place = np.array([4., 100., 0.])
    moved = place + factors[2] * np.array(twisted(place))
    x, y, z = moved * (5., 1., 5.)
    wanted = (math.sqrt(0.75) * (x + y), z + 0.5 * (y - x))
    nearest = min(math.dist(wanted, vertex) for vertex in drawn_places(figure.axes[0]))
    check(nearest < 1e-3, f"the twisted end is where it should be, to {nearest:.1e}")
    ends = np.array([figures.stress.Isometric(surface.places)(
        p + factors[2] * np.array(twisted(p)))[:2] for p in (
            np.array([0., 100., 3.]), np.array([4., 100., 3.]))])
    slope = np.degrees(np.arctan2(*(ends[1] - ends[0])[::-1]))
    check(slope < -35., f"its upper edge is seen at {slope:.0f} degrees, -30 untwisted")
    bars = bars_of(figure.axes[0])
    check(list(bars) == ["$\\sigma_{yy}$ [MPa]"] and not outside(figure),
          "without a section one scale")
    run.write("sections/strip.csv", MESH, [
        {"cell": ply - 1, "ply": ply, "material": material, "angle": 0, **{
            f"side_{s}": "0 0;1 0" for s in range(1, 5)}}
        for ply, material in enumerate(("carbon", "foam", "carbon"), 1)])
    with open(folder / "scene.prm", "a") as scene:
        scene.write("set Bodies = laminate\n")
    (_, figure), = figures.stress.stress_on_the_shape(figures.data.Results(folder))
    bars = bars_of(figure.axes[0])
    check([label.split(":")[0] for label in bars] == ["carbon", "foam"]
          and list(bars.values())[1][1] <= 1., f"core and faces: {bars}")
    shapes = max(figure.axes[0].collections, key=lambda part: len(part.get_paths()))
    shades = {tuple(np.round(color, 3)) for color in shapes.get_facecolor()}
    check(len(shades) > 100, f"smooth: {len(shades)} shades on two elements")
    run.bodies(bar(), twisted)
    check(not list(figures.stress.stress_on_the_shape(figures.data.Results(folder))),
          "nothing without stresses")


# ---- strength


PLIES = "step,body,ply,s,x,y,z,inverse_reserve_factor".split(",")


def outside(figure):
    """The texts that reach beyond what is saved of a figure."""
    figure.canvas.draw()
    renderer = figure.canvas.get_renderer()
    saved = figure.get_tightbbox(renderer).padded(0.01)
    low, high = (figure.dpi_scale_trans.transform(corner) for corner in (
        saved.min, saved.max))
    texts = list(figure.texts) + [text for axis in all_axes(figure) for text in (
        axis.xaxis.label, axis.yaxis.label, axis.title, *axis.texts)]
    boxes = [(text.get_text(), text.get_window_extent(renderer)) for text in texts
             if text.get_text()]
    return [text for text, box in boxes
            if (box.min < low).any() or (box.max > high).any()]


def check_strength(figures, folder):
    for plies in (1, 2, 3, 16):
        run = Run(folder)
        run.write("plies_along.csv", PLIES, (
            {"step": 1, "body": "bar", "ply": ply, "s": k, "y": k,
             "inverse_reserve_factor": "" if k < 3 or ply == 2 else 0.1 * k / ply}
            for ply in range(1, plies + 1) for k in range(15)))
        (_, figure), = figures.strength.ply_stacks(figures.data.Results(folder))
        check(not outside(figure), f"{plies} plies: all labels are in the picture "
              f"{outside(figure)}")
        contours = figure.axes[0].collections[1:]
        check(contours, "a line where 1/R is 1")


# ---- what is said


def check_console(figures, folder):
    """One line that says where the pictures are, and no warning: of a ply that is left
    out whole, of a title with a dollar and with characters that the font lacks, of a
    contact that touches without pressure."""
    run = Run(folder)
    told = json.loads((folder / "summary.json").read_text())
    told["title"] = "Bars for $5, 梁"
    (folder / "summary.json").write_text(json.dumps(told))
    run.bodies(bar(), twisted, stressed)
    run.cut("cut", 50., (1., 8., 1.), lambda z, ply: {"syy": 10. * z + 1.})
    run.write("contact_idle.csv", PAIR, (
        {"step": 1, "x": k, "y": k % 3, "nz": 1., "area": 1., "active": 1}
        for k in range(12)))
    run.write("history.csv", HISTORY, steps())
    run.write("plies_along.csv", PLIES, (
        {"step": 1, "body": "bar", "ply": ply, "s": k, "y": k,
         "inverse_reserve_factor": "" if ply == 2 else 0.2 * k}
        for ply in (1, 2) for k in range(9)))
    done = subprocess.run([sys.executable, figures.path, folder], capture_output=True,
                          text=True)
    check(done.returncode == 0 and not done.stderr,
          f"no warning on the console {done.stderr.strip()}")
    check(done.stdout == f"Pictures:  {folder / 'pictures'}\n", done.stdout.strip())
    drawn = sorted(path.stem for path in (folder / "pictures").glob("*.png"))
    check(drawn == ["deformed", "deformed_stress", "history", "reserve_factors",
                    "section_cut"], f"pictures: {', '.join(drawn)}")


def rubbing():
    """A flat patch of 11 x 3 points: pressure 2, shear 0.4 in the middle, where it sticks,
    and 0.6 beside it, where it slips; open at the rim."""
    for j in range(3):
        for i in range(11):
            state = "open" if i in (0, 10) else "stick" if 3 < i < 7 else "slip"
            force = 0. if state == "open" else 2.
            yield {**dict.fromkeys(PAIR, 0.), "step": 1, "x": j, "y": i, "x2": j, "y2": i,
                   "nz": 1., "area": 0.5, "force": 0.5 * force, "pressure": force,
                   "active": int(force > 0.), "state": state,
                   "shear_y": {"open": 0., "stick": -0.2, "slip": -0.3}[state]}


def check_friction(figures, folder):
    run = Run(folder)
    told = json.loads((folder / "summary.json").read_text())
    told["contacts"] = {"face": {"friction": {"coefficient": 0.3}}}
    told["path"] = {"dissipated": 7.5}
    (folder / "summary.json").write_text(json.dumps(told))
    run.write("contact_face.csv", PAIR + ["state", "shear_x", "shear_y", "shear_z"], rubbing())
    # Up to 3 and back to 1, where the support still bears more than on the way up.
    run.write("history.csv", HISTORY, (
        {"step": k, "load_factor": way, "support:clamp:fz": force, "probe:tip:uz": -way}
        for k, (way, force) in enumerate(((1., 10.), (2., 20.), (3., 30.), (1., 15.)))))
    results = figures.data.Results(folder)
    drawn = dict(figures.friction.contact_friction(results))
    check(sorted(drawn) == ["contact_face_friction", "contact_face_states"], str(sorted(drawn)))
    (axis,) = drawn["contact_face_friction"].axes
    sizes = {line.get_label(): sorted({round(float(y), 9) for y in line.get_ydata()})
             for line in axis.lines if not line.get_label().startswith("_")}
    check(sizes == {"0.3 times the pressure": [0., 0.6], "shear, sticks": [0.4],
                    "shear, slips": [0.6]}, f"shear beside what is allowed: {sizes}")
    (axis,) = drawn["contact_face_states"].axes
    found = [text.get_text() for text in axis.get_legend().get_texts()]
    check(found == ["stick", "slip", "open"], f"states: {found}")
    picture = axis.images[0].get_array()
    check([int(picture[60, k]) for k in (1, 60, 120, 180, 238)] == [2, 1, 0, 1, 2],
          "they lie where the points are")
    (name, figure), = figures.friction.loop(results)
    line, = figure.axes[0].lines
    check(list(line.get_xdata()) == [0., 1., 2., 3., 1.]
          and list(line.get_ydata()) == [0., 10., 20., 30., 15.], "the loop begins at rest")
    texts = [text.get_text() for text in figure.axes[0].texts]
    check("dissipated on the way: 7.5 N mm" in texts, f"{name}: {texts}")


# ---- modes and harmonic response


def check_modes(figures, folder):
    """A bar of 4 x 100 x 3, drawn as 20 x 100 x 15: the tip, which goes down, is drawn 8
    upwards, 0.4 times the width drawn."""
    np = figures.stress.np
    run = Run(folder).bodies(bar(), lambda p: (0., 0., -0.3 * (p[1] / 100.) ** 2),
                             dataset="mode")
    (name, figure), = figures.modes.mode_shapes(figures.data.Results(folder))
    check(name == "mode_0001" and "x 5 times, z 5 times" in figure._supxlabel.get_text(),
          f"one picture: {name}, {figure._supxlabel.get_text()}")
    axis, = figure.axes
    outline, = [part for part in axis.collections if part.get_linestyle()[0][1]]
    before = np.concatenate([path.vertices for path in outline.get_paths()])
    drawn = np.array(drawn_places(axis))
    for x, z in ((0., 0.), (20., 0.), (0., 15.), (20., 15.)):
        for y, up in ((0., 0.), (100., 8.)):
            place = np.array([math.sqrt(0.75) * (x + y), z + 0.5 * (y - x)])
            apart = [float(np.linalg.norm(where - at, axis=1).min()) for where, at in (
                (before, place), (drawn, place + [0., up]))]
            check(max(apart) < 1e-3, f"corner {x, y, z} before and drawn, to {apart}")
    inside = [np.ptp(axis.get_xlim()) > np.ptp(drawn[:, 0]),
              axis.get_ylim()[1] > drawn[:, 1].max()]
    check(all(inside) and not outside(figure), "nothing is cut off")
    (folder / "buckling.pvd").write_text("<VTKFile><Collection>" + "".join(
        f'<DataSet timestep="{k}" file="mode_0001.vtu"/>' for k in range(1, 15))
        + "</Collection></VTKFile>")
    names = [name for name, _ in figures.modes.mode_shapes(figures.data.Results(folder))]
    check(names == ["mode_0001"] + [f"buckling_{k:04}" for k in range(1, 13)],
          f"twelve of each at most: {names}")


def oscillator(frequency, of=100., damping=0.05):
    """Amplitude and phase [degrees] of a mass on a spring and a damper, for a static
    displacement of 1 mm."""
    r = frequency / of
    found = 1. / complex(1. - r * r, 2. * damping * r)
    return abs(found), math.degrees(math.atan2(found.imag, found.real))


def check_response(figures, folder):
    """Seven probes, the sizes of which differ; the first one is between two plies, and
    the second one is 120 degrees behind, so that its angle passes -180 degrees."""
    columns = ["frequency", "probe", "ply"] + [
        f"{c}{rest}" for c in ("ux", "uy", "uz") for rest in ("", " phase")]
    run = Run(folder)
    run.write("modes.csv", ["analysis", "number", "value"], [
        dict(zip(("analysis", "number", "value"), row)) for row in (
            ("modes", 1, 30.), ("modes", 2, 100.), ("modes", 3, 101.), ("modes", 4, 170.),
            ("modes", 5, 210.), ("buckling", 1, 60.))])
    rows, peak = [], 100. * math.sqrt(1. - 2. * 0.05**2)
    for frequency in sorted([*range(40, 201, 5), peak]):
        amplitude, phase = oscillator(frequency)
        for k, ply in ((0, 1), (0, 2), *((k, 1) for k in range(1, 7))):
            rows.append({"frequency": frequency, "probe": f"p{k}", "ply": ply,
                         "ux": 0.5 * amplitude / (k + 1), "ux phase": 17.,
                         "uz": amplitude / (k + 1),
                         "uz phase": phase if k != 1 else (phase + 60.) % 360. - 180.})
    run.write("response.csv", columns, rows)
    (name, figure), = figures.modes.harmonic_response(figures.data.Results(folder))
    above, below = figure.axes
    check(name == "response" and above.get_yscale() == "log"
          and above.get_ylabel() == "amplitude [mm]" and below.get_ylabel() == "phase [°]",
          "amplitudes on a logarithmic axis, phases below")
    curves = {line.get_label(): line for line in above.lines if len(line.get_xdata()) > 2}
    check(list(curves) == [f"$u_z$ of p{k}" for k in range(6)],
          f"the largest component of the six largest: {list(curves)}")
    wanted = 1. / (2. * 0.05 * math.sqrt(1. - 0.05**2))
    for k, line in enumerate(curves.values()):
        x, y = line.get_data()
        at = int(y.argmax())
        check(len(x) == 34 and abs(x[at] - peak) < 1e-9
              and abs(y[at] * (k + 1) / wanted - 1.) < 1e-12, f"resonance of p{k}: {y[at]}")
    phases = [line.get_data() for line in below.lines if len(line.get_xdata()) > 2]
    np = figures.stress.np
    for k, (x, y) in enumerate(phases):
        check(abs(y[x == 100.][0] - (150. if k == 1 else -90.)) < 1e-9,
              f"the angle of p{k} at the natural frequency: {y[x == 100.]}")
        check(np.isnan(y).sum() == (k == 1) and not (np.abs(np.diff(y)) > 180.).any(),
              "no line where it passes 180 degrees")
    for axis in figure.axes:
        lines = [line.get_xdata()[0] for line in axis.lines if line.get_linestyle() == "--"
                 and len(line.get_xdata()) == 2]
        check(lines == [100., 101., 170.], f"natural frequencies in the range: {lines}")
    texts = [text.get_text() for text in above.texts]
    check(texts == ["2–3", "4"], f"numbers of modes, of close ones together: {texts}")
    run.write("response.csv", columns, [])
    check(not list(figures.modes.harmonic_response(figures.data.Results(folder))),
          "none without rows")


def main():
    if len(sys.argv) != 3:
        sys.exit("Usage: check_pictures_of_runs.py FIGURES.py WORKDIR")
    try:
        import matplotlib  # noqa: F401
        import numpy  # noqa: F401
    except ImportError:
        print("numpy or matplotlib is not here: skipped")
        sys.exit(77)
    figures, folder = Figures(Path(sys.argv[1])), Path(sys.argv[2])
    warnings.simplefilter("error")
    for part in (check_history, check_friction, check_proportions, check_scales, check_stress,
                 check_strength, check_console, check_modes, check_response):
        part(figures, folder)
        figures.style.plt.close("all")


if __name__ == "__main__":
    main()
