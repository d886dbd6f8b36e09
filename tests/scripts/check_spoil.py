#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tests the parts of tests/robustness/spoil.py without the program: scenes as lines, kinds of
faults, the choice of cases, and the judgement of outcomes.

Usage: check_spoil.py
"""

import collections
import contextlib
import io
import json
import random
import re
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "robustness"))
import spoil  # noqa: E402

SCENE = """# A comment with set Width = 1
set Title = A beam
set Bodies = beam
subsection Body beam
  set Length = 10   # mm
  subsection Kinematics
    set Axis elements = 2
  end
end
subsection Probe tip
  set At = beam: 0, 10, 0
end""".splitlines()
GOOD = {"converged": True, "dofs": 12, "energy": 0.5,
        "supports": {"clamp": {"reaction": [0., 1., -2.]}},
        "beyond_linear": {"buckling_factor": None}}
MESH_BASES = [f"mesh {name}" for name in spoil.MESHES]
MESSAGE = "lamella: scene.prm:5: Body beam/Length = -1: it must be positive."


def draft_of(lines, seed=1):
    """A draft of given lines in the place of a base."""
    draft = spoil.Draft(random.Random(seed), "base")
    draft.lines = list(lines)
    return draft


def case_of(due="refused", validate=False, names=("Length",), line=None, base="base"):
    draft = draft_of(SCENE)
    draft.due, draft.names, draft.line, draft.base = due, list(names), line, base
    case = spoil.Case(7, "negative", draft, False)
    case.validate = validate
    return case


def refusal(message=MESSAGE, status=1):
    return spoil.Outcome(status, "", message, 0.1)


def success(out=""):
    return spoil.Outcome(0, out, "", 0.1)


class InFolder(unittest.TestCase):
    """A test with a folder of its own, which is removed afterwards."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def write(self, name, content):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(content if isinstance(content, str) else json.dumps(content))
        return path

    def write_results(self, probes="probe,uz\ntip,1\n", **changes):
        self.write("output/summary.json", {**GOOD, **changes})
        self.write("output/probes.csv", probes)

    def program(self, *lines):
        """A program in Python in the place of lamella."""
        path = self.write("program", "\n".join([f"#!{sys.executable}", *lines]) + "\n")
        path.chmod(0o755)
        return path


class Lines(unittest.TestCase):
    def test_items_know_their_subsections(self):
        items = spoil.items_of(SCENE)
        self.assertEqual([i.word for i in items], ["set", "set", "subsection", "set", "subsection",
                                                   "set", "end", "end", "subsection", "set", "end"])
        elements = spoil.entries(SCENE, {"Axis elements"})[0]
        self.assertEqual(elements.path, ("Body beam", "Kinematics"))
        self.assertEqual((elements.value, elements.kind, elements.index), ("2", "Body", 6))

    def test_comments_are_no_values(self):
        self.assertEqual([i.value for i in spoil.entries(SCENE, {"Length"})], ["10"])
        self.assertEqual(spoil.entries(SCENE, {"Width"}), [])

    def test_entries_and_subsections_are_selected(self):
        self.assertEqual([i.name for i in spoil.entries(SCENE, kind="Probe")], ["At"])
        self.assertEqual([i.name for i in spoil.entries(SCENE, kind="")], ["Title", "Bodies"])
        self.assertEqual([s.name for s in spoil.subsections(SCENE)],
                         ["Body beam", "Kinematics", "Probe tip"])
        self.assertEqual([s.name for s in spoil.subsections(SCENE, 0)], ["Body beam", "Probe tip"])

    def test_the_end_of_a_subsection_is_its_own(self):
        ends = {s.name: spoil.end_of(SCENE, s) for s in spoil.subsections(SCENE)}
        self.assertEqual(ends, {"Body beam": 8, "Kinematics": 7, "Probe tip": 11})

    def test_a_value_is_replaced_added_or_removed(self):
        self.assertIn("    set Axis elements = 3",
                      spoil.with_value(SCENE, "Body beam/Kinematics/Axis elements", "3"))
        self.assertEqual(spoil.with_value(SCENE, "Theory", "TBT")[0], "set Theory = TBT")
        added = spoil.with_value(SCENE, "Body beam/Kinematics/Axis element", "B2")
        self.assertEqual(spoil.entries(added, {"Axis element"})[0].path, ("Body beam", "Kinematics"))
        removed = spoil.with_value(SCENE, "Probe tip/At", None)
        self.assertEqual(len(removed), len(SCENE) - 1)
        self.assertEqual(spoil.entries(removed, {"At"}), [])
        # An entry of the same name in another subsection stays.
        self.assertIn("  set At = beam: 0, 10, 0", spoil.with_value(SCENE, "At", "1"))

    def test_subsections_are_dropped_whole(self):
        self.assertEqual(spoil.dropped(SCENE, ["Body beam"]), SCENE[:3] + SCENE[9:])

    def test_continued_lines_are_joined(self):
        self.assertEqual(spoil.joined_lines("set A = 1, \\\n      2\nend"), ["set A = 1, 2", "end"])


