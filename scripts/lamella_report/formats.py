# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers, formulas and units as HTML: the filters of the templates."""

import math
import re

from markupsafe import Markup, escape

ROUNDING = 1e-9  # of what stands beside a number: it is shown as 0
NUMBER = re.compile(r"-?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?", re.ASCII | re.IGNORECASE)
NAMED = re.compile(r"-?(inf|infinity|nan)", re.IGNORECASE)
COMPONENT = re.compile(r"([ufm])([xyz])|([seg])([xyz]{2}|[123]{2})")
LETTERS = {"u": "u", "f": "F", "m": "M", "s": "σ", "e": "ε", "g": "γ"}
RAISED = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")
NONE = "–"


class Written(float):
    """A number that keeps the text it was read from, with all of its digits."""

    def __new__(cls, text):
        number = super().__new__(cls, text)
        number.text = text
        return number


def spelt(text):
    """The number that all of a text spells, in the grammar of C; NaN for other texts."""
    spells = NUMBER.fullmatch(text) or NAMED.fullmatch(text)
    return float(text) if spells else math.nan


def readable(value, digits=5):
    """A number for people: significant digits, a minus sign and powers of ten in Unicode,
    as in −1.3396·10⁸. Infinities and what is no number are named as such."""
    if math.isnan(value):
        return "not a number"
    if math.isinf(value):
        return "infinite" if value > 0. else "−infinite"
    mantissa, _, exponent = f"{value:.{digits}g}".partition("e")
    text = mantissa + (f"·10{str(int(exponent)).translate(RAISED)}" if exponent else "")
    return text.replace("-", "−")


def number(value, scale=0., digits=5):
    """`<data value="...">` of a number at hand, of JSON or as a cell of a table spells it:
    all digits for programs, and readable() ones for people.

    A dash where there is none, the text itself if it spells none. What is below 1e-9 of
    scale, the size of its neighbors, is rounding and is shown as 0.
    """
    if isinstance(value, Written):
        value = value.text
    elif isinstance(value, (int, float)) and not isinstance(value, bool):
        value = f"{value:.15g}"
    if not isinstance(value, str) or not value:
        return Markup(NONE)
    if not (NUMBER.fullmatch(value) or NAMED.fullmatch(value)):
        return escape(value)
    shown = float(value)
    if abs(shown) < ROUNDING * scale:
        shown = 0.
    return Markup('<data value="{}">{}</data>').format(value, readable(shown, digits))


def is_number_cell(cell):
    """Whether a cell of a table is one number and nothing else, or none."""
    cell = str(cell)
    return cell == NONE or (cell.startswith("<data") and
                            cell.find("</data>") == len(cell) - len("</data>"))


def size_of(values):
    """The largest size of the finite ones among these numbers; 0 without any."""
    return max((abs(v) for v in values if isinstance(v, float) and math.isfinite(v)),
               default=0.)


def components(vector):
    """A vector of JSON as `(x, y, z)`; what is rounding beside the largest reads 0."""
    if not vector:
        return Markup(NONE)
    scale = size_of(vector)
    return Markup("({})").format(Markup(", ").join(number(v, scale) for v in vector))


def symbol(name):
    """The name of a column as a formula: uz as u with the index z, sxy as sigma, exx as
    epsilon, gxy as gamma; other names as they are."""
    if len(name) == 1:
        return Markup("<i>{}</i>").format(name)
    found = COMPONENT.fullmatch(name)
    if not found:
        return escape(name)
    return Markup("<i>{}</i><sub>{}</sub>").format(LETTERS[name[0]], name[1:])


class Units:
    """The labels of a scene's units; a scene without has the kinds in their place."""

    def __init__(self, labels):
        self.labels = labels

    def label(self, kind):
        """Of "length", "force" or "stress"; empty in a scene without units."""
        return self.labels.get(kind, "")

    def named(self, kind):
        return self.label(kind) or kind

    def brackets(self, kind):
        """`[mm]`; also of a moment, of EI, of an area, of a density, a "mass" and a moment of
        "inertia", and of a load on a "surface", along a "line" or at a "point". Without units
        `[length]`, `[force length]`."""
        force, length = self.named("force"), self.named("length")
        mass = {"m": "kg", "mm": "t"}.get(length)
        unit = {"moment": f"{force} {length}", "bending": f"{force} {length}²",
                "surface": f"{force}/{length}²", "line": f"{force}/{length}",
                "area": f"{length}²", "point": force,
                "mass": mass or "force s²/length",
                "inertia": f"{mass} {length}²" if mass else "force length s²",
                "density": f"{mass}/{length}³" if mass else "force s²/length⁴",
                }.get(kind) or self.named(kind)
        return f"[{unit}]"

    def behind(self, kind):
        """The unit as the ending of a number, ` mm`."""
        label = self.label(kind)
        return Markup("&nbsp;{}").format(label) if label else ""

    def of_column(self, name):
        """In brackets the unit of a column of a table, or of a resultant: of `uz`, `sxy`,
        `fz`, `mx`, `x`, `pressure`, `width`, `frequency`. Empty where there is none."""
        if name == "frequency":
            return "[Hz]"
        kind = {"pressure": "stress", "width": "length", "dissipated": "moment",
                "peel": "stress", "shear": "stress"}.get(name)
        if kind is None and 0 < len(name) <= 3:
            kind = {"u": "length", "x": "length", "y": "length", "z": "length",
                    "s": "stress", "f": "force", "m": "moment"}.get(name[0])
        return self.brackets(kind) if kind else ""

    def with_unit(self, column):
        """The column as a formula with its unit."""
        unit = self.of_column(column)
        return Markup("{} {}").format(symbol(column), unit) if unit else symbol(column)
