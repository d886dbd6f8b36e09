#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Holds what scripts/figures*.py find out and draw against what is known.

Usage: check_pictures.py FIGURES.py WORKDIR

Contacts: two cylinders as exact circles, pairs along the first one's normals, Hertz's
pressure on them for 0.3 N/mm over 2 mm along y, and the resultant in summary.json. The
half-width a = sqrt(4 F' R* / (pi E*)) and the peak p0 = 2 F' / (pi a) must come back
to 0.1 % up to a / R* = 0.3, where a parabola through the gap is percents off and the
forces point apart; what Hertz does not describe must give no ellipse.

Bodies: bricks of which some sides lie inside, moved by known displacements.

Lines and cuts: tables of known numbers, and the figures of them before they become
pictures: their panels, titles, labels, ticks and how much of a panel the data fill.
Exit status 77 (skipped) without numpy or matplotlib.
"""

import csv
import importlib
import json
import math
import re
import shutil
import struct
import subprocess
import sys
import zlib
from pathlib import Path

FORCE, LENGTH, NU = 0.3, 2., 0.3
PAIR = ("step,x,y,z,x2,y2,z2,nx,ny,nz,area,initial_gap,gap,force,pressure,"
        "active").split(",")
STRESSES = ("sxx", "syy", "szz", "sxy", "sxz", "syz")
FIELD = ["step", "body", "ply", "x", "y", "z", "ux", "uy", "uz", "exx", "eyy", "ezz",
         *STRESSES]
MESH = ["cell", "ply", "material", "angle"] + [
    f"{what}_{k}" for what in ("boundary", "side") for k in range(1, 5)]

SCENE = """
subsection Material soft
  set Isotropic = {modulus}, {nu}
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
subsection Body crossing
  set Section = strip
  set Axis    = 1, 0, 0
end
subsection Contact arcs
  set First  = lower: arc
  set Second = {second}
end
"""


def check(condition, what):
    if not condition:
        sys.exit(f"FAIL: {what}")
    print(f"ok: {what}")


# ---- what a run would leave


class Run:
    """A folder, begun anew with a scene and a summary, for results to be put in."""

    def __init__(self, folder, second="upper: arc", modulus=200., force=None):
        self.folder = folder
        shutil.rmtree(folder, ignore_errors=True)
        for part in ("lines", "history", "cuts", "sections"):
            (folder / part).mkdir(parents=True)
        (folder / "scene.prm").write_text(
            SCENE.format(modulus=modulus, nu=NU, second=second))
        contacts = {"arcs": {"force": force}} if force else {}
        (folder / "summary.json").write_text(json.dumps(
            {"title": "Known", "contacts": contacts,
             "units": {"length": "mm", "force": "N", "stress": "MPa"}}))

    def write(self, name, columns, rows):
        with open(self.folder / name, "w", newline="") as file:
            writer = csv.DictWriter(file, columns, restval=0.)
            writer.writeheader()
            writer.writerows(rows)
        return self

    def line(self, name, plies, field, body="laminate", x=5., y=150.):
        """Through plies of given thicknesses; field(z, ply) gives what is not zero."""
        return self.write(f"lines/{name}.csv", FIELD, (
            {"step": 1, "body": body, "ply": ply, "x": x, "y": y, "z": z,
             **field(z, ply)} for ply, low, high in edges_of(plies)
            for z in (low + (high - low) * t for t in (0., 0.5, 1.))))

    def cut(self, name, width, plies, field, body="laminate", at=150., axis="y",
            corner=(0., 0.)):
        """Over a section of two cells across and one a ply."""
        across = "x" if axis == "y" else "y"
        cells = [(ply, low, high, left) for ply, low, high in edges_of(plies)
                 for left in (0., 0.5)]
        return self.write(f"cuts/{name}.csv", FIELD + ["cell", "i", "j"], (
            {"step": 1, "cell": cell, "i": i, "j": j, "body": body, "ply": ply,
             across: corner[0] + width * (left + 0.25 * i), axis: at,
             "z": corner[1] + low + (high - low) * j / 2, **field(low, ply)}
            for cell, (ply, low, high, left) in enumerate(cells)
            for i in range(3) for j in range(3)))

    def bodies(self, cells, moved, stress=None, dataset="solution"):
        """The VTU of cells of 2 x 2 x 2 points, a body's number and its points each, x
        fastest; moved(point) is the displacement, stress(number of the cell, point)
        gives its ply and its six stresses."""
        points = [point for _, corners in cells for point in corners]
        shifts = [moved(point) for point in points]
        arrays = {"points": ("Float32", "f", [x + u for p, s in zip(points, shifts)
                                        for x, u in zip(p, s)]),
                  "displacement": ("Float32", "f", [u for s in shifts for u in s]),
                  "body": ("Int32", "i", [b for b, _ in cells]),
                  "offsets": ("Int32", "i", [8 * k + 8 for k in range(len(cells))]),
                  "HigherOrderDegrees": ("UInt8", "B", [1] * 3 * len(cells))}
        if stress:
            found = [stress(k // 8, point) for k, point in enumerate(points)]
            arrays["ply"] = ("Int32", "i", [ply for ply, _ in found[::8]])
            for c, name in enumerate(STRESSES):
                arrays[name] = ("Float32", "f", [values[c] for _, values in found])
        text, data = "", b""
        for name, (kind, form, values) in arrays.items():
            text += f'<DataArray type="{kind}" Name="{name}" offset="{len(data)}"/>'
            data += packed(values, form)
        (self.folder / f"{dataset}_0001.vtu").write_bytes(
            f'<VTKFile><UnstructuredGrid><Piece NumberOfPoints="{len(points)}" '
            f'NumberOfCells="{len(cells)}">{text}</Piece></UnstructuredGrid>'
            '<AppendedData encoding="raw">\n_'.encode() + data
            + b"\n</AppendedData></VTKFile>")
        (self.folder / f"{dataset}.pvd").write_text(
            f'<VTKFile><Collection><DataSet timestep="1" file="{dataset}_0001.vtu"/>'
            "</Collection></VTKFile>")
        return self

    def section(self, name, width, height):
        """A mesh of one cell."""
        corners = [f"{x} {z}" for x, z in (
            (0, 0), (width, 0), (width, height), (0, height), (0, 0))]
        sides = map(";".join, zip(corners, corners[1:]))
        return self.write(f"sections/{name}.csv", MESH, [dict(zip(MESH, (
            0, 1, "soft", 0, "bottom", "right", "top", "left", *sides)))])


def edges_of(plies):
    low = 0.
    for number, thickness in enumerate(plies, 1):
        yield number, low, low + thickness
        low += thickness


def bending(z, ply):
    """Nothing but sigma_yy, in N/mm^2, and some deflection."""
    return {"syy": 100. * (z - 2.), "uz": -1., "eyy": 1e-3}


# ---- contacts


class Circle:
    """A surface over x, its lowest point (of the upper one) at x = 0, z = 0; a radius
    of infinity is a plane, a negative one the lower body."""

    def __init__(self, radius):
        self.radius = radius

    def z(self, x):
        if math.isinf(self.radius):
            return 0.
        root = math.sqrt(self.radius**2 - x**2)
        return self.radius - math.copysign(root, self.radius)

    def normal(self, x):
        """Upwards."""
        t = 0. if math.isinf(self.radius) else x / self.radius
        return -t, math.sqrt(1. - t * t)


class Facets(Circle):
    """Its points on a coarse polygon."""

    def z(self, x, side=0.7):
        k = math.floor(x / side + 0.5)
        low, high = ((k + t) * side for t in (-0.5, 0.5))
        return super().z(low) + (super().z(high) - super().z(low)) * (x - low) / side


class Ellipse(Circle):
    """As far up as it is wide, curved at its lowest point as the circle is."""

    def z(self, x, aspect=1.5):
        width = aspect * self.radius
        return aspect * width * (1. - math.sqrt(1. - (x / width)**2))


def meets(start, direction, surface):
    """Where a ray from a point arrives at the surface, by Newton's method."""
    t = 0.
    for _ in range(50):
        x = start[0] + t * direction[0]
        miss = start[1] + t * direction[1] - surface.z(x)
        slope = (surface.z(x + 1e-6) - surface.z(x - 1e-6)) / 2e-6
        t -= miss / (direction[1] - slope * direction[0])
    return start[0] + t * direction[0], start[1] + t * direction[1]


def pairs(first, second, half_width, peak, across="x", length=LENGTH, noise=0.):
    """A grid of pairs over two half-widths, ends of y with half the area; outside
    the contact a pressure of so much noise. They touch as far as length."""
    n, m = 81, 9
    dx, dy = 4. * half_width / (n - 1), LENGTH / (m - 1)
    for j in range(m):
        for i in range(n):
            x, y = -2. * half_width + i * dx, j * dy
            n_x, n_z = first.normal(x)
            x2, z2 = meets((x, first.z(x)), (n_x, n_z), second)
            # Along the arc, and its mean over the tributary width.
            area = dx * dy / n_z * (0.5 if j in (0, m - 1) else 1.)
            force = (primitive((x + dx / 2) / half_width)
                     - primitive((x - dx / 2) / half_width)
                     ) * peak * half_width * area / dx * (y <= length)
            force = max(force, noise * area * peak)
            gap = math.hypot(x2 - x, z2 - first.z(x))
            along = {"x": (7. + x, y, 7. + x2, y, n_x, 0.),
                     "y": (y, 7. + x, y, 7. + x2, 0., n_x)}[across]
            yield dict(zip(PAIR, (
                1, *along[:2], 8. + first.z(x), *along[2:4], 8. + z2, *along[4:], n_z,
                area, gap, gap, force, force / area, int(force > 0.))))


def primitive(t):
    """Of sqrt(1 - t^2)."""
    t = max(-1., min(1., t))
    return 0.5 * (t * math.sqrt(1. - t * t) + math.asin(t))


def hertz_of(radius_1, radius_2, ratio, rigid=False):
    """Modulus of the bodies, half-width, peak where a / R* is given."""
    radius = 1. / (1. / radius_2 - 1. / radius_1)
    half_width = ratio * radius
    effective = 4. * FORCE * radius / (math.pi * half_width**2)
    modulus = effective * (1. - NU**2) * (1. if rigid else 2.)
    return modulus, half_width, 2. * FORCE / (math.pi * half_width)


def check_hertz(figures, folder):
    def found(first, second, ratio, partner="upper: arc", known=True, **options):
        rigid = partner == "roller"
        modulus, half_width, peak = hertz_of(first.radius, second.radius, ratio, rigid)
        run = Run(folder, partner, modulus, known and [0., 0., FORCE * LENGTH])
        run.write("contact_arcs.csv", PAIR, pairs(first, second, half_width, peak,
                                                  **options))
        results = figures.data.Results(folder)
        (_, patch), = figures.contact.patches(results)
        return (figures.contact.hertz_ellipse(results, "arcs", patch), patch,
                (half_width, peak, FORCE))

    plane = Circle(math.inf)
    for first, second, ratio, options in (
            (Circle(-8.), Circle(8.), 0.01, {}),
            (Circle(-8.), Circle(8.), 0.3, {"across": "x"}),
            (Circle(-8.), Circle(8.), 0.3, {"across": "y"}),
            (Circle(-5.), Circle(20.), 0.2, {}),
            (Circle(20.), Circle(5.), 0.3, {}),  # in a hollow
            (plane, Circle(8.), 0.3, {"partner": "roller"}),
            (plane, Ellipse(8.), 0.2, {"partner": "roller"})):
        ellipse, patch, wanted = found(first, second, ratio, **options)
        check(patch.across == options.get("across", "x"), "the width is known")
        check(ellipse is not None, f"an ellipse for a / R* = {ratio}")
        off = [value / reference - 1. for value, reference in zip(ellipse, wanted)]
        check(max(map(abs, off)) < 1e-3, f"a / R* = {ratio}, "
              f"R = {first.radius:g} and {second.radius:g}: a {off[0]:+.1e}, "
              f"p0 {off[1]:+.1e}, F' {off[2]:+.1e}")
    two = Circle(-8.), Circle(8.)
    for what, ellipse in (
            ("on an anisotropic body", found(*two, 0.1, "laminate: top")[0]),
            ("without a resultant", found(*two, 0.1, known=False)[0]),
            ("where half the length touches", found(*two, 0.1, length=1.)[0]),
            ("on facets", found(Facets(-8.), Facets(8.), 0.1)[0])):
        check(ellipse is None, f"no ellipse {what}")
    modulus, half_width, peak = hertz_of(-8., 8., 0.1)
    run = Run(folder, modulus=modulus, force=[0., 0., FORCE * LENGTH])
    for thickness, known in ((2.1, True), (1.9, False)):
        run.write("contact_arcs.csv", PAIR, pairs(*two, half_width, peak))
        run.section("half", 60., thickness * half_width)
        results = figures.data.Results(folder)
        patch = figures.contact.ContactPatch(results.contacts["arcs"])
        ellipse = figures.contact.hertz_ellipse(results, "arcs", patch)
        check((ellipse is not None) == known,
              f"on a strip of {thickness} half-widths: {known}")
    (folder / "sections/half.csv").unlink()
    run.write("contact_arcs.csv", PAIR, pairs(plane, plane, half_width, peak))
    results = figures.data.Results(folder)
    patch = figures.contact.ContactPatch(results.contacts["arcs"])
    check(figures.contact.hertz_ellipse(results, "arcs", patch) is None,
          "no ellipse in a flat contact")


def check_noise_of_contact(figures, folder):
    modulus, half_width, peak = hertz_of(-8., 8., 0.1)
    two = Circle(-8.), Circle(8.)
    run = Run(folder, modulus=modulus, force=[0., 0., FORCE * LENGTH])
    run.write("contact_arcs.csv", PAIR, pairs(*two, half_width, peak, noise=1e-9))
    run.write("contact_idle.csv", PAIR, pairs(*two, half_width, 1e-9 * peak))
    results = figures.data.Results(folder)
    patch = figures.contact.ContactPatch(results.contacts["arcs"])
    check(patch.extent["x"] < 2.2 * half_width,
          f"touches over {patch.extent['x'] / half_width:.3f} half-widths, 2 of Hertz")
    drawn = [name for name, _ in figures.contact.contact_pressure(results)]
    check(drawn == ["contact_arcs_pressure", "contact_arcs_map"],
          "a contact of pressures 1e-9 of another's is not drawn")

    # An even pressure: its last digits are no picture, and its points are in view.
    even = [{**row, "pressure": 3.6 + 1e-9 * (k % 7), "active": 1} for k, row in
            enumerate(pairs(Circle(math.inf), Circle(math.inf), half_width, peak))]
    run = Run(folder)
    run.write("contact_arcs.csv", PAIR, even)
    run.write("contact_few.csv", PAIR, even[::100])
    drawn = dict(figures.contact.contact_pressure(figures.data.Results(folder)))
    bar, = drawn["contact_arcs_map"].axes[0].child_axes
    check(bar.get_ylim()[0] == 0., "the map of an even pressure begins at 0")
    top = drawn["contact_few"].axes[0].get_ylim()[1]
    check(3.7 < top < 4., f"points of 3.6 MPa on an axis up to {top:.2f}")


# ---- lines and cuts


def drawn_texts(figure, start):
    figure.canvas.draw()
    renderer = figure.canvas.get_renderer()
    return [(text.get_text(), text.get_window_extent(renderer))
            for axis in figure.axes for text in axis.texts
            if text.get_text().startswith(start)]


def title_of(figure):
    return figure._suptitle.get_text()


def all_axes(figure):
    """With those of the color bars."""
    return [part for axis in figure.axes for part in (axis, *axis.child_axes)]


def components(figure):
    labels = [f"{axis.get_ylabel()} {axis.get_xlabel()}" for axis in all_axes(figure)]
    return re.findall(r"sigma_\{(\w+)\}", " ".join(labels))


SANDWICH = (1., 1., 1., 30., 1., 1., 1.)


def check_plies(figures, folder):
    run = Run(folder)
    run.cut("sandwich", 50., SANDWICH, bending)
    run.line("through", SANDWICH, bending)
    results = figures.data.Results(folder)
    table = results.cuts["sandwich"]["laminate"]
    plies = figures.style.Plies(table, "z")
    edges = plies.thickened()
    shares = [(b - a) / 36. for a, b in zip(edges, edges[1:])]
    check(min(shares) > 0.07 and max(shares) == shares[3] and abs(
        sum(shares) - 1.) < 1e-12, f"a face ply of 1/36 takes {min(shares):.3f}")
    (_, figure), = figures.sections.section_cuts(results)
    axis = figure.axes[0]
    figure.canvas.draw()
    ticks = [label.get_text() for label in axis.get_yticklabels()]
    check(ticks == "0 1 2 3 33 34 35 36".split(), "ticks name all interfaces")
    check("thin plies enlarged" in axis.get_ylabel(), "the axis says so")
    for plies in (SANDWICH, 32 * (0.125,), (0.1,) * 10 + (20.,) + (0.1,) * 10):
        run.line("through", plies, bending)
        results = figures.data.Results(folder)
        (_, figure), = figures.lines.through_the_thickness(results)
        labels = drawn_texts(figure, "pl")
        named = [k for text, _ in labels for k in numbers(text)]
        check(sorted(named) == list(range(1, len(plies) + 1)),
              f"each of {len(plies)} plies is named: {', '.join(t for t, _ in labels)}")
        check(not any(a.overlaps(b) for k, (_, a) in enumerate(labels)
                      for _, b in labels[:k]), "no label covers another")
    run.cut("even", 13., 32 * (0.125,), bending)
    results = figures.data.Results(folder)
    even = figures.style.Plies(results.cuts["even"]["laminate"], "z")
    check(even.thickened() is None, "plies of one thickness stay to scale")


def numbers(label):
    first, *last = map(int, re.findall(r"\d+", label))
    return range(first, (last or [first])[0] + 1)


def check_titles_and_ticks(figures, folder):
    run = Run(folder, force=[0., 0., FORCE * LENGTH])
    run.line("zero", (3., 3.), bending, y=-9.46936e-16)
    run.line("as_zero", (3., 3.), bending, y=3e-16)
    run.cut("zero", 100., (3., 3.), bending, at=-9.46936e-16)
    results = figures.data.Results(folder)
    for draw in (figures.lines.through_the_thickness, figures.sections.section_cuts):
        titles = [title_of(figure) for _, figure in draw(results)]
        check(len(titles) == 1 and titles[0].endswith("at y = 0 mm"), titles[0])

    # Everything far from the origin, and stresses that hardly vary.
    run = Run(folder, force=[0., 0., FORCE * LENGTH])
    shift = 149.9
    modulus, half_width, peak = hertz_of(-8., 8., 0.01)

    def steady(z, ply):
        return {"syy": 1e4 + 1e-4 * z, "syz": 7. + 1e-9 * z, "uz": -3. + 1e-7 * z}

    def moved(row):
        return {**row, **{c: row[c] + 100. * shift for c in ("y", "y2", "z", "z2")}}

    run.line("far", (1e-3, 1e-3), steady, x=shift, y=shift)
    run.cut("far", 1e-3, (1e-3, 1e-3), steady, at=shift, corner=(shift, shift))
    run.write("contact_arcs.csv", PAIR, map(moved, pairs(
        Circle(-8.), Circle(8.), half_width, peak)))
    results = figures.data.Results(folder)
    offsets, count = [], 0
    for draw in figures.FIGURES:
        for _, figure in draw(results):
            count += 1
            figure.canvas.draw()
            offsets += [axis.get_major_formatter().get_offset()
                        for panel in all_axes(figure)
                        for axis in (panel.xaxis, panel.yaxis)]
    # A factor such as 10^{-7} is none.
    with_sum = [text for text in offsets if re.search(
        "[+−-]", re.sub(r"10\^\{[^}]*\}", "", text))]
    check(count >= 4 and not with_sum, f"no offset in {count} figures {with_sum}")
    place = figures.style.Place("mm", [149.899, 149.901])
    check(place.label("y") == "y − 149.9 mm [µm]", place.label("y"))


def check_components(figures, folder):
    def angles(factor):
        return lambda z, ply: {**bending(z, ply), "syz": 1., "sxy": 400. * factor,
                               "sxz": 400. * factor}

    plies = (1.,) * 4
    for factor, wanted in ((0.2, ["yz", "yy", "xy", "xz"]), (1e-4, ["yz", "yy"])):
        run = Run(folder)
        run.line("through", plies, angles(factor))
        run.cut("cut", 20., plies, angles(factor))
        results = figures.data.Results(folder)
        for draw in (figures.lines.through_the_thickness,
                     figures.sections.section_cuts):
            (name, figure), = draw(results)
            check(components(figure) == wanted,
                  f"{name}: shears of {factor} of the largest: {components(figure)}")

    # A component of 1e-9 of the largest stress is zero; a body of no other is left out.
    def noise(z, ply):
        return {**bending(z, ply), "syz": 2e-7 * (-1)**ply}

    def idle(z, ply):
        return {c: 2e-7 * (-1)**ply for c in STRESSES}

    run = Run(folder)
    run.line("through", plies, noise)
    run.cut("cut", 20., plies, noise)
    run.cut("idle", 20., plies, idle, body="upper")
    results = figures.data.Results(folder)
    for draw in (figures.lines.through_the_thickness, figures.sections.section_cuts):
        (name, figure), = draw(results)
        check(components(figure) == ["yy"], f"{name}: noise is not drawn")
        check("yz" in figure._supxlabel.get_text(), figure._supxlabel.get_text())


def filled(figure):
    """Which part of the figure the data of its panels take, and of the panels."""
    figure.canvas.draw()
    inside = sum(axis.get_window_extent().width * axis.get_window_extent().height
                 for axis in figure.axes)
    data = sum(box.width * box.height for box in (
        axis.dataLim.transformed(axis.transData) for axis in figure.axes))
    return data / (figure.bbox.width * figure.bbox.height), data / inside


def enlarged(label):
    return int((re.findall(r"enlarged (\d+) times", label) or [1])[0])


def check_shapes(figures, folder):
    for width, height in ((100., 3.), (60., 8.), (2000., 1.), (20., 15.), (3., 80.)):
        run = Run(folder)
        run.cut("cut", width, (height,), bending)
        results = figures.data.Results(folder)
        (_, figure), = figures.sections.section_cuts(results)
        whole, panel = filled(figure)
        axis = figure.axes[0]
        x, z = enlarged(axis.get_xlabel()), enlarged(axis.get_ylabel())
        check(panel > 0.9 and whole > 0.3,
              f"a section of {width:g} x {height:g} fills {whole:.0%} of the picture, "
              f"{panel:.0%} of its panel, enlarged {x} and {z} times")
        check(abs(axis.get_aspect() * x / z - 1.) < 1e-9, "as the labels say")
    # A flat section's mesh, with names beside it and a legend.
    run = Run(folder)
    run.section("flat", 60., 4.)
    (_, figure), = figures.sections.section_meshes(figures.data.Results(folder))
    figure.canvas.draw()
    corners = figure.axes[0].transData.transform([(0., 0.), (60., 4.)])
    part = (corners[1] - corners[0]).prod() / (figure.bbox.width * figure.bbox.height)
    check(part > 0.2, f"a mesh of 60 x 4 fills {part:.0%} of the picture")
    # A strip that is thin beside the window around its contact.
    run = Run(folder)
    run.cut("cut", 200., (3.,), bending)
    table = figures.data.Results(folder).cuts["cut"]["laminate"]
    limits = figures.contact.window_limits([table], (100., 3.), 40.)
    check(limits == ((60., 140.), (0., 3.)), f"around a contact: {limits}")
    # A body along x has its section over y and z, and sigma_xx along its axis.
    run.cut("cut", 20., (5., 5.), lambda z, ply: {"sxx": 10. * z + 1., "sxz": 1.},
            body="crossing", at=40., axis="x")
    results = figures.data.Results(folder)
    (_, figure), = figures.sections.section_cuts(results)
    check(title_of(figure).endswith("section at x = 40 mm"), title_of(figure))
    check(components(figure) == ["xz", "xx"], f"with {components(figure)}")
    check(filled(figure)[1] > 0.9, "over y and z")


def check_levels(figures, folder):
    import numpy as np
    levels = np.arange(-3., 5.)
    for low, high in ((-3., 4.), (-0.5, -0.4), (0., 0.), (0.5, 2.), (-3., -3.)):
        part = figures.sections.reached(levels, np.array([low, high]))
        check(len(part) > 1 and part[0] <= low and part[-1] >= high
              and np.sum((part >= low) & (part <= high)) >= len(part) - 2,
              f"levels {part[0]:g} to {part[-1]:g} for {low} to {high}")


# ---- fields, goals, passes


def check_fields_of_nodes(figures, folder):
    columns = "body,node,s,x,y,z,fields".split(",")
    lists = [200] * 4 + [12] * 8 + [90] * 4

    def nodes(body, fields):
        return [{"body": body, "node": k + 1, "s": k, "y": k + 100., "fields": n}
                for k, n in enumerate(fields)]

    run = Run(folder)
    run.write("fields.csv", columns, nodes("beam", lists) + nodes("plate", [12] * 31))
    (name, figure), = figures.goals.fields_of_nodes(figures.data.Results(folder))
    check(name == "fields" and len(figure.axes) == 3, "a strip a body, and a color bar")
    texts = [[text.get_text() for text in axis.texts] for axis in figure.axes[:2]]
    check(texts == [["200", "12", "90"], ["12"]], f"the numbers on the strips: {texts}")
    check("1,256 DoFs, 16 nodes" in figure.axes[0].get_title(loc="left"),
          figure.axes[0].get_title(loc="left"))
    limits = [axis.get_xlim() for axis in figure.axes[:2]]
    check(limits[0] == limits[1] and abs(limits[0][0] - 99.7) < 1e-9,
          "bodies along one direction stand above each other")
    run.write("fields.csv", columns, nodes("beam", [12] * 5))
    results = figures.data.Results(folder)
    check(not list(figures.goals.fields_of_nodes(results)), "one length is no picture")


GOAL = "goal,value,estimate,corrected,bar,trusted,tolerance,met,scale,why".split(",")


def goal(name, value, estimate, bar, tolerance="", scale=None):
    """A line of goals.csv."""
    return dict(zip(GOAL, (name, value, estimate, value + estimate, bar, int(bar != ""),
                           tolerance, "", scale or abs(value), "")))


def check_goals(figures, folder):
    run = Run(folder)
    run.write("goals.csv", GOAL, [
        goal("press: fz", -755., 1.51, 7.55, 7.55), goal("tip: uz", 2e-3, -1e-5, 3e-5, 2e-5),
        goal("core: syz", 0.2, 0.06, "", 0.002), goal("clamp: mx", 0., 1., 2., "", 100.)])
    (_, figure), = figures.goals.goals_with_bars(figures.data.Results(folder))
    axis, = figure.axes
    labels = [label.get_text() for label in axis.get_yticklabels()]
    check(labels == ["press: $F_z$", "tip: $u_z$", "core: $\\sigma_{yz}$",
                     "clamp: $M_x$"], f"goals by name: {labels}")
    texts = [text.get_text() for text in axis.texts]
    check(texts[0] == "-755 N\n± 1 %" and texts[1] == "2 µm\n± 1.5 %"
          and texts[3:5] == ["-30 %", "0.2 MPa\nno bar yet"], f"in words: {texts}")
    bars = [segments.get_segments()[0] for segments in axis.collections]
    found = [(bar[0][0], bar[1][0]) for bar in bars]
    wanted = [(-0.2 - 1., -0.2 + 1.), (0.5 - 1.5, 0.5 + 1.5), (-1. - 2., -1. + 2.)]
    check(all(abs(a - b) < 1e-9 for pair in zip(found, wanted) for a, b in zip(*pair)),
          f"bars around the values, from the corrected ones on: {found}")


def check_passes(figures, folder):
    columns = "pass,dofs,seconds,goal,value,estimate,bar,trusted,met".split(",")
    run = Run(folder)
    run.write("goals.csv", GOAL, [goal("tip: uz", 2., 0.01, 0.02, 0.02),
                                  goal("core: syz", 4., 0.01, 0.02, 0.04)])
    run.write("passes.csv", columns, [
        dict(zip(columns, (k + 1, 10**(k + 2), 0.5 * 3**k, name, 2., size * 10.**-k,
                           2. * size * 10.**-k if k or name == "tip: uz" else "",
                           int(k > 0 or name == "tip: uz"), 0)))
        for k in range(3) for name, size in (("tip: uz", 1.), ("core: syz", 4.))])
    (_, figure), = figures.goals.passes_of_a_tolerance(figures.data.Results(folder))
    for axis, label in zip(figure.axes, ("freedom", "seconds")):
        check(label in axis.get_xlabel() and axis.get_yscale() == "log", label)
        names = axis.get_legend_handles_labels()[1]
        check(sorted(names) == ["core: $\\sigma_{yz}$", "tip: $u_z$", "tolerance"],
              f"with the legend {names}")
    lines = {round(line.get_ydata()[0], 9) for line in figure.axes[0].lines
             if line.get_linestyle() == "--"}
    check(lines == {1.}, f"the tolerance of both goals is 1 %: {lines}")
    dots = [line for line in figure.axes[0].lines
            if line.get_fillstyle() == "none"]
    check(len(dots) == 1 and abs(dots[0].get_ydata()[0] - 100.) < 1e-9,
          "what has no bar is an open dot at its estimate")


class Figures:
    """The parts of scripts/figures.py, which import each other by name."""

    def __init__(self, path):
        self.path = path
        sys.path.insert(0, str(path.parent))
        for part in ("data", "style", "lines", "history", "sections", "contact", "friction",
                     "goals", "surface", "shape", "stress", "strength", "modes"):
            setattr(self, part, importlib.import_module(f"figures_{part}"))
        self.FIGURES = importlib.import_module(path.stem).FIGURES


def packed(values, form):
    """One block of zlib after its header, as VTK's raw appended arrays are."""
    data = struct.pack(f"<{len(values)}{form}", *values)
    block = zlib.compress(data)
    return struct.pack("<4I", 1, len(data), 0, len(block)) + block


def brick(body, low, size):
    return body, [tuple(a + b * k for a, b, k in zip(low, size, (i, j, m)))
                  for m in (0, 1) for j in (0, 1) for i in (0, 1)]


def check_deformed(figures, folder):
    """Two bodies of 4 x 100 x 2, one upon the other; the lower one is of two cells.
    The side that they share within a body is inside, those between bodies are not."""
    cells = [brick(1, (0., 0., 0.), (4., 50., 2.)), brick(1, (0., 50., 0.), (4., 50., 2.)),
             brick(2, (0., 0., 2.), (4., 100., 2.))]
    for end, factor in ((-2., 1), (-0.01, 20)):
        run = Run(folder).bodies(cells, lambda p: (0., 0., end * (p[1] / 100.) ** 2))
        results = figures.data.Results(run.folder)
        surface = figures.surface.surface_of(results)
        places, moved, bodies = surface.places, surface.moved, surface.bodies
        areas = 0.5 * figures.shape.np.linalg.norm(figures.shape.np.cross(
            places[:, 2] - places[:, 0], places[:, 3] - places[:, 1]), axis=1)
        check([round(float(areas[bodies == b].sum()), 3) for b in (1, 2)] ==
              [2 * (400 + 200 + 8)] * 2 and (bodies == 1).sum() == 10,
              "the outer surface of each body, without what is inside")
        check(abs(moved[:, :, 2].min() - end) < 1e-6 * abs(end), "with displacements")
        (name, figure), = figures.shape.deformed_shape(results)
        panel = figure.axes[0]
        check(name == "deformed" and panel.get_xlabel().startswith("y [mm]") and
              panel.get_ylabel().startswith("z [mm]"), "slender: from the side alone")
        now = figures.shape.np.concatenate([
            path.vertices for path in panel.collections[1].get_paths()])
        check(abs(now[:, 1].min() - factor * end) < 1e-4 * factor * abs(end),
              f"displacements drawn {factor} times as large")
        check((f"{factor} times as large" in title_of(figure)) == (factor > 1),
              f"the title says so: {title_of(figure)}")
    # The gap closes by a half: drawn twice as large the bodies meet.
    run.write("contact_arcs.csv", PAIR, [
        {"step": 1, "initial_gap": 0.02, "gap": 0.01, "area": 1.}])
    results = figures.data.Results(run.folder)
    (_, figure), = figures.shape.deformed_shape(results)
    check(" 2 times as large" in title_of(figure),
          f"no further than bodies meet: {title_of(figure)}")
    run.bodies([brick(1, (0., 0., 0.), (4., 4., 4.))], lambda p: (0., 0., 1e-3 * p[2]))
    check([name for name, _ in figures.shape.deformed_shape(figures.data.Results(
        run.folder))] == ["deformed", "deformed_from_the_other_side"],
        "compact: from two sides")
    (folder / "solution.pvd").unlink()
    check(not list(figures.shape.deformed_shape(figures.data.Results(run.folder))),
          "nothing without a VTU")


def main():
    if len(sys.argv) != 3:
        sys.exit("Usage: check_pictures.py FIGURES.py WORKDIR")
    try:
        import matplotlib  # noqa: F401
        import numpy  # noqa: F401
    except ImportError:
        print("numpy or matplotlib is not here: skipped")
        sys.exit(77)
    figures, folder = Figures(Path(sys.argv[1])), Path(sys.argv[2])
    for part in (check_hertz, check_noise_of_contact, check_plies,
                 check_titles_and_ticks, check_components, check_levels, check_shapes,
                 check_fields_of_nodes, check_goals, check_passes, check_deformed):
        part(figures, folder)
        figures.style.plt.close("all")

    modulus, half_width, peak = hertz_of(-8., 8., 0.1)
    run = Run(folder, modulus=modulus, force=[0., 0., FORCE * LENGTH])
    run.write("contact_arcs.csv", PAIR,
              pairs(Circle(-8.), Circle(8.), half_width, peak))
    subprocess.run([sys.executable, sys.argv[1], folder], check=True)
    drawn = sorted(path.name for path in (folder / "pictures").glob("*.png"))
    check(drawn == ["contact_arcs_map.png", "contact_arcs_pressure.png"],
          f"pictures: {', '.join(drawn)}")


if __name__ == "__main__":
    main()
