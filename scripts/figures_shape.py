# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of scripts/plot of the bodies as they deform, from the last step's VTU.

What is seen is the outer surface, from the side in which it moves most; a compact
scene is also seen along its other direction. Displacements are enlarged by a round
number where they would not be seen, and the picture says so; never so far that bodies
that meet are drawn into each other, since gaps are not enlarged."""

import base64
import struct
import xml.etree.ElementTree as ElementTree
import zlib

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import Normalize
from matplotlib.patches import Ellipse
from matplotlib.ticker import MaxNLocator

from figures_style import (BESIDE, WIDTH, Place, Scale, drawn_larger, exaggeration,
                           new_figure, plt)

TYPES = {"Float32": "<f4", "Int32": "<i4", "UInt8": "<u1"}
VISIBLE = 0.05  # of the height drawn: displacements below are enlarged
WANTED = 0.12  # of it, if they are
OVERLAP = 0.003  # of it, that is not seen
CORNER = 0.8  # cosine between sides that meet at an edge worth a line
COMPACT = 0.15  # of the largest extent: what is seen from both sides
MOST_FACES = 200000  # a picture of more takes minutes


# ---- reading


def decode(text, kind):
    """The numbers of a base64 array in blocks of zlib, the VTK XML format."""
    text = "".join(text.split())
    n_blocks = struct.unpack("<I", base64.b64decode(text[:8])[:4])[0]
    header_bytes = 4 * (3 + n_blocks)
    header_text = 4 * ((header_bytes + 2) // 3)
    sizes = struct.unpack(f"<{3 + n_blocks}I", base64.b64decode(
        text[:header_text])[:header_bytes])[3:]
    packed, data = base64.b64decode(text[header_text:]), []
    for size in sizes:
        data.append(zlib.decompress(packed[:size]))
        packed = packed[size:]
    return np.frombuffer(b"".join(data), kind)


def last_files(folder):
    """The VTU of the last load step: one, or a part a process."""
    collection = folder / "solution.pvd"
    if not collection.exists():
        return []
    names = [entry.get("file") for entry in
             ElementTree.parse(collection).iter("DataSet")]
    if not names:
        return []
    last = folder / names[-1]
    if last.suffix == ".pvtu":
        return [folder / piece.get("Source")
                for piece in ElementTree.parse(last).iter("Piece")]
    return [last]


def blocks(path):
    """(positions, displacements, bodies) of the cells with equally many points, each
    cell's on a grid of n x n x n: (cells, n, n, n, 3)."""
    piece = ElementTree.parse(path).getroot().find(".//Piece")
    if piece is None or int(piece.get("NumberOfCells")) == 0:
        return
    arrays = {array.get("Name") or "points":
              decode(array.text, TYPES[array.get("type")])
              for array in piece.iter("DataArray")
              if array.get("Name") in (None, "displacement", "body", "offsets")}
    points = arrays["points"].reshape(-1, 3).astype(float)
    moved = arrays["displacement"].reshape(-1, 3).astype(float)
    ends = arrays["offsets"]
    sizes = np.diff(ends, prepend=0)
    # Points stand cell by cell, those of a cell line by line, layer by layer.
    for size in np.unique(sizes):
        n = int(round(size ** (1 / 3)))
        first = (ends - size)[sizes == size]
        index = first[:, None] + np.arange(size)
        shape = (len(first), n, n, n, 3)
        yield ((points - moved)[index].reshape(shape), moved[index].reshape(shape),
               arrays["body"][index[:, 0]].astype(int))


# ---- the outer surface


def faces_of(cells):
    """The six sides of each cell of (cells, n, n, n, 3): (6 cells, n, n, 3)."""
    return np.concatenate([cells[:, 0], cells[:, -1], cells[:, :, 0], cells[:, :, -1],
                           cells[:, :, :, 0], cells[:, :, :, -1]])


def outer_surface(files):
    """(quadrilaterals as they were, their displacements), each (count, 4, 3), and
    their bodies: those of sides that belong to one cell of a body only."""
    sides, moves, bodies = [], [], []
    for path in files:
        for cells, moved, body in blocks(path):
            sides.append(faces_of(cells))
            moves.append(faces_of(moved))
            bodies.append(np.tile(body, 6))
    if not sides:
        return None
    size = max(np.abs(side).max() for side in sides)
    corners = np.concatenate([side[:, ::side.shape[1] - 1, ::side.shape[1] - 1].reshape(
        -1, 4, 3) for side in sides])
    middles = np.round(corners.mean(axis=1) / size, 5)
    keys = np.column_stack([np.concatenate(bodies), middles])
    _, inverse, counts = np.unique(keys, axis=0, return_inverse=True,
                                   return_counts=True)
    outside = counts[inverse.ravel()] == 1
    pieces = []
    begin = 0
    for side, moved, body in zip(sides, moves, bodies):
        mask = outside[begin:begin + len(side)]
        begin += len(side)
        pieces.append((quadrilaterals(side[mask]), quadrilaterals(moved[mask]),
                       np.repeat(body[mask], (side.shape[1] - 1) ** 2)))
    return tuple(np.concatenate(part) for part in zip(*pieces))