class Bases(unittest.TestCase):
    def test_changes_of_a_base_are_made(self):
        for name, (_, changes) in spoil.BASES.items():
            with self.subTest(name):
                lines = spoil.base_lines(name)
                values = {"/".join([*i.path, i.name]): i.value for i in spoil.entries(lines)}
                for entry, value in changes.items():
                    self.assertEqual(values.get(entry), value)
                words = [i.word for i in spoil.items_of(lines)]
                self.assertEqual(words.count("subsection"), words.count("end"))

    def test_names_of_entries_are_documented(self):
        text = (spoil.ROOT / "doc/reference/parameters.prm").read_text()
        known = set(re.findall(r"^\s*set ([^=]+?)\s*=", text, re.MULTILINE))
        names = (spoil.NUMERIC | spoil.CHOICES | spoil.NAMES | spoil.PLACES | set(spoil.LISTS)
                 | spoil.ONE_NUMBER | spoil.REQUIRED | spoil.A_FIXED_NUMBER)
        self.assertEqual(names - known, set())

    def test_scenes_of_meshes_name_their_mesh(self):
        for name in spoil.MESHES:
            lines = spoil.mesh_scene(name)
            self.assertEqual([i.value for i in spoil.entries(lines, {"File"})], [f"{name}.msh"])
            self.assertFalse(re.search("MESH|PARTS|PROBE", "\n".join(lines)))


