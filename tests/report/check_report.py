#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs a scene, makes its report and reads the page as a browser would.

Usage: check_report.py LAMELLA SCENE.prm WORKDIR

The page is well-formed, refers to nothing outside of itself and runs nothing; all
chapters are there and in the contents; what the user has written is escaped; the
numbers shown are those of the run's tables, the worst reserve factor first, and the
tables in it are the files, byte for byte. Pictures are in it where there is a Python
that draws them, and otherwise it says which command does. Without the tables that a
scene need not have, the page says so. What cannot be reported is refused in one
message, and nothing of it is left; so is the want of Jinja2.
"""

import base64
import csv
import json
import math
import os
import re
import shutil
import subprocess
import sys
from html.parser import HTMLParser
from pathlib import Path

CHAPTERS = ("glance", "warnings", "scene", "sections", "shape", "numbers", "contact",
            "strength", "forces", "checks", "costs", "files", "again")
OF_MODES = ("modes", "buckling")
VOID = {"meta", "img"}
# What a page needs to be one; anything else is a decision.
ALLOWED = {"html", "head", "meta", "title", "style", "body", "main", "header", "nav",
           "section", "h1", "h2", "h3", "p", "ul", "ol", "li", "a", "b", "i", "sub",
           "code", "pre", "span", "div", "table", "caption", "thead", "tbody", "tr", "th",
           "td", "data", "figure", "img", "figcaption"}
SUPERSCRIPTS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
faults = []


def expect(truth, what):
    print(("ok    " if truth else "FAIL  ") + what)
    if not truth:
        faults.append(what)


class Page(HTMLParser):
    """Tags in balance, links, the text of each chapter, and tables as rows of cells,
    each (text, [(value, what is shown)])."""

    def __init__(self, text):
        super().__init__(convert_charrefs=True)
        self.open, self.tags, self.links, self.ids = [], set(), [], []
        self.images, self.downloads = [], {}
        self.tables, self.rows, self.data, self.title = {}, None, None, ""
        self.text, self.chapter, self.unbalanced = {}, None, []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.tags.add(tag)
        if tag not in VOID:
            self.open.append(tag)
        if "id" in attributes:
            self.ids.append(attributes["id"])
        for name, value in attributes.items():
            if name.startswith("on"):
                faults.append(f"<{tag} {name}> runs something")
            if name in ("src", "href"):
                self.links.append(value)
        if tag == "h2":
            self.chapter = attributes["id"]
        elif tag == "table":
            self.rows = self.tables[attributes["id"].removeprefix("table-")] = []
        elif tag == "tr":
            self.rows.append([])
        elif tag in ("td", "th"):
            self.rows[-1].append(["", []])
        elif tag == "data":
            self.data = [attributes["value"], ""]
        elif tag == "img":
            self.images.append(attributes["src"])
        elif tag == "a" and "download" in attributes:
            self.downloads[attributes["download"]] = attributes["href"]

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.unbalanced.append(tag)
        if tag == "table":
            self.rows = None
        elif tag == "data":
            if self.rows:
                self.rows[-1][-1][1].append(tuple(self.data))
            self.data = None

    def handle_data(self, text):
        if self.data:
            self.data[1] += text
        if self.rows and self.rows[-1]:
            self.rows[-1][-1][0] += text
        if self.open and self.open[-1] == "title":
            self.title += text
        self.text[self.chapter] = self.text.get(self.chapter, "") + text

    def values(self, table):
        """The numbers of each row but the head, in their order."""
        return [[float(value) for _, data in row for value, _ in data]
                for row in self.tables[table][1:]]


def shown(text):
    """The number that people read."""
    mantissa, _, power = text.replace("−", "-").partition("·10")
    return float(mantissa) * 10. ** int(power.translate(SUPERSCRIPTS) or 0)


def read(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def last_step(rows):
    return [row for row in rows if row["step"] == rows[-1]["step"]]


def numbers(row, *columns):
    return [float(row[column]) for column in columns if row[column]]


def check_form(page, chapters=CHAPTERS):
    expect(not page.open and not page.unbalanced, "every tag is closed in its turn")
    expect(page.tags <= ALLOWED, f"no other tags {sorted(page.tags - ALLOWED)}")
    outside = [link[:60] for link in page.links
               if not link.startswith(("data:image/png;base64,", "data:text/csv;base64,",
                                       "#"))]
    expect(not outside, f"nothing from outside of the page {outside}")
    inner = [link[1:] for link in page.links if link.startswith("#")]
    expect(set(inner) <= set(page.ids), "links within the page lead somewhere")
    expect(len(page.ids) == len(set(page.ids)), "no name stands twice")
    expect(set(inner) >= set(chapters) == set(page.text) - {None, "contents"},
           "all chapters are there and in the contents")
    expect(all(page.text[c].strip() for c in chapters), "none of them is empty")


def check_shown(page):
    """Five digits are shown, or what is rounding beside its neighbors as 0."""
    wrong = [(value, text) for rows in page.tables.values() for row in rows
             for _, data in row for value, text in data
             if text != "0" and abs(shown(text) - float(value)) >
             6e-2 * abs(float(value))]
    expect(not wrong, f"what is shown is the value {wrong[:3]}")
    exact = [value == text.replace("−", "-") or abs(shown(text) / float(value) - 1.) < 6e-5
             for rows in (page.tables[name] for name in
                          ("probes-stresses", "reserve-factors", "forces"))
             for row in rows for _, data in row for value, text in data
             if text != "0"]
    expect(exact and all(exact), "to five digits")


def check_numbers(page, output):
    summary = json.loads((output / "summary.json").read_text())
    goals = read(output / "goals.csv")
    expect(page.values("goals") == [
        numbers(g, "value", "estimate", "corrected", "bar", "tolerance") for g in goals],
        f"{len(goals)} goals with their bars")
    probes = last_step(read(output / "probes.csv"))
    expect(page.values("probes-displacements") == [
        numbers(p, "ply", "x", "y", "z", "ux", "uy", "uz") for p in probes] and
        page.values("probes-stresses") == [
        numbers(p, "ply", "sxx", "syy", "szz", "sxy", "sxz", "syz") for p in probes],
        f"{len(probes)} rows of probes")
    plies = sorted(last_step(read(output / "plies.csv")),
                   key=lambda p: float(p["reserve_factor"] or "inf"))
    expect(page.values("reserve-factors") == [
        numbers(p, "reserve_factor", "ply", "index", "x", "y", "z", "angle")
        for p in plies], f"{len(plies)} reserve factors, the worst first")
    expect(float(plies[0]["reserve_factor"]) < 1. < float(plies[-1]["reserve_factor"]) and
           "A ply has failed" in page.text["warnings"], "one is below 1: a warning")
    pairs = sorted((p for p in last_step(read(output / "contact_landing.csv"))
                    if float(p["pressure"]) > 0.), key=lambda p: -float(p["pressure"]))
    expect(pairs and page.values("peaks-of-landing") == [
        numbers(p, "x", "y", "z", "pressure", "force", "gap") for p in pairs[:8]],
        f"{len(pairs)} pressures, the largest first")
    expect(page.values("reactions") == [
        summary["supports"]["clamp"][k][c] for k in ("reaction", "moment", "about")
        for c in range(3)] or page.values("reactions") == [[
            summary["supports"]["clamp"][k][c] for k in ("reaction", "moment", "about")
            for c in range(3)]], "reaction and moment")
    history = read(output / "history.csv")
    table = {row[0][0]: [float(d[0][0]) for _, d in row[1:]]
             for row in page.tables["history"][1:]}
    expect(table["load factor"] == [0.5, 1.] and table["probe end: uz [mm]"] == [
        float(row["probe:end:uz"]) for row in history], "the history of both load steps")
    checks = [row[1][1][0][0] for row in page.tables["checks"][1:5]]
    expect([float(c) for c in checks] == [summary[k] for k in (
        "force_balance", "residual", "energy_balance", "max_rotation")], "checks")


def are_close(found, wanted):
    """Whether two tables of numbers agree to the digits of a CSV file; 1e-9 is rounding."""
    return len(found) == len(wanted) and all(len(a) == len(b) and all(
        math.isclose(x, y, rel_tol=1e-12, abs_tol=1e-9) for x, y in zip(a, b))
        for a, b in zip(found, wanted))


def check_modes(page, output):
    """The table is made of modes.csv; the numbers of summary.json are the same."""
    summary = json.loads((output / "summary.json").read_text())
    modes, factors = summary["modes"], summary["buckling_modes"]
    masses = [[100. * c / summary["inertia"]["mass"] for c in m["effective_mass"][:3]]
              for m in modes]
    expect(len(modes) == 3 and are_close(page.values("mode-values"), [
        [m["number"], m["frequency"], *mass] for m, mass in zip(modes, masses)] + [
        [sum(column) for column in zip(*masses)]]), "frequencies and effective masses")
    expect(len(factors) == 3 and are_close(page.values("buckling-values"), [
        [f["number"], f["factor"]] for f in factors]), "buckling factors")
    # 4 x 40 x 1.5 of density 1.6e-9, clamped.
    mass, center, _, rigid = page.values("inertia")
    expect(are_close([[mass[0] / 1.6e-9], center, rigid],
                     [[240.], [2., 20., 0.75], [0.]]), f"mass {mass}, center {center}")
    reference, = [row for row in page.tables["references"] if "mode-1" in row[0][0]]
    expect(are_close([[float(value) for _, data in reference for value, _ in data]],
                     [[modes[0]["frequency"], 2600.]]), "a reference of a mode")
    if (output / "pictures").exists():
        expect(all(f"{m['number']}: {m['frequency']:.0f} Hz, "
                   f"{m['kind']} pictures/mode_{m['number']:04}.png" in page.text["modes"]
                   for m in modes) and all(
            f"{f['kind']} pictures/buckling_{f['number']:04}.png" in page.text["buckling"]
            for f in factors), "a picture of each mode with its caption")


def check_forces(page):
    """The load is what the scene says: 2 MPa on 4 x 1.5; the sum is zero."""
    rows = {row[0][0]: [float(data[0][0]) for _, data in row[1:]]
            for row in page.tables["forces"][1:]}
    expect(abs(rows["load tip"][2] + 12.) < 1e-9, "the load is 12 N downwards")
    expect(rows["obstacle floor (contact landing)"][2] > 1. and
           max(map(abs, rows["sum"])) < 1e-10, "all forces sum to zero")
    plies = page.values("plies-of-strip")
    expect(plies == [[1, 30, 4, 1, 0, 1], [2, -10, 4, 0.5, 1, 1.5]],
           "plies: angle, width, thickness, place")


def check_words(page, output):
    words = re.sub(r"\s+", " ", page.text["scene"])
    for sentence in ("beam is a beam of length 40 mm along y, of section strip, a laminate "
                     "[30/-10].", "clamp holds the start of beam: no displacement in any "
                     "direction", "tip acts on the end of beam: force (0, 0, -2) [N/mm²]",
                     "floor is a rigid plane through (0, 0, −0.2) mm that faces along z; it "
                     "stays where it is", "the surface bottom of beam may touch the obstacle "
                     "floor", "There are 2 load steps, with load factors 0.5 and 1"):
        expect(sentence in words, sentence)
    title = json.loads((output / "summary.json").read_text())["title"]
    expect(page.title == title and "<b>" in title and "&" in title and '"' in title,
           "the title is escaped")
    expect("equilibrium & nothing else" in page.text["numbers"], "so is a source")
    expect((output / "scene.prm").read_text() in page.text["again"],
           "the whole scene, as it was run")
    summary = json.loads((output / "summary.json").read_text())
    told = re.sub(r"\s+", " ", page.text["warnings"]).lower()
    expect(summary["warnings"] and all(
        re.sub(r"\s+", " ", w["text"]).lower() in told for w in summary["warnings"]),
        f"{len(summary['warnings'])} warnings of the run")


def check_files(page, output):
    """The tables in the page are the files."""
    files = sorted(path for path in output.rglob("*.csv"))
    expect(len(page.downloads) == len(files) and all(
        base64.b64decode(page.downloads[
            str(path.relative_to(output)).replace("/", "_")].partition(",")[2])
        == path.read_bytes() for path in files), f"{len(files)} tables are in it whole")
    drawn = sorted((output / "pictures").glob("*.png"))
    embedded = {base64.b64decode(image.partition(",")[2]) for image in page.images}
    if drawn:
        expect(embedded == {path.read_bytes() for path in drawn} and
               any(path.stem == "deformed" for path in drawn),
               f"{len(drawn)} pictures, the deformed shape among them")
    else:
        expect(not embedded and "scripts/plot" in page.text["warnings"],
               "no pictures: it says how to draw them")


def make(program, *words):
    return subprocess.run([program, "report", *map(str, words)], capture_output=True,
                          text=True)


def check_without_tables(program, output, other):
    """What a scene need not have is told to be missing."""
    shutil.copytree(output, other)
    for name in ("goals.csv", "plies.csv", "probes.csv", "contact_landing.csv",
                 "sections/strip.csv", "sections/strip.json", "solution.pvd",
                 "history.csv", "modes.csv", "mode.pvd", "buckling.pvd"):
        (other / name).unlink()
    summary = json.loads((other / "summary.json").read_text())
    summary["contacts"] = {}
    del summary["inertia"], summary["rigid_modes"]
    summary["load_steps"], summary["converged"] = 1, False
    (other / "summary.json").write_text(json.dumps(summary))
    done = make(program, other)
    expect(done.returncode == 0, f"a report without tables {done.stderr}")
    page = Page((other / "report.html").read_text())
    check_form(page)
    for chapter, words in (("numbers", "names no goals"), ("contact", "has no contact"),
                           ("strength", "No failure criterion was asked for"),
                           ("shape", "no picture of the deformed bodies"),
                           ("warnings", "did not come to its end")):
        expect(words in page.text[chapter], f"{chapter}: {words}")


def check_refusals(program, output, folder):
    """(words, what the message says): status 1, one message, nothing left behind."""
    folder.mkdir()
    (folder / "empty").mkdir()
    damaged = folder / "damaged"
    shutil.copytree(output, damaged)
    summary = (damaged / "summary.json").read_text()
    (damaged / "summary.json").write_text(summary[:len(summary) // 2])
    cut_off = folder / "cut_off"
    shutil.copytree(output, cut_off)
    goals = (cut_off / "goals.csv").read_text()
    (cut_off / "goals.csv").write_text(goals[:len(goals) - 60])
    half = folder / "half_a_scene"
    shutil.copytree(output, half)
    scene = (half / "scene.prm").read_text()
    (half / "scene.prm").write_text(scene[:scene.index("Layup") - 10])
    strange = folder / "strange"
    shutil.copytree(output, strange)
    changed = json.loads(summary)
    changed["theory"] = {"beam": 2}
    (strange / "summary.json").write_text(json.dumps(changed))
    for path in folder.glob("*/report.html"):
        path.unlink()
    before = {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}
    for words, fragments in (
            ([folder / "nowhere"], ["[report.no-folder]", "nowhere"]),
            ([output / "scene.prm"], ["[report.not-a-folder]"]),
            ([folder / "empty"], ["[report.no-results]", "summary.json"]),
            ([damaged], ["summary.json", "cut off or changed"]),
            ([cut_off], ["goals.csv", "cells"]),
            ([half], ["scene.prm:", "not what a run writes"]),
            ([strange], ["summary.json", "not what a run writes"]),
            ([], ["[run.no-folder]"]),
            ([output, output], ["[run.two-scenes]"]),
            ([output, "--set", "Theory=LE-1"], ["--set", "[run.option-not-for-report]"]),
            ([output, "--output", folder / "summary.json"], ["[report.target-not-html]"]),
            ([output, "--output", folder / "empty"], ["[report.target-is-folder]"]),
            ([output, "--output", "/dev/null/report.html"], ["cannot be written"])):
        done = make(program, *words)
        expect(done.returncode == 1 and done.stderr.startswith("lamella: ") and
               len(done.stderr.strip().splitlines()) <= 3 and
               all(fragment in done.stderr for fragment in fragments),
               f"refused: {' '.join(fragments)} ({done.stderr.strip()})")
    after = {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}
    expect(before == after, "nothing is left of what was refused")


def check_without_jinja(program, output, folder):
    """No Python has it: this one finds a module of its name that cannot be imported."""
    folder.mkdir()
    (folder / "jinja2.py").write_text("raise ImportError\n")
    page = folder / "report.html"
    done = subprocess.run([program, "report", output, "--output", page], capture_output=True,
                          text=True, env={**os.environ, "PYTHONPATH": str(folder)})
    expect(done.returncode == 1 and "[report.no-jinja2]" in done.stderr and
           "python3-jinja2" in done.stderr and len(done.stderr.splitlines()) == 1 and
           not page.exists(), f"without Jinja2: {done.stderr.strip()}")


def main():
    if len(sys.argv) != 4:
        sys.exit("Usage: check_report.py LAMELLA SCENE.prm WORKDIR")
    program, scene, folder = sys.argv[1], sys.argv[2], Path(sys.argv[3])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    output = folder / "run"
    subprocess.run([program, scene, "--output", output], check=True,
                   stdout=subprocess.DEVNULL)
    done = make(program, output)
    expect(done.returncode == 0 and not done.stderr, f"a report {done.stderr}")
    page = Page((output / "report.html").read_text())
    check_form(page, CHAPTERS + OF_MODES)
    check_shown(page)
    check_numbers(page, output)
    check_modes(page, output)
    check_forces(page)
    check_words(page, output)
    check_files(page, output)

    again = make(program, f"{output}/", "--output", folder / "elsewhere.html")
    expect(again.returncode == 0 and (folder / "elsewhere.html").read_text() ==
           (output / "report.html").read_text(), "the same page elsewhere")
    check_without_tables(program, output, folder / "bare")
    check_refusals(program, output, folder / "refused")
    check_without_jinja(program, output, folder / "no_jinja")
    subprocess.run([program, scene, "--output", output, "--set", "Load factors=1"],
                   check=True, stdout=subprocess.DEVNULL)
    expect(not (output / "report.html").exists(),
           "the page of an earlier run goes with its results")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
