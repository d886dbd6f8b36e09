# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of scripts/plot of a contact: pressures, beside Hertz, and what is around."""

from collections import defaultdict

import numpy as np
from matplotlib.ticker import MaxNLocator
from matplotlib.tri import Triangulation

from figures_data import magnitude
from figures_sections import Part, SectionPicture, contour
from figures_style import (COLOURS, DASHES, Frame, Place, Scale, at, color_bar,
                           legend_above, middle, new_figure)

FEWEST = 4  # pairs that make a patch, or a profile across it


class ContactPatch:
    """Where a contact touches, in the two coordinates along its surface: across
    its width (where the gap opens faster, or the patch is narrower) and along."""

    def __init__(self, table):
        self.table = table
        self.active = table.where(table["active"] == 1)
        normal = np.array([np.mean(self.active[f"n{c}"]) for c in "xyz"])
        self.mean_normal = normal / max(np.linalg.norm(normal), 1e-300)
        self.normal = "xyz"[int(np.argmax(np.abs(normal)))]
        self.plane = [c for c in "xyz" if c != self.normal]
        self.extent = {c: np.ptp(self.active[c]) for c in self.plane}
        longest = max(self.extent.values())
        self.is_patch = all(e > 1e-3 * longest for e in self.extent.values())
        self.curved = self.rough_curvatures() if self.is_patch else {}
        order = sorted(self.plane, key=lambda c: (
            -self.curved.get(c, 0.), self.extent[c]))
        self.across, self.along = order

    def near(self, margin):
        """The points of the patch and around it, by so many half widths."""
        inside = np.ones(len(self.table), bool)
        for c in self.plane:
            low, high = self.active[c].min(), self.active[c].max()
            pad = 0.5 * margin * (high - low)
            inside &= (self.table[c] >= low - pad) & (self.table[c] <= high + pad)
        return self.table.where(inside)

    def rough_curvatures(self):
        """Of the gap between the points of the pairs (that of a row may be a mean
        over its neighborhood) in both directions, a parabola over the whole
        neighborhood; 0 where it is rounding."""
        near = self.near(2.)
        gap = sum((near[f"{c}2"] - near[c]) * near[f"n{c}"] for c in "xyz")
        terms = [np.ones(len(near))]
        for c in self.plane:
            t = (near[c] - self.active[c].mean()) / self.extent[c]
            terms += [t, t * t]
        fit = np.linalg.lstsq(np.transpose(terms), gap, rcond=None)[0]
        bends = {c: 2. * fit[2 * k + 2] for k, c in enumerate(self.plane)}
        size = max(np.abs(gap).max(), 1e-300)
        return {c: b / self.extent[c]**2 if b > 1e-6 * size else 0.
                for c, b in bends.items()}

    def curvature(self):
        """1 / R*: how much more the second surface bends away than the first, at the
        middle of the patch and across it, or None where the points do not tell.

        Each surface on its own, so that circles stay circles however the pairs lie,
        its height over the common tangent as a polynomial of degree 6: of a circle
        the terms of x^4 and x^6 are some percent where the patch is wide. Degree 4
        must say nearly the same, else the surface is none that a radius describes."""
        if not (self.is_patch and self.curved[self.across] > 0.
                and self.curved[self.along] <= 1e-3 * self.curved[self.across]):
            return None
        tangent = np.array([float(c == self.across) for c in "xyz"])
        tangent -= (tangent @ self.mean_normal) * self.mean_normal
        tangent /= np.linalg.norm(tangent)
        touching = self.across_and_up(self.active, "", tangent)[0]
        center, half = middle(touching), 0.5 * np.ptp(touching)
        bends = []
        for degree in (4, 6):
            bends.append(0.)
            for side, sign in (("", -1.), ("2", 1.)):
                s, height = self.across_and_up(self.table, side, tangent)
                found = bend((s - center) / half, height / half, degree)
                if found is None:
                    return None
                bends[-1] += sign * found / half
        # A slope of rounding across the patch is no curvature.
        size = max(np.abs(self.table[c]).max() for c in "xyz")
        flat = bends[1] * half**2 <= 1e-10 * size
        if flat or abs(bends[0] / bends[1] - 1.) > 0.02:
            return None
        return bends[1]

    def across_and_up(self, table, side, tangent):
        points = np.column_stack([table[f"{c}{side}"] for c in "xyz"])
        return points @ tangent, points @ self.mean_normal

    def stations(self):
        """(position along the patch, the rows there across it), in order."""
        near = self.near(0.5)
        step = 1e-6 * self.extent[self.along]
        places = np.round(near[self.along] / step)
        for place in np.unique(places):
            rows = near.where(places == place)
            yield rows[self.along][0], rows.where(np.argsort(rows[self.across]))