class Kinds(unittest.TestCase):
    def spoilt(self, name, base, seeds):
        """Drafts of this kind; those that the base has nothing for are left out."""
        for seed in seeds:
            draft = spoil.Draft(random.Random(f"{seed}/{name}/{base}"), base)
            with contextlib.suppress(spoil.NotHere):
                spoil.KINDS[name](draft)
                yield draft

    def test_each_kind_spoils_scenes_and_says_where(self):
        for name in spoil.KINDS:
            of_mesh = name.startswith("mesh_")
            changed = 0
            for base in MESH_BASES if of_mesh else spoil.BASES:
                good = spoil.Draft(random.Random(0), base)
                for draft in self.spoilt(name, base, range(2)):
                    with self.subTest(name, base=base):
                        self.assertIn(draft.due, ("refused", "either", "equal"))
                        self.assertTrue(draft.what)
                        self.assertTrue(any(draft.names) or draft.line is not None)
                        self.assertEqual(draft.mesh is not None, of_mesh)
                    changed += (draft.scene_bytes() != good.scene_bytes()
                                or draft.mesh != good.mesh)
                    if of_mesh:
                        self.assertEqual(draft.lines, good.lines)
            with self.subTest(name):
                self.assertGreater(changed, 0)

    def test_what_must_be_refused_is_never_the_good_scene(self):
        for name in spoil.KINDS:
            for base in MESH_BASES if name.startswith("mesh_") else ("base", "sandwich"):
                good = spoil.Draft(random.Random(0), base)
                for draft in self.spoilt(name, base, range(5)):
                    if draft.due == "refused":
                        with self.subTest(name, base=base, what=draft.what):
                            self.assertFalse(draft.scene_bytes() == good.scene_bytes()
                                             and draft.mesh == good.mesh)

    def test_a_required_entry_is_missed(self):
        draft = draft_of(["subsection Body beam", "  set Length = 10", "end"])
        spoil.delete_entry(draft)
        self.assertEqual((draft.due, draft.lines), ("refused", ["subsection Body beam", "end"]))
        draft = draft_of(["set Title = A"])
        spoil.delete_entry(draft)
        self.assertEqual((draft.due, draft.lines), ("either", []))

    def test_misspelt_words_have_a_q(self):
        words = {spoil.misspelt(random.Random(seed), "Width") for seed in range(50)}
        self.assertEqual(words, {"Wqidth", "Wiqdth", "Widqth", "Widtqh", "Widthq"})

    def test_one_number_of_a_value_is_replaced(self):
        draft = draft_of(["subsection Body b", "  set Origin = 1, -2.5e-1, 3", "end"])
        spoil.beyond_doubles(draft)
        self.assertIn(draft.lines[1], [f"  set Origin = {value}" for value in (
            "1e400, -2.5e-1, 3", "1, 1e400, 3", "1, -2.5e-1, 1e400")])
        self.assertEqual((draft.due, draft.line), ("refused", 1))
        self.assertEqual(draft.names, ["Origin", "Body b"])

    def test_numbers_that_must_be_positive(self):
        due = lambda name, number=0: spoil.due_if_not_positive(spoil.Item(0, "set", name), number)
        self.assertEqual(due("Width"), "refused")
        self.assertEqual(due("Cells across"), "refused")
        self.assertEqual(due("Origin"), "either")
        self.assertEqual([due("Isotropic", n) for n in (0, 1)], ["refused", "either"])
        self.assertEqual([due("Engineering constants", n) for n in (5, 6)], ["refused", "either"])
        self.assertEqual(spoil.due_of_count(spoil.Item(0, "set", "Samples"), 0), "refused")
        self.assertEqual(spoil.due_of_count(spoil.Item(0, "set", "Width"), 0), "either")

    def test_a_second_support_contradicts_the_first(self):
        self.assertEqual(spoil.contradicting(""), "1.0, 1.0, 1.0")
        self.assertEqual(spoil.contradicting("free, 0.5, free"), "free, 1.5, free")
        draft = draft_of(["set Supports = clamp", "subsection Support clamp", "  set On = beam: start",
                          "  set Normal displacement = 2", "end"])
        spoil.two_supports(draft)
        self.assertEqual(draft.lines[0], "set Supports = clamp, another")
        self.assertEqual(draft.lines[5:], ["subsection Support another", "  set On = beam: start",
                                           "  set Normal displacement = 3.0", "end"])

    def test_counts_that_may_be_good_are_not_solved(self):
        draft = draft_of(SCENE)
        spoil.many(draft)
        self.assertTrue(draft.unsolved)
        self.assertTrue(spoil.Case(0, "many", draft, False).validate)

    def test_expressions_have_a_verdict_each(self):
        self.assertEqual(set(spoil.EXPRESSIONS_OF_A_LOAD.values()), {"refused", "either"})
        for seed in range(100):
            draft = draft_of(["subsection Load l", "  set Pressure = 1", "end"], seed)
            spoil.expression(draft)
            text = draft.lines[1].partition(" = ")[2]
            self.assertEqual(draft.due, spoil.EXPRESSIONS_OF_A_LOAD[text.replace("#  ", "# ")])


class Cases(InFolder):
    def test_kinds_take_turns(self):
        kinds = list(spoil.KINDS)
        counts = collections.Counter(spoil.make_case(number, 1, kinds).kind
                                     for number in range(2 * len(kinds)))
        self.assertEqual(set(counts.values()), {2})
        self.assertEqual(len(counts), len(kinds))

    def test_the_same_seed_gives_the_same_cases(self):
        kinds = list(spoil.KINDS)
        fields = lambda case: (case.kind, case.base, case.what, case.scene, case.mesh,
                               case.validate)
        for number in range(0, len(kinds), 5):
            self.assertEqual(*(fields(spoil.make_case(number, 3, kinds)) for _ in range(2)))
        self.assertNotEqual(*([fields(spoil.make_case(n, seed, kinds)) for n in range(20)]
                              for seed in (1, 2)))

    def test_results_that_must_agree_are_solved_for(self):
        draft = draft_of(SCENE)
        for due, validate in (("equal", False), ("either", True), ("refused", True)):
            draft.due = due
            self.assertEqual(spoil.Case(0, "k", draft, True).validate, validate)

    def test_files_of_a_case(self):
        kinds = [name for name in spoil.KINDS if name.startswith("mesh_")]
        case = spoil.make_case(0, 1, kinds)
        spoil.write_files(case, self.folder / "mesh")
        mesh = case.base[5:] + ".msh"
        self.assertEqual({p.name for p in (self.folder / "mesh").iterdir()}, {"scene.prm", mesh})
        self.assertEqual((self.folder / "mesh" / mesh).read_bytes(), case.mesh)
        # A scene without a mesh of its own gets those that it names.
        case = case_of()
        case.scene = b"set File = rail.msh\n"
        spoil.write_files(case, self.folder / "scene")
        self.assertEqual({p.name for p in (self.folder / "scene").iterdir()},
                         {"scene.prm", "rail.msh"})

    def test_arguments(self):
        self.assertEqual(spoil.arguments_of(case_of()), ["scene.prm", "--output", "output"])
        self.assertIn("--validate", spoil.arguments_of(case_of(validate=True)))


