# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of scripts/plot of contacts that rub: where they stick and slip, shear beside
what pressure allows, and the loop of a load that turns."""

import numpy as np
from matplotlib.colors import ListedColormap

from figures_contact import FEWEST, map_of, patches
from figures_history import curves
from figures_style import COLOURS, Place, Scale, at, legend_above, middle, new_figure

STATES = {"stick": COLOURS[0], "slip": COLOURS[1], "open": "0.75"}
ARROWS = 6  # along a loop


def contact_friction(results):
    for name, patch in patches(results):
        if "state" not in patch.table:
            continue
        yield f"contact_{name}_friction", draw_shear(results, name, patch)
        if patch.is_patch:
            yield f"contact_{name}_states", draw_states(results, name, patch)


def friction_of(results, name):
    return results.summary["contacts"][name]["friction"]["coefficient"]


def tractions(rows):
    """The shear of each row over its area."""
    area = np.where(rows["area"] > 0., rows["area"], np.inf)
    return np.sqrt(sum(rows[f"shear_{c}"]**2 for c in "xyz")) / area


def draw_shear(results, name, patch):
    """Along the line in the middle of the patch on which the pressure varies."""
    direction = patch.across if patch.curved.get(patch.across, 0.) > 0. else patch.along
    if patch.is_patch:
        other = patch.along if direction == patch.across else patch.across
        near = patch.near(0.5)
        places = np.unique(near[other])
        in_middle = places[np.argmin(np.abs(places - middle(patch.active[other])))]
        rows = near.where(np.abs(near[other] - in_middle) <= 1e-6 * patch.extent[other])
        about = f"friction in contact {name}, {at(results, rows, other)}"
    else:
        rows, about = patch.active, f"friction in contact {name}"
        direction = max(patch.plane, key=lambda c: patch.extent[c])
    rows = rows.where(np.argsort(rows[direction]))
    figure, axes = new_figure(results, about, height=3.8)
    axis = axes[0, 0]
    allowed = friction_of(results, name) * rows["pressure"]
    value = Scale(results.unit("pressure"), allowed)
    place = Place(results.units.get("length"), rows[direction])
    axis.plot(place(rows[direction]), value(allowed), color="0.6", linestyle="--", linewidth=1.2,
              label=f"{friction_of(results, name):g} times the pressure")
    shear = tractions(rows)
    axis.plot(place(rows[direction]), value(shear), color="0.3", linewidth=0.8)
    for state, color in STATES.items():
        there = rows["state"] == state
        if np.any(there) and state != "open":
            axis.plot(place(rows[direction][there]), value(shear[there]), "o", color=color,
                      markersize=4.5, label=f"shear, {state}s")
    axis.set_xlabel(place.label(direction))
    axis.set_ylabel(value.label("traction"))
    axis.set_ylim(bottom=0.)
    legend_above(axis, fewest=1)
    return figure


def nearest_on_grid(x, y, wide=240, high=120):
    """The number of the point nearest to each place of a grid over all points, whose
    directions count alike."""
    u, v = ((values - values.min()) / np.ptp(values) for values in (x, y))
    found = np.empty((high, wide), int)
    for k, row in enumerate(np.linspace(0., 1., high)):
        square = (np.linspace(0., 1., wide)[:, None] - u)**2 + (row - v)**2
        found[k] = np.argmin(square, axis=1)
    return found


def draw_states(results, name, patch):
    near, (x, y), places, figure, axis = map_of(
        results, patch, f"what sticks and slips in contact {name}")
    states = [state for state in STATES if np.any(near["state"] == state)]
    numbers = np.array([states.index(state) for state in near["state"]])
    axis.imshow(numbers[nearest_on_grid(x, y)], origin="lower", aspect="auto",
                cmap=ListedColormap([STATES[state] for state in states]), vmin=-0.5,
                vmax=len(states) - 0.5, interpolation="nearest",
                extent=[*places[0]([x.min(), x.max()]), *places[1]([y.min(), y.max()])])
    axis.plot(places[0](x), places[1](y), ".", color="0.2", markersize=1.5)
    for state in states:
        axis.plot([], [], "s", color=STATES[state], label=state)
    axis.legend(loc="center left", bbox_to_anchor=(1.01, 0.5), borderaxespad=0.)
    return figure


def places_along(x, y):
    """At equal distances along a polygon: the number of a side, and where on it."""
    ends = np.concatenate([[0.], np.cumsum(np.hypot(np.diff(x), np.diff(y)))])
    for place in ends[-1] * (np.arange(ARROWS) + 0.5) / ARROWS:
        k = int(np.searchsorted(ends, place)) - 1
        yield k, (place - ends[k]) / (ends[k + 1] - ends[k])


def loop(results):
    """The force of the support that changes most over the displacement of a probe that
    does, where a path with friction turns round."""
    path, table = results.summary.get("path"), results.history
    probes = curves(table, "probe", "u")
    supports = curves(table, "support", "f")
    if not path or len(table) < FEWEST or not probes or not supports:
        return
    moved, force = (max(all_of, key=lambda curve: curve.range) for all_of in (probes, supports))
    ways = np.diff(moved.values)
    if not (np.any(ways > 0.) and np.any(ways < 0.)):
        return
    figure, axes = new_figure(results, "loop of load and displacement", height=4.6)
    axis = axes[0, 0]
    place = Scale(results.units.get("length"), moved.values)
    value = Scale(results.units.get("force"), force.values)
    x, y = moved.upwards() * place(moved.values), force.upwards() * value(force.values)
    # From the undeformed state.
    x, y = np.concatenate([[0.], x]), np.concatenate([[0.], y])
    axis.plot(x, y, color=COLOURS[0], marker="o", markersize=3.5, linewidth=1.2)
    for k, t in places_along(x / np.ptp(x), y / np.ptp(y)):
        tip, tail = ((1. - s) * np.array([x[k], y[k]]) + s * np.array([x[k + 1], y[k + 1]])
                     for s in (t, 0.))
        axis.annotate("", xy=tip, xytext=tail, arrowprops={
            "arrowstyle": "-|>", "color": COLOURS[0], "mutation_scale": 15})
    work = " ".join(filter(None, (results.units.get("force"), results.units.get("length"))))
    axis.text(0.03, 0.95, f"dissipated on the way: {path['dissipated']:.4g} {work}".rstrip(),
              transform=axis.transAxes, va="top")
    axis.set_xlabel(place.label(f"{moved.symbol()} of {moved.name}"))
    axis.set_ylabel(value.label(f"{force.symbol()} of support {force.name}"))
    yield "loop", figure
