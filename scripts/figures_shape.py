# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of scripts/plot of the bodies as they deform, from the last step's VTU.

What is seen is the outer surface, from the side in which it moves most; a compact
scene is also seen along its other direction. Displacements are enlarged by a round
number where they would not be seen, and the picture says so; never so far that bodies
that meet are drawn into each other, since gaps are not enlarged."""

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import Normalize
from matplotlib.patches import Ellipse
from matplotlib.ticker import MaxNLocator

from figures_style import (BESIDE, WIDTH, Place, Scale, drawn_larger, exaggeration,
                           new_figure, plt)
from figures_surface import MOST_FACES, edges_of_bodies, fine_facets, surface_of

VISIBLE = 0.05  # of the height drawn: displacements below are enlarged
WANTED = 0.12  # of it, if they are
OVERLAP = 0.003  # of it, that is not seen
COMPACT = 0.15  # of the largest extent: what is seen from both sides


# ---- drawing


def views(places, moved):
    """(horizontal, vertical, depth) as numbers of coordinates: upwards what moves
    most, to the right what is longest; both others where the scene is compact."""
    up = int(np.argmax(np.abs(moved).max(axis=(0, 1))))
    extents = np.ptp(places.reshape(-1, 3), axis=0)
    others = sorted((c for c in range(3) if c != up), key=lambda c: -extents[c])
    for right, depth in (others, others[::-1]):
        if extents[right] >= COMPACT * extents.max() or right == others[0]:
            # z stands upright where it can.
            yield (up, 2, depth) if right == 2 else (right, up, depth)


def enlargement(results, moved, extent):
    """A round factor that makes displacements visible beside an extent."""
    largest = np.abs(moved).max()
    if largest >= VISIBLE * extent or largest == 0.:
        return 1
    return round_below(min(WANTED * extent / largest, most_without_overlap(
        results, extent)))


def most_without_overlap(results, extent):
    """The factor with which bodies that come nearer to each other meet."""
    most = np.inf
    for table in results.contacts.values():
        closed = table["initial_gap"] - table["gap"]
        near = closed > 0.
        if near.any():
            most = min(most, np.min((np.maximum(table["initial_gap"][near], 0.)
                                     + OVERLAP * extent) / closed[near]))
    return most


def round_below(most):
    factors = np.array([k * 10.**p for p in range(15) for k in (1, 2, 5)])
    return int(factors[factors <= max(most, 1.)][-1])


def deformed_shape(results):
    """The last load step's bodies; none without their VTU or without displacements."""
    surface = surface_of(results)
    if surface is None or len(surface) > MOST_FACES or not surface.moved.any():
        return
    for number, view in enumerate(views(surface.places, surface.moved)):
        yield "deformed" + ("" if number == 0 else "_from_the_other_side"), draw_view(
            results, surface, view)


