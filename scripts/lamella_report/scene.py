# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scene that was run: its entries, and what of them becomes words."""

import math

from markupsafe import Markup

from .formats import number


class Entries(dict):
    """Entries of a scene by their paths; what it does not say is empty."""

    def __missing__(self, path):
        return ""


def read_entries(text):
    """The entries of a resolved scene by their paths, `Body upper/Kinematics/Theory`. Throws
    ValueError with the number of the line that a scene would not have there."""
    entries, path, number_of_line = Entries(), [], 0
    for number_of_line, line in enumerate(text.split("\n"), 1):
        word, _, rest = without_comment(line).partition(" ")
        name, equals, value = rest.partition("=")
        if word == "subsection" and rest:
            path.append(" ".join(rest.split()))
        elif word == "end" and not rest and path:
            path.pop()
        elif word == "set" and equals:
            entries["/".join([*path, " ".join(name.split())])] = value.strip()
        elif word:
            raise ValueError(number_of_line)
    if path or not entries:
        raise ValueError(number_of_line)
    return entries


def without_comment(line):
    """A line up to its `#`; `\\#` is one of the value."""
    hidden = line.replace("\\#", "\0")
    return hidden.partition("#")[0].replace("\0", "#").strip()


def split(text, separator=","):
    """A list of a scene, cut where no parentheses are open; none of white space alone."""
    pieces, depth = [""], 0
    for c in text:
        depth += (c == "(") - (c == ")")
        if c == separator and depth == 0:
            pieces.append("")
        else:
            pieces[-1] += c
    return [piece.strip() for piece in pieces] if text.strip() else []


def regions_of(text):
    """(body, place) of each of `BODY: PLACE; BODY: PLACE`."""
    return [(*split(region, ":"), "")[:2] for region in split(text, ";")]


def to_number(text):
    """The number that an entry spells; NaN for what is none."""
    try:
        return float(text)
    except ValueError:
        return math.nan


def is_zero(text):
    return to_number(text) == 0.


def rubs(contact):
    """Whether the entries of a contact give it friction."""
    return contact["Friction"] not in ("none", "0")


def are_zero(text):
    """Whether a list has nothing but zeros, or nothing at all."""
    return all(map(is_zero, split(text)))


def point(text):
    """The numbers of a list as the scene writes them, `(0, 0, 1)`."""
    return Markup("({})").format(Markup(", ").join(map(number, split(text))))


def direction(text):
    """`along y` for directions along an axis of the scene; `along (1, 1, 0)`."""
    axes = [("−" if to_number(part) < 0. else "") + axis
            for part, axis in zip(split(text), "xyz") if not is_zero(part)]
    return Markup("along {}").format(
        Markup("<i>{}</i>").format(axes[0]) if len(axes) == 1 else point(text))


class Scene:
    """The entries of a scene and its names."""

    def __init__(self, text):
        """Throws ValueError with the number of a line that no scene has."""
        self.entries = read_entries(text)

    def __getitem__(self, path):
        return self.entries[path]

    def names(self, entry):
        """Those in a list of the scene: `Bodies`, say."""
        return split(self.entries[entry])

    def part(self, kind, name):
        """The entries of `subsection KIND NAME`, by their paths in it."""
        begin = f"{kind} {name}/"
        return Entries((path[len(begin):], value) for path, value in self.entries.items()
                       if path.startswith(begin))

    def parts(self, kind, entry):
        """(name, its entries) of each name in a list."""
        return [(name, self.part(kind, name)) for name in self.names(entry)]

    @property
    def has_friction(self):
        return any(rubs(contact) for _, contact in self.parts("Contact", "Contacts"))

    @property
    def has_heat(self):
        return any(load["Temperature"] for _, load in self.parts("Load", "Loads"))
