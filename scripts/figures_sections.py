# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of scripts/plot over a section: contours of cuts, and the meshes."""

from collections import defaultdict

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import BoundaryNorm, to_rgb
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.path import Path as MplPath
from matplotlib.ticker import FixedFormatter, FixedLocator, MaxNLocator

from figures_data import magnitude, own_scales, stress, stresses_to_show
from figures_style import (COLOURS, LABEL, NAMES, WIDTH, Frame, Place, Plies, Scale,
                           apart, at, color_bar, drawn_larger, exaggeration,
                           new_figure, tell_zero)

# Colors of the first, second and third scale of a panel.
TWO_SIGNS = ("RdBu_r", "PuOr_r", "BrBG_r")
ONE_SIGN = ("cividis", "YlGn_r", "copper")


# ---- cuts


def section_cuts(results):
    for name, cut in results.cuts.items():
        for body, rows in cut.items():
            axis, across, up, _ = results.frame(body)
            columns = stresses_to_show([rows], axis, across, up)
            # Soft cores and contacts stretch through the thickness.
            if magnitude([rows], f"e{up}{up}") > magnitude([rows], f"e{axis}{axis}"):
                columns.append(f"e{up}{up}")
            if columns:
                yield (f"section_{name}" + (f"_{body}" if len(cut) > 1 else ""),
                       draw_cut(results, body, rows, columns))
            else:
                print(f"{name}: all stresses in {body} are zero, not drawn")


def draw_cut(results, body, table, columns):
    axis, across, up, straight = results.frame(body)
    # z stands upright even where the section lies on its side.
    x, z = (up, across) if across == "z" else (across, up)
    station = at(results, table, *(axis if straight else "xyz"))
    plies = Plies(table, z)
    flat = results.is_flat_laminate(results.section_of(body))
    edges = plies.thickened() if flat else None
    frame = Frame(len(columns), np.ptp(table[x]), np.ptp(table[z]), len(plies),
                  free=edges is not None, true=not flat)
    figure, axes = frame.figure(results, f"{body}, section at {station}", len(columns))
    place = {c: Place(results.units.get("length"), table[c]) for c in (x, z)}
    label = place[z].label(z)
    position = {x: place[x], z: place[z]}
    if edges is not None:
        position[z] = lambda values: place[z](np.interp(values, plies.edges, edges))
        label += "\nthin plies enlarged"
    materials = results.materials(body)
    for panel, column in zip(axes, columns):
        parts = [Part([rows], column, Scale(results.unit(column), rows[column]), names)
                 for names, rows in own_scales(materials, table, column)]
        contour(panel, parts, position, frame)
        if edges is not None:
            show_edges(panel, place[z](edges), place[z](plies.edges), frame.height)
    frame.label(axes, place[x].label(x), label)
    tell_zero(figure, [c for c in (stress(up, axis), stress(axis, axis))
                       if c not in columns])
    return figure


def show_edges(panel, drawn, values, height):
    """Ticks at the plies' edges, which say what the drawn places stand for."""
    kept = apart(drawn, LABEL / height * np.ptp(drawn))
    panel.yaxis.set_major_locator(FixedLocator(drawn[kept]))
    panel.yaxis.set_major_formatter(FixedFormatter([f"{values[k]:.5g}" for k in kept]))


class Part:
    """Tables that are drawn on one color scale, and what they are called beside the
    bar where there are several."""

    def __init__(self, tables, column, scale, names=""):
        self.tables, self.column, self.scale, self.names = tables, column, scale, names

    def values(self):
        return np.concatenate([self.scale(table[self.column]) for table in self.tables])

    def label(self):
        shown = self.scale.label(NAMES[self.column])
        return f"{self.names}: {shown}" if self.names else shown


def shades(values, number):
    """(levels, what turns values into colors); about zero where they have two signs.
    Scales of different numbers have different colors."""
    low, high = values.min(), values.max()
    two_signs = low < -0.1 * high and high > -0.1 * low
    if two_signs:
        high = max(-low, high)
        low = -high
    # Within a thousandth it is constant, and its variation is rounding.
    if not high - low > 1e-3 * max(-low, high):
        margin = 0.05 * max(-low, high) or 1.
        low, high = low - margin, high + margin
    levels = MaxNLocator(14).tick_values(low, high)
    colors = plt.get_cmap((TWO_SIGNS if two_signs else ONE_SIGN)[number % 3])
    return levels, ScalarMappable(BoundaryNorm(levels, colors.N), colors)


