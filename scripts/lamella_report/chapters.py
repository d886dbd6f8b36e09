# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the chapters tell, found in the files of a run: plain data for their templates."""

import math
import os

from .folder import value
from .formats import Written, number, readable, size_of
from .scene import split, to_number

PLACE = ("x", "y", "z")
ORTHOTROPIC = 9  # elastic constants: E1, E2, E3, G12, G13, G23, nu12, nu13, nu23
MOST_PLIES, MOST_POINTS, MOST_STEPS = 24, 8, 8  # the folder's tables have all
LARGEST_TABLE = 1 << 20  # bytes, within the page
MOST_PLIES_OF_A_SECTION = 1e6


def column_of(goal):
    """`tip: uz` to `uz`, `c: fz in y 1 2` to `fz`."""
    return goal.rpartition(": ")[2].partition(" ")[0] if ": " in goal else ""


def quotient(a, b):
    return a / b if b else math.nan


def size_of_columns(rows, columns):
    return size_of(value(row, c) for row in rows for c in columns)


def size_of_vectors(vectors):
    return size_of(c for vector in vectors for c in vector or ())


def cells_of(rows, name):
    return [row.get(name, "") for row in rows]


def numbers_of(row, columns, size):
    return [number(row.get(c, ""), size) for c in columns]


# ---- materials, sections

def materials(run, library):
    """(name, library, kind, constants, strengths of the library) of each material; constants
    are None if they cannot be read, or are of a library that another program had."""
    for name, entries in run.scene.parts("Material", "Materials"):
        built_in = entries["Library"]
        if built_in:
            units = "MPa" if run.units.label("stress") == "MPa" else "Pa"
            known = library.get(units, {}).get(built_in, {})
            yield name, built_in, "", known.get("elastic"), known.get("strengths")
            continue
        e = [to_number(text) for entry in ("Isotropic", "Engineering constants")
             for text in split(entries[entry])]
        if len(e) == 2:
            E, nu = e
            G = quotient(E, 2. * (1. + nu))
            yield name, "", "isotropic", [E, E, E, G, G, G, nu, nu, nu], None
        elif len(e) == ORTHOTROPIC:
            yield name, "", "orthotropic", e, None
        else:
            yield name, "", "", None, None


class Extent:
    """A ply, or part, of a section and where it lies, in the section's coordinates."""

    def __init__(self, row):
        self.material, self.angle = row.get("material", ""), row.get("angle", "")
        self.low, self.high = [math.inf, math.inf], [-math.inf, -math.inf]

    def add(self, row):
        """A cell of it, each side of which is `x z` of some points with ; between them."""
        for side in range(1, 5):
            for place in split(row.get(f"side_{side}", ""), ";"):
                x = [to_number(c) for c in (*place.split(" "), "")[:2]]
                self.low = [min(pair) for pair in zip(self.low, x)]
                self.high = [max(pair) for pair in zip(self.high, x)]

    @property
    def width(self):
        return self.high[0] - self.low[0]

    @property
    def thickness(self):
        return self.high[1] - self.low[1]


def heights_of(plies):
    """How far the plies reach from the section's origin, up or down."""
    return size_of(z for ply in plies.values() for z in (ply.low[1], ply.high[1]))


def plies_of(mesh):
    """{number: extent} of the plies of a section's mesh, the lowest number first."""
    plies = {}
    for row in mesh.rows:
        ply = value(row, "ply")
        if 1. <= ply <= MOST_PLIES_OF_A_SECTION:
            plies.setdefault(int(ply), Extent(row)).add(row)
    return dict(sorted(plies.items()))


# ---- numbers

def share_of_bar(goal):
    """The bar of a goal in per cent of its scale; NaN without one."""
    return 100. * quotient(value(goal, "bar"), value(goal, "scale"))


def references(run):
    """(where, column, value of the run, of the reference, source) of all that the scene
    compares with."""
    for name, entries in run.scene.parts("Probe", "Probes"):
        row = next((r for r in run.probes.rows if r.get("probe") == name), {})
        yield from compared(f"Probe {name}", entries, lambda column: row.get(column, ""))
    modes = {f"{name}-{row['number']}": row["value"] for analysis, name in (
        ("modes", "mode"), ("buckling", "buckling")) for row in modes_of(run, analysis)}
    for reference in split(run.scene["Mode references"], "|"):
        mode, *parts = split(reference, ":")
        if len(parts) >= 2:
            yield mode, column_of_mode(mode), modes.get(mode), parts[0], ": ".join(parts[1:])
    for kind, key, force in (("Support", "supports", "reaction"),
                             ("Contact", "contacts", "force")):
        for name, entries in run.scene.parts(kind, f"{kind}s"):
            found = run.summary.get(key, {}).get(name, {})
            forces = zip(("fx", "fy", "fz"), found.get(force, ()))
            yield from compared(f"{kind} {name}", entries, {
                column: c for column, c in forces if isinstance(c, Written)}.get)


def compared(where, entries, found):
    for reference in split(entries["References"], "|"):
        column, *parts = split(reference, ":")
        if len(parts) >= 2:
            yield where, column, found(column), parts[0], ": ".join(parts[1:])


def scale_of(reference):
    return abs(to_number(reference))


def difference(this, reference):
    """In per cent of a reference how far this is off; NaN where it cannot be said."""
    this = this if isinstance(this, float) else to_number(this or "")
    return 100. * (quotient(this, to_number(reference)) - 1.)


def doubts_of_goals(goals):
    """{why: goals} of those without a bar, in their order, and those beyond their
    tolerance."""
    why, beyond = {}, []
    for row in goals.rows:
        if row.get("met") == "0":
            beyond.append(row.get("goal", ""))
        if row.get("trusted") != "1":
            why.setdefault(row.get("why", ""), []).append(row.get("goal", ""))
    return why, beyond


