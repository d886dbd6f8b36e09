#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Spoils good scenes and meshes at random, one fault each, and judges what the
program makes of them.

Usage: spoil.py LAMELLA WORKDIR --count N --seed S [--jobs 2] [--limit 20]
                [--only KIND[,KIND...]] [--case I] [--list]

Every case takes one of BASES (or a mesh of prm/sections) and applies one of KINDS
to it; --list prints these. The same seed gives the same cases. What is due:

    refused   exit 1 or 2 with one message
    either    may run as well, if its results are numbers
    equal     may run as well, with the results of the good scene

and what came of it:

    crash     a signal, an internal error, an exit status other than 0, 1, 2
    time-out  more than --limit processor seconds, or ten times as many by the clock:
              others on the machine are no fault of a scene
    silent    it ran where it had to refuse; or ran, and left NaN, infinity, or
              results of another scene; or refused, and left files behind
    unclear   a message that is empty, long, of the machinery, that does not say
              where the fault is, or what to do about it
    ok

Cases that are not ok stay in WORKDIR/cases, each with its scene and a file `run`.
Exit status 1 if there is a crash, a time-out, a silent one, or 1 % of unclear ones.
"""

import argparse
import collections
import concurrent.futures
import json
import math
import os
import random
import re
import resource
import shlex
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LONGEST_MESSAGE = (12, 1500)  # lines, characters
# A user can do nothing with these.
OF_THE_MACHINERY = ("Exception", "Stack trace", "Stacktrace", "terminate called", "std::", "what()",
                    "dealii", "An error occurred", "basic_string", "boost", "regex_error",
                    "stoi", "stoul", "stod", "map::at", "json.", "vector::", "_M_", "errno")
# Words of advice, or of what would be right: they say what to do.
OF_A_REMEDY = re.compile(
    r"\b(must|needs?|nearest|use|write|give|name|keep|remove|rename|make|choose|change|check|draw|"
    r"put|add|hold|lower|raise|fewer|smaller|larger|instead|say|first|either|leave|close|move|set|"
    r"prescribe|reduce|refine|coarser|expected|as in|is missing|has no 'end|apart|report|one of|"
    r"between|merge|swap|turn|increase|scale|at most|at least|all of them|it has|is made of|"
    r"coherence|look|says|save|twice)\b", re.IGNORECASE)
MEMORY = 8 << 30
LARGEST_FILE = 2 << 30


# ---- what entries are

LISTS = ("Materials", "Sections", "Bodies", "Supports", "Loads", "Obstacles", "Contacts",
         "Probes", "Lines", "Cuts", "Measures")
POSITIVE = {"Width", "Height", "Ply thickness", "Radius", "Finest cell", "Wall thickness",
            "Web thickness", "Flange thickness", "Length", "Scale", "Rotation limit"}
COUNTS = {"Cells per ply", "Cells across", "Cells per wall", "Cells along wall", "Sectors",
          "Axis elements", "Samples", "Maximum iterations"}
VECTORS = {"Origin", "Through", "u"}
DIRECTIONS = {"Axis", "Up", "Normal"}
NUMBERS = {"Fiber angle", "Graded towards", "Axis breaks", "Across breaks", "Stabilization",
           "Load factors", "Isotropic", "Engineering constants", "Normal displacement",
           "Search distance", "Penalty", "Shear factor", "Refinements"}
POINTS = {"At", "From", "To"}
EXPRESSIONS = {"Force", "Pressure"}
NUMERIC = POSITIVE | COUNTS | VECTORS | DIRECTIONS | NUMBERS | POINTS | EXPRESSIONS | {"Layup"}
CHOICES = {"Theory", "Units", "Shape", "Axis element", "Discretization", "Enforcement",
           "Contact strategy", "Library", "Write VTU", "Linear solver", "Overclosure",
           "Slave side", "Poisson correction", "Shear strains", "Axis nodes", "Stress"}
NAMES = {"Section", "Material", "Ply materials"}
PLACES = {"On", "First", "Second"}
ONE_NUMBER = {"Length", "Width", "Height", "Radius", "Finest cell", "Scale", "Pressure",
              "Normal displacement", "Rotation limit", "Stabilization", "Fiber angle",
              "Maximum iterations", "Sectors", "Samples"}
A_FIXED_NUMBER = ONE_NUMBER | VECTORS | DIRECTIONS | POINTS | {
    "Isotropic", "Engineering constants", "Force"}
REQUIRED = {"Width", "Length", "Section", "On", "First", "Second", "From", "To", "Radius",
            "Materials", "Sections", "Bodies"}
NUMBER = re.compile(r"(?<![\w.])[-+]?\d+\.?\d*(?:[eE][-+]?\d+)?(?![\w.])")


class NotHere(Exception):
    """The scene at hand has nothing that this kind could spoil."""


# ---- scenes as lines

class Item:
    """A line of a scene: what it is, and in which subsections it stands."""

    def __init__(self, index, word, name="", value="", path=()):
        self.index, self.word, self.name, self.value, self.path = index, word, name, value, path

    @property
    def kind(self):
        """Body, Support, ...; empty at the top."""
        return self.path[0].split()[0] if self.path else ""


def items_of(lines):
    path, items = [], []
    for index, line in enumerate(lines):
        bare = line.split("#")[0].strip()
        word, _, rest = bare.partition(" ")
        if word == "subsection":
            items.append(Item(index, word, " ".join(rest.split()), path=tuple(path)))
            path.append(" ".join(rest.split()))
        elif word == "end":
            path.pop()
            items.append(Item(index, word, path=tuple(path)))
        elif word == "set":
            name, _, value = rest.partition("=")
            items.append(Item(index, word, name.strip(), value.strip(), tuple(path)))
    return items


def entries(lines, names=None, kind=None):
    return [item for item in items_of(lines) if item.word == "set"
            and (names is None or item.name in names)
            and (kind is None or item.kind == kind)]


def subsections(lines, depth=None):
    return [item for item in items_of(lines) if item.word == "subsection"
            and (depth is None or len(item.path) == depth)]


def end_of(lines, head):
    """The index of the `end` of the subsection that begins at the item @p head."""
    return next(item.index for item in items_of(lines)
                if item.word == "end" and item.index > head.index and item.path == head.path)


def set_line(item, value):
    return "  " * len(item.path) + f"set {item.name} = {value}"


def joined_lines(text):
    """Lines of a scene, those that a backslash continues in one."""
    return re.sub(r"\\\n\s*", "", text).splitlines()


def with_value(lines, path, value):
    """@p lines with the entry SUBSECTION/ENTRY set, which may be new; None removes it."""
    *where, name = path.split("/")
    for item in entries(lines, {name}):
        if list(item.path) == where:
            new = [] if value is None else [set_line(item, value)]
            return lines[:item.index] + new + lines[item.index + 1:]
    if not where:
        return [f"set {name} = {value}"] + lines
    head = next(s for s in subsections(lines) if [*s.path, s.name] == where)
    return lines[:head.index + 1] + [f"set {name} = {value}"] + lines[head.index + 1:]


# Good scenes, and what makes them small.
ELEMENTS = "Kinematics/Axis elements"
FEW = {f"Line {name}/Samples": "3" for name in (
    "upper_axis", "lower_axis", "upper_thickness", "lower_thickness", "lower_across")}
BASES = {
    "base": ("tests/bad_input/base.prm", {}),
    "laminated_beams": ("prm/laminated_beams.prm", {
        f"Body upper/{ELEMENTS}": "2", f"Body lower/{ELEMENTS}": "2",
        "Section strip/Cells across": "2", "Write VTU": "false", **FEW}),
    "sandwich": ("prm/sandwich.prm", {
        f"Body beam/{ELEMENTS}": "1, 1, 1, 1, 1", "Section sandwich/Cells across": "1",
        "Section sandwich/Cells per ply": "1, 1, 1, 2, 1, 1, 1", "Theory": "LE-1",
        "Write VTU": "false",
        **{f"Line {name}/Samples": "3" for name in (
            "thickness_150", "thickness_250", "top_axis", "bottom_axis")}}),
    "hertz": ("prm/hertz_plane_strain.prm", {
        "Section half/Finest cell": "2", "Section half/Sectors": "12", "Write VTU": "false",
        "Contact nip/Search distance": "0.2",
        **{f"Line {name}/Samples": "3" for name in ("lower_depth", "upper_depth", "across")}}),
    "cantilever": ("prm/cantilever.prm", {f"Body beam/{ELEMENTS}": "2", "Write VTU": "false"}),
    "solid": ("prm/cantilever.prm", {
        "Theory": "solid-1", f"Body beam/{ELEMENTS}": "4", "Body beam/Section": "sandwich",
        "Body beam/Kinematics/Refine near": "0.5, 0, 0.5: 0.5: 1", "Probes": "tip",
        "Probe tip/At": "beam: 2.5, 10, 0.5", "Probe quarter_left/At": None}),
    "hexagon": ("prm/sections/hexagon.prm", {
        "Theory": "TE-2", "Write VTU": "false", "Cut middle/Samples": "1",
        f"Body tube/{ELEMENTS}": "1, 1, 1"}),
    "shapes": ("prm/sections/shapes.prm", {
        "Theory": "TE-2", f"Body beam/{ELEMENTS}": "2", "Write VTU": "false",
        "Section half_disc/Finest cell": "2"}),
    "arc_pressure": ("tests/scenes/arc_pressure.prm", {"Section disc/Finest cell": "4"}),
    "cantilever_pressure": ("tests/scenes/cantilever_pressure.prm", {
        f"Body beam/{ELEMENTS}": "4", "Write VTU": "false"}),
    "crossed_beams": ("tests/scenes/crossed_beams.prm", {"Theory": "LE-1"}),
    "double_t": ("tests/scenes/double_t.prm", {
        "Theory": "TBT", f"Body beam/{ELEMENTS}": "1, 2", "Write VTU": "false"}),
    "end_to_end": ("tests/scenes/end_to_end.prm", {"Load factors": "0.5, 1"}),
    "held_by_contact": ("tests/scenes/held_by_contact.prm", {}),
    "rising_floor": ("tests/scenes/rising_floor.prm", {"Write VTU": "false"}),
    "slender": ("tests/scenes/slender_contact.prm", {
        "Body upper/" + ELEMENTS: "4", "Body lower/" + ELEMENTS: "4", "Theory": "EBBT"}),
}
MESHES = {"hexagon": "", "rail": "", "sandwich": "  set Parts = skin: carbon 45 | core: foam\n"}
MESH_SCENE = """set Title = A cantilever with a mesh
set Units = mm, N
set Theory = LE-1
set Write VTU = false
set Materials = carbon, foam
set Sections = meshed
set Bodies = beam
set Supports = clamp
set Loads = tip
set Probes = tip
subsection Material carbon
  set Isotropic = 70000, 0.3
