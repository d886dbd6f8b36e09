#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of a trade: errors, fronts, bars, sentences, CSV file and picture of given variants."""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parents[2] / "scripts"
sys.path.insert(0, str(SCRIPTS))

from trade_table import NoReference, Table  # noqa: E402

PHASES = ["setup", "solve"]
# Each theory with those that it holds.
HELD = {"TBT": ["EBBT"], "TE-1": ["EBBT", "TBT"], "TE-2": ["EBBT", "TBT", "TE-1"],
        "LE-2": ["LE-1"], "LE-3": ["LE-1", "LE-2"], "LE-4": ["LE-1", "LE-2", "LE-3"],
        "tolerance 0.1": ["tolerance 1"]}


def variant(name, theory, seconds, dofs, *values, **others):
    return {"name": name, "theory": theory, "seconds": seconds, "dofs": dofs,
            "values": list(values), "phases": dict.fromkeys(PHASES, 0.), "memory": 1.,
            "bars": [], "axis": 1., "section": 1., "overridden": False, "failure": "",
            "stiffening": 0., "buckling_factor": None, "is_solid": theory.startswith("solid"),
            **others}


def failed(name):
    return variant(name, name, 1., 0, failure="It does not fit. Buy memory.")


def hierarchy():
    """Errors 10 %, 3 %, 5 %, 0.5 %, 0.2 % and the reference."""
    return [variant("EBBT", "EBBT", 1., 10, .9), variant("TE-2", "TE-2", 2., 30, 1.03), failed("LE-1"),
            variant("LE-2", "LE-2", 3., 20, .95), variant("LE-2, axis 2", "LE-2", 4., 100, 1.005),
            variant("solid-2", "solid-2", 9., 90, .998), variant("LE-3", "LE-3", 20., 500, 1.)]


def trade_of(variants, reference="finest", given=None, tolerances=(.01,)):
    for one in variants:
        one["holds"] = [k for k, other in enumerate(variants) if other["theory"] == one["theory"]
                        or other["theory"] in HELD.get(one["theory"], ())]
    return {"variants": variants, "quantities": [{"label": "tip: uz", "given": given}],
            "reference": reference, "tolerances": list(tolerances), "phases": PHASES,
            "title": "It's a `title` $a_b", "remark": ""}


def table(*words, **others):
    return Table(trade_of(*words, **others))


