# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure of scripts/plot of the load steps: forces and moments over a displacement."""

from dataclasses import dataclass

import numpy as np

from figures_data import NEGLIGIBLE, Table
from figures_style import (COLOURS, DASHES, Scale, legend_above, moment_unit, new_figure,
                           show_no_less)

MOST_CURVES = 6  # in one panel


@dataclass
class Curve:
    """A column of history.csv: KIND:NAME:QUANTITY, such as support:clamp:mx."""

    kind: str
    name: str
    letter: str  # f, m or u
    component: str  # x, y or z
    values: np.ndarray

    @property
    def range(self):
        return np.ptp(self.values)

    @property
    def largest(self):
        return np.abs(self.values).max()

    def upwards(self):
        """The sign that makes the largest value positive."""
        return -1. if -self.values.min() > self.values.max() else 1.

    def symbol(self):
        minus = "-" if self.upwards() < 0. else ""
        letter = self.letter if self.letter == "u" else self.letter.upper()
        return f"${minus}{letter}_{self.component}$"


def curves(table, kind, letter):
    """All components of one quantity of all supports, contacts or probes."""
    found = []
    for header, values in table.columns.items():
        parts = header.split(":")
        if len(parts) == 3 and parts[0] == kind and parts[2] in (
                letter + c for c in "xyz"):
            found.append(Curve(kind, parts[1], letter, parts[2][1], values))
    return found


def load_history(results):
    """Forces of contacts, or of supports where nothing touches, and the moments of
    supports below them, over the displacement of a probe that changes most. Moments of
    contacts are about the scene's origin and say nothing that their forces do not."""
    table = with_trials(results)
    probes = curves(table, "probe", "u")
    if "load_factor" not in table or len(table) < 2 or not probes:
        return
    moved = max(probes, key=lambda curve: curve.range)
    forces, moments = without_rounding(
        largest_components(curves(table, "contact", "f"))
        or largest_components(curves(table, "support", "f")),
        largest_components(curves(table, "support", "m")), longest(results))
    panels = [panel for panel in (forces, moments) if panel]
    if not panels:
        return
    figure, axes = new_figure(results, "load history", rows=len(panels),
                              height=3.6 if len(panels) == 1 else 2.9,
                              sharex=True)
    place = Scale(results.units.get("length"), moved.values)
    x = moved.upwards() * place(moved.values)
    for axis, panel in zip(axes[:, 0], panels):
        draw_curves(axis, results, x, panel)
    failure = results.summary.get("first_failure")
    if failure:
        mark_failure(axes[0, 0], results, table, x, panels[0], failure)
    for axis in axes[:, 0]:
        legend_above(axis, fewest=1)
    show_no_less(axes[0, 0], "x")
    axes[-1, 0].set_xlabel(place.label(f"{moved.symbol()} of {moved.name}"))
    figure.align_ylabels()
    yield "history", figure


def scale_of(results, panel):
    unit = results.units.get("force") if panel[0].letter == "f" else moment_unit(results)
    return Scale(unit, *[curve.values for curve in panel])


def draw_curves(axis, results, x, panel):
    scale = scale_of(results, panel)
    for k, curve in enumerate(panel):
        axis.plot(x, curve.upwards() * scale(curve.values), marker="o", markersize=4,
                  linestyle=DASHES[k % len(DASHES)], color=COLOURS[k % len(COLOURS)],
                  label=f"{curve.symbol()} of {curve.kind} {curve.name}")
    show_no_less(axis, "y")
    axis.set_ylabel(scale.label("force" if panel[0].letter == "f" else "moment"))


def mark_failure(axis, results, table, x, panel, failure):
    """On the curve that is the largest there."""
    k = int(np.argmin(np.abs(table["load_factor"] - failure["load_factor"])))
    curve = max(panel, key=lambda curve: np.abs(curve.values[k]))
    axis.plot(x[k], curve.upwards() * scale_of(results, panel)(curve.values[k]),
              marker="X", markersize=11, linestyle="none", color=COLOURS[1], zorder=3,
              label=f"first failure: ply {failure['ply']} of {failure['body']}, "
                    f"{failure['mode']}")


def with_trials(results):
    """The load steps, and in the order of load factors those that the search for the
    first failure has tried."""
    if not len(results.failure):
        return results.history
    table = Table((), ())
    table.columns = {name: np.concatenate([results.history[name], column])
                     for name, column in results.failure.columns.items()
                     if name in results.history}
    order = np.argsort(table["load_factor"], kind="stable")
    table.columns = {name: column[order] for name, column in table.columns.items()}
    return table


def largest_components(found):
    """For each name its component that changes most, without the idle ones; the names
    that change most, in the order of the table."""
    best = {}
    for curve in sorted(found, key=lambda curve: curve.range):
        best[curve.name] = curve
    most = max((curve.range for curve in best.values()), default=0.)
    kept = sorted((curve for curve in best.values() if curve.range > NEGLIGIBLE * most),
                  key=lambda curve: -curve.range)[:MOST_CURVES]
    return [curve for curve in found if any(curve is other for other in kept)]


def without_rounding(forces, moments, length):
    """Both, but none of them where all of it is nothing beside the other over the
    scene's length: a point holds no moment, and a couple asks for no force."""
    force, moment = (max((curve.largest for curve in panel), default=0.)
                     for panel in (forces, moments))
    return (forces if force * length > NEGLIGIBLE * moment else [],
            moments if moment > NEGLIGIBLE * force * length else [])


def longest(results):
    """Of the bodies."""
    return max((float(entries["Length"]) for name, entries in results.scene.items()
                if name.startswith("Body ") and "Length" in entries), default=1.)
