# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of scripts/plot of what a run's numbers cost and hold: the fields that its
nodes carry, its goals with their bars, and the passes of a run to a tolerance."""

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import LogNorm
from matplotlib.patches import Rectangle
from matplotlib.ticker import LogLocator, NullFormatter

from figures_style import (COLOURS, NAMES, Place, Scale, WIDTH, legend_above,
                           moment_unit, new_figure, plt)

STRIP = 0.75  # inches of a body's strip
ROW = 0.62  # inches of a goal
ENOUGH = "#e3f1e3"  # within a tolerance
LEAST = 1e-6  # of the scale: errors are drawn from there


# ---- which node carries what


def fields_of_nodes(results):
    """A strip along each axis, colored by the length of the nodes' lists; none where
    all nodes of the scene carry the same number."""
    table = results.fields
    if not len(table) or np.ptp(table["fields"]) == 0.:
        return
    bodies = list(table.split("body"))
    figure, axes = new_figure(results, "fields that the nodes carry", rows=len(bodies),
                              height=STRIP + 0.6)
    shades = ScalarMappable(
        LogNorm(table["fields"].min(), table["fields"].max()), plt.get_cmap("YlGnBu"))
    along = {body: direction(results, body, rows) for body, rows in bodies}
    for axis, (body, rows) in zip(axes[:, 0], bodies):
        name = along[body]
        same = [nodes for other, nodes in bodies if along[other] == name]
        place = Place(results.unit("ux"), *[nodes[name] for nodes in same])
        draw_strip(axis, place(rows[name]), rows["fields"].astype(int), shades)
        axis.set_xlim(*span([place(nodes[name]) for nodes in same]))
        axis.set_xlabel(place.label("along the axis" if name == "s" else name))
        axis.set_title(f"{body}: {int(rows['fields'].sum()):,} DoFs, "
                       f"{len(rows)} nodes", loc="left")
    bar = figure.colorbar(shades, ax=list(axes[:, 0]), pad=0.015, aspect=10 * len(bodies))
    low, high = table["fields"].min(), table["fields"].max()
    ticks = round_ticks(low, high)
    bar.set_ticks(ticks, labels=[f"{tick:g}" for tick in ticks])
    bar.ax.yaxis.set_minor_formatter(NullFormatter())
    bar.set_label("fields a node")
    yield "fields", figure


def direction(results, body, rows):
    """The scene's coordinate along the body, or s, the distance from its start."""
    name, _, _, straight = results.frame(body)
    return name if straight else "s"


def span(places):
    low, high = min(map(np.min, places)), max(map(np.max, places))
    return low - 0.01 * (high - low), high + 0.01 * (high - low)


def round_ticks(low, high):
    """Both ends, and what of 1, 2, 5 times powers of ten is well between them."""
    between = [k * 10.**p for p in range(7) for k in (1, 2, 5)]
    return [low, *[t for t in between if 1.2 * low < t < high / 1.2], high]


def draw_strip(axis, places, fields, shades):
    """Each node has the half of the way to its neighbors; below the strip a tick a
    node, and the number itself where there is room for it."""
    order = np.argsort(places)
    places, fields = places[order], fields[order]
    edges = np.concatenate([places[:1], 0.5 * (places[1:] + places[:-1]), places[-1:]])
    axis.pcolormesh(edges, [0., 1.], fields[None, :], cmap=shades.cmap, norm=shades.norm)
    axis.plot(places, np.full(len(places), -0.1), "|", color="0.3", markersize=5,
              markeredgewidth=0.7, clip_on=False)
    axis.set_ylim(-0.2, 1.)
    axis.set_yticks([])
    axis.grid(False)
    for side in ("left", "bottom"):
        axis.spines[side].set_visible(False)
    starts = [0, *(np.nonzero(np.diff(fields))[0] + 1), len(fields)]
    for begin, end in zip(starts, starts[1:]):
        wide = edges[end] - edges[begin] > 0.012 * (1 + len(str(fields[begin]))) * (
            edges[-1] - edges[0])
        if wide:
            shade = shades.to_rgba(fields[begin])
            axis.text(0.5 * (edges[begin] + edges[end]), 0.5, str(fields[begin]),
                      ha="center", va="center", fontsize=9,
                      color="white" if np.dot(shade[:3], (0.3, 0.59, 0.11)) < 0.5
                      else "0.15")