end
subsection Material foam
  set Isotropic = 35, 0.3
end
subsection Section meshed
  set Shape = file
  set File = MESH.msh
PARTSend
subsection Body beam
  set Section = meshed
  set Length = 100
  subsection Kinematics
    set Axis elements = 1
  end
end
subsection Support clamp
  set On = beam: start
end
subsection Load tip
  set On = beam: top
  set Pressure = 0.001
end
subsection Probe tip
  set At = beam: PROBE
end
"""
PROBES = {"hexagon": "19, 100, 0", "rail": "10, 100, 15", "sandwich": "20, 100, 6"}


def dropped(lines, names):
    """@p lines without the subsections @p names."""
    for name in names:
        head = next(s for s in subsections(lines, 0) if s.name == name)
        lines = lines[:head.index] + lines[end_of(lines, head) + 1:]
    return lines


def base_lines(name):
    path, changes = BASES[name]
    lines = joined_lines((ROOT / path).read_text())
    for entry, value in changes.items():
        lines = with_value(lines, entry, value)
    if name == "solid":
        lines = dropped(lines, [f"Probe {p}" for p in (
            "quarter_left", "quarter_right", "late_left", "late_right")])
    return lines


class Draft:
    """A scene that is being spoiled: its files as bytes, and what to expect."""

    def __init__(self, rng, base):
        self.rng, self.base = rng, base
        self.lines = base_lines(base) if base in BASES else mesh_scene(base[5:])
        self.mesh = mesh_text(base[5:]) if base not in BASES else None
        self.due, self.what = "either", ""
        self.names = []          # one of these the message must have
        self.line = None         # or the number of this line
        self.bytes = None        # the scene's bytes, if they are not those of lines
        self.unsolved = False    # --validate in any case

    def pick(self, items):
        if not items:
            raise NotHere
        return self.rng.choice(items)

    def at(self, item, what, due):
        """The fault is at this item."""
        self.names += [item.name, *item.path]
        self.line, self.what, self.due = item.index, what, due

    def replace(self, item, value, due):
        self.at(item, f"{'/'.join([*item.path, item.name])} = {value[:60]}", due)
        self.lines[item.index] = set_line(item, value)

    def insert(self, index, *lines):
        self.lines[index:index] = lines

    def add_entry(self, head, name, value, due):
        """Into the subsection with this head."""
        self.names += [name, head.name]
        self.line, self.due = head.index + 1, due
        self.what = f"{head.name}/{name} = {value} added"
        self.insert(head.index + 1, f"  set {name} = {value}")

    def scene_bytes(self):
        return self.bytes if self.bytes is not None else ("\n".join(self.lines) + "\n").encode()


KINDS = collections.OrderedDict()


def kind(function):
    """A kind of fault; those whose names begin with mesh_ spoil meshes."""
    KINDS[function.__name__] = function
    return function


# ---- kinds: what is there, and how it is spelt

@kind
def delete_entry(draft):
    item = draft.pick(entries(draft.lines))
    required = item.name in REQUIRED or (item.name == "At" and item.kind in ("Probe", "Cut"))
    listed = item.name in LISTS
    draft.at(item, f"without {'/'.join([*item.path, item.name])}",
             "refused" if required or listed else "either")
    if listed:
        draft.names += [name.strip() for name in item.value.split(",")]
    del draft.lines[item.index]


@kind
def delete_subsection(draft):
    head = draft.pick(subsections(draft.lines))
    draft.at(head, f"without subsection {head.name}",
             "either" if head.name in ("Kinematics", "Trade") else "refused")
    draft.names += head.name.split()
    del draft.lines[head.index:end_of(draft.lines, head) + 1]


@kind
def delete_end(draft):
    item = draft.pick([i for i in items_of(draft.lines) if i.word == "end"])
    draft.at(item, f"line {item.index + 1}: no 'end'", "refused")
    draft.names += [s.name for s in subsections(draft.lines)]
    del draft.lines[item.index]


@kind
def extra_end(draft):
    item = draft.pick(items_of(draft.lines))
    draft.at(item, f"line {item.index + 1}: one 'end' more", "refused")
    draft.insert(item.index, "end")
    draft.names += ["'end'"]  # is told where the last one is too many


@kind
def double_entry(draft):
    item = draft.pick(entries(draft.lines))
    draft.at(item, f"{'/'.join([*item.path, item.name])} twice", "refused")
    draft.insert(item.index, draft.lines[item.index])


@kind
def double_subsection(draft):
    head = draft.pick(subsections(draft.lines))
    last = end_of(draft.lines, head) + 1
    draft.at(head, f"subsection {head.name} twice", "refused")
    draft.insert(last, *draft.lines[head.index:last])


def misspelt(rng, word):
    """No word of ours has a q within."""
    place = rng.randrange(1, len(word) + 1)
    return word[:place] + "q" + word[place:]


@kind
def misspell_entry(draft):
    item = draft.pick(entries(draft.lines))
    draft.at(item, f"{item.name} misspelt", "refused")
    item.name = misspelt(draft.rng, item.name)
    draft.lines[item.index] = set_line(item, item.value)


@kind
def misspell_subsection(draft):
    head = draft.pick(subsections(draft.lines))
    draft.at(head, f"subsection {head.name} misspelt", "refused")
    draft.lines[head.index] = "subsection " + misspelt(draft.rng, head.name)
    draft.names += head.name.split()


@kind
def misspell_keyword(draft):
    item = draft.pick(items_of(draft.lines))
    draft.at(item, f"line {item.index + 1}: {item.word} misspelt", "refused")
    draft.lines[item.index] = draft.lines[item.index].replace(
        item.word, misspelt(draft.rng, item.word), 1)


@kind
def no_equals(draft):
    item = draft.pick(entries(draft.lines))
    draft.at(item, f"line {item.index + 1}: no '='", "refused")
    draft.lines[item.index] = draft.lines[item.index].replace("=", "", 1).replace("=", "")


@kind
def odd_statement(draft):
    item = draft.pick(items_of(draft.lines))
    odd = draft.pick(["set /// = 1", "set = 1", "set", "set /", "subsection", "subsection /",
                      "end end", "include other.prm", "set Width = 1 = 2 =", "]", "set a/b/c = 1",
                      "subsection ///", "SET Title = x", "set \\ = 1", "%", "set Title == x"])
    draft.at(item, f"line {item.index + 1}: '{odd}'", "either" if "==" in odd else "refused")
    draft.names += odd.split() + [odd]
    draft.insert(item.index, odd)
    if odd.startswith("subsection "):
        draft.insert(item.index + 1, "end")


@kind
def path_as_entry(draft):
    """An entry of a subsection at the top, as --set has it."""
    item = draft.pick([i for i in entries(draft.lines) if i.path])
    path = "/".join([*item.path, item.name])
    draft.at(item, f"set {path} at the top", "equal")
    del draft.lines[item.index]
    draft.insert(0, f"set {path} = {item.value}")
    draft.names.append(path)


@kind
def misspell_word(draft):
    item = draft.pick(entries(draft.lines, CHOICES | NAMES | PLACES | set(LISTS)))
    if item.kind == "Trade" or not item.value:
        raise NotHere
    draft.replace(item, misspelt(draft.rng, item.value), "refused")
    draft.names += [w for w in re.split(r"[,:;\s]+", item.value) if w]


@kind
def other_case(draft):
    item = draft.pick([i for i in entries(draft.lines, CHOICES | NAMES)
                       if i.value.swapcase() != i.value])
    draft.replace(item, item.value.swapcase(), "either")


@kind
def swap_values(draft):
    all_of = entries(draft.lines)
    a = draft.pick(all_of)
    b = draft.pick([i for i in all_of if i.path == a.path and i.value != a.value])
    draft.replace(a, b.value, "either")
    draft.replace(b, a.value, "either")
    draft.what = f"{'/'.join([*a.path, a.name])} and {b.name} swapped"


@kind
def swap_lines(draft):
    a, b = draft.pick(items_of(draft.lines)), draft.pick(items_of(draft.lines))
    draft.at(a, f"lines {a.index + 1} and {b.index + 1} swapped", "either")
    lines = draft.lines
    lines[a.index], lines[b.index] = lines[b.index], lines[a.index]
    draft.names += [b.name, *b.path, *(s.name for s in subsections(base_lines(draft.base))),
                    "'end'", "'set"]


# ---- kinds: numbers

def spoil_number(draft, spoilt, due, names=NUMERIC):
    """Replaces one number of an entry by spoilt(text), or all of it if that is None."""
    item = draft.pick([i for i in entries(draft.lines, names) if NUMBER.search(i.value)])
    numbers = list(NUMBER.finditer(item.value))
    number = draft.rng.randrange(len(numbers))
    match = numbers[number]
    value = item.value[:match.start()] + spoilt(match[0]) + item.value[match.end():]
    draft.replace(item, value, due(item, number) if callable(due) else due)


def due_if_not_positive(item, number):
    refused = (item.name in POSITIVE | COUNTS or (item.name == "Isotropic" and number == 0)
               or (item.name == "Engineering constants" and number < 6))
    return "refused" if refused else "either"


@kind
def zero(draft):
    spoil_number(draft, lambda text: "0", due_if_not_positive)


@kind
def zero_direction(draft):
    item = draft.pick(entries(draft.lines, DIRECTIONS))
    draft.replace(item, "0, 0, 0", "refused")


@kind
def negative(draft):
    spoil_number(draft, lambda text: "-" + text.lstrip("+-") if float(text) else "-1",
                 due_if_not_positive)


def due_of_count(item, _):
    return "refused" if item.name in COUNTS else "either"


@kind
def huge(draft):
    spoil_number(draft, lambda text: "1e300", due_of_count)


@kind
def large(draft):
    spoil_number(draft, lambda text: "1e12", due_of_count)


@kind
def many(draft):
    spoil_number(draft, lambda text: draft.rng.choice(["9999", "10000", "1000"]), "either",
                 COUNTS)
    draft.unsolved = True  # some are large but good


@kind
def beyond_integers(draft):
    spoil_number(draft, lambda text: draft.rng.choice(
        ["4294967297", "2147483648", "18446744073709551617", "1.5"]), "refused", COUNTS)


@kind
def tiny(draft):
    spoil_number(draft, lambda text: "1e-310", due_of_count)


@kind
def small(draft):
    spoil_number(draft, lambda text: "1e-30", due_of_count)


@kind
def minus_tiny(draft):
    spoil_number(draft, lambda text: "-1e-310", due_if_not_positive)


@kind
def beyond_doubles(draft):
    spoil_number(draft, lambda text: "1e400", "refused")


@kind
def not_a_number(draft):
    spoil_number(draft, lambda text: draft.rng.choice(["nan", "NaN", "-nan", "nan(1)"]),
                 "refused")


@kind
def infinite(draft):
    spoil_number(draft, lambda text: draft.rng.choice(["inf", "-inf", "infinity"]), "refused")


@kind
def text_for_number(draft):
    spoil_number(draft, lambda text: draft.rng.choice(
        ["thick", "--1", "1.2.3", "1e", "+", "1 2", "0x10", "1f", "%d", "1_000", "$1", "'1'",
         "\"1\"", "1;2;3;4;5", ".", "1/", "()", "[1]", "\u22121", "\u0661", "1\u00a0"]),
        lambda item, _: "either" if item.name in ("Layup", "Force", "Pressure") else "refused")


@kind
def unit(draft):
    spoil_number(draft, lambda text: text + draft.rng.choice([" mm", "m", " N", "%"]), "refused")


@kind
def empty_value(draft):
    item = draft.pick(entries(draft.lines))
    draft.replace(item, "", "refused" if item.name in REQUIRED else "either")
    draft.names += [n.strip() for n in item.value.split(",")]


@kind
def only_separators(draft):
    item = draft.pick(entries(draft.lines, NUMERIC | PLACES | NAMES | set(LISTS)))
    draft.replace(item, draft.rng.choice([",", ",,,", ";", ":", "|", "/", "; ;", ": ,"]),
                  "either")
    draft.names += [n.strip() for n in item.value.split(",")]


@kind
def component_more(draft):
    item = draft.pick(entries(draft.lines, NUMERIC - {"Layup"}))
    draft.replace(item, item.value + ", 1", "refused" if item.name in A_FIXED_NUMBER else "either")


@kind
def component_fewer(draft):
    item = draft.pick([i for i in entries(draft.lines, NUMERIC - {"Layup"}) if "," in i.value])
    draft.replace(item, item.value.rpartition(",")[0],
                  "refused" if item.name in A_FIXED_NUMBER else "either")


# ---- kinds: names and contradictions

@kind
def unknown_name(draft):
    item = draft.pick(entries(draft.lines, NAMES | PLACES | {"From", "To"})
                      + [i for i in entries(draft.lines, {"At"}) if ":" in i.value])
    _, colon, rest = item.value.partition(":")
    draft.replace(item, "nobody" + colon + rest, "refused")


@kind
def unknown_surface(draft):
    item = draft.pick([i for i in entries(draft.lines, PLACES) if ":" in i.value])
    draft.replace(item, item.value.rpartition(":")[0] + ": nowhere", "refused")


@kind
def list_twice(draft):
    item = draft.pick([i for i in entries(draft.lines, set(LISTS)) if i.value])
    draft.replace(item, item.value + ", " + item.value.split(",")[0], "refused")


@kind
def list_more(draft):
    item = draft.pick(entries(draft.lines, set(LISTS)))
    draft.replace(item, item.value + ", nobody", "refused")
    draft.names.append("nobody")


@kind
def list_fewer(draft):
    item = draft.pick([i for i in entries(draft.lines, set(LISTS)) if i.value])
    names = [name.strip() for name in item.value.split(",")]
    gone = draft.pick(names)
    names.remove(gone)
    draft.replace(item, ", ".join(names), "refused")
    draft.names.append(gone)


def contradicting(value):
    """Another displacement where u (empty: 0, 0, 0) prescribes one."""
    components = [part.strip() for part in (value or "0, 0, 0").split(",")]
    return ", ".join(c if c == "free" else str(float(c) + 1.) for c in components)


@kind
def two_supports(draft):
    head = draft.pick([s for s in subsections(draft.lines, 0) if s.name.startswith("Support ")])
    last = end_of(draft.lines, head)
    given = {i.name: i.value for i in entries(draft.lines) if i.path == (head.name,)}
    draft.at(head, f"a support that contradicts {head.name}", "refused")
    given.pop("References", None)
    if "Normal displacement" in given:
        given["Normal displacement"] = str(float(given["Normal displacement"]) + 1.)
    else:
        given["u"] = contradicting(given.get("u"))
    draft.insert(last + 1, "subsection Support another",
                 *(f"  set {name} = {value}" for name, value in given.items()), "end")
    item = entries(draft.lines, {"Supports"})[0]
    draft.lines[item.index] += ", another"
    draft.names += ["another", "contradict"]


@kind
def two_of_a_kind(draft):
    """Entries that exclude each other."""
    excluding = {"Force": ("Pressure", "1"), "Pressure": ("Force", "0, 0, 1"),
                 "Library": ("Isotropic", "1, 0.3"), "Isotropic": ("Library", "IM7-8552"),
                 "u": ("Normal displacement", "0"), "Normal displacement": ("u", "0, 0, 0"),
                 "Engineering constants": ("Isotropic", "1, 0.3"),
                 "Layup": ("Radius", "1"), "Sectors": ("Layup", "0/90"),
                 "Wall thickness": ("Finest cell", "1"), "File": ("Height", "1")}
    item = draft.pick(entries(draft.lines, set(excluding)))
    if item.kind == "Obstacle":  # moves by u
        raise NotHere
    head = next(s for s in subsections(draft.lines) if [*s.path, s.name] == list(item.path))
    draft.add_entry(head, *excluding[item.name], "refused")
    draft.names.append(item.name)


@kind
def at_without_use(draft):
    with_at = {i.path for i in entries(draft.lines, {"At"})}
    head = draft.pick([s for s in subsections(draft.lines, 0)
                       if s.name.split()[0] in ("Support", "Load")
                       and (s.name,) not in with_at])
    draft.add_entry(head, "At", "0, 0, 0", "refused")


@kind
def on_twice(draft):
    """The same place twice: not twice the load."""
    item = draft.pick(entries(draft.lines, {"On"}))
    draft.replace(item, item.value + "; " + item.value.split(";")[0], "equal")


@kind
def contact_twice(draft):
    head = draft.pick([s for s in subsections(draft.lines, 0) if s.name.startswith("Contact ")])
    last = end_of(draft.lines, head) + 1
    draft.at(head, f"{head.name} again by another name", "refused")
    draft.insert(last, "subsection Contact another", *draft.lines[head.index + 1:last])
    item = entries(draft.lines, {"Contacts"})[0]
    draft.lines[item.index] += ", another"
    draft.names.append("Contact another")


@kind
def contact_with_itself(draft):
    first = draft.pick(entries(draft.lines, {"First"}))
    second = next(i for i in entries(draft.lines, {"Second"}) if i.path == first.path)
    if draft.rng.random() < 0.5:
        first, second = second, first
        if ":" not in second.value or ":" not in first.value:
            raise NotHere
    draft.replace(second, first.value, "refused")


@kind
def point_outside(draft):
    item = draft.pick([i for i in entries(draft.lines, POINTS) if ":" in i.value])
    numbers = item.value.partition(":")[2].split(",")
    numbers[draft.rng.randrange(len(numbers))] = " 12345.6"
    draft.replace(item, item.value.split(":")[0] + ":" + ",".join(numbers), "refused")


# ---- kinds: bytes

def in_bytes(draft, what, change, due="equal"):
    draft.what, draft.due = what, due
    draft.bytes = change(("\n".join(draft.lines) + "\n").encode())
    # Such faults are of the file as a whole.
    draft.names.append("scene.prm")


@kind
def nul(draft):
    item = draft.pick(entries(draft.lines, NUMERIC | CHOICES | PLACES))
    place = draft.rng.randrange(len(item.value) + 1)
    value = item.value[:place] + "\0" + item.value[place:]
    draft.replace(item, value, "refused")
    draft.what = draft.what.replace("\0", "<NUL>")


@kind
def nul_in_comment(draft):
    item = draft.pick(items_of(draft.lines))
    draft.at(item, "a NUL in a comment", "equal")
    draft.insert(item.index, "# a \0 b")
    draft.names.append("scene.prm")


@kind
def utf8_mark(draft):
    in_bytes(draft, "a byte order mark", lambda text: b"\xef\xbb\xbf" + text)


@kind
def utf16(draft):
    coding = draft.pick(["utf-16", "utf-16-le", "utf-16-be", "utf-32"])
    in_bytes(draft, coding, lambda text: text.decode().encode(coding))


@kind
def line_ends(draft):
    end = draft.pick([b"\r\n", b"\r", b"\n\n", b"\n\r", b"\v", b"\f", b"\xc2\x85", b" \t\n"])
    in_bytes(draft, f"lines that end in {end}", lambda text: text.replace(b"\n", end))


@kind
def blanks(draft):
    blank = draft.pick([b"\t", b"  ", b" \t ", b"\xc2\xa0", b"\v", b"\xe3\x80\x80"])
    in_bytes(draft, f"{blank} for blanks", lambda text: text.replace(b" ", blank))


@kind
def no_blanks(draft):
    item = draft.pick(entries(draft.lines))
    draft.at(item, f"{item.name}= without blanks", "equal")
    draft.lines[item.index] = f"set {item.name}={item.value}"


@kind
def cut_off(draft):
    """The file ends within a line."""
    text = ("\n".join(draft.lines)).encode()
    place = draft.rng.randrange(len(text))
    in_bytes(draft, f"the first {place} bytes", lambda _: text[:place], "either")


@kind
def foreign_letters(draft):
    """Latin-1 and other bytes that are no UTF-8, control characters, quotes in texts."""
    text = draft.pick([b"R\xf6hre", b"\xff\xfe", b"a\x1b[31mb", b"a\"b\\c", b"\xc3\xa9", b"a\x01b",
                       b"%s%n%d", b"{}", b"<&>", b"\xf0\x9f\x98\x80", b"$(x)`y`"])
    title = "set Title = TITLE" if draft.rng.random() < 0.7 else "# TITLE"
    lines = [line for line in draft.lines if not line.strip().startswith("set Title")]
    draft.lines = [title, *lines]
    in_bytes(draft, f"{title} with {text}", lambda whole: whole.replace(b"TITLE", text, 1))
    draft.names.append("Title")


@kind
def foreign_value(draft):
    item = draft.pick(entries(draft.lines, NUMERIC | CHOICES | NAMES | PLACES | set(LISTS)))
    draft.at(item, f"{item.name} with bytes that are no text", "refused")
    draft.lines[item.index] = set_line(item, item.value + "BYTES")
    text = draft.pick([b"\xff", b"\xe4", b"\x01", b"\x7f", b"\xc3\xa9", b"\x1b[0m"])
    draft.bytes = ("\n".join(draft.lines) + "\n").encode().replace(b"BYTES", text)


@kind
def backslash_in_comment(draft):
    item = draft.pick(entries(draft.lines))
    draft.at(item, f"a backslash at the end of a comment before {item.name}", "equal")
    if draft.rng.random() < 0.5 or item.index == 0:
        draft.insert(item.index, "# C:\\scenes\\")
    else:
        draft.lines[item.index - 1] += " # see C:\\"


@kind
def backslash_in_value(draft):
    """Joins two lines."""
    item = draft.pick(entries(draft.lines, NUMERIC | CHOICES))
    if not draft.lines[item.index + 1].strip().startswith(("set", "end", "subsection")):
        raise NotHere
    draft.replace(item, item.value + " \\", "refused")
    draft.names.append("'end'")
    draft.names += [s.name for s in subsections(draft.lines)]


@kind
def hash_value(draft):
    items = [i for i in entries(draft.lines, POSITIVE | COUNTS | VECTORS | {"Isotropic"} | PLACES)
             if i.value]
    item = draft.pick(items)
    draft.replace(item, "#" + item.value, "refused")
    if item.name == "Rotation limit":
        draft.due = "either"


@kind
def hash_within(draft):
    item = draft.pick([i for i in entries(draft.lines, NUMERIC) if len(i.value) > 1])
    place = draft.rng.randrange(1, len(item.value))
    draft.replace(item, item.value[:place] + "#" + item.value[place:], "either")


@kind
def long_number(draft):
    text = draft.pick(["1" * 10000, "0." + "1" * 10000, "(" * 10000, "1," * 5000, "-" * 10000,
                       "1e" + "9" * 10000, "0/" * 5000, "x" * 10000, "1+" * 5000 + "1"])
    item = draft.pick(entries(draft.lines, NUMERIC))
    fits = text.startswith("0.1") or (item.name in ("Layup", "Force", "Pressure"))
    draft.replace(item, text, "either" if fits else "refused")


@kind
def long_word(draft):
    item = draft.pick(entries(draft.lines, CHOICES | NAMES | PLACES | set(LISTS) | {"File"}))
    draft.replace(item, item.value + "q" * 10000, "refused")


@kind
def long_text(draft):
    item = draft.pick(entries(draft.lines))
    draft.at(item, "10,000 characters", "equal")
    which = draft.rng.randrange(3)
    if which == 0:
        draft.lines[item.index] += " # " + "q" * 10000
    elif which == 1:
        draft.insert(item.index, " " * 10000)
    else:
        draft.lines = [line for line in draft.lines if not line.strip().startswith("set Title")]
        draft.insert(0, "set Title = " + "q" * 10000)


@kind
def long_name(draft):
    item = draft.pick(items_of(draft.lines))
    draft.at(item, "a name of 10,000 characters", "refused")
    draft.insert(item.index, draft.pick(["set " + "q" * 10000 + " = 1", "q" * 10000,
                                         "set " + "/" * 10000 + " = 1"]))


# ---- kinds: expressions

EXPRESSIONS_OF_A_LOAD = {
    "x=1": "refused", "rand()": "refused", "rand_seed(1)": "refused", "(1": "refused",
    "1)": "refused", "sin(": "refused", "sin()": "refused", "1/0": "refused", "0/0": "refused",
    "1/(x-x)": "refused", "log(0)": "refused", "sqrt(-1)": "refused", "foo(x)": "refused",
    "q": "refused", "1 +": "refused", "x y": "refused", "2x": "refused", "1,5": "refused",
    "1e400": "refused", "'a'": "refused", "\"a\"": "refused", "x^^2": "refused",
    "y=x": "refused", "z+=1": "refused", "a=1": "refused", "1e308*1e308": "refused",
    "x=y=z": "refused", "t": "refused", "1;2": "refused", "max()": "refused",
    "if(x>0, 1, 2)": "either", "x > 0 ? 1 : 2": "either", "x > 0 ? 1": "refused", "_pi": "either",
    "sum(1, 2": "refused", "0x10": "either", "1e300": "either", "1e-310": "either", "-": "refused",
    "pi()": "refused", "sin x": "refused", "sin(x,y)": "refused", "exp(1000)": "refused",
    "tan(pi/2)": "either", "x!": "refused", "x//2": "refused", "x**2": "refused",
    "1 # 2": "either", "erf(x)": "either", "(((((((((((1)))))))))))": "either",
    "min(1,2,3)": "either", "ln(-1)": "refused", "0^-1": "refused", "(-8)^(1/3)": "refused",
    "{x}": "refused", "\\": "refused", "x\u00b2": "refused", "\u03c0": "refused"}


@kind
def expression(draft):
    item = draft.pick(entries(draft.lines, EXPRESSIONS))
    text = draft.pick(list(EXPRESSIONS_OF_A_LOAD))
    if text == "\\" and item.name == "Force":
        text = "1)"
    value = text if item.name == "Pressure" else f"0, 0, {text}"
    if text == "1 # 2":  # a comment, as anywhere
        value = value.replace("#", "# ")
    draft.replace(item, value, EXPRESSIONS_OF_A_LOAD[text])


# ---- kinds: meshes

def mesh_scene(name):
    text = MESH_SCENE.replace("MESH", name).replace("PARTS", MESHES[name]).replace(
        "PROBE", PROBES[name])
    return text.splitlines()


def mesh_text(name):
    return (ROOT / "prm/sections" / f"{name}.msh").read_text().splitlines()


def block(lines, name):
    """The indices of the lines between $name and $Endname."""
    return lines.index(f"${name}") + 1, lines.index(f"$End{name}")


def mesh_line(draft, sections=("Nodes", "Elements"), numbers=None, head=True):
    """The index of a line of these parts, of so many numbers if that is given."""
    found = []
    for section in sections:
        if f"${section}" in draft.mesh:
            first, last = block(draft.mesh, section)
            found += [i for i in range(first + (0 if head else 1), last)
                      if numbers is None or len(draft.mesh[i].split()) in numbers]
    return draft.pick(found)


def of_mesh(draft, index, what, due):
    shown = draft.mesh[index][:60] if index is not None else ""
    draft.what = f"{what}, line {index + 1 if index is not None else '-'}: {shown}"
    draft.due = due
    draft.names += [".msh"]


def spoil_mesh_number(draft, index, spoilt, what, due, which=None):
    of_mesh(draft, index, what, due)
    words = draft.mesh[index].split()
    place = draft.rng.randrange(len(words)) if which is None else which
    words[place] = spoilt
    draft.mesh[index] = " ".join(words)
    draft.what += f" -> {draft.mesh[index][:60]}"


def coordinates(draft):
    return mesh_line(draft, ("Nodes",), (3,), head=False)


def cell(draft):
    """A line of a quadrilateral."""
    return mesh_line(draft, ("Elements",), (5,), head=False)


@kind
def mesh_node_of_cell(draft):
    """-1, 0, 2^32 + 1, and others that do not exist."""
    spoil_mesh_number(draft, cell(draft), draft.pick(
        ["-1", "0", "4294967297", "999999", "2147483648", "-2147483649", "1.5", "nan", "a",
         "18446744073709551616"]), "node of a cell", "refused", -draft.rng.randrange(1, 5))


@kind
def mesh_count(draft):
    """Counts of nodes and elements, of a block or of all."""
    index = mesh_line(draft, numbers=(4,))
    spoil_mesh_number(draft, index, draft.pick(
        ["4294967297", "-1", "0", "1000000000", "999", "1e9", "99999999999999999999", "nan"]),
        "a count", "either")


@kind
def mesh_count_of_entities(draft):
    index = mesh_line(draft, ("PhysicalNames", "Entities"))
    spoil_mesh_number(draft, index, draft.pick(
        ["4294967297", "-1", "1000000000", "99", "99999999999999999999"]),
        "a number of entities", "either")


@kind
def mesh_number(draft):
    spoil_mesh_number(draft, mesh_line(draft), draft.pick(
        ["-1", "0", "1", "2", "4294967297", "1e9", "nan", "a", "1e300", "-5", "99"]),
        "a number", "either")


@kind
def mesh_missing_coordinate(draft):
    index = coordinates(draft)
    of_mesh(draft, index, "a coordinate is missing", "refused")
    draft.mesh[index] = draft.mesh[index].rpartition(" ")[0]


@kind
def mesh_bad_coordinate(draft):
    text = draft.pick(["nan", "inf", "-inf", "a", "1e300", "-1e300", "1e400", "1e12", "1,5", ""])
    spoil_mesh_number(draft, coordinates(draft), text, "a coordinate",
                      "either" if text == "1e12" else "refused", -draft.rng.randrange(2, 4))


@kind
def mesh_moved_node(draft):
    """Far away, or where another one is."""
    index, other = coordinates(draft), coordinates(draft)
    if index == other:
        raise NotHere
    of_mesh(draft, index, "two nodes at one place", "refused")
    draft.mesh[index] = " ".join(draft.mesh[index].split()[:-3] + draft.mesh[other].split()[-3:])


@kind
def mesh_swap_lines(draft):
    a, b = mesh_line(draft), mesh_line(draft)
    of_mesh(draft, a, f"swapped with line {b + 1}", "either")
    draft.mesh[a], draft.mesh[b] = draft.mesh[b], draft.mesh[a]


@kind
def mesh_delete_line(draft):
    index = mesh_line(draft)
    of_mesh(draft, index, "deleted", "refused")
    del draft.mesh[index]


@kind
def mesh_delete_any_line(draft):
    index = draft.rng.randrange(len(draft.mesh))
    of_mesh(draft, index, "deleted", "either")
    del draft.mesh[index]


@kind
def mesh_double_line(draft):
    index = mesh_line(draft)
    of_mesh(draft, index, "doubled", "refused")
    draft.mesh.insert(index, draft.mesh[index])


@kind
def mesh_double_any_line(draft):
    index = draft.rng.randrange(len(draft.mesh))
    of_mesh(draft, index, "doubled", "either")
    draft.mesh.insert(index, draft.mesh[index])


@kind
def mesh_tags(draft):
    """Of physical groups and entities."""
    index = mesh_line(draft, ("PhysicalNames", "Entities"), head=False)
    words = draft.mesh[index].split()
    place = draft.rng.choice([0, 1] if "\"" in draft.mesh[index] else
                             [k for k in (0, 7, 8, 9) if k < len(words)])
    spoil_mesh_number(draft, index, draft.pick(
        ["-" + words[place], "-1", "0", "4294967297", "255", "2147483648", "7", "a", "65536"]),
        "a tag", "either", place)


@kind
def mesh_cut_off(draft):
    index = mesh_line(draft)
    of_mesh(draft, index, "ends here", "refused")
    line = draft.mesh[index]
    draft.mesh = draft.mesh[:index] + [line[:draft.rng.randrange(len(line))]]


@kind
def mesh_type(draft):
    """The type of elements in the head of their block."""
    index = mesh_line(draft, ("Elements",), (4,), head=False)
    of_type = draft.mesh[index].split()[2]
    new = draft.pick([t for t in ("1", "2", "3", "10", "16", "99", "0", "-3", "15", "5",
                                  "4294967299") if t != of_type])
    # Blocks of points hold nothing that a section needs.
    spoil_mesh_number(draft, index, new, "the type of elements", "either" if of_type == "15"
                      else "refused", 2)


@kind
def mesh_turned_cell(draft):
    """Clockwise: it is turned back."""
    index = cell(draft)
    of_mesh(draft, index, "clockwise", "equal")
    words = draft.mesh[index].split()
    draft.mesh[index] = " ".join(words[:-4] + words[:-5:-1])


@kind
def mesh_bow_tie(draft):
    index = cell(draft)
    of_mesh(draft, index, "a bow tie", "refused")
    words = draft.mesh[index].split()
    words[-1], words[-2] = words[-2], words[-1]
    draft.mesh[index] = " ".join(words)


@kind
def mesh_twice_a_node(draft):
    index = cell(draft)
    of_mesh(draft, index, "a node twice", "refused")
    words = draft.mesh[index].split()
    words[-1] = words[-draft.rng.randrange(2, 5)]
    draft.mesh[index] = " ".join(words)


@kind
def mesh_format(draft):
    line = draft.pick(["4.1 1 8", "2.2 1 8", "3 0 8", "1 0 8", "4 0 8", "nan 0 8", "4.1", "",
                       "4.1 0 4", "4.1 0 99", "2.2 0 8", "-4.1 0 8", "4.1 0 8"])
    of_mesh(draft, 1, f"format {line}", "either")
    draft.mesh[1] = line


@kind
def mesh_name(draft):
    """The name of a group."""
    index = mesh_line(draft, ("PhysicalNames",), head=False)
    words = draft.mesh[index].split()
    new = draft.pick(["\"\"", "\"", "carbon", "\"all\"", "\"a b\"", "\"carbon\"", "\"top\"",
                      "\"" + "q" * 10000 + "\"", "\"\xe4\"", "\"a\"b\"", ""])
    of_mesh(draft, index, f"name {new[:20]}", "either")
    draft.mesh[index] = " ".join(words[:2] + [new])


@kind
def mesh_bytes(draft):
    index = mesh_line(draft)
    text = draft.pick(["\0", "\r", "\t", "#", "//", "\ufeff", ",", "$", "$EndNodes", "\n", "\x1a"])
    of_mesh(draft, index, f"with {text!r}", "either")
    line = draft.mesh[index]
    place = draft.rng.randrange(len(line) + 1)
    draft.mesh[index] = line[:place] + text + line[place:]


@kind
def mesh_line_ends(draft):
    end = draft.pick(["\r\n", "\r", " \n"])
    of_mesh(draft, None, f"lines that end in {end!r}", "equal")
    draft.mesh = end.join(draft.mesh).split("\n")


@kind
def mesh_other_file(draft):
    text = draft.pick([[], ["", ""], ["$MeshFormat", "4.1 0 8", "$EndMeshFormat"],
                       ["\0" * 1000], ["$Nodes", "$EndNodes"], ["$MeshFormat"],
                       ["$EndMeshFormat", "$MeshFormat"]])
    of_mesh(draft, None, f"another text, {text!r:.40}", "refused")
    draft.mesh = text


# ---- cases

class Case:
    def __init__(self, number, kind_name, draft, validate):
        self.number, self.kind, self.base = number, kind_name, draft.base
        self.due, self.what, self.names = draft.due, draft.what, draft.names
        self.line = draft.line
        self.scene = draft.scene_bytes()
        self.mesh = None if draft.mesh is None else (
            "\n".join(draft.mesh) + "\n").encode("utf-8", "replace")
        self.validate = draft.unsolved or (validate and draft.due != "equal")


def make_case(number, seed, kinds):
    """Kinds take turns, so that each comes as often as the others."""
    rng = random.Random(f"{seed}/{number}")
    name = kinds[number % len(kinds)]
    bases = [f"mesh {m}" for m in MESHES] if name.startswith("mesh_") else list(BASES)
    for _ in range(200):
        draft = Draft(rng, rng.choice(bases))
        try:
            KINDS[name](draft)
        except NotHere:
            continue
        return Case(number, name, draft, rng.random() < 0.5)
    sys.exit(f"spoil.py: no scene that {name} could spoil")


def write_files(case, folder):
    folder.mkdir(parents=True)
    (folder / "scene.prm").write_bytes(case.scene)
    if case.mesh is not None:
        name = case.base[5:]
        (folder / f"{name}.msh").write_bytes(case.mesh)
        return
    for path in (ROOT / "prm/sections").glob("*.msh"):
        if path.name.encode() in case.scene:
            shutil.copy(path, folder)


def limits(seconds):
    # So that a blow-up is seen in the one case, not on the whole machine.
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_FSIZE, (LARGEST_FILE, LARGEST_FILE))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_CPU, (math.ceil(seconds), math.ceil(seconds) + 1))


class Outcome:
    def __init__(self, status, out, message, seconds):
        self.status, self.out, self.message, self.seconds = status, out, message, seconds


def run(program, arguments, folder, limit):
    # Open MPI keeps one folder a user there, which runs at a time take from each other:
    # one ends, removes it, and the other cannot start. That is no fault of a scene.
    own = folder.parent / f"{folder.name}.tmp"
    own.mkdir(exist_ok=True)
    environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1",
                   "OMPI_MCA_orte_tmpdir_base": str(own)}
    start = time.monotonic()
    try:
        done = subprocess.run([program, *arguments], cwd=folder, env=environment, timeout=10. * limit,
                              capture_output=True, preexec_fn=lambda: limits(limit),
                              stdin=subprocess.DEVNULL)
    except subprocess.TimeoutExpired as expired:
        return Outcome(None, "", (expired.stderr or b"").decode("utf-8", "replace"), limit)
    finally:
        shutil.rmtree(own, ignore_errors=True)
    if done.returncode == -signal.SIGXCPU:
        return Outcome(None, "", done.stderr.decode("utf-8", "replace"), limit)
    return Outcome(done.returncode, done.stdout.decode("utf-8", "replace"),
                   done.stderr.decode("utf-8", "replace"), time.monotonic() - start)


def arguments_of(case):
    return ["scene.prm", "--output", "output"] + (["--validate"] if case.validate else [])


# ---- judgment

def numbers_not_finite(value, where=""):
    """Places in summary.json without a number; nlohmann writes null for NaN."""
    if isinstance(value, dict):
        for name, part in value.items():
            yield from numbers_not_finite(part, f"{where}/{name}")
    elif isinstance(value, list):
        for part in value:
            yield from numbers_not_finite(part, where)
    elif value is None or value in ("nan", "inf", "-nan", "-inf") or (
            isinstance(value, float) and abs(value) == float("inf")):
        yield where


def faults_of_results(folder):
    path = folder / "output/summary.json"
    if not path.exists():
        yield "exit 0 without summary.json"
        return
    try:
        summary = json.loads(path.read_bytes().decode("utf-8"))
    except ValueError as error:
        yield f"summary.json is no JSON: {error}"
        return
    for where in set(numbers_not_finite(summary)):
        if where.endswith("/buckling_factor"):  # None: nothing buckles.
            continue
        yield f"summary.json: {where} is no number"
    if summary.get("converged") is not True:
        yield "exit 0, and not converged"
    for table in (folder / "output").rglob("*.csv"):
        if re.search(rb"(?:^|[,\s])-?(?:nan|inf)\b", table.read_bytes()):
            yield f"{table.name} holds nan or inf"


def results_of(folder):
    """What stays the same in another spelling of the same scene."""
    summary = json.loads((folder / "output/summary.json").read_text())
    forces = [f for support in summary["supports"].values() for f in support["reaction"]]
    probes = folder / "output/probes.csv"
    return {"dofs": [summary["dofs"]], "energy": [summary["energy"]], "reactions": forces,
            "rows": [len(probes.read_text().splitlines())]}


def differences(good, results):
    for name, values in good.items():
        size = max(map(abs, values), default=0.)
        if len(values) != len(results[name]) or any(
                abs(a - b) > 1e-8 * size for a, b in zip(values, results[name])):
            yield f"{name} is not that of the good scene"


def faults_of_message(case, message):
    lines = message.strip().splitlines()
    if not lines:
        yield "nothing on stderr"
        return
    if len(lines) > LONGEST_MESSAGE[0] or len(message) > LONGEST_MESSAGE[1]:
        yield f"{len(lines)} lines, {len(message)} characters"
    if sum(line.startswith("lamella: ") for line in lines) != 1:
        yield "not one message"
    for word in OF_THE_MACHINERY:
        if word in message:
            yield f"the word {word}"
    if any(ord(c) < 32 and c not in "\n\t" for c in message):
        yield "control characters"
    flat = " ".join(message.split())
    places = [f":{n}:" for n in range(case.line, case.line + 3)] if case.line is not None else []
    # A failure of the numerics is of a body, a contact, a load step, not of an entry.
    if not any(name and name in flat for name in case.names + places) and not (
            case.due == "either" and re.search(r"bod(y|ies)|contact|load step|scene", flat)):
        yield "does not say where"
    if not OF_A_REMEDY.search(flat):
        yield "no remedy"


def left_behind(folder):
    return [str(path.relative_to(folder)) for path in sorted(folder.rglob("*"))
            if path.name != "scene.prm" and path.suffix != ".msh"]


def judge_success(case, outcome, folder, good):
    faults = []
    if case.due == "refused":
        faults.append("had to be refused")
    if case.validate:
        if re.search(r"(?<![\w.])-?(nan|inf)\b", outcome.out):
            faults.append("--validate prints nan or inf")
    else:
        faults += faults_of_results(folder)
        if case.due == "equal" and not faults:
            faults += differences(good[case.base], results_of(folder))
    return ("silent", "; ".join(faults)) if faults else ("ok", "")


def judge_refusal(case, outcome, folder):
    left = left_behind(folder)
    if outcome.status == 1 and left:
        return "silent", "exit 1 left " + ", ".join(left[:5])
    summary = folder / "output/summary.json"
    if outcome.status == 2 and summary.exists() and \
            json.loads(summary.read_text()).get("converged") is not False:
        return "silent", "exit 2, and converged"
    if outcome.status == 2 and left and not summary.exists():
        return "silent", "exit 2 left half of the results: " + ", ".join(left[:5])
    if case.due == "equal" and outcome.status == 2:
        return "silent", "exit 2, not the results of the good scene"
    faults = list(faults_of_message(case, outcome.message))
    return ("unclear", "; ".join(faults)) if faults else ("ok", "")


def judge(case, outcome, folder, good):
    """The class of the outcome, and why."""
    if outcome.status is None:
        return "time-out", f"{outcome.seconds:.0f} s"
    said = outcome.message + outcome.out
    for word in ("internal error", "terminate called", "AddressSanitizer", "runtime error:"):
        if word in said:
            return "crash", word
    if outcome.status not in (0, 1, 2):
        return "crash", f"exit status {outcome.status}"
    if outcome.status == 0:
        return judge_success(case, outcome, folder, good)
    return judge_refusal(case, outcome, folder)


# ---- all of it

def good_results(program, workdir, bases, jobs, limit):
    """Runs the scenes as they are, which must be good."""
    def of(base):
        folder = workdir / "good" / base.replace(" ", "_")
        draft = Draft(random.Random(0), base)
        case = Case(0, "good", draft, False)
        write_files(case, folder)
        outcome = run(program, arguments_of(case), folder, limit)
        faults = [f"exit status {outcome.status}: {outcome.message}"] if outcome.status else list(
            faults_of_results(folder))
        if faults:
            sys.exit(f"spoil.py: {base} is no good scene: {'; '.join(faults)}")
        return base, results_of(folder)

    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        return dict(pool.map(of, sorted(bases)))


def check(program, case, workdir, good, limit):
    folder = workdir / "cases" / f"{case.number:05d}_{case.kind}"
    write_files(case, folder)
    outcome = run(program, arguments_of(case), folder, limit)
    verdict, why = judge(case, outcome, folder, good)
    if verdict == "ok":
        shutil.rmtree(folder)
    else:
        command = shlex.join([str(program), *arguments_of(case)])
        (folder / "run").write_text(
            f"cd {folder}\n{command}\n# {case.base}: {case.what}\n# due: {case.due}\n"
            f"# {verdict}: {why}\n# exit status {outcome.status}\n{outcome.message}\n")
    return case, verdict, why, outcome


CLASSES = ("ok", "unclear", "silent", "time-out", "crash")


def print_table(results):
    counts = collections.defaultdict(collections.Counter)
    for case, verdict, _, _ in results:
        counts[case.kind][verdict] += 1
    width = max(map(len, counts))
    print(f"{'':{width}}", *(f"{name:>8}" for name in CLASSES))
    for name in KINDS:
        if name in counts:
            print(f"{name:{width}}", *(f"{counts[name][c] or '':>8}" for c in CLASSES))
    total = collections.Counter(verdict for _, verdict, _, _ in results)
    print(f"{'all':{width}}", *(f"{total[c]:>8}" for c in CLASSES))
    return total


def print_failures(results, workdir):
    for case, verdict, why, outcome in results:
        if verdict != "ok":
            folder = workdir / "cases" / f"{case.number:05d}_{case.kind}"
            print(f"\n{verdict}: case {case.number}, {case.kind}, {case.base}: {case.what!r}; "
                  f"due: {case.due}; {why}")
            print(f"  in {folder}: {shlex.join(['lamella', *arguments_of(case)])}")
            for line in outcome.message.strip().splitlines()[:12]:
                print("  |", "".join(c if c.isprintable() else "?" for c in line[:200]))


def arguments():
    parser = argparse.ArgumentParser(usage=__doc__.replace("%", "%%"))
    parser.add_argument("lamella", nargs="?")
    parser.add_argument("workdir", nargs="?", type=Path)
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", default="1")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--limit", type=float, default=20.)
    parser.add_argument("--only", default="")
    parser.add_argument("--case", type=int)
    parser.add_argument("--list", action="store_true")
    given = parser.parse_args()
    if not given.list and (given.lamella is None or given.workdir is None):
        sys.exit(__doc__)
    return given


def main():
    given = arguments()
    if given.list:
        print("kinds:", *KINDS, "\nscenes:", *BASES, "\nmeshes:", *MESHES)
        return 0
    program, workdir = Path(given.lamella).resolve(), given.workdir.resolve()
    # Only what an earlier run made.
    for name in ("cases", "good"):
        shutil.rmtree(workdir / name, ignore_errors=True)
    kinds = [name for name in KINDS if not given.only or name in given.only.split(",")]
    random.Random(str(given.seed)).shuffle(kinds)
    numbers = range(given.count) if given.case is None else [given.case]
    cases = [make_case(number, given.seed, kinds) for number in numbers]
    start = time.monotonic()
    good = good_results(program, workdir, {case.base for case in cases}, given.jobs, given.limit)
    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        results = list(pool.map(
            lambda case: check(program, case, workdir, good, given.limit), cases))
    total = print_table(results)
    print_failures(results, workdir)
    print(f"\n{len(cases)} cases, seed {given.seed}, {time.monotonic() - start:.0f} s")
    bad = total["crash"] + total["time-out"] + total["silent"]
    return 1 if bad or 100 * total["unclear"] >= len(cases) else 0


if __name__ == "__main__":
    sys.exit(main())