def contour(panel, parts, position, frame):
    """Cell by cell, so that the jumps between cells stay visible. The positions are
    of the coordinates to the right and upwards, in this order."""
    tables = [table for part in parts for table in part.tables]
    # Known limits: without, each cell makes matplotlib look through all others.
    for limits, c in zip((panel.set_xlim, panel.set_ylim), position):
        along = np.concatenate([position[c](table[c]) for table in tables])
        margin = 0.02 * np.ptp(along)
        limits(along.min() - margin, along.max() + margin)
    panel.autoscale(False)
    outlines = []
    for number, (part, bar) in enumerate(zip(parts, frame.bars(len(parts)))):
        levels, colors = shades(part.values(), number)
        for table in part.tables:
            for _, cell in table.split("cell"):
                x, z, v = cell_grids(cell, position, part)
                panel.contourf(x, z, v, reached(levels, v), cmap=colors.cmap,
                               norm=colors.norm, antialiased=False)
                outlines.append(outline(x, z))
        color_bar(panel, colors, part.label(), *bar)
    panel.add_collection(LineCollection(outlines, colors="0.25", linewidths=0.5
                                        if len(outlines) <= 200 else 0.2))
    # They stay within the panel, and asking each for its place takes long.
    for artist in panel.collections:
        artist.set_in_layout(False)


def outline(x, z):
    """Around the grid of a cell."""
    k = np.r_[0:x.size].reshape(x.shape)
    edge = np.concatenate([k[0], k[1:, -1], k[-1, -2::-1], k[-2::-1, 0]])
    return np.column_stack([x.flat[edge], z.flat[edge]])


def reached(levels, values):
    """The levels around these values: matplotlib draws an artist for each, seen or
    not."""
    first = np.searchsorted(levels[1:-1], values.min())
    last = np.searchsorted(levels[1:-1], values.max(), side="right")
    return levels[first:last + 2]


def cell_grids(cell, position, part):
    i, j = cell["i"].astype(int), cell["j"].astype(int)
    shape = i.max() + 1, j.max() + 1
    grids = []
    for values in (*(position[c](cell[c]) for c in position),
                   part.scale(cell[part.column])):
        grid = np.full(shape, np.nan)
        grid[i, j] = values
        grids.append(grid)
    return grids


# ---- the sections' meshes


