# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of scripts/plot of natural modes, buckling modes and the harmonic response.

A mode is drawn in isometric projection, colored by its displacement, over the edges of
the undeformed bodies. Slender bodies are drawn thicker than they are."""

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection

from figures_data import DISPLACEMENTS
from figures_stress import Isometric, draw_facets, ends_of, in_steps
from figures_style import COLOURS, DASHES, NAMES, Scale, legend_above, new_figure, plt
from figures_surface import (MOST_FACES, datasets, edges_of_bodies, fine_facets,
                             outer_surface, parts_of)

MOST_MODES = 12  # pictures of natural modes, and of buckling modes
MOST_PROBES = 6  # curves of a response
SMALL = 3.6  # inches of the width of a mode
FACETS = 6000  # of a mode, enough for its size
AMPLITUDE = 0.12  # of the longest extent drawn: the largest displacement drawn
OF_THICKNESS = 0.4  # of the thickness drawn, if that is less
ROUNDING = 1e-9  # of the largest amplitude: amplitudes below are not drawn
SPACING = 0.03  # of the range of frequencies: least distance of two labels


# ---- mode shapes


def mode_shapes(results):
    """One small picture per mode; none without VTU files."""
    for name in ("mode", "buckling"):
        for number, path in datasets(results.folder / f"{name}.pvd")[:MOST_MODES]:
            surface = outer_surface(parts_of(path))
            if surface is not None and len(surface) <= MOST_FACES:
                yield f"{name}_{int(number):04}", draw_mode(surface)


def draw_mode(surface):
    view = Isometric(surface.places)
    amplitude, factor = amplification(surface, view)
    before, drawn = view(surface.places), view(surface.places + factor * surface.moved)
    # Of all modes alike: the length of a row of the projection is sqrt(1.5).
    room = np.sqrt(1.5) * amplitude
    low, high = before.min(axis=(0, 1))[:2] - room, before.max(axis=(0, 1))[:2] + room
    figure, axis = plt.subplots(
        figsize=(SMALL, SMALL * (high[1] - low[1]) / (high[0] - low[0]) + 0.2))
    axis.set_axis_off()
    axis.set_aspect("equal")
    axis.set_xlim(low[0], high[0])
    axis.set_ylim(low[1], high[1])
    sizes = np.linalg.norm(surface.moved, axis=2)
    facets = fine_facets(np.dstack([drawn, sizes]), FACETS)
    colors = ScalarMappable(cmap="viridis").to_rgba(facets[:, :, 3].mean(axis=1))
    edges = edges_of_bodies(surface.places, surface.bodies)
    draw_facets(axis, facets, colors, in_steps(ends_of(edges, drawn), 4))
    axis.add_collection(LineCollection(ends_of(edges, before)[:, :, :2], colors="0.6",
                                       linewidths=0.7, linestyles="--"))
    larger = [f"{name} {int(s):,} times" for name, s in zip("xyz", view.stretch) if s > 1.]
    if larger:
        figure.supxlabel("enlarged: " + ", ".join(larger), fontsize=7, color="0.35")
    return figure


def amplification(surface, view):
    """The largest displacement as drawn, and the factor of the shape for it, whose sign
    makes the largest component positive."""
    largest = surface.moved.flat[np.argmax(np.abs(surface.moved))]
    extent = np.ptp(surface.places.reshape(-1, 3) * view.stretch, axis=0).max()
    amplitude = min(AMPLITUDE * extent, OF_THICKNESS * view.thickness)
    size = np.linalg.norm(surface.moved * view.stretch, axis=2).max()
    return amplitude, np.sign(largest) * amplitude / size


# ---- harmonic response


def harmonic_response(results):
    """Amplitude and phase of the largest displacement component of each probe, with the
    natural frequencies within the range."""
    curves = largest_amplitudes(results.response)
    if not curves:
        return
    figure, axes = new_figure(results, "harmonic response", rows=2, height=2.9, sharex=True)
    amplitudes, phases = axes[:, 0]
    scale = Scale(results.units.get("length"), *[rows[c] for _, c, rows in curves])
    least = ROUNDING * max(rows[c].max() for _, c, rows in curves)
    for k, (probe, column, rows) in enumerate(curves):
        style = {"linestyle": DASHES[k % len(DASHES)], "color": COLOURS[k]}
        values = np.where(rows[column] > least, rows[column], np.nan)
        amplitudes.semilogy(rows["frequency"], scale(values), **style,
                            label=f"{NAMES[column]} of {probe}")
        phases.plot(*without_jumps(rows["frequency"], np.where(
            rows[column] > least, rows[f"{column} phase"], np.nan)), **style)
    mark_modes(results, amplitudes, phases)
    amplitudes.set_ylabel(scale.label("amplitude"))
    phases.set_ylabel("phase [°]")
    phases.set_xlabel("frequency [Hz]")
    phases.set_ylim(-190., 190.)
    phases.set_yticks(range(-180, 181, 90))
    legend_above(amplitudes, fewest=1)
    figure.align_ylabels()
    yield "response", figure


def largest_amplitudes(table):
    """(probe, column, rows ordered by frequency) of the probes with the largest
    amplitudes, in the order of the table. A probe between plies has its first ply."""
    found = []
    for probe, rows in table.split("probe") if len(table) else ():
        _, first = np.unique(rows["frequency"], return_index=True)
        rows = rows.where(first)
        column = max(DISPLACEMENTS, key=lambda c: rows[c].max())
        found.append((rows[column].max(), probe, column, rows))
    kept = sorted((f[0] for f in found), reverse=True)[:MOST_PROBES]
    return [rest for size, *rest in found
            if size >= kept[-1] and size > ROUNDING * kept[0]][:MOST_PROBES]


def without_jumps(frequency, phase):
    """The curve, interrupted where the angle passes 180 degrees."""
    at = np.flatnonzero(np.abs(np.diff(phase)) > 180.) + 1
    return np.insert(frequency, at, frequency[at]), np.insert(phase, at, np.nan)


def mark_modes(results, amplitudes, phases):
    """Draws dashed lines at the natural frequencies within the range, with the numbers of
    the modes; close ones share a label."""
    if not len(results.modes):
        return
    low, high = amplitudes.dataLim.intervalx
    modes = results.modes.where((results.modes["analysis"] == "modes")
                                & (results.modes["value"] >= low)
                                & (results.modes["value"] <= high))
    for k, frequency in enumerate(modes["value"]):
        for axis in (amplitudes, phases):
            axis.axvline(frequency, color="0.45", linewidth=1., linestyle="--", zorder=1,
                         label="natural frequencies" if k == 0 else None)
    close = np.flatnonzero(np.diff(modes["value"]) > SPACING * (high - low)) + 1
    for group in np.split(modes["number"].astype(int), close) if len(modes) else ():
        text = f"{group[0]}" if len(group) == 1 else f"{group[0]}–{group[-1]}"
        amplitudes.annotate(text, (modes["value"][modes["number"] == group[-1]][0], 1.),
                            xycoords=("data", "axes fraction"), xytext=(2, -9),
                            textcoords="offset points", fontsize=8, color="0.35")
