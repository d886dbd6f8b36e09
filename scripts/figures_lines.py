# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of scripts/plot from lines."""

import numpy as np
from matplotlib.ticker import MaxNLocator

from figures_data import (NEGLIGIBLE, STRESSES, magnitude, stress, stresses_to_show,
                          that_matter, variation)
from figures_style import (COLOURS, DASHES, LABEL, NAMES, Place, Plies, Scale, at,
                           in_rows, legend_above, new_figure, show_no_less, tell_zero)

MOST_LINES = 6  # in one panel


# ---- which lines and components


def stresses_of_lines(results, lines):
    """Those of all lines' bodies, and the usual ones that are zero."""
    shown, usual = [], []
    for line in lines:
        frame = results.frame(line.body)[:3]
        shown += stresses_to_show([line.table], *frame)
        usual += [stress(frame[2], frame[0]), stress(frame[0], frame[0])]
    shown = list(dict.fromkeys(shown))
    return shown, [c for c in dict.fromkeys(usual) if c not in shown]


def grouped(results, kind, alike):
    """Groups of lines along the axis (0), width (1) or thickness (2) of their bodies
    that belong into one figure."""
    groups = []
    for line in results.lines:
        if line.direction != results.frame(line.body)[kind]:
            continue
        for group in groups:
            if (len(group) < MOST_LINES and group[0].direction == line.direction
                    and alike(results, group[0], line)):
                group.append(line)
                break
        else:
            groups.append([line])
    # The uppermost first, as they stand in the scene.
    return [sorted(group, key=lambda line: -line.table["z"].mean())
            for group in groups]


def overlap(results, a, b):
    shared = min(a.span[1], b.span[1]) - max(a.span[0], b.span[0])
    return shared > 0.5 * max(a.span[1] - a.span[0], b.span[1] - b.span[0])


def same_station(results, a, b):
    """Of their bodies' axes, which are parallel, or a line through both."""
    axes = {results.frame(line.body)[0] for line in (a, b)}
    return all(abs(a.table[c][0] - b.table[c][0]) <= 1e-6 * results.size for c in axes)


def overlap_at_station(results, a, b):
    return overlap(results, a, b) and same_station(results, a, b)


def label_of(line, lines):
    """The body's name, with the line's where the body has several."""
    same = [other for other in lines if other.body == line.body]
    return line.body if len(same) == 1 else f"{line.body}, {line.name}"


def file_name(lines, kind):
    return lines[0].name if len(lines) == 1 else kind


# ---- drawing


def draw_pieces(axis, line, scale, x, y, shift=0., label=None, **style):
    """y(x) - shift, ply by ply; only the first piece goes into the legend."""
    for _, piece in line.pieces():
        axis.plot(scale[x](piece[x]), scale[y](piece[y] - shift), label=label,
                  **style)
        label = None


def scales(results, lines, columns):
    return {c: (Place if c in "xyz" else Scale)(
        results.unit(c), *[line.table[c] for line in lines]) for c in columns}


def draw_against(results, lines, direction, columns, about):
    """One panel a column, all lines in each, against the scene's direction."""
    figure, axes = new_figure(results, about, rows=len(columns), sharex=True)
    scale = scales(results, lines, [direction, *columns])
    for axis, column in zip(axes[:, 0], columns):
        name = NAMES[column]
        shift = nearly_constant(lines, column)
        if shift:
            scale[column] = Scale(results.unit(column), *[
                line.table[column] - shift[k] for k, line in enumerate(lines)])
            name += " − mean"
        for k, line in enumerate(lines):
            label = label_of(line, lines)
            if shift:
                whole = Scale(results.unit(column), shift[k])
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
    for lines in grouped(results, 0, overlap):
        tables = [line.table for line in lines]
        axis, across, up, _ = results.frame(lines[0].body)
        axial, in_plane = stress(axis, axis), stress(across, axis)
        shown = stresses_to_show(tables, axis, across, up)
        displacements = that_matter(tables, [f"u{c}" for c in (up, axis, across)])
        # The shears out of the plies' plane are none on most lines, those on a surface.
        largest = max(magnitude(tables, c) for c in STRESSES)
        stresses = [c for c in shown if c in (axial, in_plane) or (
            c[1] != c[2] and magnitude(tables, c) > 0.1 * largest)]
        if displacements + stresses:
            figure = draw_against(results, lines, axis, displacements + stresses,
                                  "along the axis")
            tell_zero(figure, [] if axial in shown else [axial])
            yield file_name(lines, "along_the_axis"), figure