class Numbers(unittest.TestCase):
    def test_errors_and_fronts(self):
        t = table(hierarchy())
        self.assertEqual(t.against, 6)
        self.assertFalse(t.has_error(2, 0) or t.has_error(6, 0))
        self.assertAlmostEqual(t.error(3, 0), .05, delta=1e-15)
        # LE-2 is beaten in seconds, TE-2 in neither; in DoFs solid-2 beats LE-2, axis 2.
        self.assertEqual(t.front(0, "seconds"), [0, 1, 4, 5])
        self.assertEqual(t.front(0, "dofs"), [0, 3, 1, 5])

    def test_references(self):
        solid = table(hierarchy(), "solid")
        self.assertEqual(solid.against, 5)
        self.assertAlmostEqual(solid.error(6, 0), .002 / .998, delta=1e-15)
        given = table(hierarchy(), "given", 2.)
        self.assertIsNone(given.against)
        self.assertAlmostEqual(given.error(6, 0), .5, delta=1e-15)
        self.assertEqual(table(hierarchy(), "TE-2").against, 1)
        with self.assertRaises(NoReference):
            table(hierarchy(), "LE-1")
        # The finest is the last that succeeded.
        self.assertEqual(table(hierarchy() + [failed("LE-4")]).against, 6)
        with self.assertRaises(NoReference):
            table([failed("LE-1")])

    def test_no_error_is_relative_to_zero(self):
        variants = hierarchy()
        for one in variants:
            one["values"] = one["values"] and [0.]
        zero = table(variants)
        self.assertFalse(zero.has_error(0, 0))
        self.assertEqual(zero.front(0, "seconds"), [])
        self.assertIn("the reference is zero", zero.sentence(0, .01))

    def test_cheapest_to_count_on(self):
        # TBT contradicts EBBT, TE-2 contradicts TBT at 1 %; nobody contradicts TE-2 at 3 %, nor
        # LE-2, whose own richer variant is within.
        t = table([variant("EBBT", "EBBT", 1., 10, 1.001), variant("TBT", "TBT", 2., 11, 1.005),
                   variant("TE-2", "TE-2", 3., 30, 1.02), variant("LE-2", "LE-2", 4., 90, .993),
                   variant("LE-3", "LE-3", 5., 99, .995), variant("LE-4", "LE-4", 9., 200, 1.)])
        self.assertEqual(t.cheapest(0, .01), 0)
        self.assertEqual(t.cheapest_to_count_on(0, .01), 3)
        self.assertEqual(t.cheapest_to_count_on(0, .03), 0)
        self.assertIsNone(t.cheapest_to_count_on(0, .0015))

    def test_seconds_that_noise_can_make(self):
        for seconds, best in ((4.25, 5), (4.35, 4)):
            variants = hierarchy()
            variants[5]["seconds"] = seconds
            self.assertEqual(table(variants).cheapest(0, .01), best)

    def test_accidents(self):
        def beside(poor, rich):
            """TBT, off by `poor`, beside TE-2, off by `rich`."""
            return table([variant("TBT", "TBT", 1., 10, 1. + poor),
                          variant("TE-2", "TE-2", 2., 30, 1. - rich),
                          variant("LE-1", "LE-1", 3., 40, 1. + .9 * poor),
                          variant("LE-3", "LE-3", 9., 90, 1.)])
        # More than twice as much, and more than 0.1 %.
        self.assertTrue(beside(1e-3, 2.1e-3).is_accident(0, 0))
        self.assertFalse(beside(1e-3, 1.9e-3).is_accident(0, 0))
        self.assertFalse(beside(1e-5, 9e-4).is_accident(0, 0))
        self.assertTrue(beside(1e-5, 1.1e-3).is_accident(0, 0))
        # It stands on no front, and TE-2, which it would have beaten, does.
        self.assertEqual(beside(1e-3, 1.9e-3).front(0, "dofs"), [0, 2])
        self.assertEqual(beside(1e-3, 2.1e-3).front(0, "dofs"), [1, 2])
        # A variant that is poorer, or of another family, makes no accident.
        self.assertFalse(beside(1e-3, 2.1e-3).is_accident(1, 0))
        self.assertFalse(beside(5e-4, 0.).is_accident(2, 0))
        # Of runs to a tolerance the one to a smaller one is richer.
        runs = [variant("tolerance 1", "tolerance 1", 1., 10, 1.),
                variant("tolerance 0.1", "tolerance 0.1", 2., 20, 1.002),
                variant("LE-3", "LE-3", 9., 90, 1.)]
        self.assertTrue(table(runs).is_accident(0, 0))
        self.assertFalse(table(runs).is_accident(1, 0))
        with self.assertRaises(NoReference):
            table(runs, "solid")


class Sentences(unittest.TestCase):
    def test_how_sure_a_reference_is(self):
        # By the nearest variant, and not by the one before; by none that is far off.
        self.assertEqual(table(hierarchy()).basis(),
                         "Errors are against LE-3. The nearest to it, solid-2, is off by up to "
                         "0.2 %: errors smaller than that say little.")
        self.assertEqual(table(hierarchy(), "EBBT").basis(),
                         "Errors are against EBBT. No other variant comes near it in all quantities "
                         "(the nearest, LE-2, is off by up to 5.6 %), so nothing here tells how "
                         "sure it is.")

    def test_cheapest(self):
        t = table(hierarchy())
        self.assertEqual(t.sentence(0, .01), "For 1 % in tip: uz the cheapest is LE-2, axis 2: "
                         "100 DoFs, 4 s (off by 0.5 %).")
        self.assertEqual(t.sentence(0, .001),
                         "For 0.1 % in tip: uz no variant is enough but the reference itself.")

    def test_luck(self):
        # The richer of a family being further off, the poorer was lucky.
        variants = hierarchy()
        variants[0]["values"] = [1.001]
        self.assertEqual(table(variants).sentence(0, .01),
                         "For 1 % in tip: uz the cheapest is EBBT: 10 DoFs, 1 s (off by 0.1 %). "
                         "Do not count on it: TE-2, which is richer, is off by 3 %. The cheapest "
                         "to count on is LE-2, axis 2: 100 DoFs, 4 s (off by 0.5 %).")
        # Nothing else is within 0.15 %.
        self.assertIn("is off by 3 %. There is none to count on but the reference itself.",
                      table(variants).sentence(0, .0015))
        # A coarser mesh is not richer, whichever the theory; nor is another scene.
        variants[1]["axis"] = .5
        self.assertNotIn("count on", table(variants).sentence(0, .01))
        variants[1].update(axis=1., overridden=True)
        self.assertNotIn("count on", table(variants).sentence(0, .01))

    def test_beyond_linear(self):
        variants = hierarchy()
        # The reference counts, and of that what is worth a word.
        variants[0]["stiffening"] = 3.
        variants[6].update(stiffening=.005, buckling_factor=12.)
        self.assertEqual(table(variants).beyond_linear(), "")
        variants[6].update(stiffening=.12, buckling_factor=3.4)
        said = "By LE-3: stiffening 12 %, buckling factor 3.4"
        self.assertIn(said, table(variants).beyond_linear())
        # Without a reference the variant of most DoFs.
        self.assertIn(said, table(variants, "given", 1.).beyond_linear())