def bend(s, height, degree, fewest=9):
    """The curvature at s = 0 of height(s), |s| <= 1 where the bodies touch, from the
    points there and as many around as are needed, up to |s| = 3; else None."""
    places = np.unique(np.round(np.abs(s), 6) * np.sign(s))
    nearest = np.sort(np.abs(places))
    if len(nearest) < fewest or nearest[fewest - 1] > 3.:
        return None
    inside = np.abs(s) <= max(1., nearest[fewest - 1]) + 1e-5
    fit = np.polynomial.polynomial.polyfit(s[inside], height[inside], degree)
    return 2. * fit[2] / (1. + fit[1]**2)**1.5


# ---- pressures


def patches(results):
    for name, table in results.contacts.items():
        if len(table) and np.sum(table["active"]) >= FEWEST:
            yield name, ContactPatch(table)


def contact_pressure(results):
    for name, patch in patches(results):
        stations = list(patch.stations()) if patch.is_patch else []
        if any(np.sum(rows["active"]) >= FEWEST for _, rows in stations):
            yield (f"contact_{name}_pressure",
                   draw_pressure_across(results, name, patch, stations))
            yield f"contact_{name}_map", draw_pressure_map(results, name, patch)
        else:
            yield f"contact_{name}", draw_pressure_points(results, name, patch)


def pressure_axis(axis, label):
    axis.set_ylabel(label)
    axis.set_ylim(0, 1.06 * axis.dataLim.y1 or 1.)


def draw_pressure_points(results, name, patch):
    active = patch.active
    directions = [c for c in patch.plane
                  if patch.extent[c] > 1e-3 * max(patch.extent.values())]
    figure, axes = new_figure(results, f"pressure in contact {name}", height=3.4,
                              columns=len(directions), sharey=True)
    value = Scale(results.unit("pressure"), active["pressure"])
    for axis, direction in zip(axes[0], directions):
        place = Place(results.units.get("length"), active[direction])
        axis.plot(place(active[direction]), value(active["pressure"]), "o",
                  markersize=4.5, alpha=0.7, markeredgewidth=0)
        axis.set_xlabel(place.label(direction))
        axis.xaxis.set_major_locator(MaxNLocator(5))
    pressure_axis(axes[0, 0],
                  value.label(f"pressure of the {len(active)} active pairs"))
    return figure


def draw_pressure_across(results, name, patch, stations):
    """In the middle and at one end of the patch, with the Hertz ellipse of the
    whole force."""
    figure, axes = new_figure(
        results, f"pressure across contact {name}", height=3.8)
    axis = axes[0, 0]
    active, length = patch.active, results.units.get("length")
    value = Scale(results.unit("pressure"), active["pressure"])
    center = middle(active[patch.across])
    if abs(center) < 1e-9 * patch.extent[patch.across]:
        center = 0.
    place = Place(length, active[patch.across], origin=center)
    in_middle = min(stations, key=lambda s: abs(s[0] - 0.5 * (
        stations[0][0] + stations[-1][0])))
    shown = [in_middle] if in_middle[0] == stations[0][0] else [in_middle, stations[0]]
    for k, (_, rows) in enumerate(shown):
        axis.plot(place(rows[patch.across]), value(rows["pressure"]),
                  marker="o", markersize=4.5, linewidth=1., color=COLOURS[k],
                  linestyle=DASHES[k], label=at(results, rows, patch.along))
    hertz = hertz_ellipse(results, name, patch)
    if hertz:
        half_width, peak, force = hertz
        t = np.linspace(-np.pi / 2, np.pi / 2, 200)
        per_length = "/".join(filter(None, (results.units.get("force"), length)))
        axis.plot(place(center + half_width * np.sin(t)), value(peak * np.cos(t)),
                  color="0.2", linewidth=1.4,
                  label=f"Hertz, mean force {force:.4g} {per_length}".rstrip() + ": "
                  f"a = {place.number(float(f'{half_width:.4g}'))}, "
                  f"$p_0$ = {value.number(float(f'{peak:.4g}'))}")
    axis.set_xlabel(place.label(patch.across))
    pressure_axis(axis, value.label("pressure"))
    legend_above(axis, fewest=1)
    return figure


def hertz_ellipse(results, name, patch):
    """(half-width, peak pressure, force per length) of two cylinders with the
    curvatures of the surfaces, or None if this is not that."""
    modulus = effective_modulus(results.scene, name)
    contact = results.summary.get("contacts", {}).get(name, {})
    curvature = patch.curvature()
    length = np.ptp(patch.table[patch.along])
    # A mean force a length is one where the whole length touches.
    if not (modulus and curvature and "force" in contact
            and patch.extent[patch.along] > 0.95 * length):
        return None
    force = np.linalg.norm(contact["force"]) / length
    half_width = np.sqrt(4. * force / (np.pi * modulus * curvature))
    if half_width > 0.5 * thinnest(results, name):
        return None
    return half_width, np.sqrt(force * modulus * curvature / np.pi), force


def bodies_of(scene, contact):
    """The entries of a contact's bodies, without rigid ones."""
    for side in ("First", "Second"):
        body = scene.get(f"Contact {contact}", {}).get(side, "").partition(":")[0]
        if f"Body {body}" in scene:
            yield scene[f"Body {body}"]