class Messages(unittest.TestCase):
    def faults(self, message, **case):
        return "; ".join(spoil.faults_of_message(case_of(**case), message))

    def test_a_good_message(self):
        self.assertEqual(self.faults(MESSAGE), "")

    def test_each_fault_of_a_message(self):
        for message, fault in (
                ("", "nothing on stderr"),
                (MESSAGE + "\nmore" * 12, "13 lines"),
                (MESSAGE + "q" * 1500, "characters"),
                (MESSAGE + "\n" + MESSAGE, "not one message"),
                ("Body beam/Length must be positive", "not one message"),
                (MESSAGE + " std::bad_alloc", "the word std::"),
                (MESSAGE + "\x1b[0m", "control characters"),
                ("lamella: it must be positive", "does not say where"),
                ("lamella: Length = -1", "no remedy")):
            with self.subTest(fault):
                self.assertIn(fault, self.faults(message))

    def test_the_place_is_a_name_or_a_line(self):
        message = "lamella: scene.prm:6: it must be positive"
        self.assertIn("where", self.faults(message, names=()))
        for line in (4, 5, 6):  # counted from zero; two lines later is still near
            self.assertEqual(self.faults(message, names=(), line=line), "")
        self.assertIn("where", self.faults(message, names=(), line=7))

    def test_a_failure_of_the_numerics_may_name_a_body(self):
        message = "lamella: body 'beam' is not held: add a support"
        self.assertIn("where", self.faults(message, names=("Width",)))
        self.assertEqual(self.faults(message, names=("Width",), due="either"), "")


class Judgement(InFolder):
    def verdict(self, outcome, good=None, **case):
        return spoil.judge(case_of(**case), outcome, self.folder, {"base": good})

    def test_time_out(self):
        self.assertEqual(self.verdict(spoil.Outcome(None, "", "", 20.)), ("time-out", "20 s"))

    def test_crashes(self):
        for outcome in (refusal(status=-11), refusal(status=3),
                        refusal("lamella: internal error: it must not be"),
                        spoil.Outcome(0, "runtime error: x", "", 1.)):
            self.assertEqual(self.verdict(outcome)[0], "crash")

    def test_a_good_refusal(self):
        self.write("scene.prm", "")
        self.write("rail.msh", "")
        self.assertEqual(self.verdict(refusal()), ("ok", ""))

    def test_an_unclear_refusal(self):
        self.assertEqual(self.verdict(refusal("lamella: no"))[0], "unclear")

    def test_a_refusal_leaves_nothing(self):
        self.write("output/scene.csv", "")
        verdict, why = self.verdict(refusal())
        self.assertEqual(verdict, "silent")
        self.assertIn("exit 1 left output", why)
        self.assertIn("half of the results", self.verdict(refusal(status=2))[1])

    def test_results_up_to_a_failure_are_marked(self):
        self.write("output/summary.json", {**GOOD, "converged": False})
        self.assertEqual(self.verdict(refusal(status=2)), ("ok", ""))
        self.write("output/summary.json", GOOD)
        self.assertEqual(self.verdict(refusal(status=2)), ("silent", "exit 2, and converged"))

    def test_a_run_where_a_refusal_is_due(self):
        self.write_results()
        self.assertEqual(self.verdict(success()), ("silent", "had to be refused"))
        self.assertEqual(self.verdict(success(), validate=True), ("silent", "had to be refused"))

    def test_a_good_run(self):
        self.write_results()
        self.assertEqual(self.verdict(success(), due="either"), ("ok", ""))
        self.assertEqual(self.verdict(success("reaction 1"), due="either", validate=True),
                         ("ok", ""))

    def test_validate_prints_numbers(self):
        for out in ("EI nan", "area -inf", "(nan, 0)"):
            self.assertEqual(self.verdict(success(out), due="either", validate=True)[0], "silent")
        for out in ("nanometre", "infinite", "tenant"):
            self.assertEqual(self.verdict(success(out), due="either", validate=True)[0], "ok")

    def test_results_are_numbers(self):
        for changes, fault in (({"energy": None}, "/energy is no number"),
                               ({"energy": "nan"}, "/energy is no number"),
                               ({"energy": float("inf")}, "/energy is no number"),
                               ({"supports": {"c": {"reaction": [0., None]}}}, "/reaction"),
                               ({"converged": False}, "not converged"),
                               ({"probes": "probe,uz\ntip,nan\n"}, "probes.csv holds"),
                               ({"probes": "probe,uz\ntip,-inf\n"}, "probes.csv holds")):
            with self.subTest(fault, changes=changes):
                self.write_results(**changes)
                verdict, why = self.verdict(success(), due="either")
                self.assertEqual(verdict, "silent")
                self.assertIn(fault, why)

    def test_results_are_there(self):
        self.assertIn("without summary.json", self.verdict(success(), due="either")[1])
        self.write("output/summary.json", "{")
        self.assertIn("no JSON", self.verdict(success(), due="either")[1])

    def test_results_of_the_same_scene(self):
        self.write_results()
        good = spoil.results_of(self.folder)
        self.assertEqual(good, {"dofs": [12], "energy": [0.5], "reactions": [0., 1., -2.],
                                "rows": [2]})
        self.assertEqual(self.verdict(success(), good, due="equal"), ("ok", ""))
        self.write_results(energy=0.5 * (1. + 1e-10))
        self.assertEqual(self.verdict(success(), good, due="equal"), ("ok", ""))
        for changes, name in (({"energy": 0.5 * (1. + 1e-6)}, "energy"), ({"dofs": 13}, "dofs"),
                              ({"supports": {"c": {"reaction": [0., 1.]}}}, "reactions"),
                              ({"probes": "probe,uz\n"}, "rows")):
            with self.subTest(name):
                self.write_results(**changes)
                self.assertEqual(self.verdict(success(), good, due="equal"),
                                 ("silent", f"{name} is not that of the good scene"))

    def test_a_scene_that_must_agree_does_not_fail(self):
        self.assertEqual(self.verdict(refusal(status=2), {}, due="equal")[0], "silent")
        self.assertEqual(self.verdict(refusal(), {}, due="equal")[0], "ok")