def across_the_width(results):
    for lines in grouped(results, 1, overlap_at_station):
        axis, across, up, _ = results.frame(lines[0].body)
        columns = that_matter([line.table for line in lines],
                              [f"u{c}" for c in (up, axis, across)], variation)
        if columns:
            place = at(results, lines[0].table, axis)
            yield (file_name(lines, "across_the_width"),
                   draw_against(results, lines, across, columns,
                                f"across the width at {place}"))


def through_the_thickness(results):
    for lines in grouped(results, 2, same_station):
        if meet(lines):
            yield file_name(lines, "through_the_contact"), draw_meeting(results, lines)
            continue
        columns, zero = stresses_of_lines(results, lines)
        if not columns:
            print(f"{', '.join(line.name for line in lines)}: all stresses are zero, "
                  "not drawn")
            continue
        yield (file_name(lines, "through_the_thickness"),
               draw_thickness(results, lines, columns, zero))


def draw_thickness(results, lines, columns, zero):
    axis_name, _, up, _ = results.frame(lines[0].body)
    parts = in_rows(columns)
    figure, axes = new_figure(
        results, f"through the thickness at {at(results, lines[0].table, axis_name)}",
        rows=len(lines) * len(parts), columns=len(parts[0]), height=3.)
    scale = scales(results, lines, [up, *columns])
    rows = iter(axes)
    for line in lines:
        for part in parts:
            row = next(rows)
            row[0].set_title(label_of(line, lines), loc="left")
            row[0].set_ylabel(scale[up].label(up))
            for k, (axis, column) in enumerate(zip(row, part)):
                shade_plies(axis, line, up, scale[up], column == part[-1])
                draw_pieces(axis, line, scale, column, up,
                            color=COLOURS[columns.index(column)])
                axis.axvline(0, color="0.6", linewidth=0.8)
                axis.set_xlabel(scale[column].label(NAMES[column]))
                axis.set_ylim(*scale[up](line.span))
                axis.margins(x=0.08)
                show_no_less(axis, "x")
                axis.xaxis.set_major_locator(MaxNLocator(5 if len(part) < 3 else 4))
                axis.tick_params(labelleft=k == 0)
            for axis in row[len(part):]:
                axis.remove()
    tell_zero(figure, zero)
    return figure


def shade_plies(axis, line, up, scale, with_names):
    plies = Plies(line.table, up)
    if len(plies) < 2:
        return
    axis.grid(False)
    axis.grid(True, axis="x")
    edges = scale(plies.edges)
    for k, (low, high) in enumerate(zip(edges, edges[1:])):
        axis.axhspan(low, high, color="0.95" if k % 2 else "white", zorder=0)
    height = 2.2  # inches of such a panel, or a little more
    if with_names:
        for text, place in plies.labels(LABEL / height * np.ptp(plies.edges)):
            axis.annotate(text, (1.02, scale(place)), va="center", color="0.35",
                          xycoords=("axes fraction", "data"), annotation_clip=False)


def meet(lines):
    """Whether the lines, the uppermost first, are one through several bodies."""
    others = "xyz".replace(lines[0].direction, "")
    spans = [line.span for line in lines]
    length = spans[0][1] - spans[-1][0]
    return (len(lines) > 1 and len({line.body for line in lines}) == len(lines)
            and all(abs(above[0] - below[1]) < 0.05 * length
                    for above, below in zip(spans, spans[1:]))
            and all(abs(line.table[c][0] - lines[0].table[c][0]) <= 0.01 * length
                    for line in lines for c in others))


def draw_meeting(results, lines):
    up = lines[0].direction
    shown, zero = stresses_of_lines(results, lines)
    first = [stress(up, up)] if magnitude(
        [line.table for line in lines], stress(up, up)) else []
    columns = [f"u{up}"] + first + [c for c in shown if c not in first]
    place = at(results, lines[0].table, *"xyz".replace(up, ""))
    parts = in_rows(columns)
    figure, axes = new_figure(results, f"through the contact at {place}",
                              rows=len(parts), columns=len(parts[0]), sharey=True,
                              height=4.6 if len(parts) == 1 else 3.8)
    scale = scales(results, lines, [up, *columns])
    for row, part in zip(axes, parts):
        for axis, column in zip(row, part):
            for k, line in enumerate(lines):
                draw_pieces(axis, line, scale, column, up, color=COLOURS[k],
                            label=label_of(line, lines))
            for line in lines[1:]:
                axis.axhline(scale[up](line.span[1]), color="0.6", linewidth=0.8)
            axis.set_xlabel(scale[column].label(NAMES[column]))
            show_no_less(axis, "x")
            axis.xaxis.set_major_locator(MaxNLocator(4))
            axis.margins(y=0.01)
        row[0].set_ylabel(scale[up].label(up))
        for axis in row[len(part):]:
            axis.remove()
    legend_above(axes[0, 0])
    tell_zero(figure, zero)
    return figure
