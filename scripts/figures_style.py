# SPDX-License-Identifier: LGPL-2.1-or-later
"""The look of what scripts/plot draws: units, labels, axes and their sizes."""

import logging
import warnings

import matplotlib

matplotlib.use("Agg")
# What it says of its own caches is no matter of who draws a run.
logging.getLogger("matplotlib").setLevel(logging.ERROR)
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import MaxNLocator

# Okabe and Ito's colors, told apart by color-blind readers, too.
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9")
DASHES = ("-", "--", "-.", ":")
WIDTH = 8.4  # inches of every figure; 1260 pixels
BESIDE = 1.7  # inches beside a contour: labels and color bar
ROW = 0.5  # inches below it
LEAST_BAR = 0.9  # inches of a color bar
TALLEST = 11.  # inches of a figure of contours
LABEL = 0.18  # inches that a label takes in height
FAR = 200.  # times their range: values that are drawn from their middle
NAMES = {"ux": "$u_x$", "uy": "$u_y$", "uz": "$u_z$"}
NAMES.update({f"s{a}{b}": rf"$\sigma_{{{a}{b}}}$" for a in "xyz" for b in "xyz"})
NAMES.update({f"e{a}{a}": rf"$\epsilon_{{{a}{a}}}$" for a in "xyz"})

plt.rcParams.update({
    "font.size": 11, "axes.titlesize": 11, "axes.labelsize": 11,
    "figure.dpi": 150, "figure.constrained_layout.use": True,
    # What does not fit the layout makes the picture larger.
    "savefig.bbox": "tight", "savefig.pad_inches": 0.06,
    "axes.spines.top": False, "axes.spines.right": False,
    "axes.grid": True, "grid.color": "0.9", "axes.axisbelow": True,
    "axes.prop_cycle": matplotlib.cycler(color=COLOURS),
    "lines.linewidth": 1.8, "legend.frameon": False,
    "axes.formatter.limits": (-4, 5), "axes.formatter.use_mathtext": True,
    "axes.formatter.useoffset": False,
})


# A character of a title that the font lacks is drawn as a box, and that is all.
warnings.filterwarnings("ignore", message="Glyph .* missing from current font")


# ---- units


SI_PREFIXES = {
    "m": ((2e-5, "µm", 1e6), (0.5, "mm", 1e3), (np.inf, "m", 1)),
    "Pa": ((1e4, "Pa", 1), (1e10, "MPa", 1e-6), (np.inf, "GPa", 1e-9)),
    "mm": ((2e-2, "µm", 1e3), (np.inf, "mm", 1)),
    "MPa": ((1e-2, "Pa", 1e6), (np.inf, "MPa", 1)),
    "N": ((1e4, "N", 1), (np.inf, "kN", 1e-3)),
    "N mm": ((1e4, "N mm", 1), (np.inf, "N m", 1e-3)),
    "N m": ((1e4, "N m", 1), (np.inf, "kN m", 1e-3)),
}


def moment_unit(results):
    units = results.units.get("force"), results.units.get("length")
    return " ".join(units) if all(units) else None


class Scale:
    """The factor and the unit that make the numbers of a plot readable."""

    def __init__(self, unit, *values):
        finite = np.concatenate([np.ravel(v) for v in values] or [[0.]])
        largest = np.nanmax(np.abs(finite)) if len(finite) else 0.
        self.factor, self.unit = 1., unit or ""
        # Zero is in the unit itself, not in the smallest that there is.
        for limit, name, factor in SI_PREFIXES.get(unit, ()) if largest else ():
            if largest < limit:
                self.unit, self.factor = name, factor
                break

    def __call__(self, values):
        return np.asarray(values) * self.factor

    def label(self, name):
        return f"{name} [{self.unit}]" if self.unit else name

    def number(self, value):
        return f"{value * self.factor:.6g} {self.unit}".rstrip()


class Place(Scale):
    """A scale of a coordinate. Far from its zero it counts from a round number,
    which the label names, so that the ticks need not carry it."""

    def __init__(self, unit, *values, origin=None):
        low = min(np.min(v) for v in values)
        high = max(np.max(v) for v in values)
        if origin is None:
            far = max(-low, high) > FAR * (high - low) > 0.
            origin = rounded(0.5 * (low + high), high - low) if far else 0.
        self.origin, self.of_origin = origin, Scale(unit, origin)
        super().__init__(unit, low - origin, high - origin)

    def __call__(self, values):
        return super().__call__(np.asarray(values) - self.origin)

    def label(self, name):
        if self.origin:
            sign = "−" if self.origin > 0. else "+"
            name = f"{name} {sign} {self.of_origin.number(abs(self.origin))}"
        return super().label(name)


