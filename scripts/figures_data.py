# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a run left in a folder, for scripts/plot: read, and rounding made zero.

Everything that is drawn has passed through here, so no figure needs to know what is
rounding: a column that is all zero is none.
"""

import csv
import json
from pathlib import Path

import numpy as np

ROUNDING = 1e-12  # of the largest coordinate: a place at zero
NEGLIGIBLE = 1e-6  # of the largest component: rounding, not worth a panel
LEAST_SHEAR = 1e-3  # of the largest stress: what is drawn beyond the usual ones
SOFT = 0.1  # of what others bear: a material that stays below has its own color scale
DISPLACEMENTS = ("ux", "uy", "uz")
STRAINS = ("exx", "eyy", "ezz", "gxy", "gxz", "gyz")
STRESSES = ("sxx", "syy", "szz", "sxy", "sxz", "syz")


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
        self.folder = folder = Path(folder)
        summary = folder / "summary.json"
        self.summary = json.loads(summary.read_text()) if summary.exists() else {}
        self.title = self.summary.get("title", "")
        self.units = self.summary.get("units") or {}
        self.lines = [line for path in sorted(folder.glob("lines/*.csv"))
                      for line in self.lines_of(path)]
        self.cuts = {name: dict(table.split("body")) if len(table) else {}
                     for name, table in self.tables(folder.glob("cuts/*.csv")).items()}
        self.contacts = self.tables(folder.glob("contact_*.csv"), "contact_")
        self.sections = self.tables(folder.glob("sections/*.csv"))
        (self.history, self.fields, self.goals, self.passes, self.failure, self.modes,
         self.response, plies_along) = (
            Table.read(path) if path.exists() else Table((), ())
            for path in (folder / f"{name}.csv" for name in (
                "history", "fields", "goals", "passes", "failure", "modes", "response",
                "plies_along")))
        self.plies_along = plies_along.last_step()
        scene = folder / "scene.prm"
        self.scene = read_scene(scene.read_text()) if scene.exists() else {}
        self.remove_rounding()

    @staticmethod
    def lines_of(path):
        table = Table.read(path).last_step()
        return [Line(path.stem, rows) for _, rows in table.split("body")] if len(
            table) else []

    @staticmethod
    def tables(paths, prefix=""):
        return {path.stem[len(prefix):]: Table.read(path).last_step()
                for path in sorted(paths)}

    def remove_rounding(self):
        fields = [line.table for line in self.lines] + [
            rows for cut in self.cuts.values() for rows in cut.values()]
        contacts = list(self.contacts.values())
        self.size = max((magnitude(fields + contacts, c) for c in "xyz"), default=0.)
        for table in fields + contacts:
            for c in filter(table.__contains__, ("x", "y", "z", "x2", "y2", "z2")):
                table[c][np.abs(table[c]) < ROUNDING * self.size] = 0.
        for columns in (DISPLACEMENTS, STRAINS, STRESSES):
            whole = {c: magnitude(fields, c) for c in columns}
            for table in fields:
                for c in filter(table.__contains__, columns):
                    if magnitude([table], c) <= zero_below(c, whole):
                        table[c][:] = 0.
        stress = max((magnitude(fields, c) for c in STRESSES), default=0.)
        pressure = magnitude(contacts, "pressure")
        for table in contacts:
            light = table["pressure"] <= max(NEGLIGIBLE * pressure, 1e-12 * stress)
            table["pressure"][light] = 0.
            table["active"][light] = 0.

    def frame(self, body):
        """The body's axis, width and thickness, as the letters nearest to them, and
        whether its axis is one of x, y, z."""
        entries = self.scene.get(f"Body {body}", {})
        axis, up = (np.abs([float(v) for v in entries.get(name, default).split(",")])
                    for name, default in (("Axis", "0, 1, 0"), ("Up", "0, 0, 1")))
        k = int(np.argmax(axis))
        up[k] = -1.
        m = int(np.argmax(up))
        return "xyz"[k], "xyz"[3 - k - m], "xyz"[m], bool(
            axis[k] > (1. - 1e-9) * np.linalg.norm(axis))

    def is_flat_laminate(self, section):
        """Whether a section is a stack of level plies made by the program: what is
        drawn of all others, meshes by Gmsh among them, stays in proportion."""
        entries = self.scene.get(f"Section {section}", {})
        return entries.get("Shape", "laminate") == "laminate"

    def section_of(self, body):
        return self.scene.get(f"Body {body}", {}).get("Section", "")

    def materials(self, body):
        """The material of each ply number of a body; none without its section."""
        table = self.sections.get(self.section_of(body))
        if table is None or not len(table):
            return {}
        return dict(zip(table["ply"].astype(int), table["material"].astype(str)))

    def unit(self, column):
        if column[0] in "eg":
            return None
        kind = ("stress" if column[0] == "s" or column == "pressure" else
                "force" if column == "force" else "length")
        return self.units.get(kind)


def magnitude(tables, column):
    return max((np.nanmax(np.abs(t[column])) for t in tables
                if len(t) and column in t), default=0.)


def zero_below(column, whole):
    """Up to where a column of a table is no result, from the largest of each column
    of its kind in the whole run: rounding; for stresses also what a mesh leaves where
    symmetry asks for zero, little beside all stresses and beside its own elsewhere."""
    largest = max(whole.values())
    if column in DISPLACEMENTS:
        return 1e-9 * largest
    rounding = NEGLIGIBLE * largest
    if column in STRAINS:
        return rounding
    return max(rounding, min(2e-5 * largest, 1e-2 * whole[column]))


def stress(a, b):
    return "s" + "".join(sorted(a + b))


def that_matter(tables, columns, size=magnitude):
    """The columns that are not rounding beside the largest of them."""
    sizes = {c: size(tables, c) for c in columns}
    largest = max(sizes.values())
    return [c for c in columns if sizes[c] > NEGLIGIBLE * largest]


def variation(tables, column):
    return max(np.ptp(table[column]) for table in tables)


def stresses_to_show(tables, axis="y", across="x", up="z"):
    """Of a body: shear and axial stress; the other shears where plies at angles (or
    edges) make them more than noise, the thickness stress where contact makes it
    big."""
    order = {stress(up, axis): 0., stress(axis, axis): 0.,
             stress(across, axis): LEAST_SHEAR, stress(across, up): LEAST_SHEAR,
             stress(up, up): 0.1}
    sizes = {c: magnitude(tables, c) for c in order}
    largest = max(sizes.values())
    return [c for c, least in order.items()
            if sizes[c] > max(least, NEGLIGIBLE) * largest]


def own_scales(materials, table, column):
    """(names, rows) of what shares a color scale, the most stressed first: a material
    that stays below a tenth of the others, as a core beside its faces, has one of its
    own, so that what varies in it is seen; but for components that are little in it,
    too. A single pair without names where all share one."""
    kind = STRESSES if column in STRESSES else STRAINS
    rows = {name: table.where(np.isin(table["ply"].astype(float), [
        ply for ply, other in materials.items() if other == name]))
        for name in dict.fromkeys(materials.values())}
    rows = {name: part for name, part in rows.items() if len(part)}
    size = {name: magnitude([part], column) for name, part in rows.items()}
    groups = []
    for name in sorted(size, key=size.get, reverse=True):
        matters = size[name] > LEAST_SHEAR * max(magnitude([rows[name]], c) for c in kind)
        if groups and (size[name] >= SOFT * size[groups[-1][0]] or not matters):
            groups[-1].append(name)
        else:
            groups.append([name])
    if len(groups) < 2 or sum(map(len, rows.values())) < len(table):
        return [("", table)]
    return [(", ".join(group), table.where(np.isin(table["ply"].astype(float), [
        ply for ply, name in materials.items() if name in group]))) for group in groups]


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
