#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks that what the pages name exists, and that no file names a machine.

Usage: check_docs.py ROOT

In *.md: relative links with their headings, pictures, scenes (prm/NAME.prm),
scripts (scripts/NAME), cases of doc/reference/limits.md, the length of pages.
In every text file: no path that only one machine has.
"""

import functools
import re
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))
from doc_filter import slug  # noqa: E402

LINK = re.compile(r"!?\[[^\]]*\]\(\s*<?([^)\s>]+)>?[^)]*\)|<img[^>]*\ssrc=\"([^\"]+)\"")
NAMED = re.compile(r"(?<![\w/.-])((?:prm|tests)/[\w./-]+\.prm|scripts/[\w.-]*\w)")
CODE_BLOCK = re.compile(r"^```.*?^```", re.MULTILINE | re.DOTALL)
CODE = re.compile(r"`[^`\n]*`")
HEADING = re.compile(r"^#+ +(.*)$", re.MULTILINE)
LONGEST_PAGE = 200
# Folders of a user or of a build machine; put in pieces, so that this file does
# not find itself.
FOLDERS = ("home", "root", "tmp", "work", "mnt", "Users", "builds", "workspace")
OF_ONE_MACHINE = re.compile(r"(?<![\w.$}~/-])/(?:" + "|".join(FOLDERS) + r")/[\w.-]+")


def project_files(root):
    """Tracked files and new ones; without git, all but hidden and built ones."""
    try:
        listed = subprocess.run(
            ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
            cwd=root, capture_output=True, text=True, check=True).stdout
    except (OSError, subprocess.CalledProcessError):
        listed = None
    if listed is not None:
        names = filter(None, listed.split("\0"))
    else:
        names = (str(path.relative_to(root)) for path in root.rglob("*"))
        names = (name for name in names
                 if not re.match(r"\.|build|results", name))
    return sorted({root / name for name in names if (root / name).is_file()})


@functools.lru_cache(maxsize=None)
def anchors_in(page):
    text = CODE_BLOCK.sub("", page.read_text())
    return {slug(heading) for heading in HEADING.findall(text)}


def check_page(root, page):
    text = page.read_text()
    # Code shows the syntax of links and of C++ lambdas, and links nowhere.
    prose = CODE.sub("", CODE_BLOCK.sub("", text))
    if page.is_relative_to(root / "doc") and len(text.splitlines()) > LONGEST_PAGE:
        yield f"{page.relative_to(root)}: more than {LONGEST_PAGE} lines: make two pages of it"
    for markdown, html in LINK.findall(prose):
        name, _, anchor = (markdown or html).partition("#")
        if re.match(r"[a-z]+:", name):
            continue
        target = page.parent / name if name else page
        if not target.exists():
            yield f"{page.relative_to(root)}: no such file: {name}"
        elif anchor and target.suffix == ".md" and anchor not in anchors_in(target.resolve()):
            yield f"{page.relative_to(root)}: no such heading: {name}#{anchor}"
    for name in sorted(set(NAMED.findall(text))):
        if not (root / name).exists():
            yield f"{page.relative_to(root)}: names {name}, which does not exist"


def check_limits(root):
    """Each row of the page of limits is a case of the tests with its identifier."""
    page = root / "doc/reference/limits.md"
    rows = re.findall(r"\| `([\w-]+)` +\| `([\w.-]+)` +\|", page.read_text())
    if not rows:
        yield f"{page.relative_to(root)}: no row with a case and an identifier"
    cases = {}
    for table in [*root.glob("tests/bad_input/*.table"), *root.glob("tests/bad_input/*.bad")]:
        for name, text in re.findall(r"^case (\S+)\n(.*?)(?=^case |\Z)", table.read_text(),
                                     re.MULTILINE | re.DOTALL):
            cases[name] = text
    for path in root.glob("tests/mpi/*.parallel"):
        cases[path.stem] = re.sub(r"^says \[(.*)\]$", r"id \1", path.read_text(), flags=re.MULTILINE)
    for case, identifier in rows:
        if f"id {identifier}\n" not in cases.get(case, "") + "\n":
            yield f"{page.relative_to(root)}: no case {case} with id {identifier} in the tests"


def check_paths(root, path):
    try:
        text = path.read_text()
    except UnicodeDecodeError:
        return
    for number, line in enumerate(text.splitlines(), 1):
        found = OF_ONE_MACHINE.search(line)
        if found:
            yield (f"{path.relative_to(root)}:{number}: {found[0]} is a path of "
                   "one machine")


def faults(root):
    files = project_files(root)
    if not (root / "README.md").is_file():
        yield "README.md is missing"
    yield from check_limits(root)
    for path in files:
        if path.suffix == ".md":
            yield from check_page(root, path)
        yield from check_paths(root, path)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("Usage: check_docs.py ROOT")
    found = list(faults(Path(sys.argv[1]).resolve()))
    print("\n".join(found) or "The pages name what exists.")
    sys.exit(1 if found else 0)
