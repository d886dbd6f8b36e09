#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prepares a page or a header for Doxygen: `scripts/doc_filter.py FILE`, the result on stdout.

For doc/Doxyfile; FILE is relative to the root of the project or absolute. Lines keep their
numbers, so that warnings name the line of the file.

A page (*.md): headings get the identifiers that links to them use on the web sites of git
(`page.md#a-heading`), unique over all pages; relative links become links between the pages of
the site; files that are no pages are named, without a link.

A header (*.h): the comment `// The room NAME: ...` becomes the description of the group
room_NAME, of which everything in the header is a member.
"""

import os
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FENCE = re.compile(r"^\s*(```|~~~)")
HEADING = re.compile(r"^(#{1,6})\s+(.*?)\s*#*$")
# Code or link: code is left alone.
INLINE = re.compile(r"(`+[^`]+`+)|(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(\s*<?([^)\s>]+)>?\s*\)")


def slug(heading):
    """The anchor of a heading on the web sites of git."""
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading)
    text = re.sub(r"[^\w\- ]", "", text.replace("`", "").lower())
    return text.strip().replace(" ", "-")


def page_id(path):
    """The identifier of a page, made of its path; README.md of the project is the front page."""
    if path == ROOT / "README.md":
        return "mainpage"
    name = path.relative_to(ROOT).with_suffix("")
    return "page_" + re.sub(r"\W", "_", str(name))


def anchor(path, heading):
    """The identifier of a heading of a page."""
    return f"{page_id(path)}_{re.sub(r'[^0-9A-Za-z_]', '_', heading)}"


def page_of(target):
    """The page that a path leads to: itself, or README.md of a folder."""
    page = target / "README.md" if target.is_dir() else target
    return page if page.suffix == ".md" and page.is_file() else None


def link(page, bang, text, target):
    """A link as Doxygen has it."""
    if re.match(r"[a-z]+:", target):
        return f"{bang}[{text}]({target})"
    name, _, heading = target.partition("#")
    path = Path(os.path.normpath(page.parent / name)) if name else page
    if bang:
        return f"![{text}]({target})"
    found = page_of(path)
    if not found or not found.is_relative_to(ROOT):
        return text
    reference = anchor(found, heading) if heading else page_id(found)
    reference = "index" if reference == "mainpage" else reference
    return f"[{text}](@ref {reference})"


def filter_page(page, text):
    """The page with identifiers of its headings, and with links between pages."""
    lines, in_code, seen = text.split("\n"), False, []
    for index, line in enumerate(lines):
        if FENCE.match(line):
            in_code = not in_code
        elif not in_code and HEADING.match(line):
            marks, heading = HEADING.match(line).groups()
            name = slug(heading)
            count = seen.count(name)
            label = anchor(page, f"{name}-{count}" if count else name) if seen else page_id(page)
            seen.append(name)
            lines[index] = f"{marks} {heading} {{#{label}}}"
    blocks = re.split(r"(^```.*?^```)", "\n".join(lines), flags=re.M | re.S)
    for index in range(0, len(blocks), 2):
        blocks[index] = INLINE.sub(
            lambda m: m[1] if m[1] else replaced(page, m), blocks[index])
    return "".join(blocks)


def replaced(page, found):
    """The link with as many lines as before."""
    whole = link(page, found[2], " ".join(found[3].split()), found[4])
    return whole + "\n" * found[0].count("\n")


def filter_header(path, text):
    """Members of the group of the room; its description where the header has one."""
    room = path.parent.name
    described = re.search(rf"^// The room `{room}`: ((?:.*\n//)*.*)\n", text, re.M)
    if described:
        title, _, rest = re.sub(r"^// ?", "", described[1], flags=re.M).partition(".")
        comment = (f"/** \\defgroup room_{room} {room}: {' '.join(title.split())}\n"
                   f"{rest.strip()} */")
        missing = described[0].count("\n") - comment.count("\n")
        text = text.replace(described[0], comment + "\n" * missing, 1)
    # A dot product is no end of a sentence.
    text = re.sub(r"^ *(///|\*) .*", lambda m: m[0].replace(" . ", " \u00b7 "), text, flags=re.M)
    # Doxygen begins groups anew in each namespace.
    text = re.sub(r"^namespace lamella\n\{$",
                  f"namespace lamella {{ /** \\\\addtogroup room_{room}\n@{{ */", text, flags=re.M)
    return re.sub(r"^\}(?= // namespace lamella$)", "/** @} */ }", text, flags=re.M)


def main():
    if len(sys.argv) != 2:
        sys.exit("Usage: scripts/doc_filter.py FILE")
    path = Path(sys.argv[1]).resolve()
    text = path.read_text()
    sys.stdout.write(filter_page(path, text) if path.suffix == ".md"
                     else filter_header(path, text))


if __name__ == "__main__":
    main()
