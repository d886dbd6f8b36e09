#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pieces of the program that makes the page of a report, one by one (scripts/lamella_report).

Usage: check_pieces.py
"""

import json
import math
import os
import re
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))
from lamella_report import chapters, formats, pictures, scene  # noqa: E402
from lamella_report.folder import InputError, RunFolder, Table, value  # noqa: E402
from lamella_report.page import environment, page  # noqa: E402

PROGRAM = {"version": "0", "materials": {}}


class InFolder(unittest.TestCase):
    """With a folder of its own that goes with the test."""

    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self.scratch.cleanup)
        self.folder = Path(self.scratch.name)

    def write(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return str(path)

    def run_folder(self, summary="{}", text="set Title = A\n"):
        self.write("summary.json", summary)
        self.write("scene.prm", text)
        return RunFolder(str(self.folder))


class Numbers(unittest.TestCase):
    def test_numbers_keep_their_digits(self):
        self.assertEqual(formats.readable(-133963123.), "−1.3396·10⁸")
        self.assertEqual(formats.readable(2.5e-11), "2.5·10⁻¹¹")
        self.assertEqual(formats.readable(0.), "0")
        self.assertEqual(formats.readable(-0.125), "−0.125")
        self.assertEqual(formats.readable(math.inf), "infinite")
        self.assertEqual(formats.readable(-math.inf), "−infinite")
        self.assertEqual(formats.readable(math.nan), "not a number")
        self.assertEqual(formats.number("-0.123456789012345"),
                         '<data value="-0.123456789012345">−0.12346</data>')
        # As JSON spells it, and of a number at hand 15 digits.
        self.assertEqual(formats.number(formats.Written("2.9902849999999996")),
                         '<data value="2.9902849999999996">2.9903</data>')
        self.assertEqual(formats.number(0.1 + 0.2), '<data value="0.3">0.3</data>')

    def test_what_is_no_number(self):
        for nothing in ("", None, True, {}):
            self.assertEqual(formats.number(nothing), "–")
        self.assertEqual(formats.number("<none>"), "&lt;none&gt;")
        # To Python numbers, to the program's tables none.
        for text in ("1_0", " 1", "0x1"):
            self.assertEqual(formats.number(text), text)

    def test_rounding_beside_its_neighbors(self):
        self.assertEqual(formats.number("-1e-17", 1.), '<data value="-1e-17">0</data>')
        self.assertEqual(formats.number("-1e-17"), '<data value="-1e-17">−1·10⁻¹⁷</data>')
        vector = [formats.Written(c) for c in ("1e-17", "0.0", "-2.5")]
        self.assertEqual(formats.components(vector), '(<data value="1e-17">0</data>, '
                         '<data value="0.0">0</data>, <data value="-2.5">−2.5</data>)')
        self.assertEqual(formats.components([]), "–")

    def test_columns_are_formulas(self):
        for name, html in (("uz", "<i>u</i><sub>z</sub>"), ("sxy", "<i>σ</i><sub>xy</sub>"),
                           ("gyz", "<i>γ</i><sub>yz</sub>"), ("s12", "<i>σ</i><sub>12</sub>"),
                           ("fx", "<i>F</i><sub>x</sub>"), ("x", "<i>x</i>"), ("", ""),
                           ("step", "step"), ("<", "<i>&lt;</i>")):
            self.assertEqual(formats.symbol(name), html)

    def test_units(self):
        units = formats.Units({"length": "mm", "force": "N", "stress": "MPa"})
        none = formats.Units({})
        for kind, unit, without in (
                ("length", "[mm]", "[length]"), ("moment", "[N mm]", "[force length]"),
                ("bending", "[N mm²]", "[force length²]"), ("point", "[N]", "[force]"),
                ("line", "[N/mm]", "[force/length]"), ("surface", "[N/mm²]", "[force/length²]"),
                ("density", "[t/mm³]", "[force s²/length⁴]"), ("mass", "[t]", "[force s²/length]"),
                ("inertia", "[t mm²]", "[force length s²]"), ("stress", "[MPa]", "[stress]")):
            self.assertEqual(units.brackets(kind), unit)
            self.assertEqual(none.brackets(kind), without)
        self.assertEqual([units.of_column(c) for c in (
            "uz", "sxy", "fz", "mx", "x", "pressure", "width", "frequency", "step", "")],
            ["[mm]", "[MPa]", "[N]", "[N mm]", "[mm]", "[MPa]", "[mm]", "[Hz]", "", ""])
        self.assertEqual((units.behind("length"), none.behind("length")), ("&nbsp;mm", ""))


class Scenes(unittest.TestCase):
    def test_entries(self):
        entries = scene.read_entries(
            "set Title = 5 \\# 3 = 2 # a comment\nsubsection  Body   upper\n"
            "  subsection Kinematics\n    set Theory = LE-2\n  end\nend\nset Last =\n")
        self.assertEqual(entries, {"Title": "5 # 3 = 2", "Body upper/Kinematics/Theory": "LE-2",
                                   "Last": ""})
        self.assertEqual(entries["nothing of it"], "")
        for text, line in (("set A = 1\nsubsection B\n", 3), ("set A = 1\nend\n", 2),
                           ("set A\n", 1), ("A = 1\n", 1), ("", 1)):
            with self.assertRaises(ValueError) as caught:
                scene.read_entries(text)
            self.assertEqual(caught.exception.args, (line,))

    def test_lists(self):
        self.assertEqual(scene.split(" if(y > 1, 2, 0) , 3,"), ["if(y > 1, 2, 0)", "3", ""])
        self.assertEqual(scene.split("  "), [])
        self.assertEqual(scene.regions_of("a: top; floor"), [("a", "top"), ("floor", "")])

    def test_directions(self):
        for text, words in (("0, 2, 0", "along <i>y</i>"), ("0, 0, -1", "along <i>−z</i>")):
            self.assertEqual(scene.direction(text), words)
        self.assertEqual(scene.direction("1, 0, -1"), 'along (<data value="1">1</data>, '
                         '<data value="0">0</data>, <data value="-1">−1</data>)')


class Tables(InFolder):
    def test_tables_of_csv(self):
        table = Table.read(self.write("t.csv", 'step,goal,bar\n1,"c: fz in y 1, 2",0.125\n'
                                      '2,tip,\n2,"end",-3e-5\n'))
        self.assertEqual(len(table.rows), 3)
        self.assertEqual(table.rows[0]["goal"], "c: fz in y 1, 2")
        self.assertEqual(value(table.rows[0], "bar"), 0.125)
        self.assertTrue(math.isnan(value(table.rows[1], "bar")))
        self.assertTrue(math.isnan(value(table.rows[0], "no such column")))
        self.assertEqual([row["bar"] for row in table.last_step().rows], ["", "-3e-5"])

    def test_a_table_that_a_scene_need_not_have(self):
        none = Table.read(str(self.folder / "missing.csv"))
        self.assertEqual((none.rows, none.last_step().rows), ([], []))

    def test_a_table_that_was_cut_off(self):
        for content, cells in (("a,b\n1,2\n3\n", 1), ("a,b\n1,2\n\n3,4\n", 0)):
            with self.assertRaisesRegex(InputError, "cut.csv: line 3 has "
                                        f"{cells} cells where the first line has 2"):
                Table.read(self.write("cut.csv", content))
        with self.assertRaisesRegex(InputError, "cut.csv: it is not what a run writes"):
            Table.read(self.write("cut.csv", "a,b\n1\r2,3\n"))

    def test_tables_of_html(self):
        template = environment(self.run_folder()).from_string(
            '{% from "macros.html" import row, table %}'
            '{% call table("t", ["what", "value"]) %}\n{{ row("words", "1"|number) }}\n'
            '{{ row(one|number ~ " of " ~ "2"|number, "–", marked=true) }}\n{% endcall %}')
        self.assertEqual(template.render(one="1").replace("\n", ""),
            '<div class="wide"><table id="table-t"><thead><tr><th scope="col">what</th><th '
            'scope="col">value</th></tr></thead><tbody><tr><td>words</td><td class="number">'
            '<data value="1">1</data></td></tr><tr class="marked"><td><data value="1">1</data> '
            'of <data value="2">2</data></td><td class="number">–</td></tr>'
            '</tbody></table></div>')

    def test_bytes_in_the_page(self):
        # RFC 4648: f, fo, foo.
        for content, encoded in ((b"f", "Zg=="), (b"fo", "Zm8="), (b"foo", "Zm9v")):
            self.assertEqual(pictures.data_uri("text/plain", content),
                             f"data:text/plain;base64,{encoded}")
        self.assertEqual([chapters.size_text(n) for n in (1023, 2048, 3 << 20)],
                         ["1023 bytes", "2 kB", "3 MB"])


class Pages(InFolder):
    def test_text_is_escaped(self):
        text = b"set Title = </style><script> & \"c\" 'd' Ger\xc3\xbcst \xc3 \x07\tx\n"
        self.assertIn("&lt;/style&gt;&lt;script&gt; &amp; &#34;c&#34; &#39;d&#39; Gerüst "
                      "\ufffd \ufffd\tx\n", page(self.run_folder(text=text), PROGRAM))

    def test_a_run_that_left_the_least(self):
        text = page(self.run_folder(text="set Title = <i>\n"), PROGRAM, "No <pictures>.")
        for words in ("The scene has no contact.", "The scene names no goals",
                      "No failure criterion was asked for", "did not come to its end",
                      "No &lt;pictures&gt;.", "set Title = &lt;i&gt;", "The scene has no sections.",
                      "There is no picture of the deformed bodies.",
                      "The run left no table of its load steps.",
                      "No loads act; what moves the bodies is prescribed.",
                      "The run was made by version ? of Lamella, this page by version\n0."):
            self.assertIn(words, text)
        self.assertNotIn("Undefined", text)

    def test_what_no_run_writes(self):
        for summary in ("[1, 2]", '{"units": 3}', '{"theory": {"beam": 2}}', "{", "", "NaN",
                        '{"dofs": Infinity}', '{"bodies": {"beam": []}}', "[" * 100000,
                        b'{"title": "\xff"}'):
            with self.assertRaisesRegex(InputError, "summary.json: it is not what a run writes"):
                self.run_folder(summary)
        with self.assertRaisesRegex(InputError, "scene.prm:2: it is not what a run writes"):
            self.run_folder(text="set Title = A\nsubsection")

    def test_modes(self):
        self.write("modes.csv", "analysis,number,value,bar,kind,body,px,py,pz,torsion,width\n"
                   "modes,1,123.456,0.5,torsion,beam,1,0,-1.5,0.875,0.125\n"
                   "modes,2,23456.7,,width,beam,0,1e-12,0.5,0.005,0.995\n"
                   "buckling,1,2.5,,torsion,<arm>,0,0,0,1,0\n")
        os.mkdir(self.folder / "pictures")
        for name in ("mode_0001", "mode_0002", "buckling_0001"):
            self.write(f"pictures/{name}.png", name)
        text = page(self.run_folder(
            '{"rigid_modes": 1, "inertia": {"mass": 4.0}}',
            "set Mode references = mode-1: 123: a book | buckling-1: 2.4: Euler\n"), PROGRAM)
        cells = re.sub("</?(data|td|i|sub)[^>]*>", "|", text)
        cells = re.sub(r"\|+", "|", cells)
        for row in ("|1|123.46|0.5|torsion (88 %)|beam|25|0|56.2|",
                    "|2|23457|–|width|beam|0|0|6.25|", "|sum|25|0|62.5|",
                    "|1|2.5|torsion|&lt;arm&gt;|",
                    "mode-1: frequency [Hz]|123.46|123|0.371|a book|",
                    "buckling-1: factor|2.5|2.4|4.17|Euler|", "lowest natural frequency|123.46| Hz",
                    "1: 123.5 Hz, torsion ", "2: 23457 Hz, width ", "1: factor 2.5, torsion "):
            self.assertIn(row, cells)
        self.assertNotIn("Harmonic response", text)

    def test_harmonic_response(self):
        """A mass on a spring, 2 mm at rest: the largest amplitude is 2 / (2 D sqrt(1 - D^2))."""
        damping, rows = 0.25, ["frequency,probe,ply,ux,ux phase,uz,uz phase"]
        peak = 10. * math.sqrt(1. - 2. * damping**2)
        for frequency in (5., 9., peak, 9.7, 10., 20.):
            r = frequency / 10.
            u = 2. / complex(1. - r**2, 2. * damping * r)
            angle = math.degrees(math.atan2(u.imag, u.real))
            for ply in (1, 2):
                rows.append(f"{frequency},tip,{ply},0.5,0,{abs(u)},{angle}")
        self.write("response.csv", "\n".join(rows) + "\n")
        run = self.run_folder()
        (probe, column, row), = chapters.peaks_of_response(run)
        self.assertEqual((probe, column, value(row, "frequency")), ("tip", "uz", peak))
        self.assertAlmostEqual(value(row, "uz"), 1. / (damping * math.sqrt(1. - damping**2)))
        self.assertIn(f'<data value="{row["uz phase"]}">', page(run, PROGRAM))

    def test_pictures_that_nobody_knows(self):
        run = self.run_folder()
        os.mkdir(self.folder / "pictures")
        for name in ("deformed", "another", "history"):
            self.write(f"pictures/{name}.png", name)
        text = page(run, PROGRAM)
        order = [text.index(f'<img alt="{name}"') for name in ("deformed", "another", "history")]
        self.assertEqual(order, sorted(order))

    def test_materials_of_the_program(self):
        constants = [9., 1., 1., 0.5, 0.5, 0.25, 0.3, 0.3, 0.4]
        known = {"MPa": {"ply": {"elastic": constants, "strengths": constants}}, "Pa": {}}
        text = ("set Materials = a, b, c\nsubsection Material a\n  set Library = ply\nend\n"
                "subsection Material b\n  set Library = of a later version\nend\n"
                "subsection Material c\n  set Isotropic = 2, 0.25\nend\n")
        run = self.run_folder(json.dumps({"units": {"stress": "MPa"}}), text)
        self.assertEqual(list(chapters.materials(run, known)), [
            ("a", "ply", "", constants, constants),
            ("b", "of a later version", "", None, None),
            ("c", "", "isotropic", [2.] * 3 + [0.8] * 3 + [0.25] * 3, None)])
        self.assertIn("the program's\nown", page(run, {"version": "0", "materials": known}))


if __name__ == "__main__":
    unittest.main()
