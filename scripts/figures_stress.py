# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure of scripts/plot of a stress on the deformed bodies, seen in isometric
projection.

From above, from one side and from the start of the longest body: how it bends and how it
twists are both to be seen. Slender bodies are drawn thicker than they are, each direction
by a round factor, and displacements larger; the picture says both."""

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import Normalize

from figures_data import SOFT, STRESSES
from figures_sections import ONE_SIGN, TWO_SIGNS
from figures_shape import most_without_overlap, round_below
from figures_style import NAMES, WIDTH, Scale, new_figure, plt, round_factor
from figures_surface import (MOST_FACES, continuous, edges_of_bodies, fine_facets,
                             surface_of)

THICK, THIN = 0.2, 0.06  # of the longest extent: how thick at least bodies are drawn
VISIBLE = 0.1  # of the larger thickness drawn: displacements below are enlarged
WANTED = 0.3  # of it, if they are
PEAK = 0.998  # of all values are on the color scale, where few are far beyond
FAR = 1.5  # times the others: a peak that would take the colors from all others
TALLEST = 7.  # inches of the picture
COS, SIN = np.sqrt(0.75), 0.5  # of 30 degrees


class Isometric:
    """How places come onto the picture: x or y, whichever is longer, goes up to the
    right, the other one down to the right, z stands upright, stretched each."""

    def __init__(self, places):
        extents = np.ptp(places.reshape(-1, 3), axis=0)
        self.along = 0 if extents[0] > extents[1] else 1
        # Right-handed, as the scene is.
        self.aside = (1, -1.) if self.along == 0 else (0, 1.)
        self.stretch = stretches(extents)
        self.thickness = np.sort(extents * self.stretch)[1]

    def __call__(self, places):
        """(right, up, towards who looks), the last one for the order alone."""
        x = places * self.stretch
        other, sign = self.aside
        a, b, z = x[..., self.along], sign * x[..., other], x[..., 2]
        return np.stack([COS * (a + b), z + SIN * (a - b), b - a + z], axis=-1)


def stretches(extents):
    """Round factors that make the middle extent, and the smallest with it, thick enough
    beside the longest; the smallest by more where it would still be a sheet."""
    small, middle, long = np.argsort(extents)
    longest = extents[long]
    factors = np.ones(3)
    factors[[small, middle]] = round_factor(THICK * longest, extents[middle])
    if extents[small] * factors[small] < THIN * longest:
        factors[small] = round_factor(THIN * longest, extents[small])
    return factors


def stress_on_the_shape(results):
    """The component that is largest over the bodies; none without their VTU."""
    surface = surface_of(results)
    if (surface is None or surface.stresses is None or len(surface) > MOST_FACES
            or not surface.stresses.any()):
        return
    # Not the largest value, which may be of a corner alone.
    component = STRESSES[int(np.argmax((surface.stresses**2).mean(axis=(0, 1))))]
    values = continuous(surface, surface.stress(component))
    yield "deformed_stress", draw_stress(results, surface, component, values)


def draw_stress(results, surface, component, values):
    view = Isometric(surface.places)
    factor = enlargement(results, surface, view)
    drawn = view(surface.places + factor * surface.moved)
    before = view(surface.places)
    low, high = (f(np.concatenate([drawn, before]), axis=(0, 1))[:2]
                 for f in (np.min, np.max))
    # Beside it are the color bars.
    height = 0.76 * WIDTH * (high[1] - low[1]) / (high[0] - low[0]) + 0.3
    figure, axes = new_figure(results, f"{NAMES[component]} on the deformed shape",
                              height=min(height, TALLEST))
    axis = axes[0, 0]
    axis.set_axis_off()
    axis.set_aspect("equal")
    axis.set_xlim(low[0], high[0])
    axis.set_ylim(low[1], high[1])
    parts = scales_of_bodies(results, surface, values)
    facets, colors = [], []
    for number, (names, mask) in enumerate(parts):
        scale = Scale(results.unit(component), values[mask])
        shades = smooth_shades(scale(values[mask]), number)
        facets.append(fine_facets(np.dstack([drawn[mask], scale(values[mask])])))
        colors.append(shades.to_rgba(facets[-1][:, :, 3].mean(axis=1)))
        label = scale.label(NAMES[component])
        add_bar(axis, shades, f"{names}: {label}" if names else label, number, len(parts))
    edges = edges_of_bodies(surface.places, surface.bodies)
    axis.add_collection(LineCollection(ends_of(edges, before)[:, :, :2], colors="0.75",
                                       linewidths=0.6, zorder=0.5))
    draw_facets(axis, np.concatenate(facets), np.concatenate(colors),
                in_steps(ends_of(edges, drawn), 4))
    draw_directions(axis, results, view, low, high)
    tell(figure, view, factor)
    return figure


def enlargement(results, surface, view):
    """As in the pictures from the side, beside the thickness that is drawn."""
    largest = np.linalg.norm(surface.moved * view.stretch, axis=2).max()
    if largest >= VISIBLE * view.thickness or largest == 0.:
        return 1
    return round_below(min(WANTED * view.thickness / largest, most_without_overlap(
        results, np.ptp(surface.places[:, :, 2]))))


def scales_of_bodies(results, surface, values):
    """(names, which quadrilaterals) that share a color scale: materials of which the
    stress stays below a tenth of the others' have their own."""
    bodies = [name.strip() for name in results.scene.get("Bodies", "").split(",")]
    material = np.full(len(surface), "", object)
    for number, name in enumerate(bodies, 1):
        for ply, found in results.materials(name).items():
            material[(surface.bodies == number) & (surface.plies == ply)] = found
    size = {name: np.abs(values[material == name]).max() for name in set(material)}
    groups = []
    for name in sorted(size, key=lambda name: -size[name]):
        if groups and (size[name] >= SOFT * size[groups[-1][0]] or size[name] == 0.):
            groups[-1].append(name)
        else:
            groups.append([name])
    if len(groups) < 2 or "" in size:
        return [("", np.ones(len(surface), bool))]
    return [(", ".join(sorted(group)), np.isin(material, group)) for group in groups]


