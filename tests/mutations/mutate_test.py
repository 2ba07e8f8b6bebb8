#!/usr/bin/env python3
"""The lists fit the sources, and what reads them notices when they do not."""

import pathlib
import tempfile
import unittest

import mutate
import mutation_list
from mutate import Result

ROOT = pathlib.Path(__file__).resolve().parents[2]

LIST = """# About this list.

== core/a.h
A sign
- +x
+ -x
Two lines
- first
-   second
+ first
Nothing is left
- gone
== core/a.h: core/b_test
Others test it
- x
+ y
"""


class Lists(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.write("tests/core/a_test.cpp")
        self.write("tests/core/b_test.cpp")

    def write(self, name, text=""):
        (self.root / name).parent.mkdir(parents=True, exist_ok=True)
        (self.root / name).write_text(text)

    def problems(self, text, source):
        self.write("core/a.h", source)
        return mutation_list.problems_of(mutation_list.parse(text, self.root, "list"), self.root)

    def test_of_this_project_fit_its_sources(self):
        mutations = mutation_list.read_lists(ROOT)
        self.assertGreaterEqual(len(mutations), 80)

    def test_are_read(self):
        sign, lines, nothing, others = mutation_list.parse(LIST, self.root, "list")
        self.assertEqual((sign.file, sign.search, sign.replacement), ("core/a.h", "+x", "-x"))
        self.assertEqual(sign.tests, ("core/a_test",))
        self.assertEqual(sign.name, "core/a.h: A sign")
        self.assertEqual((lines.search, lines.replacement), ("first\n  second", "first"))
        self.assertEqual(nothing.replacement, "")
        self.assertEqual(others.tests, ("core/b_test",))

    def test_are_rejected_where_something_is_out_of_place(self):
        for text in ("A mutation of no file\n", "== core/a.h\n- text without a description\n", "== core/a.h\nNo text\n",
                     "== core/a.h\nNothing to replace\n+ x\n"):
            with self.assertRaises(mutation_list.ListError, msg=text):
                mutation_list.parse(text, self.root, "list")

    def test_are_stale_where_the_text_does_not_stand_once(self):
        one = "== core/a.h\nA sign\n- +x\n+ -x\n"
        self.assertEqual(self.problems(one, "y +x\n"), [])
        self.assertIn("occurs 0 times", self.problems(one, "y -x\n")[0])
        self.assertIn("occurs 2 times", self.problems(one, "+x +x\n")[0])

    def test_are_wrong_without_a_file_a_test_or_a_change(self):
        self.assertIn("no such file", self.problems("== core/gone.h: core/a_test\nA sign\n- x\n+ y\n", "")[0])
        self.assertIn("no test mirrors", self.problems("== core/gone.h\nA sign\n- x\n+ y\n", "")[0])
        self.assertIn("no tests/core/c_test.cpp", self.problems("== core/a.h: core/c_test\nA\n- x\n+ y\n", "x")[0])
        self.assertIn("changes nothing", self.problems("== core/a.h\nA sign\n- x\n+ x\n", "x")[0])
        self.assertIn("listed twice", self.problems("== core/a.h\nA\n- x\n+ y\nA\n- x\n+ z\n", "x")[0])


class Resuming(unittest.TestCase):
    def test_keeps_what_was_noticed_while_file_and_tests_are_the_same(self):
        for verdict in (mutate.MIRRORED, mutate.PASSES):
            result = Result(verdict, fingerprint="file", sources="all")
            self.assertTrue(mutate.still_holds(result, "file", "others"))
            self.assertFalse(mutate.still_holds(result, "changed", "all"))

    def test_keeps_what_the_whole_suite_said_while_no_source_has_changed(self):
        for verdict in (mutate.WHOLE, mutate.SURVIVED):
            result = Result(verdict, fingerprint="file", sources="all")
            self.assertTrue(mutate.still_holds(result, "file", "all"))
            self.assertFalse(mutate.still_holds(result, "file", "others"))

    def test_tries_again_what_did_not_compile(self):
        self.assertFalse(mutate.still_holds(Result(mutate.BROKEN, fingerprint="file", sources="all"), "file", "all"))


class Running(unittest.TestCase):
    def test_ends_what_hangs(self):
        code, output = mutate.run(["sh", "-c", "echo begun; sleep 60"], ROOT, timeout=0.2)
        self.assertEqual((code, output), (-1, "begun\n\ntimeout"))


if __name__ == "__main__":
    unittest.main()