def quadrilaterals(faces):
    """Those between neighbouring points of (faces, n, n, 3)."""
    quads = np.stack([faces[:, :-1, :-1], faces[:, 1:, :-1], faces[:, 1:, 1:],
                      faces[:, :-1, 1:]], axis=3)
    return quads.reshape(-1, 4, 3)


def edges_of_bodies(places, bodies):
    """(quadrilateral, its corner where the edge begins), an edge a row: where sides
    meet at an angle."""
    normals = np.cross(places[:, 2] - places[:, 0], places[:, 3] - places[:, 1])
    normals /= np.linalg.norm(normals, axis=1)[:, None] + 1e-300
    middles = 0.5 * (places + np.roll(places, -1, axis=1))
    keys = np.column_stack([np.repeat(bodies, 4), np.round(
        middles.reshape(-1, 3) / np.abs(places).max(), 5)])
    _, edge = np.unique(keys, axis=0, return_inverse=True)
    order = np.argsort(edge.ravel(), kind="stable")
    first, second = order[:-1], order[1:]
    pairs = edge.ravel()[first] == edge.ravel()[second]
    first, second = first[pairs], second[pairs]
    cosine = np.abs(np.sum(normals[first // 4] * normals[second // 4], axis=1))
    return np.column_stack([first // 4, first % 4])[cosine < CORNER]


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
    most = WANTED * extent / largest
    for table in results.contacts.values():
        closed = table["initial_gap"] - table["gap"]
        near = closed > 0.
        if near.any():
            most = min(most, np.min((np.maximum(table["initial_gap"][near], 0.)
                                     + OVERLAP * extent) / closed[near]))
    factors = np.array([k * 10.**p for p in range(15) for k in (1, 2, 5)])
    return int(factors[factors <= max(most, 1.)][-1])


def deformed_shape(results):
    """The last load step's bodies; none without their VTU."""
    surface = outer_surface(last_files(results.folder))
    if surface is None or len(surface[0]) > MOST_FACES:
        return
    places, moved, bodies = surface
    edges = edges_of_bodies(places, bodies)
    for number, view in enumerate(views(places, moved)):
        yield "deformed" + ("" if number == 0 else "_from_the_other_side"), draw_view(
            results, places, moved, edges, view)


def draw_view(results, places, moved, edges, view):
    right, up, depth = view
    flat, shift = places[:, :, [right, up]], moved[:, :, [right, up]]
    width, height = (np.ptp(flat + shift, axis=(0, 1)) + 1e-300)
    stretch = exaggeration(width, height, wanted=5.)
    factor = enlargement(results, shift[:, :, 1], height)
    now = flat + factor * shift
    both = np.concatenate([flat, now])
    place = [Place(results.units.get("length"), both[:, :, c]) for c in range(2)]
    drawn = [np.stack([place[c](at[:, :, c]) for c in range(2)], axis=2)
             for at in (flat, now)]
    sizes = np.linalg.norm(moved, axis=2)
    scale = Scale(results.units.get("length"), sizes)

    about = "deformed" + (f", displacements drawn {factor:,} times as large"
                          if factor > 1 else "")
    ratio = np.ptp(both[:, :, 1]) * stretch[1] / (np.ptp(both[:, :, 0]) * stretch[0])
    panel = min((WIDTH - BESIDE) * ratio + 0.5, 6.5)
    figure, axes = new_figure(results, about, height=max(panel, 1.6))
    axis = axes[0, 0]
    axis.grid(False)
    axis.add_collection(PolyCollection(drawn[0], facecolors="0.9", edgecolors="0.9",
                                       linewidths=0.4))
    order = np.argsort(places[:, :, depth].mean(axis=1) * (-1 if depth == 0 else 1))
    shades = ScalarMappable(Normalize(0., scale(sizes).max() or 1.),
                            plt.get_cmap("viridis"))
    colours = shades.to_rgba(scale(sizes.mean(axis=1)))
    axis.add_collection(PolyCollection(drawn[1][order], facecolors=colours[order],
                                       edgecolors=colours[order], linewidths=0.3))
    side, corner = edges.T
    axis.add_collection(LineCollection(
        np.stack([drawn[1][side, corner], drawn[1][side, (corner + 1) % 4]], axis=1),
        colors="0.2", linewidths=0.5))
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
        centre = [place[0](through[right]), place[1](through[up])]
        if is_plane and abs(direction[depth]) < 1e-6:
            along = np.array([direction[up] * place[0].factor,
                              -direction[right] * place[1].factor])
            far = 1e3 * max(np.ptp(axis.get_xlim()), np.ptp(axis.get_ylim()))
            along *= far / np.linalg.norm(along)
            axis.add_collection(LineCollection([[centre - along, centre + along]],
                                               colors="0.35", linewidths=1.2))
        elif not is_plane and abs(direction[depth]) > 1. - 1e-6:
            radius = float(entries["Radius"])
            axis.add_patch(Ellipse(centre, 2. * radius * place[0].factor,
                                   2. * radius * place[1].factor, facecolor="none",
                                   edgecolor="0.35", linewidth=1.2))