def draw_view(results, surface, view):
    right, up, _ = view
    flat = surface.places[:, :, [right, up]]
    shift = surface.moved[:, :, [right, up]]
    width, height = (np.ptp(flat + shift, axis=(0, 1)) + 1e-300)
    stretch = exaggeration(width, height, wanted=5.)
    factor = enlargement(results, shift[:, :, 1], height)
    now = flat + factor * shift
    both = np.concatenate([flat, now])
    place = [Place(results.units.get("length"), both[:, :, c]) for c in range(2)]
    drawn = [np.stack([place[c](at[:, :, c]) for c in range(2)], axis=2)
             for at in (flat, now)]
    sizes = np.linalg.norm(surface.moved, axis=2)
    scale = Scale(results.units.get("length"), sizes)

    about = "deformed" + (f", displacements drawn {factor:,} times as large"
                          if factor > 1 else "")
    ratio = np.ptp(both[:, :, 1]) * stretch[1] / (np.ptp(both[:, :, 0]) * stretch[0])
    panel = min((WIDTH - BESIDE) * ratio + 0.5, 6.5)
    figure, axes = new_figure(results, about, height=max(panel, 1.6))
    axis = axes[0, 0]
    axis.grid(False)
    shades = ScalarMappable(Normalize(0., scale(sizes).max() or 1.),
                            plt.get_cmap("viridis"))
    draw_bodies(axis, surface, drawn, scale(sizes), shades, view)
    axis.autoscale_view()
    limits = axis.get_xlim(), axis.get_ylim()
    draw_obstacles(axis, results, view, place, factor)
    axis.set_xlim(limits[0])
    axis.set_ylim(with_margin(limits[1]))
    # Units may differ from one coordinate to the other.
    axis.set_aspect(stretch[1] / stretch[0] * place[0].factor / place[1].factor)
    axis.yaxis.set_major_locator(MaxNLocator(5))
    for c, name in enumerate((right, up)):
        label = place[c].label("xyz"[name]) + drawn_larger(stretch[c])
        (axis.set_ylabel if c else axis.set_xlabel)(label)
    figure.colorbar(shades, ax=axis, pad=0.015, aspect=12).set_label(
        scale.label("displacement"))
    return figure


def draw_bodies(axis, surface, drawn, values, shades, view):
    """Grey, where they were; on it where they are, the nearest last, in facets fine
    enough to show no steps."""
    _, _, depth = view
    axis.add_collection(PolyCollection(drawn[0], facecolors="0.9", edgecolors="0.9",
                                       linewidths=0.4))
    facets = fine_facets(np.dstack([drawn[1], values, surface.places[:, :, depth]]))
    order = np.argsort(facets[:, :, 3].mean(axis=1) * (-1 if depth == 0 else 1))
    facets = facets[order]
    colors = shades.to_rgba(facets[:, :, 2].mean(axis=1))
    axis.add_collection(PolyCollection(facets[:, :, :2], facecolors=colors,
                                       edgecolors=colors, linewidths=0.3))
    side, corner = edges_of_bodies(surface.places, surface.bodies).T
    axis.add_collection(LineCollection(
        np.stack([drawn[1][side, corner], drawn[1][side, (corner + 1) % 4]], axis=1),
        colors="0.2", linewidths=0.5))


def with_margin(limits, share=0.08):
    low, high = limits
    return low - share * (high - low), high + share * (high - low)


def draw_obstacles(axis, results, view, place, factor):
    """Rigid cylinders that are seen from their ends, and planes from their side,
    where they are at the last load step."""
    right, up, depth = view
    factors = results.scene.get("Load factors", "1").split(",")
    load = float(factors[-1])
    for name in filter(None, map(str.strip, results.scene.get("Obstacles", "").split(
            ","))):
        entries = results.scene.get(f"Obstacle {name}", {})
        through, u = (np.array([float(v) for v in entries[key].split(",")])
                      for key in ("Through", "u"))
        through = through + factor * load * u
        is_plane = entries.get("Shape") == "plane"
        direction = np.array([float(v) for v in entries[
            "Normal" if is_plane else "Axis"].split(",")])
        direction /= np.linalg.norm(direction)
        center = [place[0](through[right]), place[1](through[up])]
        if is_plane and abs(direction[depth]) < 1e-6:
            along = np.array([direction[up] * place[0].factor,
                              -direction[right] * place[1].factor])
            far = 1e3 * max(np.ptp(axis.get_xlim()), np.ptp(axis.get_ylim()))
            along *= far / np.linalg.norm(along)
            axis.add_collection(LineCollection([[center - along, center + along]],
                                               colors="0.35", linewidths=1.2))
        elif not is_plane and abs(direction[depth]) > 1. - 1e-6:
            radius = float(entries["Radius"])
            axis.add_patch(Ellipse(center, 2. * radius * place[0].factor,
                                   2. * radius * place[1].factor, facecolor="none",
                                   edgecolor="0.35", linewidth=1.2))