# ---- goals and their bars


def unit_of(results, goal):
    column = goal.split(": ")[-1]
    if column[0] == "f":
        return results.units.get("force")
    if column[0] == "m":
        return moment_unit(results)
    return results.unit(column)


def label_of(goal):
    name, _, column = goal.rpartition(": ")
    shown = NAMES.get(column, column)
    if column[0] in "fm" and len(column) == 2:
        shown = f"${column[0].upper()}_{column[1]}$"
    return f"{name}: {shown}"


def goals_with_bars(results):
    """Each goal's value from its corrected one on, with the bar, over the scale; none
    where richer models had no result."""
    table = results.goals
    rows = [dict(zip(table.columns, row)) for row in zip(*table.columns.values())]
    rows = [row for row in rows if row["scale"] > 0.]
    if not any(row["trusted"] == 1. or row["estimate"] for row in rows):
        return
    figure, axes = new_figure(results, "goals and their error bars", height=0.5)
    figure.set_figheight(1.3 + ROW * len(rows))
    axis = axes[0, 0]
    reach = max([extent(row) for row in rows if row["trusted"] == 1.] or [1.])
    for k, row in enumerate(rows):
        draw_goal(axis, -k, row, reach)
        axis.annotate(in_words(results, row), (1.02, -k), xycoords=("axes fraction", "data"), va="center",
                      fontsize=10, annotation_clip=False)
    axis.axvline(0., color="0.35", linewidth=0.9, zorder=1)
    axis.set_yticks([-k for k in range(len(rows))],
                    labels=[label_of(row["goal"]) for row in rows])
    axis.set_ylim(-len(rows) + 0.4, 0.6)
    axis.set_xlim(-1.08 * reach, 1.08 * reach)
    axis.grid(False, axis="y")
    axis.xaxis.set_major_formatter(lambda x, _: f"{x:g} %")
    axis.set_xlabel("value − corrected value")
    axis.plot([], [], "o", color=COLOURS[0], label="value, with its bar")
    if any(row["tolerance"] > 0. for row in rows):
        axis.add_patch(Rectangle((0, 9), 0, 0, color=ENOUGH, label="tolerance"))
    legend_above(axis, fewest=1)
    yield "goals", figure


def in_words(results, row):
    """The value to a digit more than the bar holds, and the bar."""
    scale = Scale(unit_of(results, row["goal"]), row["value"])
    if row["trusted"] != 1.:
        return f"{scale.factor * row['value']:.3g} {scale.unit}".rstrip() + "\nno bar yet"
    share = max(row["bar"] / row["scale"], LEAST)
    digits = max(3, int(np.ceil(1. - np.log10(share))))
    return (f"{scale.factor * row['value']:.{digits}g} {scale.unit}".rstrip()
            + f"\n± {100. * share:.2g} %")


def extent(row):
    """How far a row reaches, in per cent of the scale."""
    most = abs(row["estimate"]) + max(row["bar"], np.nan_to_num(row["tolerance"]))
    return 100. * most / row["scale"]


def draw_goal(axis, y, row, reach):
    """All in per cent of the scale; what is beyond the others' reach has an arrow."""
    factor = 100. / row["scale"]
    x = -row["estimate"] * factor
    if row["tolerance"] > 0.:
        axis.add_patch(Rectangle((x - row["tolerance"] * factor, y - 0.32),
                                 2. * row["tolerance"] * factor, 0.64, color=ENOUGH,
                                 zorder=0))
    if abs(x) > reach:
        side = np.sign(x)
        axis.annotate("", (side * 1.06 * reach, y), (side * 0.9 * reach, y),
                      arrowprops={"arrowstyle": "->", "color": "0.5"})
        axis.text(side * 0.88 * reach, y, f"{x:+.2g} %", va="center", color="0.4",
                  ha="right" if side > 0. else "left", fontsize=9)
    elif row["trusted"] == 1.:
        axis.errorbar(x, y, xerr=row["bar"] * factor, fmt="o", color=COLOURS[0],
                      capsize=5, markersize=5.5)
    elif row["estimate"]:
        axis.plot(x, y, "o", color="0.5", fillstyle="none", markersize=5.5)