class SectionPicture:
    """The mesh of a section: cells by material and angle, boundaries by name."""

    def __init__(self, table):
        self.cells, self.fabrics, self.edges = [], [], defaultdict(list)
        self.corners = []
        for row in range(len(table)):
            angle = f"{float(table['angle'][row]):g}°"
            self.fabrics.append(f"{table['material'][row]}, {angle}")
            sides = [np.array([p.split() for p in table[f"side_{k}"][row].split(";")],
                              float) for k in range(1, 5)]
            self.cells.append(np.concatenate([side[:-1] for side in sides]))
            self.corners.append(np.array([side[0] for side in sides]))
            for k, side in enumerate(sides, 1):
                # A column without any name has been read as numbers.
                name = str(table[f"boundary_{k}"][row])
                if name not in ("", "nan"):
                    self.edges[name].append(side)
        points = np.concatenate(self.cells)
        self.low, self.high = points.min(axis=0), points.max(axis=0)
        self.size = self.high - self.low
        # Tables of earlier versions have no normals: their plies are level.
        n = len(table)
        self.normals = np.column_stack([table["normal_x"], table["normal_z"]]
                                       if "normal_x" in table else
                                       [np.zeros(n), np.ones(n)])
        self.angles = np.radians(np.array(table["angle"], float))
        self.plies = np.array(table["ply"], int)

    def has_walls(self):
        """Whether any ply lies in another plane than that of x and y."""
        return bool((self.normals[:, 1] < 1.).any())

    def marked_cells(self, most=48):
        """Cells for the marks of plane and fiber: in each ply every so many."""
        marked = []
        plies = sorted(set(self.plies))
        for ply in plies:
            cells = np.flatnonzero(self.plies == ply)
            wanted = max(1, most // len(plies))
            step = max(1, -(-len(cells) // wanted))
            marked += list(cells[step // 2::step])
        return marked

    def label_places(self, name):
        """(point, outward normal) on the boundary's edges, the best first: near
        the middle of them all, of those as near the upper right one."""
        points, normals = [], []
        for side in self.edges[name]:
            along = side[-1] - side[0]
            middle = (side[len(side) // 2] + side[(len(side) - 1) // 2]) / 2
            points += [side[0], middle]
            # Cells run counter-clockwise, so outside is to the right.
            normals += 2 * [np.array([along[1], -along[0]])]
        points = np.array(points)
        away = np.linalg.norm((points - points[1::2].mean(axis=0)) / self.size, axis=1)
        away[::2] += 0.1  # rather the middle of an edge than a corner
        upper_right = points @ (1, 2) / self.size.max()
        order = sorted(range(len(points)), key=lambda k: (
            round(away[k], 3), -round(upper_right[k], 3)))
        return [(points[k], normals[k]) for k in order]


def section_meshes(results):
    for name, table in results.sections.items():
        if len(table):
            yield f"section_{name}", draw_section(results, name, SectionPicture(table))


def draw_section(results, name, picture):
    scale = Scale(results.units.get("length"), picture.low, picture.high)
    stretch = np.array(exaggeration(*picture.size, wanted=3.)
                       if results.is_flat_laminate(name) else (1, 1))
    drawn = picture.size * stretch
    # The section fills what labels and legend leave of the width, or the height.
    longest = max((len(boundary) for boundary in picture.edges), default=0)
    inches = np.array([0.15 + 0.08 * longest, 0.32])
    inch = max(drawn[0] / (0.66 * WIDTH - 2 * inches[0]), drawn[1] / 4.2)
    pad = inches * inch / stretch
    figure, axes = new_figure(results, f"section {name}, {len(picture.cells)} cells",
                              height=drawn[1] / inch + 2 * inches[1] + 0.3)
    axis = axes[0, 0]
    axis.grid(False)
    axis.set_aspect(stretch[1] / stretch[0])
    axis.set_xlim(*scale([picture.low[0] - pad[0], picture.high[0] + pad[0]]))
    axis.set_ylim(*scale([picture.low[1] - pad[1], picture.high[1] + pad[1]]))
    axis.set_xlabel(scale.label("x") + drawn_larger(stretch[0]))
    axis.set_ylabel(scale.label("z") + drawn_larger(stretch[1]))

    fabrics = list(dict.fromkeys(picture.fabrics))
    shade = {fabric: tint(COLOURS[k % len(COLOURS)], 0.3 - 0.1 * (k // len(COLOURS)))
             for k, fabric in enumerate(fabrics)}
    thin = min(0.8, 30. / len(picture.cells)**0.5 / 4)
    axis.add_collection(PolyCollection(
        [scale(cell) for cell in picture.cells], edgecolors="0.45", linewidths=thin,
        facecolors=[shade[fabric] for fabric in picture.fabrics]))
    handles = [Patch(facecolor=shade[fabric], edgecolor="0.45", label=fabric)
               for fabric in fabrics]
    colors = {boundary: COLOURS[(k + 1) % len(COLOURS)]
               for k, boundary in enumerate(sorted(picture.edges))}
    for boundary, color in colors.items():
        axis.add_collection(LineCollection(
            [scale(side) for side in picture.edges[boundary]], colors=color,
            linewidths=2.4, capstyle="round", zorder=3))
        handles.append(Line2D([], [], color=color, linewidth=2.4, label=boundary))
    if picture.has_walls():
        handles += mark_plies(axis, picture, scale)
    axis.legend(handles=handles, loc="center left", bbox_to_anchor=(1.02, 0.5))
    label_boundaries(figure, axis, picture, scale, colors)
    return figure


def mark_plies(axis, picture, scale):
    """Of each ply in some cells: a line in its plane, and on it how far the fiber goes
    sideways on its way along +y, which points away from who looks. What they mean, for
    the legend."""
    ink, half = "0.1", 0.42
    planes, middles, ways = [], [], []
    for cell in picture.marked_cells():
        corners, normal = picture.corners[cell], picture.normals[cell]
        along = np.array([normal[1], -normal[0]])
        middle = corners.mean(axis=0)
        reach = half * np.ptp(corners @ along)
        planes.append(scale([middle - reach * along, middle + reach * along]))
        middles.append(scale(middle))
        ways.append(scale(reach * np.sin(picture.angles[cell]) * along))
    middles, ways = np.array(middles), np.array(ways)
    axis.add_collection(LineCollection(planes, colors=ink, linewidths=0.7, zorder=4))
    axis.plot(*middles.T, "o", color=ink, markersize=2.2, zorder=5)
    aside = np.linalg.norm(ways, axis=1) > 1e-9 * scale(picture.size.max())
    axis.quiver(*middles[aside].T, *ways[aside].T, angles="xy", scale_units="xy", scale=1,
                color=ink, width=0.004, headwidth=4, headlength=4.5, headaxislength=4,
                zorder=5)
    return [Line2D([], [], color=ink, linewidth=0.7, marker="o", markersize=2.2,
                   label="plane of a ply, seen along y"),
            Line2D([], [], color=ink, linewidth=0, marker=r"$\rightarrow$", markersize=10,
                   label="fiber, followed into the picture")]


def tint(color, strength):
    return 1 - strength * (1 - np.array(to_rgb(color)))


def label_boundaries(figure, axis, picture, scale, colors):
    """The names beside their edges, where they cover neither cells nor others;
    a name that finds no place is in the legend all the same."""
    figure.canvas.draw()
    renderer = figure.canvas.get_renderer()
    to_pixels = axis.transData.transform
    cells = [MplPath(to_pixels(scale(cell)), closed=False) for cell in picture.cells]
    taken = []
    for boundary, color in colors.items():
        for point, outwards in picture.label_places(boundary):
            normal = to_pixels(scale(point + outwards)) - to_pixels(scale(point))
            normal /= max(np.linalg.norm(normal), 1e-12)
            text = axis.annotate(
                boundary, scale(point), xytext=9 * normal,
                textcoords="offset points", color=color, fontweight="bold",
                ha=("center", "left", "right")[side_of(normal[0])],
                va=("center", "bottom", "top")[side_of(normal[1])],
                annotation_clip=False)
            box = text.get_window_extent(renderer)
            if not (any(box.overlaps(other) for other in taken)
                    or any(cell.intersects_bbox(box) for cell in cells)):
                taken.append(box.padded(2))
                break
            text.remove()


def side_of(component):
    """0: hardly to either side, 1: forwards, -1: backwards."""
    return 0 if abs(component) < 0.4 else int(np.sign(component))