def rounded(value, size):
    """The value to the digits that count beside a size."""
    return round(value, 1 - int(np.floor(np.log10(size))))


def at(results, table, *axes):
    """'x = 3 mm, y = 10 mm', the middle of a table, in the unit of the bodies."""
    scale = Scale(results.units.get("length"), results.size)
    return ", ".join(f"{c} = {scale.number(middle(table[c]) + 0.)}" for c in axes)


def middle(values):
    """Not the mean, whose rounding is that of all values."""
    return 0.5 * (values.min() + values.max())


# ---- figures


def new_figure(results, about, rows=1, columns=1, height=2.3, **options):
    figure, axes = plt.subplots(rows, columns, squeeze=False,
                                figsize=(WIDTH, 0.9 + height * rows), **options)
    # A dollar of the scene's title is one, and begins no formula.
    title = results.title.replace("$", r"\$")
    figure.suptitle(": ".join(filter(None, (title, about))), fontsize=12)
    return figure, axes


def tell_zero(figure, columns):
    """Says which components are not drawn because they are zero."""
    if columns:
        figure.set_figheight(figure.get_figheight() + 0.25)
        names = ", ".join(NAMES[c] for c in columns)
        figure.supxlabel(f"not drawn, as it is zero or rounding: {names}", fontsize=9,
                         color="0.35")