# ---- the passes of a run to a tolerance


def passes_of_a_tolerance(results):
    """Estimated errors and bars of all goals, against DoFs and seconds."""
    table = results.passes
    if not len(table):
        return
    scale, tolerance = {}, {}
    for row in zip(*[results.goals[c] for c in ("goal", "scale", "tolerance")]
                   if len(results.goals) else []):
        scale[row[0]], tolerance[row[0]] = float(row[1]), float(row[2])
    figure, axes = new_figure(results, "passes to the tolerance", columns=2, height=3.5,
                              sharey=True)
    for axis, column, label in zip(axes[0], ("dofs", "seconds"),
                                   ("degrees of freedom", "seconds since the start")):
        goals = list(table.split("goal"))
        for k, (goal, rows) in enumerate(goals):
            size = scale.get(goal) or np.nanmax(np.abs(rows["value"]))
            # Side by side, so that bars do not hide each other.
            shift = 1.025**(k - 0.5 * (len(goals) - 1))
            draw_passes(axis, rows[column] * shift, rows, size, COLOURS[k % len(COLOURS)],
                        label_of(goal))
        for k, limit in enumerate(sorted({100. * tolerance[goal] / scale[goal]
                                          for goal in tolerance if tolerance[goal] > 0.})):
            axis.axhline(limit, color="0.35", linewidth=1., linestyle="--", zorder=1,
                         label="" if k else "tolerance")
        axis.set_xscale("log")
        axis.set_yscale("log")
        axis.yaxis.set_major_formatter(lambda y, _: f"{y:g}")
        widen(axis, table[column])
        axis.set_xlabel(label)
    axes[0, 0].set_ylabel("error of the goal [%]")
    axes[0, 1].legend(loc="upper left", bbox_to_anchor=(1.02, 1.02), fontsize=10,
                      handlelength=1.6, borderaxespad=0.)
    told = "dots: estimated errors; bars above them: what is held of them"
    if (table["trusted"] != 1.).any():
        told += "; open dots: no bar yet"
    figure.supxlabel(told, fontsize=9, color="0.35")
    yield "passes", figure


def widen(axis, values):
    """Room on either side, and ticks that are numbers on a short range."""
    low, high = values.min(), values.max()
    axis.set_xlim(low / 1.25, high * 1.25)
    if high < 30. * low:
        axis.xaxis.set_major_locator(LogLocator(subs=(1., 2., 5.)))
        axis.xaxis.set_major_formatter(lambda x, _: f"{x:,.4g}")
        axis.xaxis.set_minor_formatter(NullFormatter())


def draw_passes(axis, x, rows, size, color, label):
    error = np.maximum(100. * np.abs(rows["estimate"]) / size, 100. * LEAST)
    bar = np.maximum(100. * rows["bar"] / size, error)
    trusted = rows["trusted"] == 1.
    axis.plot(x, np.where(trusted, bar, error), color=color, linewidth=1., alpha=0.5)
    axis.vlines(x[trusted], error[trusted], bar[trusted], color=color, linewidth=1.4)
    axis.plot(x[trusted], bar[trusted], "_", color=color, markersize=9,
              markeredgewidth=1.6)
    axis.plot(x[trusted], error[trusted], "o", color=color, markersize=4.5,
              label=label if trusted.any() else "")
    if not trusted.all():
        axis.plot(x[~trusted], error[~trusted], "o", color=color, fillstyle="none",
                  markersize=6, label="" if trusted.any() else label)
