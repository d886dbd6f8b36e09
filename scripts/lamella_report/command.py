# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command: reads its words, makes the page and puts it in its place."""

import argparse
import contextlib
import json
import os
import sys

from .folder import InputError, RunFolder
from .page import page
from .pictures import are_up_to_date, draw_missing


def check_target(target):
    """Throws InputError unless a page may be put there."""
    if os.path.isdir(target):
        raise InputError(f"--output {target}: this path is a folder. Name a file, as in "
                         f"{target}/report.html. [report.target-is-folder]")
    if os.path.splitext(target)[1] not in (".html", ".htm"):
        raise InputError(f"--output {target}: the report is an HTML page. Write a name that "
                         "ends in .html, as in report.html. [report.target-not-html]")


@contextlib.contextmanager
def output_file(target):
    """A file to write to that is there whole or not at all: it is written beside its place
    and renamed into it. Throws InputError if that fails; what stood there before stays."""
    beside = target + ".new"
    try:
        os.makedirs(os.path.dirname(target) or ".", exist_ok=True)
        with open(beside, "wb") as file:
            yield file
        os.replace(beside, target)
    except OSError:
        raise InputError(f"--output {target}: the report cannot be written into this file. Write "
                         "--output FILE.html with a file in a folder that you may write to. "
                         "[report.cannot-write]") from None
    finally:
        with contextlib.suppress(OSError):
            os.remove(beside)


def tell(words):
    """A line to the console; that it is full or gone is no fault: the page is there."""
    with contextlib.suppress(OSError):
        os.write(sys.stdout.fileno(), f"{words}\n".encode(errors="surrogateescape"))


def write_page(folder, target, program):
    """Writes what a run left in a folder as one self-contained file of HTML, and what was done
    to the console. Pictures that are missing are drawn first; where that fails the page says
    so.

    Throws InputError if the folder holds no results of a run, if a file in it is damaged, or
    if the target cannot be written or is not called *.html.
    """
    check_target(target)
    run, why = RunFolder(folder), ""
    html = page(run, program)  # before anything is drawn or written
    with output_file(target) as file:
        if not are_up_to_date(run.path):
            why = draw_missing(run.path)
            html = page(run, program, why)
        content = html.encode()
        file.write(content)
    tell(f"Report: {target} ({len(content) / 1048576.:.2g} MB)")
    if why:
        tell(f"Note: {why}")


def main(words=None):
    """The exit status: 0 done, 1 a fault of the input, 130 ended by Ctrl-C."""
    parser = argparse.ArgumentParser(prog="report.py", description=__doc__)
    parser.add_argument("folder", help="that a run has left its results in")
    parser.add_argument("--output", required=True, help="the page, FILE.html")
    parser.add_argument("--program", type=json.loads, default={"materials": {}},
                        help="in JSON what lamella knows: its version and its materials")
    given = parser.parse_args(words)
    try:
        write_page(given.folder, given.output, given.program)
    except InputError as error:
        print(f"lamella: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 130
    return 0
