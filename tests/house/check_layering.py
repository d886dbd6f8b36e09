#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks that the rooms are one-way floors and that the headers are in order.

Usage: check_layering.py ROOT
"""

import re
import shutil
import subprocess
import sys
from pathlib import Path

# Lowest first: what each room may include besides itself. An arrow that is not
# here is a decision: draw it here first, and never upwards.
ARROWS = {
    "base": (),
    "linear": ("base",),
    "material": ("base",),
    "strength": ("base", "material"),
    "shape": ("base", "material"),
    "section": ("base", "linear", "material", "shape"),
    "axis": ("base",),
    "body": ("base", "linear", "material", "shape", "section", "axis"),
    "conditions": ("base", "body"),
    "contact": ("base", "body", "conditions"),
    "solve": ("base", "linear", "body", "conditions", "contact"),
    "recover": ("base", "linear", "strength", "shape", "body", "conditions", "contact", "solve"),
    "adapt": ("base", "linear", "section", "body", "conditions", "contact", "recover"),
    "report": ("base", "material", "shape", "section", "body", "contact", "solve", "recover"),
    "scene": ("base", "material", "shape", "section", "body", "conditions", "contact", "solve",
              "recover"),
    "run": ("base", "conditions", "contact", "solve", "recover", "adapt", "report", "scene"),
    "estimate": ("base", "axis", "body", "recover", "adapt", "report", "scene", "run"),
    "trade": ("base", "section", "recover", "scene", "run"),
    "export": ("base", "body", "contact", "recover", "adapt", "scene"),
}
ROOMS = tuple(ARROWS)
# Rooms that are components: no room of the core includes them.
COMPONENTS = {"export": "components/calculix"}

# The header of each room that says in a comment what the room owns and what it
# never does.
FRONT_DOORS = {
    "base": "exceptions", "linear": "linear_solver", "material": "material",
    "strength": "criterion",
    "shape": "section_mesh", "section": "section", "axis": "axis", "body": "body",
    "conditions": "region", "contact": "gap_constraints", "solve": "structure",
    "recover": "recovery", "adapt": "node_fields", "report": "results_writer", "scene": "scene",
    "run": "simulation", "estimate": "estimation", "trade": "trade", "export": "calculix_deck",
}

# These see bodies through their interface alone.
BLIND_TO_KINDS_OF_BODIES = ("contact", "solve", "recover", "report")
KINDS_OF_BODIES = re.compile(r"lamella/body/(beam|solid)\w*\.h")

LICENSE = "// SPDX-License-Identifier: LGPL-2.1-or-later"
LONGEST_FUNCTION = 70

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"](lamella/[^">]+)[">]', re.MULTILINE)


def includes(path):
    return INCLUDE.findall(path.read_text())


def home_of(root, room):
    """The folder whose include/lamella and source hold the room."""
    return root / COMPONENTS.get(room, "")


def files_of(root, room):
    """The headers and the sources of a room."""
    home = home_of(root, room)
    return sorted((home / "include/lamella" / room).glob("**/*.h")) + sorted(
        path for path in (home / "source" / room).glob("**/*") if path.suffix in (".h", ".cc"))


def check_rooms(root):
    for parent in (root / "include/lamella", root / "source"):
        for folder in parent.iterdir():
            if folder.is_dir() and folder.name not in ROOMS:
                yield f"{folder.relative_to(root)}: not a room ({', '.join(ROOMS)})"


def check_floors(root, path, room):
    for header in includes(path):
        other = header.split("/")[1]
        where = f"{path.relative_to(root)} includes {header}"
        if not (home_of(root, other) / "include" / header).is_file():
            yield f"{where}, which does not exist"
        elif other != room and other not in ARROWS[room]:
            yield f"{where}; there is no arrow from {room} to {other} in ARROWS"
        elif room in BLIND_TO_KINDS_OF_BODIES and KINDS_OF_BODIES.match(header):
            yield f"{where}; the room {room} sees bodies as lamella/body/body.h"


def check_header(root, path, room):
    text, where = path.read_text(), path.relative_to(root)
    guard = f"lamella_{room}_{path.stem}_h"
    if not text.startswith(LICENSE + "\n"):
        yield f"{where}: the first line is not {LICENSE}"
    if f"#ifndef {guard}\n#define {guard}\n" not in text:
        yield f"{where}: no include guard {guard}"
    if re.search(r"^\s*using\s+namespace\s+dealii\b", text, re.MULTILINE):
        yield f"{where}: `using namespace dealii` in a header"


def check_arrows(root):
    """All point down, and each is drawn by somebody: one that nobody needs is a door left open."""
    for room, others in ARROWS.items():
        drawn = {header.split("/")[1] for path in files_of(root, room) for header in includes(path)}
        for other in others:
            if ROOMS.index(other) >= ROOMS.index(room):
                yield f"ARROWS: {room} to {other} does not point down"
            if other not in drawn:
                yield f"ARROWS: nothing in {room} includes a header of {other}; take the arrow out"


def check_front_doors(root):
    for room, header in FRONT_DOORS.items():
        path = home_of(root, room) / "include/lamella" / room / f"{header}.h"
        if not path.is_file():
            yield f"{path.relative_to(root)}: the front door of a room is missing"
        elif not re.search(rf"^// The room `{room}`:(.*\n//)*.*\b(never|not|independent)\b",
                           path.read_text(), re.MULTILINE):
            yield (f"{path.relative_to(root)}: no comment '// The room `{room}` ...' that "
                   "says what it owns and what it does not do")


def check_cycles(root):
    """A depth-first walk; a header met again on its own path closes a cycle."""
    folder = root / "include"
    graph = {str(path.relative_to(folder)): includes(path)
             for path in folder.rglob("*.h")}
    finished = set()

    def walk(header, path):
        if header in path:
            yield "a cycle: " + " -> ".join(path[path.index(header):] + [header])
        elif header not in finished:
            for other in graph.get(header, ()):
                yield from walk(other, path + [header])
            finished.add(header)

    for header in sorted(graph):
        yield from walk(header, [])


def check_function_lengths(root, files):
    """Needs Universal Ctags, which alone tells where a function ends."""
    if not shutil.which("ctags") or "Universal" not in subprocess.run(
            ["ctags", "--version"], capture_output=True, text=True).stdout:
        yield "no Universal Ctags to measure functions with: run scripts/setup --test"
        return
    tags = subprocess.run(
        ["ctags", "-f", "-", "--fields=+ne", "--c++-kinds=f", "-L", "-"],
        input="\n".join(map(str, files)), cwd=root, capture_output=True, text=True)
    for tag in tags.stdout.splitlines():
        found = re.search(r"\tline:(\d+).*\tend:(\d+)", tag)
        if not found:
            continue
        length = int(found[2]) - int(found[1]) + 1
        name, path = tag.split("\t")[:2]
        if length > LONGEST_FUNCTION:
            yield (f"{path}:{found[1]}: {name} has {length} lines, more than "
                   f"{LONGEST_FUNCTION}")


def faults(root):
    yield from check_rooms(root)
    yield from check_arrows(root)
    yield from check_front_doors(root)
    for room in ROOMS:
        for path in files_of(root, room):
            yield from check_floors(root, path, room)
            if path.suffix == ".h" and path.is_relative_to(home_of(root, room) / "include"):
                yield from check_header(root, path, room)
    yield from check_cycles(root)
    code = [path.relative_to(root) for folder in ("include", "source", "components", "tutorials")
            for path in sorted((root / folder).glob("**/*"))
            if path.suffix in (".h", ".cc")]
    if not code:
        yield f"no code below {root}"
    yield from check_function_lengths(root, code)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("Usage: check_layering.py ROOT")
    found = list(faults(Path(sys.argv[1]).resolve()))
    print("\n".join(found) or "The rooms and headers are in order.")
    sys.exit(1 if found else 0)