def in_rows(columns, most=3):
    """Columns in as few rows as need be, of equal lengths but for the last."""
    rows = -(-len(columns) // most)
    length = -(-len(columns) // max(rows, 1))
    return [columns[k:k + length] for k in range(0, len(columns), length or 1)]


def legend_above(axis, fewest=2):
    handles, labels = axis.get_legend_handles_labels()
    if len(handles) >= fewest:
        # About ten characters an inch, a handle taking eight.
        fitting = int(10 * WIDTH / (8 + max(len(label) for label in labels)))
        axis.legend(loc="lower left", bbox_to_anchor=(0, 1.0), ncol=max(
            1, min(len(handles), 3, fitting)), borderaxespad=0.2,
            handlelength=2.4)


def show_no_less(axis, direction, least=0.02):
    """Limits around what is drawn, and no narrower than a part of its largest value,
    which is as good as constant then."""
    low, high = getattr(axis, f"get_{direction}lim")()
    need = least * max(-low, high)
    if high - low < need:
        center = 0.5 * (low + high)
        getattr(axis, f"set_{direction}lim")(center - need / 2, center + need / 2)


# ---- the sizes of contours


def exaggeration(width, height, wanted=4.):
    """Round factors for x and z, one of them 1: both where the shape is readable,
    else the ones that make the longer side about so many times the shorter."""
    aspect = width / height
    if 1 / (1.5 * wanted) <= aspect <= 1.5 * wanted:
        return 1, 1
    factor = round_factor(max(aspect, 1 / aspect), wanted)
    return (1, factor) if aspect > 1 else (factor, 1)


def round_factor(wanted, present):
    """A round number, not below 1, that brings what is there near to what is wanted."""
    factors = np.array([k * 10.**p for p in range(12) for k in (1, 2, 3, 5)])
    return int(factors[np.argmin(np.abs(np.log(factors * present / wanted)))])


def drawn_larger(factor):
    return "" if factor == 1 else f"\nenlarged {factor} times"


class Frame:
    """Rows and columns of so many contours of one size, and the stretch of x and z
    that lets the data fill them; free if the axes need not be to any scale, true if
    they must be to the same."""

    def __init__(self, count, width, height, plies=1, free=False, true=False):
        # One below the other where they are wide and that is not too tall.
        for self.columns in (1, 2, 3):
            self.rows = -(-count // self.columns)
            across = WIDTH / self.columns - BESIDE
            # Some pixels a ply, but no panel taller than wide for that.
            wanted = min((4., 1.6, 2.)[self.columns - 1] if width > height else 1.6,
                         max(1., across / (0.08 * plies)))
            self.stretch = (1, 1) if free or true else exaggeration(
                width, height, wanted)
            drawn = 1. if free else width * self.stretch[0] / (height * self.stretch[1])
            self.height = min(across / drawn, 4.5)
            self.width = self.columns * (self.height * drawn + BESIDE)
            # A flat section leaves its color bar the height that that needs.
            self.room = max(self.height, LEAST_BAR)
            fits = self.rows * (self.room + ROW) <= TALLEST
            if count <= self.columns or (fits and (drawn > 1.4 or self.columns > 1)):
                break
        self.aspect = "auto" if free else self.stretch[1] / self.stretch[0]

    def figure(self, results, about, count):
        """The figure and as many axes as are asked for."""
        with plt.rc_context({"figure.constrained_layout.h_pad": 0.08}):
            figure, axes = new_figure(results, about, self.rows, self.columns,
                                      self.room + ROW, sharex=True, sharey=True)
        figure.set_figwidth(min(WIDTH, max(self.width, 0.7 * WIDTH)))
        for axis in axes.flat[count:]:
            axis.remove()
        for axis in axes.flat[:count]:
            axis.set_aspect(self.aspect)
            axis.grid(False)
            axis.xaxis.set_major_locator(MaxNLocator(6 if self.columns == 1 else 4))
        return figure, axes.flat[:count]

    def bars(self, count):
        """The (low, high) of so many color bars one above the other, over the height
        of a panel, the first uppermost."""
        high = 0.5 + 0.5 * self.room / self.height
        step = (2. * high - 1.) / count
        gap = 0.06 * step if count > 1 else 0.
        return [(high - (k + 1) * step + gap, high - k * step - gap)
                for k in range(count)]

    def label(self, axes, x, z):
        for k, axis in enumerate(axes):
            if k % self.columns == 0:
                axis.set_ylabel(z + drawn_larger(self.stretch[1]))
            if k + self.columns >= len(axes):
                axis.set_xlabel(x + drawn_larger(self.stretch[0]))
                axis.tick_params(labelbottom=True)


def color_bar(axis, shades, label, low=0., high=1.):
    """Beside the axes and as high as they are drawn, or over a part of the height."""
    columns = axis.get_subplotspec().get_gridspec().ncols
    width = WIDTH / columns - BESIDE
    beside = axis.inset_axes([1. + 0.08 / width, low, 0.15 / width, high - low])
    axis.get_figure().colorbar(shades, cax=beside)
    beside.yaxis.set_major_locator(MaxNLocator(6 if high - low > 0.6 else 4))
    beside.set_ylabel(label)


# ---- plies


class Plies:
    """The plies of a section along one coordinate, the lowest first: their numbers
    and edges, none where they do not lie one above the other."""

    def __init__(self, table, axis):
        spans = sorted((rows[axis].min(), rows[axis].max(), int(float(ply)))
                       for ply, rows in table.split("ply")) if "ply" in table else []
        thinnest = min((high - low for low, high, _ in spans), default=0.)
        if any(above[0] < below[1] - 1e-3 * thinnest
               for below, above in zip(spans, spans[1:])):
            spans = []
        self.numbers = [ply for _, _, ply in spans]
        self.edges = np.array([low for low, _, _ in spans] + [s[1] for s in spans[-1:]])

    def __len__(self):
        return len(self.numbers)

    def thickened(self, least=0.9, thin=0.35):
        """Where the edges are drawn if the thinnest ply is thin beside the mean, so
        that each ply gets room; None if no ply needs any."""
        if len(self) < 2:
            return None
        height = self.edges[-1] - self.edges[0]
        shares = np.diff(self.edges) / height
        if shares.min() * len(self) >= thin:
            return None
        drawn = np.maximum(shares, least / len(self))
        return self.edges[0] + height * np.concatenate(
            [[0.], np.cumsum(drawn) / drawn.sum()])

    def labels(self, spacing):
        """(text, place) no closer than the spacing: neighbors too thin for one each
        share it."""
        groups = [[low, high, [ply]] for low, high, ply in zip(
            self.edges, self.edges[1:], self.numbers)]
        while True:
            close = [k for k in range(len(groups) - 1)
                     if sum(groups[k + 1][:2]) - sum(groups[k][:2]) < 2 * spacing]
            if not close:
                break
            k = min(close, key=lambda k: groups[k + 1][1] - groups[k][0])
            below, above = groups[k], groups.pop(k + 1)
            groups[k] = [below[0], above[1], below[2] + above[2]]
        return [(f"ply {plies[0]}" if len(plies) == 1 else
                 f"plies {min(plies)}–{max(plies)}", 0.5 * (low + high))
                for low, high, plies in groups]


def apart(places, spacing):
    """Which of ascending places keep the spacing, the first and last among them."""
    kept = [0]
    for k in range(1, len(places) - 1):
        if (places[k] - places[kept[-1]] >= spacing
                and places[-1] - places[k] >= spacing):
            kept.append(k)
    return kept + [len(places) - 1]
