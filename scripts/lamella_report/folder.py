# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a run left in its folder (doc/reference/output.md), read."""

import csv
import json
import math
import os
import time

from .formats import Units, Written, spelt
from .scene import Scene

# What members of summary.json are, those that are there; ANY is each of another name.
ANY = ""
FORCES = {ANY: {"force": list, "moment": list, "reaction": list, "about": list}}
FORM = {
    "title": str, "version": str, "no_error_bars": str, "converged": bool, "warnings": list,
    "units": {ANY: str}, "theory": {ANY: str}, "seconds": {},
    "bodies": {ANY: {"solver": {"name": str}}},
    "loads": FORCES, "supports": FORCES, "contacts": FORCES,
    "strength": {"body": str, "criterion": str, "mode": str},
    "first_failure": {"body": str, "criterion": str, "mode": str, "place": list},
    "beyond_linear": {"stiffened": str, "buckled": str},
    "inertia": {"mass": float, "center": list, "moments": list},
    "interface_jumps": {}, "interface_jumps_of_tractions": {},
    "free_corrections": list, "contact_corrections": list,
}

CHANGED = "The file was cut off or changed; run the scene again. [report.damaged-file]"
DAMAGED = f"it is not what a run writes there. {CHANGED}"


class InputError(Exception):
    """A fault of what the user gave, in words for the user: where, the rule, the remedy."""


def content_of(path):
    """All bytes of a file; none if it cannot be read."""
    try:
        with open(path, "rb") as file:
            return file.read()
    except OSError:
        return b""


def text_of(path):
    """The text of a file; what is no UTF-8 becomes U+FFFD."""
    return content_of(path).decode(errors="replace")


def has_form(value, form):
    """Whether a value of JSON is what FORM says of it."""
    if isinstance(form, dict):
        return isinstance(value, dict) and all(
            has_form(v, form.get(k, form.get(ANY, object))) for k, v in value.items())
    return isinstance(value, form)


def read_json(path, form):
    """The object in a file, its numbers as they are written there. Throws InputError unless
    it has this form."""
    def refuse(constant):
        raise ValueError(constant)

    try:
        value = json.loads(content_of(path).decode(), parse_float=Written, parse_int=Written,
                           parse_constant=refuse)
    except (ValueError, RecursionError):
        value = None
    if not has_form(value, form):
        raise InputError(f"{path}: {DAMAGED}")
    return value


class Table:
    """A table of a run: names of columns, and rows by these names, as they are written."""

    def __init__(self, names=(), rows=()):
        self.names, self.rows = list(names), list(rows)

    @classmethod
    def read(cls, path):
        """The file at this path; an empty table if there is none. Throws InputError if a row
        has more or fewer cells than there are names."""
        lines = csv.reader(text_of(path).removesuffix("\n").split("\n"))
        try:
            names, *rows = lines
        except csv.Error:
            raise InputError(f"{path}: {DAMAGED}") from None
        for number, cells in enumerate(rows, 2):
            if len(cells) != len(names):
                raise InputError(f"{path}: line {number} has {len(cells)} cells where the first "
                                 f"line has {len(names)}. {CHANGED}")
        return cls(names, (dict(zip(names, cells)) for cells in rows))

    def last_step(self):
        """The rows of the largest number in the column `step`; without one, all."""
        steps = [value(row, "step") for row in self.rows]
        last = max((s for s in steps if not math.isnan(s)), default=-math.inf)
        return Table(self.names, (row for row, s in zip(self.rows, steps) if not s < last))


def value(row, name):
    """The number in a column of a row; NaN if there is none."""
    return spelt(row.get(name, ""))


class RunFolder:
    """The files of a run. Only summary.json and scene.prm must be there; of what else is
    missing the tables are empty, as of a scene that did not ask for it."""

    def __init__(self, path):
        """Throws InputError if there is no such folder, if no run has left its results
        there, or if a file is not what a run writes."""
        self.path = path.rstrip("/") or path[:1]
        self.require_results()
        self.summary = read_json(self.file("summary.json"), FORM)
        self.units = Units(self.summary.get("units", {}))
        self.scene_text = text_of(self.file("scene.prm"))
        try:
            self.scene = Scene(self.scene_text)
        except ValueError as error:
            raise InputError(f"{self.file('scene.prm')}:{error}: {DAMAGED}") from None
        self.probes = self.table("probes").last_step()
        self.history, self.goals, self.passes, self.plies, self.modes, self.response = map(
            self.table, ("history", "goals", "passes", "plies", "modes", "response"))

    def file(self, name):
        return f"{self.path}/{name}"

    def require_results(self):
        place = f"report {self.path}: "
        if not os.path.exists(self.path):
            raise InputError(place + "there is no folder of this name. Name the folder with the "
                             "results of a run, as in results/cantilever. [report.no-folder]")
        if not os.path.isdir(self.path):
            raise InputError(place + "this is a file, not a folder. Name the folder with the "
                             "results of a run; lamella SCENE.prm runs a scene. "
                             "[report.not-a-folder]")
        for name in ("summary.json", "scene.prm"):
            if not os.path.isfile(self.file(name)):
                raise InputError(
                    f"{place}the folder has no results of a run, since it has no {name}. Name the "
                    "folder of a run that completed a load step; for a variant of a trade, name "
                    "variants/NN_NAME/run. [report.no-results]")

    def table(self, name):
        return Table.read(self.file(f"{name}.csv"))

    def contact(self, name):
        """The pairs of a contact at the last load step."""
        return self.table(f"contact_{name}").last_step()

    def section_mesh(self, name):
        return self.table(f"sections/{name}")

    def section_stiffness(self, name):
        """The section as a beam; empty if the run wrote nothing of it."""
        path = self.file(f"sections/{name}.json")
        return read_json(path, {"fault": str}) if os.path.exists(path) else {}

    def table_files(self):
        """The paths, relative to the folder, of its tables, in alphabetical order."""
        return sorted(
            part + name for part in ("", "lines/", "cuts/", "sections/")
            if os.path.isdir(self.file(part)) for name in os.listdir(self.file(part))
            if os.path.splitext(name)[1] == ".csv")

    def date(self):
        """When summary.json was written, UTC."""
        written = os.stat(self.file("summary.json")).st_mtime
        return time.strftime("%Y-%m-%d %H:%M UTC", time.gmtime(written))