def first_of_probes(probes):
    """(probe, column, cell): of each probe the largest displacement in its first row."""
    before = None
    for row in probes.rows:
        if row.get("probe") != before:
            before = row["probe"]
            column = max(("ux", "uy", "uz"), key=lambda c: abs(value(row, c)))
            yield before, column, row.get(column, "")


# ---- contact, strength

def size_of_scene(contact):
    """What penetrations are rounding beside; 0 where the run does not say it."""
    relative = size_of([contact.get("max_penetration_relative")])
    return size_of([contact.get("max_penetration")]) / relative if relative else 0.


def peaks(pairs):
    """The pairs that press, the largest pressure first."""
    pressed = [row for row in pairs.rows if value(row, "pressure") > 0.]
    return sorted(pressed, key=lambda row: -value(row, "pressure"))


def worst_first(plies):
    """Rows by their reserve factors, those without one (nothing brings failure) last."""
    def reserve(row):
        factor = value(row, "reserve_factor")
        return math.inf if math.isnan(factor) else factor

    return sorted(plies.rows, key=reserve)


def governing(plies):
    """Of each load step the row with the smallest reserve factor, in their order."""
    first = {}
    for row in worst_first(plies):
        first.setdefault(row.get("step"), row)
    return [row for row in plies.rows if any(row is worst for worst in first.values())]


# ---- modes, harmonic response

def modes_of(run, analysis):
    """Rows of modes.csv of the natural ("modes") or the buckling modes ("buckling")."""
    return [row for row in run.modes.rows if row.get("analysis") == analysis]


def column_of_mode(name):
    return "frequency" if name.startswith("mode-") else "factor"


def effective_masses(modes, mass):
    """Sums of effective masses along x, y and z in per cent of the mass; none without it."""
    return [number(100. * sum(value(mode, p)**2 for mode in modes) / mass, 100., 3)
            for p in ("px", "py", "pz")] if mass else []


def moments_of_inertia(inertia):
    return [row[k] for k, row in enumerate(inertia.get("moments", ()))]


def motion_of(mode):
    """The kind of a mode, with its share of the kinetic energy if that is below 99 %."""
    kind = mode.get("kind", "")
    share = value(mode, kind)
    return f"{kind} ({100. * share:.0f} %)" if share < 0.99 else kind


def caption_of_mode(mode):
    """`3: 6079 Hz, bending about x` or `1: factor 2.59, bending about x`."""
    size = value(mode, "value")
    text = readable(size, 4 if size < 1e4 else 5)
    text = f"{text} Hz" if mode.get("analysis") == "modes" else f"factor {text}"
    return f"{mode.get('number')}: {text}, {mode.get('kind')}"


def peaks_of_response(run):
    """(probe, column, row) where the largest displacement component of each probe is
    largest."""
    for probe in dict.fromkeys(cells_of(run.response.rows, "probe")):
        rows = [row for row in run.response.rows if row.get("probe") == probe]
        column, row = max(((c, row) for c in ("ux", "uy", "uz") for row in rows),
                          key=lambda pair: value(pair[1], pair[0]))
        yield probe, column, row


# ---- forces

def forces_on_bodies(run):
    """(kind, name, force): all that acts on the bodies from outside at the last load step,
    the sum at the end, which is zero in equilibrium. Forces between bodies are inner ones,
    and heat has no resultant."""
    all_forces = []
    for name, load in loads(run):
        all_forces.append(("load", name, scaled(load.get("force"), last_factor(run, name))))
    for name, support in run.summary.get("supports", {}).items():
        all_forces.append(("support", name, scaled(support.get("reaction"))))
    for name, contact in run.summary.get("contacts", {}).items():
        if ":" not in run.scene[f"Contact {name}/Second"]:
            # Reported as it acts on the obstacle.
            all_forces.append(("obstacle", name, scaled(contact.get("force"), -1.)))
    total = [sum(components) for components in zip([0.] * 3, *(f for *_, f in all_forces))]
    return [*all_forces, ("sum", "", total)]


def last_factor(run, load):
    """What multiplies a load at the last load step: of its own `Factors`, if it has any."""
    row = run.history.rows[-1]
    own = split(run.scene[f"Load {load}/Factors"])
    return to_number(own[int(value(row, "step")) - 1]) if own else value(row, "load_factor")


def scaled(force, factor=1.):
    components = [factor * c if isinstance(c, Written) else 0. for c in (force or ())]
    return (components + [0.] * 3)[:3]


def loads(run):
    """(name, what it is in all) of the loads but for temperatures."""
    return [(name, load) for name, load in run.summary.get("loads", {}).items()
            if not run.scene[f"Load {name}/Temperature"]]


def columns_of_history(history):
    """(name, size) of the columns but for those that are zero in all steps:
    `support:NAME:fx`, `contact:NAME:fx`, `probe:NAME:ux`."""
    sizes = ((name, size_of_columns(history.rows, [name])) for name in history.names)
    return [(name, size) for name, size in sizes if size > 0. and name != "step"]


# ---- files

def files(run):
    """(path, bytes, whether it is in the page) of each table."""
    for name in run.table_files():
        size = os.path.getsize(run.file(name))
        yield name, size, size <= LARGEST_TABLE


def size_text(size):
    """Bytes with their unit, for people."""
    if size < 1024:
        return f"{size} bytes"
    return f"{size / 1024.:.3g} kB" if size < 1 << 20 else f"{size / 1048576.:.3g} MB"
