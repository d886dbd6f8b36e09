#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws what a run left in a folder into its subfolder pictures.

Usage: figures.py DIR (through scripts/plot, which finds a fitting python3)

No scene is known by name: the data decide which figures there are. A line that
runs mostly along y (the beams' axis), z (their thickness) or x (their width)
gives a figure of that kind, lines of two bodies that meet one through both, a
section cut a contour, several load steps a force-displacement curve, and each
section its mesh. A contact with more than a few active pairs gives its pressure,
over a patch also as a map, and over the width of a long patch beside the Hertz
ellipse where the materials in scene.prm are isotropic; cuts through the patch give
contours around it.
"""

import csv
import json
import re
import sys
from collections import defaultdict
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import BoundaryNorm, to_rgb
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.path import Path as MplPath
from matplotlib.ticker import MaxNLocator
from matplotlib.tri import Triangulation

# Okabe and Ito's colours, told apart by colour-blind readers, too.
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9")
DASHES = ("-", "--", "-.", ":")
WIDTH = 8.4  # inches of every figure; 1260 pixels
NEGLIGIBLE = 1e-6  # of the largest component: rounding, not worth a panel
MOST_LINES = 6  # in one panel
NAMES = {"ux": "$u_x$", "uy": "$u_y$", "uz": "$u_z$"}
NAMES.update({f"s{a}{b}": rf"$\sigma_{{{a}{b}}}$" for a in "xyz" for b in "xyz"})
NAMES.update({f"e{a}{a}": rf"$\epsilon_{{{a}{a}}}$" for a in "xyz"})

plt.rcParams.update({
    "font.size": 11, "axes.titlesize": 11, "axes.labelsize": 11,
    "figure.dpi": 150, "figure.constrained_layout.use": True,
    "axes.spines.top": False, "axes.spines.right": False,
    "axes.grid": True, "grid.color": "0.9", "axes.axisbelow": True,
    "axes.prop_cycle": matplotlib.cycler(color=COLOURS),
    "lines.linewidth": 1.8, "legend.frameon": False,
    "axes.formatter.limits": (-4, 5), "axes.formatter.use_mathtext": True,
})


# ---- what the run left behind


class Table:
    """Columns of a CSV file: arrays of numbers, or of text where they are not."""

    def __init__(self, names, rows):
        self.columns = {}
        for k, name in enumerate(names):
            cells = [row[k] for row in rows]
            try:
                column = np.array([float(c) if c else np.nan for c in cells])
            except ValueError:
                column = np.array(cells)
            self.columns[name] = column

    @classmethod
    def read(cls, path):
        with open(path, newline="") as file:
            names, *rows = list(csv.reader(file)) or [[]]
        return cls(names, rows)

    def __getitem__(self, name):
        return self.columns[name]

    def __contains__(self, name):
        return name in self.columns

    def __len__(self):
        return len(next(iter(self.columns.values()), ()))

    def where(self, mask):
        part = Table((), ())
        part.columns = {name: c[mask] for name, c in self.columns.items()}
        return part

    def split(self, name):
        """(value, rows) for each value of a column, in order of appearance."""
        values = self[name].astype(str)
        for value in dict.fromkeys(values):
            yield value, self.where(values == value)

    def last_step(self):
        if "step" not in self or not len(self):
            return self
        return self.where(self["step"] == self["step"].max())


class Line:
    """A line of one body at the last step."""

    def __init__(self, name, table):
        self.name, self.table = name, table
        self.body = str(table["body"][0])
        extents = {axis: np.ptp(table[axis]) for axis in "xyz"}
        self.direction = max(extents, key=extents.get)

    @property
    def span(self):
        values = self.table[self.direction]
        return values.min(), values.max()

    def pieces(self):
        """The line ply by ply, so that nothing is drawn across an interface."""
        if "ply" not in self.table:
            return [("", self.table)]
        return list(self.table.split("ply"))


class Results:
    def __init__(self, folder):
        summary = folder / "summary.json"
        self.summary = json.loads(summary.read_text()) if summary.exists() else {}
        self.title = self.summary.get("title", "")
        self.units = self.summary.get("units") or {}
        self.lines = [line for path in sorted(folder.glob("lines/*.csv"))
                      for line in self.lines_of(path)]
        self.cuts = self.tables(folder.glob("cuts/*.csv"))
        self.contacts = self.tables(folder.glob("contact_*.csv"), "contact_")
        self.sections = self.tables(folder.glob("sections/*.csv"))
        history = folder / "history.csv"
        self.history = Table.read(history) if history.exists() else Table((), ())
        scene = folder / "scene.prm"
        self.scene = read_scene(scene.read_text()) if scene.exists() else {}

    @staticmethod
    def lines_of(path):
        table = Table.read(path).last_step()
        return [Line(path.stem, rows) for _, rows in table.split("body")] if len(
            table) else []

    @staticmethod
    def tables(paths, prefix=""):
        return {path.stem[len(prefix):]: Table.read(path).last_step()
                for path in sorted(paths)}


def read_scene(text):
    """The entries of a resolved scene, subsections as dictionaries."""
    path = [{}]
    for line in text.splitlines():
        word, _, rest = line.split("#")[0].strip().partition(" ")
        if word == "subsection":
            path.append(path[-1].setdefault(rest.strip(), {}))
        elif word == "end":
            path.pop()
        elif word == "set":
            name, _, value = rest.partition("=")
            path[-1][name.strip()] = value.strip()
    return path[0]


# ---- units and labels


SI_PREFIXES = {
    "m": ((2e-5, "µm", 1e6), (0.5, "mm", 1e3), (np.inf, "m", 1)),
    "Pa": ((1e4, "Pa", 1), (1e10, "MPa", 1e-6), (np.inf, "GPa", 1e-9)),
    "mm": ((2e-2, "µm", 1e3), (np.inf, "mm", 1)),
    "MPa": ((1e-2, "Pa", 1e6), (np.inf, "MPa", 1)),
    "N": ((1e4, "N", 1), (np.inf, "kN", 1e-3)),
}


class Scale:
    """The factor and the unit that make the numbers of a plot readable."""

    def __init__(self, unit, *values):
        finite = np.concatenate([np.ravel(v) for v in values] or [[0.]])
        largest = np.nanmax(np.abs(finite)) if len(finite) else 0.
        self.factor, self.unit = 1., unit or ""
        for limit, name, factor in SI_PREFIXES.get(unit, ()):
            if largest < limit:
                self.unit, self.factor = name, factor
                break

    def __call__(self, values):
        return np.asarray(values) * self.factor

    def label(self, name):
        return f"{name} [{self.unit}]" if self.unit else name

    def number(self, value):
        return f"{value * self.factor:.6g} {self.unit}".rstrip()


def unit_of(results, column):
    if column[0] == "e":
        return None
    kind = ("stress" if column[0] == "s" or column == "pressure" else
            "force" if column == "force" else "length")
    return results.units.get(kind)


def magnitude(tables, column):
    return max((np.nanmax(np.abs(t[column])) for t in tables if len(t)), default=0.)


def that_matter(tables, columns, size=magnitude):
    """The columns that are not rounding beside the largest of them."""
    sizes = {c: size(tables, c) for c in columns}
    largest = max(sizes.values())
    return [c for c in columns if sizes[c] > NEGLIGIBLE * largest]


def variation(tables, column):
    return max(np.ptp(table[column]) for table in tables)


def stresses_to_show(tables):
    """Shear and axial stress; the thickness stress where contact makes it big."""
    sizes = {c: magnitude(tables, c) for c in ("syz", "syy", "szz")}
    shown = [c for c in ("syz", "syy")
             if sizes[c] > NEGLIGIBLE * max(sizes.values())]
    return shown + (["szz"] if sizes["szz"] > 0.1 * max(sizes.values()) else [])


# ---- pieces of figures


def new_figure(results, about, rows=1, columns=1, height=2.3, **options):
    figure, axes = plt.subplots(rows, columns, squeeze=False,
                                figsize=(WIDTH, 0.9 + height * rows), **options)
    figure.suptitle(": ".join(filter(None, (results.title, about))), fontsize=12)
    return figure, axes


def legend_above(axis, fewest=2):
    handles, labels = axis.get_legend_handles_labels()
    if len(handles) >= fewest:
        # About ten characters an inch, a handle taking eight.
        fitting = int(10 * WIDTH / (8 + max(len(label) for label in labels)))
        axis.legend(loc="lower left", bbox_to_anchor=(0, 1.0), ncol=max(
            1, min(len(handles), 3, fitting)), borderaxespad=0.2,
            handlelength=2.4)


def label_of(line, lines):
    """The body's name, with the line's where the body has several."""
    same = [other for other in lines if other.body == line.body]
    return line.body if len(same) == 1 else f"{line.body}, {line.name}"


def file_name(lines, kind):
    return lines[0].name if len(lines) == 1 else kind


def draw_pieces(axis, line, scale, x, y, shift=0., label=None, **style):
    """y(x) - shift, ply by ply; only the first piece goes into the legend."""
    for _, piece in line.pieces():
        axis.plot(scale[x](piece[x]), scale[y](piece[y] - shift), label=label,
                  **style)
        label = None


def scales(results, lines, columns):
    return {c: Scale(unit_of(results, c), *[line.table[c] for line in lines])
            for c in columns}


def draw_against(results, lines, direction, columns, about):
    """One panel a column, all lines in each, against the scene's direction."""
    figure, axes = new_figure(results, about, rows=len(columns), sharex=True)
    scale = scales(results, lines, [direction, *columns])
    for axis, column in zip(axes[:, 0], columns):
        name = NAMES[column]
        shift = nearly_constant(lines, column)
        if shift:
            scale[column] = Scale(unit_of(results, column), *[
                line.table[column] - shift[k] for k, line in enumerate(lines)])
            name += " − mean"
        for k, line in enumerate(lines):
            label = label_of(line, lines)
            if shift:
                whole = Scale(unit_of(results, column), shift[k])
                label += f" (mean {whole.number(shift[k])})"
            draw_pieces(axis, line, scale, direction, column, label=label,
                        shift=shift[k] if shift else 0.,
                        color=COLOURS[k], linestyle=DASHES[k % len(DASHES)])
        axis.set_ylabel(scale[column].label(name))
        axis.margins(x=0.01)
        if shift or column == columns[0]:
            legend_above(axis, fewest=1 if shift else 2)
    axes[-1, 0].set_xlabel(scale[direction].label(direction))
    figure.align_ylabels()
    return figure


def nearly_constant(lines, column):
    """The means of the lines where they would hide the variation, else None."""
    values = [line.table[column] for line in lines]
    if all(np.ptp(v) < 0.02 * np.abs(v).max() for v in values):
        return [v.mean() for v in values]
    return None


# ---- the figures; each yields (file name, figure)


def along_the_axis(results):
    for lines in grouped(results.lines, "y", same_span):
        tables = [line.table for line in lines]
        columns = (that_matter(tables, ("uz", "uy", "ux"))
                   + that_matter(tables, ("syy",)))
        if columns:
            yield (file_name(lines, "along_the_axis"),
                   draw_against(results, lines, "y", columns, "along the axis"))


def across_the_width(results):
    for lines in grouped(results.lines, "x", same_span):
        columns = that_matter([line.table for line in lines], ("uz", "uy", "ux"),
                              variation)
        if columns:
            place = Scale(results.units.get("length"), lines[0].table["y"])
            at = place.number(lines[0].table["y"][0])
            yield (file_name(lines, "across_the_width"),
                   draw_against(results, lines, "x", columns,
                                f"across the width at y = {at}"))


def through_the_thickness(results):
    for lines in grouped(results.lines, "z", same_station):
        if meet(lines):
            yield file_name(lines, "through_the_contact"), draw_meeting(results, lines)
            continue
        columns = stresses_to_show([line.table for line in lines])
        if not columns:
            continue
        place = Scale(results.units.get("length"),
                      *[line.table["y"] for line in results.lines])
        at = place.number(lines[0].table["y"][0])
        figure, axes = new_figure(
            results, f"through the thickness at y = {at}", rows=len(lines),
            columns=len(columns), height=3., sharey="row")
        scale = scales(results, lines, ["z", *columns])
        for row, line in zip(axes, lines):
            for k, (axis, column) in enumerate(zip(row, columns)):
                shade_plies(axis, line, scale["z"], k == len(columns) - 1)
                draw_pieces(axis, line, scale, column, "z", color=COLOURS[k])
                axis.axvline(0, color="0.6", linewidth=0.8)
                axis.set_xlabel(scale[column].label(NAMES[column]))
                axis.set_ylim(*(scale["z"](v) for v in line.span))
                axis.margins(x=0.08)
                axis.xaxis.set_major_locator(MaxNLocator(5))
            row[0].set_ylabel(scale["z"].label("z"))
            row[0].set_title(label_of(line, lines), loc="left")
        yield file_name(lines, "through_the_thickness"), figure


def meet(lines):
    """Whether the lines, the uppermost first, are one through several bodies."""
    spans = [line.span for line in lines]
    length = spans[0][1] - spans[-1][0]
    return (len(lines) > 1 and len({line.body for line in lines}) == len(lines)
            and all(abs(above[0] - below[1]) < 0.05 * length
                    for above, below in zip(spans, spans[1:]))
            and all(abs(line.table["x"][0] - lines[0].table["x"][0]) <= 0.01 * length
                    for line in lines))


def draw_meeting(results, lines):
    tables = [line.table for line in lines]
    columns = ["uz", "szz"] + [c for c in stresses_to_show(tables) if c != "szz"]
    place = {c: Scale(results.units.get("length"), tables[0][c]) for c in "xy"}
    at = ", ".join(f"{c} = {place[c].number(tables[0][c][0])}" for c in "xy")
    figure, axes = new_figure(results, f"through the contact at {at}", height=4.6,
                              columns=len(columns), sharey=True)
    scale = scales(results, lines, ["z", *columns])
    for axis, column in zip(axes[0], columns):
        for k, line in enumerate(lines):
            draw_pieces(axis, line, scale, column, "z", color=COLOURS[k],
                        label=label_of(line, lines))
        for line in lines[1:]:
            axis.axhline(scale["z"](line.span[1]), color="0.6", linewidth=0.8)
        axis.set_xlabel(scale[column].label(NAMES[column]))
        axis.xaxis.set_major_locator(MaxNLocator(4))
        axis.margins(y=0.01)
    axes[0, 0].set_ylabel(scale["z"].label("z"))
    legend_above(axes[0, 0])
    return figure


def shade_plies(axis, line, scale, with_names):
    pieces = line.pieces()
    if len(pieces) < 2:
        return
    axis.grid(False)
    axis.grid(True, axis="x")
    for k, (ply, piece) in enumerate(pieces):
        low, high = scale(piece["z"].min()), scale(piece["z"].max())
        axis.axhspan(low, high, color="0.95" if k % 2 else "white", zorder=0)
        if with_names and len(pieces) <= 16:
            axis.annotate(f"ply {float(ply):g}", (1.02, (low + high) / 2),
                          xycoords=("axes fraction", "data"), va="center",
                          color="0.35", annotation_clip=False)


def grouped(lines, direction, alike):
    """Groups of lines along a direction that belong into one figure."""
    groups = []
    for line in lines:
        if line.direction != direction:
            continue
        for group in groups:
            if len(group) < MOST_LINES and alike(group[0], line):
                group.append(line)
                break
        else:
            groups.append([line])
    # The uppermost first, as they stand in the scene.
    return [sorted(group, key=lambda line: -line.table["z"].mean())
            for group in groups]


def same_span(a, b):
    overlap = min(a.span[1], b.span[1]) - max(a.span[0], b.span[0])
    longest = max(a.span[1] - a.span[0], b.span[1] - b.span[0])
    if overlap <= 0.5 * longest:
        return False
    return a.direction == "y" or same_station(a, b)


def same_station(a, b):
    y = a.table["y"][0], b.table["y"][0]
    return abs(y[0] - y[1]) <= 1e-6 * max(abs(y[0]), abs(y[1]))


def section_cuts(results):
    for name, table in results.cuts.items():
        if not len(table):
            continue
        for body, rows in table.split("body"):
            columns = stresses_to_show([rows])
            # Soft cores and contacts stretch through the thickness.
            if magnitude([rows], "ezz") > magnitude([rows], "eyy"):
                columns.append("ezz")
            several = len(set(table["body"])) > 1
            if columns:
                yield (f"section_{name}" + (f"_{body}" if several else ""),
                       draw_cut(results, body, rows, columns))


def draw_cut(results, body, table, columns):
    length = results.units.get("length")
    scale = Scale(length, np.ptp(table["x"]), np.ptp(table["z"]))
    place = Scale(length, table["y"])
    width, height = np.ptp(table["x"]), np.ptp(table["z"])
    stretch_x, stretch_z = exaggeration(width, height)
    panel = WIDTH * 0.7 * (height * stretch_z) / (width * stretch_x)
    # A tall section has its panels side by side, a wide one above each other.
    wide = width * stretch_x >= height * stretch_z
    rows, cols = (len(columns), 1) if wide else (1, len(columns))
    figure, axes = new_figure(
        results, f"{body}, section at y = {place.number(table['y'].mean())}",
        rows=rows, columns=cols, height=panel + 0.35 if wide else 6.,
        sharex=True, sharey=True)
    figure.set_constrained_layout_pads(h_pad=0.12)
    for axis, column in zip(axes.flat, columns):
        contour(axis, [table], column, scale, Scale(unit_of(results, column),
                                                    table[column]))
        axis.set_aspect(stretch_z / stretch_x)
        axis.grid(False)
    for axis in axes[:, 0]:
        axis.set_ylabel(scale.label("z") + drawn_larger(stretch_z))
    for axis in axes[-1, :]:
        axis.set_xlabel(scale.label("x") + drawn_larger(stretch_x))
    return figure


def exaggeration(width, height, largest_aspect=8., drawn_aspect=3.):
    """Round factors for x and z; one is 1, both where the shape is readable."""
    aspect = width / height
    if max(aspect, 1 / aspect) <= largest_aspect:
        return 1, 1
    wanted = max(aspect, 1 / aspect) / drawn_aspect
    factors = [k * 10.**p for p in range(8) for k in (1, 2, 5)]
    factor = int(max(f for f in factors if f <= wanted))
    return (1, factor) if aspect > 1 else (factor, 1)


def drawn_larger(factor):
    return "" if factor == 1 else f"\nenlarged {factor} times"


def contour(axis, tables, column, position, stress):
    """Cell by cell, so that the jumps between cells stay visible."""
    values = np.concatenate([stress(table[column]) for table in tables])
    low, high = values.min(), values.max()
    two_signs = low < -0.1 * high and high > -0.1 * low
    if two_signs:
        high = max(-low, high)
        low = -high
    if not high > low:
        low, high = low - 1, high + 1
    levels = MaxNLocator(14).tick_values(low, high)
    colours = plt.get_cmap("RdBu_r" if two_signs else "cividis")
    norm = BoundaryNorm(levels, colours.N)
    # Known limits: without, each cell makes matplotlib look through all others.
    for limits, name in ((axis.set_xlim, "x"), (axis.set_ylim, "z")):
        along = np.concatenate([position(table[name]) for table in tables])
        margin = 0.02 * np.ptp(along)
        limits(along.min() - margin, along.max() + margin)
    axis.autoscale(False)
    outlines = []
    for table in tables:
        for _, cell in table.split("cell"):
            x, z, v = cell_grids(cell, position, stress, column)
            shades = axis.contourf(x, z, v, levels, cmap=colours, norm=norm,
                                   antialiased=False)
            outline = np.r_[0:x.size].reshape(x.shape)
            edge = np.concatenate([outline[0], outline[1:, -1],
                                   outline[-1, -2::-1], outline[-2::-1, 0]])
            outlines.append(np.column_stack([x.flat[edge], z.flat[edge]]))
    axis.add_collection(LineCollection(outlines, colors="0.25", linewidths=0.5))
    figure = axis.get_figure()
    bar = figure.colorbar(shades, ax=axis, pad=0.02, aspect=14)
    bar.ax.yaxis.set_major_locator(MaxNLocator(6))
    bar.set_label(stress.label(NAMES[column]))


def cell_grids(cell, position, stress, column):
    i, j = cell["i"].astype(int), cell["j"].astype(int)
    shape = i.max() + 1, j.max() + 1
    grids = []
    for values in (position(cell["x"]), position(cell["z"]), stress(cell[column])):
        grid = np.full(shape, np.nan)
        grid[i, j] = values
        grids.append(grid)
    return grids


# ---- the sections' meshes


class SectionPicture:
    """The mesh of a section: cells by material and angle, boundaries by name."""

    def __init__(self, table):
        self.cells, self.fabrics, self.edges = [], [], defaultdict(list)
        for row in range(len(table)):
            angle = f"{float(table['angle'][row]):g}°"
            self.fabrics.append(f"{table['material'][row]}, {angle}")
            sides = [np.array([p.split() for p in table[f"side_{k}"][row].split(";")],
                              float) for k in range(1, 5)]
            self.cells.append(np.concatenate([side[:-1] for side in sides]))
            for k, side in enumerate(sides, 1):
                # A column without any name has been read as numbers.
                name = str(table[f"boundary_{k}"][row])
                if name not in ("", "nan"):
                    self.edges[name].append(side)
        points = np.concatenate(self.cells)
        self.low, self.high = points.min(axis=0), points.max(axis=0)
        self.size = self.high - self.low

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
    stretch = exaggeration(*picture.size, largest_aspect=20.)
    drawn = picture.size * stretch
    height = min(max(0.7 * WIDTH * drawn[1] / drawn[0], 1.1), 5.2) + 0.4
    figure, axes = new_figure(results, f"section {name}, "
                              f"{len(picture.cells)} cells", height=height)
    axis = axes[0, 0]
    axis.grid(False)
    axis.set_aspect(stretch[1] / stretch[0])
    longest = max((len(boundary) for boundary in picture.edges), default=0)
    pad = np.array([0.05 + 0.012 * longest, 0.09]) * drawn.max() / stretch
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
    colours = {boundary: COLOURS[(k + 1) % len(COLOURS)]
               for k, boundary in enumerate(sorted(picture.edges))}
    for boundary, colour in colours.items():
        axis.add_collection(LineCollection(
            [scale(side) for side in picture.edges[boundary]], colors=colour,
            linewidths=2.4, capstyle="round", zorder=3))
        handles.append(Line2D([], [], color=colour, linewidth=2.4, label=boundary))
    axis.legend(handles=handles, loc="center left", bbox_to_anchor=(1.02, 0.5))
    label_boundaries(figure, axis, picture, scale, colours)
    return figure


def tint(colour, strength):
    return 1 - strength * (1 - np.array(to_rgb(colour)))


def label_boundaries(figure, axis, picture, scale, colours):
    """The names beside their edges, where they cover neither cells nor others;
    a name that finds no place is in the legend all the same."""
    figure.canvas.draw()
    renderer = figure.canvas.get_renderer()
    to_pixels = axis.transData.transform
    cells = [MplPath(to_pixels(scale(cell)), closed=False) for cell in picture.cells]
    taken = []
    for boundary, colour in colours.items():
        for point, outwards in picture.label_places(boundary):
            normal = to_pixels(scale(point + outwards)) - to_pixels(scale(point))
            normal /= max(np.linalg.norm(normal), 1e-12)
            text = axis.annotate(
                boundary, scale(point), xytext=9 * normal,
                textcoords="offset points", color=colour, fontweight="bold",
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


HISTORY_COLUMN = re.compile(
    r"(support|contact|probe)s?[.:/ ](.+?)[.:/ ]?(?:reaction|force)?[.:/ _]?"
    r"([fru]?)_?([xyz])$")


def load_history(results):
    table = results.history
    if "step" not in table or len(table) < 2:
        return
    kinds = defaultdict(list)
    for column in table.columns:
        found = HISTORY_COLUMN.match(column)
        if found:
            kinds[found[1]].append((np.ptp(table[column]), column, found))
    probes = sorted(kinds["probe"], key=lambda entry: -entry[0])
    forces = kinds["contact"] or kinds["support"]
    if not probes or not forces:
        return
    _, x, probe = probes[0]
    figure, axes = new_figure(results, "load history", height=3.6)
    axis = axes[0, 0]
    curves = largest_components(forces)
    force = Scale(results.units.get("force"), *[table[c] for c, _ in curves])
    moved = Scale(results.units.get("length"), table[x])
    sign, minus = upwards(table[x])
    axis.set_xlabel(moved.label(f"${minus}u_{probe[4]}$ of {probe[2]}"))
    for k, (column, found) in enumerate(curves):
        force_sign, minus = upwards(table[column])
        axis.plot(sign * moved(table[x]), force_sign * force(table[column]),
                  marker="o", markersize=4, linestyle=DASHES[k % len(DASHES)],
                  label=f"${minus}F_{found[4]}$ of {found[1]} {found[2]}")
    axis.set_ylabel(force.label("force"))
    legend_above(axis, fewest=1)
    yield "history", figure


def upwards(values):
    """The sign that makes the largest value positive, and its label."""
    return (-1, "-") if -values.min() > values.max() else (1, "")


def largest_components(forces):
    """For each name its component that changes most, without the idle ones."""
    best = {}
    for size, column, found in sorted(forces, key=lambda entry: entry[0]):
        best[found[2]] = (size, column, found)
    largest = max(size for size, _, _ in best.values())
    return [(column, found) for size, column, found in best.values()
            if size >= NEGLIGIBLE * largest][:MOST_LINES]


# ---- contacts


class ContactPatch:
    """Where a contact touches, in the two coordinates along its surface: across
    its width (where the gap opens faster, or the patch is narrower) and along."""

    def __init__(self, table):
        self.table = table
        self.active = table.where(table["active"] == 1)
        normal = [np.abs(np.mean(self.active[f"n{c}"])) for c in "xyz"]
        self.normal = "xyz"[int(np.argmax(normal))]
        self.plane = [c for c in "xyz" if c != self.normal]
        self.extent = {c: np.ptp(self.active[c]) for c in self.plane}
        longest = max(self.extent.values())
        self.is_patch = all(e > 1e-3 * longest for e in self.extent.values())
        self.curvature = self.curvatures() if self.is_patch else {}
        order = sorted(self.plane, key=lambda c: (
            -self.curvature.get(c, 0.), self.extent[c]))
        self.across, self.along = order

    def near(self, margin):
        """The points of the patch and around it, by so many half widths."""
        inside = np.ones(len(self.table), bool)
        for c in self.plane:
            low, high = self.active[c].min(), self.active[c].max()
            pad = 0.5 * margin * (high - low)
            inside &= (self.table[c] >= low - pad) & (self.table[c] <= high + pad)
        return self.table.where(inside)

    def curvatures(self):
        """Of the gap between the points of the pairs (that of a row may be a mean
        over its neighbourhood) in both directions, 1 / R*; 0 where it is rounding."""
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

    def stations(self):
        """(position along the patch, the rows there across it), in order."""
        near = self.near(0.5)
        step = 1e-6 * self.extent[self.along]
        places = np.round(near[self.along] / step)
        for place in np.unique(places):
            rows = near.where(places == place)
            yield rows[self.along][0], rows.where(np.argsort(rows[self.across]))


def contact_pressure(results):
    for name, table in results.contacts.items():
        if not len(table) or np.sum(table["active"]) <= 3:
            continue
        patch = ContactPatch(table)
        stations = list(patch.stations()) if patch.is_patch else []
        if any(np.sum(rows["active"]) > 3 for _, rows in stations):
            yield (f"contact_{name}_pressure",
                   draw_pressure_across(results, name, patch, stations))
            yield f"contact_{name}_map", draw_pressure_map(results, name, patch)
        else:
            yield f"contact_{name}", draw_pressure_points(results, name, patch)


def draw_pressure_points(results, name, patch):
    active = patch.active
    directions = [c for c in patch.plane
                  if patch.extent[c] > 1e-3 * max(patch.extent.values())]
    figure, axes = new_figure(results, f"pressure in contact {name}", height=3.4,
                              columns=len(directions), sharey=True)
    value = Scale(unit_of(results, "pressure"), active["pressure"])
    for axis, direction in zip(axes[0], directions):
        place = Scale(results.units.get("length"), active[direction])
        axis.plot(place(active[direction]), value(active["pressure"]), "o",
                  markersize=4.5, alpha=0.7, markeredgewidth=0)
        axis.set_xlabel(place.label(direction))
        axis.set_ylim(bottom=0)
        axis.xaxis.set_major_locator(MaxNLocator(5))
    axes[0, 0].set_ylabel(value.label(f"pressure of the {len(active)} active pairs"))
    return figure


def draw_pressure_across(results, name, patch, stations):
    """In the middle and at one end of the patch, with the Hertz ellipse of the
    whole force."""
    figure, axes = new_figure(
        results, f"pressure across contact {name}", height=3.8)
    axis = axes[0, 0]
    active, length = patch.active, results.units.get("length")
    value = Scale(unit_of(results, "pressure"), active["pressure"])
    centre = active[patch.across].mean()
    place = Scale(length, active[patch.across] - centre)
    along = Scale(length, active[patch.along])
    middle = min(stations, key=lambda s: abs(s[0] - np.mean(
        [stations[0][0], stations[-1][0]])))
    shown = [middle] if middle[0] == stations[0][0] else [middle, stations[0]]
    for k, (at, rows) in enumerate(shown):
        axis.plot(place(rows[patch.across] - centre), value(rows["pressure"]),
                  marker="o", markersize=4.5, linewidth=1., color=COLOURS[k],
                  linestyle=DASHES[k], label=f"{patch.along} = {along.number(at)}")
    hertz = hertz_ellipse(results, name, patch)
    if hertz:
        half_width, peak, force = hertz
        t = np.linspace(-np.pi / 2, np.pi / 2, 200)
        per_length = "/".join(filter(None, (results.units.get("force"), length)))
        axis.plot(place(half_width * np.sin(t)), value(peak * np.cos(t)),
                  color="0.2", linewidth=1.4,
                  label=f"Hertz, mean force {force:.4g} {per_length}: "
                  f"a = {place.number(float(f'{half_width:.4g}'))}, "
                  f"$p_0$ = {value.number(float(f'{peak:.4g}'))}")
    whole = Scale(length, [centre])
    offset = (f"{patch.across} − {whole.number(float(f'{centre:.6g}'))}"
              if abs(centre) > 1e-9 * patch.extent[patch.across] else patch.across)
    axis.set_xlabel(place.label(offset))
    axis.set_ylabel(value.label("pressure"))
    axis.set_ylim(bottom=0)
    legend_above(axis, fewest=1)
    return figure


def hertz_ellipse(results, name, patch):
    """(half-width, peak pressure, force per length) of two cylinders with the
    curvature of the initial gap, or None if this is not that."""
    curvature = patch.curvature
    modulus = effective_modulus(results.scene, name)
    if not modulus or curvature[patch.across] <= 0. or (
            curvature[patch.along] > 1e-3 * curvature[patch.across]):
        return None
    force = np.sum(patch.active["force"]) / np.ptp(patch.table[patch.along])
    radius = 1. / curvature[patch.across]
    return (np.sqrt(4. * force * radius / (np.pi * modulus)),
            np.sqrt(force * modulus / (np.pi * radius)), force)


def effective_modulus(scene, contact):
    """E* of two isotropic bodies (1/E* = sum (1 - nu^2) / E, nothing from a rigid
    one), or None."""
    compliance = 0.
    for side in ("First", "Second"):
        body = scene.get(f"Contact {contact}", {}).get(side, "").partition(":")[0]
        if f"Body {body}" not in scene:
            continue
        section = scene.get(f"Section {scene[f'Body {body}']['Section']}", {})
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


def draw_pressure_map(results, name, patch):
    length = results.units.get("length")
    near = patch.near(0.5)
    x, y = (near[c] for c in (patch.along, patch.across))
    scale = Scale(length, x, y)
    value = Scale(unit_of(results, "pressure"), near["pressure"])
    figure, axes = new_figure(results, f"pressure in contact {name}", height=3.6)
    axis = axes[0, 0]
    # Long patches have long triangles; what is near is so in the picture.
    triangles = Triangulation((x - x.mean()) / np.ptp(x), (y - y.mean()) / np.ptp(y))
    shades = axis.tricontourf(Triangulation(scale(x), scale(y), triangles.triangles),
                              value(near["pressure"]), levels=12, cmap="cividis")
    axis.plot(scale(x), scale(y), ".", color="0.3", markersize=1.5)
    bar = figure.colorbar(shades, ax=axis, pad=0.02)
    bar.set_label(value.label("pressure"))
    axis.grid(False)
    axis.set_xlabel(scale.label(patch.along))
    axis.set_ylabel(scale.label(patch.across))
    return figure


def around_the_contact(results):
    """Contours in the section around the patch, all bodies cut there."""
    for name, table in results.contacts.items():
        if not len(table) or np.sum(table["active"]) <= 3:
            continue
        patch = ContactPatch(table)
        if not patch.is_patch or (patch.across, patch.along) != ("x", "y"):
            continue
        half = 2. * patch.extent["x"]
        centre = [patch.active[c].mean() for c in "xz"]
        y = patch.active["y"]
        cuts = defaultdict(list)
        for cut in results.cuts.values():
            if len(cut) and y.min() <= cut["y"][0] <= y.max() and (
                    np.ptp(cut["x"]) > 3. * half):
                window = cut_window(cut, centre, half)
                if len(window):
                    cuts[round(cut["y"][0] / np.ptp(y), 6)].append(window)
        for tables in cuts.values():
            yield (f"contact_{name}_section",
                   draw_around(results, name, tables, centre, half))


def cut_window(cut, centre, half):
    """The cells that reach into the window."""
    inside = (np.abs(cut["x"] - centre[0]) <= half) & (
        np.abs(cut["z"] - centre[1]) <= half)
    return cut.where(np.isin(cut["cell"], np.unique(cut["cell"][inside])))


def draw_around(results, name, tables, centre, half):
    length = results.units.get("length")
    scale = Scale(length, *[np.ravel(centre) + half])
    place = Scale(length, tables[0]["y"])
    columns = ["uz", "szz"]
    figure, axes = new_figure(
        results, f"around contact {name}, y = {place.number(tables[0]['y'].mean())}",
        columns=len(columns), height=2.9, sharey=True)
    for axis, column in zip(axes[0], columns):
        shown = [table[column][(np.abs(table["x"] - centre[0]) <= half)
                               & (np.abs(table["z"] - centre[1]) <= half)]
                 for table in tables]
        contour(axis, tables, column, scale, Scale(unit_of(results, column), *shown))
        axis.set_xlim(*scale([centre[0] - half, centre[0] + half]))
        axis.set_ylim(*scale([centre[1] - half, centre[1] + half]))
        axis.set_aspect("equal")
        axis.grid(False)
        axis.xaxis.set_major_locator(MaxNLocator(4))
        axis.set_xlabel(scale.label("x"))
    axes[0, 0].set_ylabel(scale.label("z"))
    return figure


FIGURES = (along_the_axis, through_the_thickness, across_the_width, section_cuts,
           load_history, contact_pressure, around_the_contact, section_meshes)


def main():
    if len(sys.argv) != 2 or not Path(sys.argv[1]).is_dir():
        sys.exit("Usage: scripts/plot DIR (the output folder of a run)")
    folder = Path(sys.argv[1])
    results = Results(folder)
    pictures = folder / "pictures"
    pictures.mkdir(exist_ok=True)
    for old in pictures.glob("*.png"):
        old.unlink()
    taken = defaultdict(int)
    for draw in FIGURES:
        for name, figure in draw(results):
            taken[name] += 1
            suffix = f"_{taken[name]}" if taken[name] > 1 else ""
            figure.savefig(pictures / f"{name}{suffix}.png")
            plt.close(figure)
    if not taken:
        print(f"{folder} holds nothing to draw (no lines, cuts or load steps).")


if __name__ == "__main__":
    main()
