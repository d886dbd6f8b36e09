# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page: its chapters from their templates."""

import os
import re

from jinja2 import ChainableUndefined, Environment, FileSystemLoader
from markupsafe import Markup

from . import chapters, formats, pictures, scene
from .folder import content_of, value

# In their order; the template of each has its words, or none if the chapter is to be left out.
CHAPTERS = {
    "glance": "At a glance",
    "warnings": "Warnings",
    "scene": "The scene in words",
    "sections": "Sections and plies",
    "shape": "Deformed shape and fields",
    "numbers": "Numbers, with their error bars",
    "contact": "Contact",
    "strength": "Reserve factors of the plies",
    "modes": "Natural modes",
    "buckling": "Buckling modes",
    "response": "Harmonic response",
    "forces": "Loads, supports and reactions",
    "checks": "Checks",
    "costs": "Size, time and memory",
    "files": "All numbers as tables",
    "again": "How to run it again",
}
# What no page may have: controls, and halves of characters that names of files can have.
UNSHOWN = re.compile("[\x00-\x08\x0b-\x1f\x7f\ud800-\udfff]")


def quantity(json_value, scale=0.):
    """A number of JSON, or a vector."""
    if isinstance(json_value, list):
        return formats.components(json_value)
    return formats.number(json_value, scale)


def readable_or_dash(number, digits=3):
    return formats.readable(number, digits) if abs(number) < float("inf") else formats.NONE


def sentence(warning):
    """A warning, which begins in the middle of one, as a sentence."""
    return warning[:1].upper() + warning[1:]


def environment(run):
    """Filters, tests and functions of the templates."""
    env = Environment(loader=FileSystemLoader(os.path.join(os.path.dirname(__file__), "templates")),
                      autoescape=True, trim_blocks=True, lstrip_blocks=True,
                      undefined=ChainableUndefined, extensions=["jinja2.ext.do"])
    env.filters.update(
        number=formats.number, components=formats.components, symbol=formats.symbol,
        with_unit=run.units.with_unit, quantity=quantity, readable_or_dash=readable_or_dash,
        sentence=sentence, point=scene.point, direction=scene.direction,
        bytes=chapters.size_text,
        length_cell=lambda length, scale=0.: formats.number(f"{length:.14g}", scale),
        table_uri=lambda path: pictures.data_uri("text/csv", content_of(path)))
    env.tests.update(number_cell=formats.is_number_cell, zero=scene.is_zero,
                     all_zero=scene.are_zero, rubbing=scene.rubs)
    # All that chapters.py finds, by its own names.
    env.globals.update(vars(chapters), value=value, split=scene.split,
                       regions_of=scene.regions_of)
    return env


def page(run, program, why_no_pictures=""):
    """The page of a run with the pictures that are there.

    program is what the program knows: its "version", and the "materials" of its library by
    their unit of stress; why_no_pictures says why there are none, if so.
    """
    env = environment(run)
    context = {"run": run, "summary": run.summary, "scene": run.scene, "units": run.units,
               "program": program, "why_no_pictures": why_no_pictures,
               "pictures": pictures.Pictures(run.path)}
    # The shape last: it shows the pictures that no other chapter has shown.
    html = {name: Markup(env.get_template(f"{name}.html").render(context))
            for name in sorted(CHAPTERS, key="shape".__eq__)}
    title = run.summary.get("title") or os.path.basename(run.path)
    text = env.get_template("page.html").render(
        context, title=title,
        chapters=[(name, heading, html[name]) for name, heading in CHAPTERS.items()
                           if html[name].strip()])
    return UNSHOWN.sub("\ufffd", text)