class Bars(unittest.TestCase):
    def setUp(self):
        # Against the reference -2: errors 9 % and 6 %, and bars of 0.2 and 0.1 in the quantity's
        # unit, 10 % and 5 % of 2. The first one holds.
        self.variants = [variant("A", "TE-1", 1., 10, -1.82), variant("B", "TE-2", 2., 20, -2.12),
                      variant("C", "LE-1", 3., 30, -2.2), failed("LE-2"),
                      variant("E", "LE-3", 4., 40, -2.02), variant("F", "LE-4", 9., 90, -2.)]
        for k, bar in {0: (.2, True), 1: (.1, True), 2: (.1, False), 5: (.01, True)}.items():
            self.variants[k]["bars"] = [{"bar": bar[0], "trusted": bar[1]}]
        self.variants[4]["bars"] = [None]

    def test_bars(self):
        t = table(self.variants)
        self.assertAlmostEqual(t.bar(0, 0), .1, delta=1e-15)
        self.assertIsNone(t.bar(2, 0))
        self.assertEqual([t.made_bar(k, 0) for k in range(6)],
                         [True, True, True, False, False, True])
        self.assertEqual(t.count_of_bars(), "Bars that hold, with the error at most the bar: "
                         "1 of 2; values without a bar: 1.")
        # B is off by 0.12, its bar 0.1; that of the reference is 0.03 now.
        self.variants[5]["bars"][0]["bar"] = .03
        self.assertEqual(table(self.variants).count_of_bars(),
                         "Bars that hold, with the error at most the bar: 1 of 2 (1 more with the "
                         "reference's own bar added); values without a bar: 1.")
        self.assertEqual(table(hierarchy()).count_of_bars(), "")

    def test_what_is_printed(self):
        with tempfile.TemporaryDirectory() as folder:
            trade = trade_of(self.variants)
            call = ("import json, pathlib, sys, trade; trade.make_tables(json.load(sys.stdin), "
                    f"pathlib.Path({folder!r}))")
            done = subprocess.run([sys.executable, "-c", call], input=json.dumps(trade), text=True,
                                  capture_output=True, cwd=SCRIPTS, check=False)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            for cell in ("9 % (bar 10 %)", "6 % (bar 5 %)", "10 % (no bar)", "- (bar 0.5 %)",
                         "\nBars that hold", "failed: It does not fit.\n"):
                self.assertIn(cell, done.stdout)
            lines = Path(folder, "trade.csv").read_text().splitlines()
            columns = lines[0].count(",")
            self.assertEqual([line.count(",") for line in lines[1:]], [columns] * 6)
            self.assertEqual(lines[4], "LE-2,LE-2,,1" + "," * (len(PHASES) + 11)
                             + "It does not fit. Buy memory.")
            script = Path(folder, "trade.py").read_text()
            self.assertIn("TITLE = \"It's a `title` $a_b\"\n", script)
            self.assertIn("TOLERANCES = [1.0]", script)
            drawn = [Path(folder, "trade." + kind).exists() for kind in ("png", "svg")]
            self.assertEqual(drawn, ["No pictures" not in done.stdout] * 2)


if __name__ == "__main__":
    unittest.main()
