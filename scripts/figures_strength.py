# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of scripts/plot of how near plies are to failure."""

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.ticker import MaxNLocator

from figures_goals import direction, span
from figures_style import COLOURS, Place, new_figure, plt

ROW = 0.17  # inches of a ply
LEAST, MOST = 0.6, 4.  # inches of a body


def ply_stacks(results):
    """Each body as its stack of plies: 1/R along the axis and, beside it, the largest of
    each ply. What is left out of the sweep stays blank."""
    table = results.plies_along
    if not len(table):
        return
    bodies = list(table.split("body"))
    largest = largest_of(table["inverse_reserve_factor"])
    shades = ScalarMappable(Normalize(0., largest or 1.), plt.get_cmap("YlOrRd"))
    heights = [np.clip(ROW * len(np.unique(rows["ply"])), LEAST, MOST)
               for _, rows in bodies]
    # Room for the last tick of an axis and the first of its neighbor.
    with plt.rc_context({"figure.constrained_layout.w_pad": 0.12}):
        figure, axes = new_figure(
            results, "how near plies are to failure", rows=len(bodies), columns=2,
            height=np.mean(heights) + 0.65,
            gridspec_kw={"width_ratios": [4, 1], "height_ratios": heights})
    along = {body: direction(results, body, rows) for body, rows in bodies}
    for (axis, beside), (body, rows) in zip(axes, bodies):
        name = along[body]
        same = [others[name] for other, others in bodies if along[other] == name]
        place = Place(results.unit("ux"), *same)
        plies = draw_stack(axis, place(rows[name]), rows, shades)
        axis.set_xlim(*span([place(places) for places in same]))
        axis.set_xlabel(place.label("along the axis" if name == "s" else name))
        axis.set_ylabel("ply")
        axis.set_title(body, loc="left")
        draw_largest(beside, plies, rows, largest)
    # A bar may be as low as one ply, and its label no longer.
    bar = figure.colorbar(shades, ax=list(axes[:, 1]), pad=0.03, aspect=25)
    bar.set_label("1/R")
    bar.locator = MaxNLocator(6 if sum(heights) > 1. else 3)
    bar.update_ticks()
    figure.set_figheight(figure.get_figheight() + 0.25)
    figure.supxlabel("1/R: the larger, the nearer to failure; a ply fails at 1",
                     fontsize=9, color="0.35")
    yield "reserve_factors", figure


def largest_of(values):
    """0 where all of them are left out."""
    return np.max(values, where=np.isfinite(values), initial=0.)


def draw_stack(axis, places, rows, shades):
    """The numbers of plies from the bottom; each station has the half of the way to its
    neighbors."""
    plies, stations = np.unique(rows["ply"]), np.unique(places)
    grid = np.full((len(plies), len(stations)), np.nan)
    grid[np.searchsorted(plies, rows["ply"]),
         np.searchsorted(stations, places)] = rows["inverse_reserve_factor"]
    edges = np.concatenate([stations[:1], 0.5 * (stations[1:] + stations[:-1]),
                            stations[-1:]])
    axis.pcolormesh(edges, np.arange(len(plies) + 1) + 0.5, grid, cmap=shades.cmap,
                    norm=shades.norm)
    if largest_of(grid) > 1. and len(stations) > 1:
        # Of one ply from its lower edge to its upper one.
        rows = np.arange(len(plies)) + 1. if len(plies) > 1 else [0.5, 1.5]
        axis.contour(stations, rows, np.broadcast_to(
            np.nan_to_num(grid), (len(rows), len(stations))), [1.],
            colors="0.1", linewidths=1.)
    show_plies(axis, plies)
    return plies


def show_plies(axis, plies):
    step = max(1, -(-len(plies) // 16))
    shown = np.arange(0, len(plies), step)
    axis.set_yticks(shown + 1, labels=[f"{plies[k]:g}" for k in shown])
    axis.set_ylim(0.5, len(plies) + 0.5)
    axis.grid(False)


def draw_largest(axis, plies, rows, largest):
    values = [largest_of(rows["inverse_reserve_factor"][rows["ply"] == ply])
              for ply in plies]
    axis.barh(np.arange(len(plies)) + 1, values, height=0.8, color=COLOURS[0])
    if largest > 0.5:
        axis.axvline(1., color="0.1", linewidth=1.)
    axis.set_xlabel("largest 1/R")
    axis.set_xlim(0., 1.08 * (max(largest, 1.) if largest > 0.5 else largest or 1.))
    show_plies(axis, plies)
    axis.set_yticklabels([])