def smooth_shades(values, number):
    """About zero where there are two signs."""
    low, high = values.min(), values.max()
    most = np.quantile(np.abs(values), PEAK)
    if max(-low, high) > FAR * most > 0.:
        low, high = max(low, -most), min(high, most)
    two_signs = low < -0.1 * high and high > -0.1 * low
    if two_signs:
        high = max(-low, high)
        low = -high
    maps = TWO_SIGNS if two_signs else ONE_SIGN
    shades = ScalarMappable(Normalize(low, high), plt.get_cmap(maps[number % len(maps)]))
    shades.beyond = {(False, False): "neither", (True, False): "min",
                     (False, True): "max", (True, True): "both"}[
                         bool(values.min() < low), bool(values.max() > high)]
    return shades


def add_bar(axis, shades, label, number, count):
    """Beside the bodies, one above the other."""
    step = 1. / count
    beside = axis.inset_axes([1.03, 1. - (number + 0.94) * step, 0.025, 0.88 * step])
    axis.get_figure().colorbar(shades, cax=beside, extend=shades.beyond)
    beside.set_ylabel(label)


def ends_of(edges, where):
    side, corner = edges.T
    return np.stack([where[side, corner], where[side, (corner + 1) % 4]], axis=1)


def draw_facets(axis, facets, colors, edges):
    """From the farthest to the nearest, edges between them, so that what is behind is
    hidden."""
    # Just in front of the facets that they bound.
    lift = 1.5 * np.quantile(np.ptp(facets[:, :, 2], axis=1), 0.9)
    order = np.argsort(np.concatenate([facets[:, :, 2].mean(axis=1),
                                       edges[:, :, 2].mean(axis=1) + lift]))
    shapes = np.concatenate([facets[:, :, :2], edges[:, [0, 1, 1, 0], :2]])
    colors = np.concatenate([colors, np.tile([0.15, 0.15, 0.15, 1.], (len(edges), 1))])
    widths = np.concatenate([np.full(len(facets), 0.3), np.full(len(edges), 0.7)])
    axis.add_collection(PolyCollection(
        shapes[order], facecolors=colors[order], edgecolors=colors[order],
        linewidths=widths[order]))
    for artist in axis.collections:
        artist.set_in_layout(False)


def in_steps(ends, steps):
    """Straight lines (count, 2, 3) in so many pieces."""
    t = np.linspace(0., 1., steps + 1)[:, None]
    points = ends[:, :1] * (1. - t) + ends[:, 1:] * t
    return np.stack([points[:, :-1], points[:, 1:]], axis=2).reshape(-1, 2, 3)


def draw_directions(axis, results, view, low, high):
    """An arrow along each coordinate, as long as its label says, where there is room
    below the end that is far away."""
    scale = Scale(results.units.get("length"), results.size)
    reach = 0.13 * (high - low).max()
    lengths = [round_length(reach / s) for s in view.stretch]
    tips = np.array([view(length * np.eye(3)[c])[:2] for c, length in enumerate(lengths)])
    # Two of them end to the right, with their labels behind.
    corner = np.array([high[0] - np.maximum(tips, 0.)[:, 0].max() - 0.7 * reach,
                       low[1] - np.minimum(tips, 0.)[:, 1].min()])
    for name, length, tip in zip("xyz", lengths, tips):
        axis.annotate("", corner + tip, corner, arrowprops={
            "arrowstyle": "-|>", "color": "0.25", "shrinkA": 0., "shrinkB": 0.})
        axis.annotate(f"{name}, {scale.number(length)}", corner + tip,
                      xytext=3. * np.sign(tip), textcoords="offset points", color="0.25",
                      fontsize=9, ha="right" if tip[0] < -0.1 * reach else "left",
                      va="bottom" if tip[1] > 0. else "top")


def round_length(most):
    """The largest of 1, 2, 5 times a power of ten that is no longer."""
    power = 10.**np.floor(np.log10(most))
    return max(k * power for k in (1., 2., 5.) if k * power <= most * (1. + 1e-9))


def tell(figure, view, factor):
    """What is not to scale."""
    larger = [f"{name} {int(s):,} times" for name, s in zip("xyz", view.stretch) if s > 1.]
    told = ["isometric"]
    if larger:
        told.append("enlarged: " + ", ".join(larger))
    if factor > 1:
        told.append(f"displacements drawn {factor:,} times as large")
    told.append("grey: where the edges were")
    figure.set_figheight(figure.get_figheight() + 0.25)
    figure.supxlabel("; ".join(told), fontsize=9, color="0.35")