def thinnest(results, contact):
    """The smallest dimension of the bodies' sections: Hertz has half spaces."""
    tables = [results.sections.get(body["Section"])
              for body in bodies_of(results.scene, contact)]
    return min((SectionPicture(table).size.min() for table in tables if table),
               default=np.inf)


def effective_modulus(scene, contact):
    """E* of two isotropic bodies (1/E* = sum (1 - nu^2) / E, nothing from a rigid
    one), or None."""
    compliance = 0.
    for body in bodies_of(scene, contact):
        section = scene.get(f"Section {body['Section']}", {})
        names = section.get("Material") or section.get("Ply materials", "")
        # A section that names none has the one of the scene.
        materials = ({part.strip() for part in names.split(",")} if names else
                     {key.partition(" ")[2] for key in scene
                      if key.startswith("Material ")})
        constants = [scene.get(f"Material {m}", {}).get("Isotropic", "")
                     for m in materials]
        if len(constants) != 1 or not constants[0]:
            return None
        E, nu = (float(number) for number in constants[0].split(","))
        compliance += (1. - nu**2) / E
    return 1. / compliance if compliance else None


def map_of(results, patch, about):
    """A figure for a map of the patch and around it: the points there, along and across
    it, the scales of both, figure and axis, whose labels stand."""
    near = patch.near(0.5)
    x, y = (near[c] for c in (patch.along, patch.across))
    frame = Frame(1, np.ptp(x), np.ptp(y))
    figure, (axis,) = frame.figure(results, about, 1)
    places = [Place(results.units.get("length"), values) for values in (x, y)]
    frame.label([axis], places[0].label(patch.along), places[1].label(patch.across))
    return near, (x, y), places, figure, axis


def draw_pressure_map(results, name, patch):
    near, (x, y), places, figure, axis = map_of(
        results, patch, f"pressure in contact {name}")
    value = Scale(results.unit("pressure"), near["pressure"])
    # Long patches have long triangles; what is near is so in the picture.
    triangles = Triangulation((x - x.mean()) / np.ptp(x), (y - y.mean()) / np.ptp(y))
    drawn = Triangulation(places[0](x), places[1](y), triangles.triangles)
    # From zero: an even pressure is one color.
    pressure = value(near["pressure"])
    levels = MaxNLocator(12).tick_values(0., pressure.max())
    shades = axis.tricontourf(drawn, pressure, levels, cmap="cividis")
    axis.plot(drawn.x, drawn.y, ".", color="0.3", markersize=1.5)
    color_bar(axis, shades, value.label("pressure"))
    return figure


# ---- around the contact


def around_the_contact(results):
    """Contours in the section around the patch, all bodies cut there."""
    for name, patch in patches(results):
        if not patch.is_patch or (patch.across, patch.along) != ("x", "y"):
            continue
        half = 2. * patch.extent["x"]
        center = [middle(patch.active[c]) for c in "xz"]
        y = patch.active["y"]
        cuts = defaultdict(list)
        for cut in (rows for cut in results.cuts.values() for rows in cut.values()):
            if y.min() <= cut["y"][0] <= y.max() and np.ptp(cut["x"]) > 3. * half:
                window = cut_window(cut, center, half)
                if len(window):
                    cuts[round(cut["y"][0] / np.ptp(y), 6)].append(window)
        for tables in cuts.values():
            yield (f"contact_{name}_section",
                   draw_around(results, name, tables, center, half))


def cut_window(cut, center, half):
    """The cells that reach into the window."""
    inside = (np.abs(cut["x"] - center[0]) <= half) & (
        np.abs(cut["z"] - center[1]) <= half)
    return cut.where(np.isin(cut["cell"], np.unique(cut["cell"][inside])))


def window_limits(tables, center, half):
    """Of x and z: so far from the center, but in z no farther than there are bodies."""
    low = min(table["z"].min() for table in tables)
    high = max(table["z"].max() for table in tables)
    return ((center[0] - half, center[0] + half),
            (max(center[1] - half, low), min(center[1] + half, high)))


def draw_around(results, name, tables, center, half):
    limits = window_limits(tables, center, half)
    columns = [c for c in ("uz", "szz") if magnitude(tables, c)]
    frame = Frame(len(columns), *(high - low for low, high in limits))
    figure, axes = frame.figure(
        results, f"around contact {name}, {at(results, tables[0], 'y')}", len(columns))
    places = [Place(results.units.get("length"), pair) for pair in limits]
    for axis, column in zip(axes, columns):
        shown = [table[column][(np.abs(table["x"] - center[0]) <= half)
                               & (np.abs(table["z"] - center[1]) <= half)]
                 for table in tables]
        contour(axis, [Part(tables, column, Scale(results.unit(column), *shown))],
                dict(zip("xz", places)), frame)
        axis.set_xlim(*places[0](limits[0]))
        axis.set_ylim(*places[1](limits[1]))
    frame.label(axes, places[0].label("x"), places[1].label("z"))
    return figure
