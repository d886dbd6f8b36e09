#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tests how check_scene.py and check_bad_input.py read tables of cases and report failures.

Usage: check_checkers.py

A program in Python stands in for lamella. All tables of tests/ are read: no two cases may
have the same name, which is that of a ctest entry.
"""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
TESTS = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(TESTS / "scenes"), str(TESTS / "bad_input")]
import check_bad_input  # noqa: E402
import check_scene  # noqa: E402

# Writes the deflection 2 and says what its arguments are; a scene refused.prm is refused.
PROGRAM = f"""#!{sys.executable}
import json, pathlib, sys
scene, option, folder, *rest = sys.argv[1:]
if scene.endswith("refused.prm"):
    sys.exit("lamella: refused: Width must be positive [scene.bad-width]")
pathlib.Path(folder).mkdir(parents=True)
pathlib.Path(folder, "summary.json").write_text(json.dumps({{"uz": 2.0}}))
print("rest:", *rest)
"""
ROW = "summary:uz | 2 | 1% | by hand\n"


class InFolder(unittest.TestCase):
    """A test with a folder of its own, which is removed afterwards."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)
        self.program = self.write("program", PROGRAM)
        self.program.chmod(0o755)

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def run_checker(self, checker, table, *cases):
        done = subprocess.run(
            [sys.executable, "-B", checker.__file__, self.program, table, self.folder / "work",
             *cases], capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr


class Scenes(InFolder):
    def read(self, text):
        return check_scene.read_expectations(self.write("table.expect", text))

    def check(self, text, *cases):
        return self.run_checker(check_scene, self.write("table.expect", text), *cases)

    def test_a_file_without_names_is_one_case(self):
        case, = self.read("# A comment\nall --validate\nrun a.prm --set B=1\n" + ROW)
        self.assertEqual((case.name, case.what), ("table", ""))
        self.assertEqual(case.runs[0].run, ["a.prm", "--set", "B=1", "--validate"])
        self.assertEqual(case.runs[0].rows, [["summary:uz", "2", "1%", "by hand"]])

    def test_cases_have_names_and_runs_of_their_own(self):
        first, second = self.read(f"case one: Theory\nall -x\nrun a.prm\nagain -y\n{ROW}"
                                  f"case two: Length = 2: a slender one\nrun b.prm\n{ROW}{ROW}")
        self.assertEqual((first.name, first.what), ("one", "Theory"))
        self.assertEqual((first.runs[0].run, first.runs[0].again), (["a.prm", "-x"], ["-y", "-x"]))
        self.assertEqual((second.name, second.what), ("two", "Length = 2: a slender one"))
        self.assertEqual((second.runs[0].run, second.runs[0].again), (["b.prm"], None))
        self.assertEqual([len(first.runs[0].rows), len(second.runs[0].rows)], [1, 2])

    def test_comments_before_a_run_are_those_of_the_run(self):
        case, = self.read(f"case one: Theory\n# Of the case\n\n# TBT.\n# Sheared.\nrun a.prm\n"
                          f"# Of a row\n{ROW}# EBBT.\nrun b.prm\n{ROW}")
        self.assertEqual([run.comments for run in case.runs], [["# TBT.", "# Sheared."], ["# EBBT."]])

    def test_faults_of_a_table(self):
        for text, fault in (
                ("", "no line `run SCENE.prm`"),
                (ROW, "line 1: a row before"),
                ("again\n", "line 1: `again` is out of place"),
                ("run a.prm\nall -x\n" + ROW, "line 2: `all` is out of place"),
                ("run a.prm\nx | y | z\n", "line 2: not KEY"),
                ("run a.prm\nrun b.prm\n" + ROW, "no row to compare for `run a.prm`"),
                ("case one\nrun a.prm\n" + ROW, "line 1: not `case NAME"),
                ("case one two: x\nrun a.prm\n" + ROW, "line 1: not `case NAME"),
                ("case one: x\ncase two: y\nrun a.prm\n" + ROW, "case one: no line `run"),
                (2 * ("case one: x\nrun a.prm\n" + ROW), "line 4: a second case one"),
                ("run a.prm\n" + ROW + "case one: x\nrun a.prm\n" + ROW, "before the first `case")):
            with self.subTest(fault):
                with self.assertRaises(check_scene.Fault) as raised:
                    self.read(text)
                self.assertIn(fault, str(raised.exception))

    def test_a_failing_row_is_printed_with_its_variant(self):
        text = (f"case good: Theory = TBT\nrun a.prm\n{ROW}\ncase bad: Theory = EBBT\n"
                f"# Slender.\nrun a.prm --first\n{ROW}\nrun a.prm --second\n{ROW.replace('2', '3', 1)}")
        status, said = self.check(text)
        self.assertEqual(status, 1)
        self.assertIn("# Slender.\nbad 1: a.prm --first\n", said)
        self.assertEqual([line for line in said.splitlines() if line.startswith("FAIL")],
                         ["FAIL  bad 2 (Theory = EBBT): summary:uz"])
        self.assertTrue((self.folder / "work/bad/2/run/summary.json").exists())
        status, said = self.check(text, "good")
        self.assertEqual(status, 0)
        self.assertNotIn("bad", said)
        status, said = self.check(text, "goood")
        self.assertEqual(status, 1)
        self.assertIn("no case goood", said)

    def test_an_exit_status_is_a_failure_or_a_row(self):
        text = "case one: x\nrun refused.prm\nstderr:Width | present | exact | named\n"
        status, said = self.check(text)
        self.assertEqual(status, 1)
        self.assertIn("FAIL  one (x): exit status 1", said)
        self.assertEqual(self.check(text + "exit | 1 | exact | refused\n")[0], 0)


class BadInput(InFolder):
    GOOD = "case {}\n# Why.\nrun refused.prm --set A=1\nexit 1\nid scene.bad-width\nsays Width\nnever Height\n"

    def check(self, text, *cases):
        return self.run_checker(check_bad_input, self.write("table.bad", text), *cases)

    def test_cases_by_name(self):
        path = self.write("table.bad", self.GOOD.format("one") + "leaves a b\n"
                          + self.GOOD.format("two") + "file c.txt A text.\n")
        cases = check_bad_input.read_cases(path)
        self.assertEqual(cases["one"], {"run": ["refused.prm", "--set", "A=1"], "exit": 1, "file": [],
                                        "id": ["scene.bad-width"], "says": ["Width"], "never": ["Height"], "leaves": ["a", "b"]})
        self.assertEqual(cases["two"]["file"], [("c.txt", "A text.")])
        self.assertEqual(cases["two"]["leaves"], [])

    def test_faults_of_a_table(self):
        for text in ("run a.prm\n", "case one\nrun a.prm\nexit 1\n", "case one\nexit 1\nid x.y-z\n",
                     self.GOOD.format("one") + "exit 2\n", self.GOOD.format("one") + "tells x\n",
                     2 * self.GOOD.format("one")):
            with self.subTest(text):
                with self.assertRaises(SystemExit):
                    check_bad_input.read_cases(self.write("table.bad", text))

    def test_a_failing_case_is_named(self):
        text = self.GOOD.format("good") + self.GOOD.format("bad").replace("exit 1", "exit 2")
        status, said = self.check(text)
        self.assertEqual(status, 1)
        self.assertIn("FAIL: bad: exit status 1, not 2", said)
        self.assertNotIn("FAIL: good", said)
        self.assertEqual(self.check(text, "good")[0], 0)
        for nothing in ((text, "neither"), ("",)):
            self.assertEqual(self.check(*nothing)[0], 1)


class Tables(unittest.TestCase):
    def test_names_of_cases_are_unique(self):
        for names in (
                [case.name for path in TESTS.glob("scenes/*.expect")
                 for case in check_scene.read_expectations(path)],
                [name for path in TESTS.glob("bad_input/*.bad")
                 for name in check_bad_input.read_cases(path)]):
            self.assertEqual(sorted(set(names)), sorted(names))
            self.assertGreater(len(names), 50)


if __name__ == "__main__":
    unittest.main()