class Runs(InFolder):
    def test_status_and_messages_of_a_program(self):
        program = self.program("import sys, os", "print('out', *sys.argv[1:])",
                               "print(os.environ['OMP_NUM_THREADS'], file=sys.stderr)", "sys.exit(2)")
        outcome = spoil.run(program, ["a", "b"], self.folder, 10.)
        self.assertEqual((outcome.status, outcome.out, outcome.message), (2, "out a b\n", "1\n"))
        self.assertEqual([p.name for p in self.folder.parent.glob(f"{self.folder.name}.tmp")], [])

    def test_processor_time_is_limited(self):
        outcome = spoil.run(self.program("while True: pass"), [], self.folder, 1.)
        self.assertIsNone(outcome.status)

    def test_only_bad_cases_are_kept(self):
        program = self.program("import sys", f"sys.exit({MESSAGE!r})")
        folder = self.folder / "cases/00007_negative"
        self.assertEqual(spoil.check(program, case_of(), self.folder, {}, 10.)[1:3], ("ok", ""))
        self.assertFalse(folder.exists())
        program = self.program("import sys", "sys.exit('lamella: no')")
        self.assertEqual(spoil.check(program, case_of(), self.folder, {}, 10.)[1], "unclear")
        text = (folder / "run").read_text()
        for fragment in (str(program), "# due: refused", "# unclear: ", "# exit status 1"):
            self.assertIn(fragment, text)

    def test_a_base_that_fails_ends_the_run(self):
        program = self.program("import sys", "sys.exit(1)")
        with self.assertRaisesRegex(SystemExit, "base is no good scene"):
            spoil.good_results(program, self.folder, {"base"}, 1, 10.)

    def test_the_table_counts_verdicts(self):
        results = [(case_of(), verdict, "", None) for verdict in ("ok", "ok", "silent", "crash")]
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            total = spoil.print_table(results)
        self.assertEqual(dict(total), {"ok": 2, "silent": 1, "crash": 1})
        self.assertRegex(printed.getvalue(), r"negative +2 +1 +1 *\n")


if __name__ == "__main__":
    unittest.main()
