# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
"""The table's verdicts, its JSON, and the page of results."""

import json
import os
import tempfile
import unittest

from validation.lib.checks import results_page, verdicts


def some():
    checks = verdicts.Checks("one", lambda row: None)
    checks.close("near", 1.01, 1.0, 0.02)
    checks.close("far", 1.05, 1.0, 0.02)
    checks.close("not a number", float("nan"), 1.0, 0.02)
    checks.note("why <it> is far")
    return checks


class VerdictsTest(unittest.TestCase):
    def test_a_gate_has_two_sides(self):
        checks = verdicts.Checks("one", lambda row: None)
        for value, passed in ((0.981, True), (1.019, True), (0.979, False), (1.021, False)):
            self.assertIs(bool(checks.close("q", value, 1.0, 0.02)), passed, value)

    def test_json(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "r.json")
            verdicts.write_json(path, some().rows)
            with open(path, encoding="utf-8") as f:
                rows = json.load(f)
        self.assertEqual([r["passed"] for r in rows], [True, False, False])
        self.assertEqual(set(rows[0]), {"case", "quantity", "value", "reference", "error", "gate", "passed"})
        self.assertIsNone(rows[2]["value"])

    def test_what_is_skipped_counts_neither_way(self):
        told = []
        checks = verdicts.Checks("one", told.append)
        checks.true("asked", True)
        checks.skipped("not asked", "the tool is not installed")
        self.assertEqual(verdicts.count(checks.rows), "1 passed, 0 failed, 1 skipped")
        self.assertEqual(verdicts.failed(checks.rows), [])
        self.assertIsNone(verdicts.plain(checks.rows[1])["passed"])
        self.assertRegex(verdicts.line(told[1]), "^skip .*not asked .*the tool is not installed$")


class PageTest(unittest.TestCase):
    def test_page_and_record(self):
        with tempfile.TemporaryDirectory() as folder:
            here = os.path.join(folder, "here")
            os.makedirs(os.path.join(here, "room", "one"))
            readme = os.path.join(here, "room", "one", "README.md")
            with open(readme, "w", encoding="utf-8") as f:
                f.write("# One\n<!-- last result -->\nold\n<!-- end of last result -->\nkept\n")
            with open(results_page.write(folder, [results_page.Result("a title", some(), 1.0)], keep=False),
                      encoding="utf-8") as f:
                shown = f.read()
            self.assertIn("why &lt;it&gt; is far", shown)
            self.assertIn('class="FAIL">2<', shown)
            results_page.record(folder, ["one"], here, {"one": os.path.join(here, "room", "one")})
            with open(readme, encoding="utf-8") as f:
                text = f.read()
            self.assertIn("| far | 1.05 | 1 | 0.05 | 0.02 | FAIL |", text)
            self.assertNotIn("old", text)
            self.assertIn("kept", text)
            with open(os.path.join(here, "RESULTS.md"), encoding="utf-8") as f:
                self.assertIn("## one", f.read())
            self.assertIn("<td>far</td>", shown)
            self.assertNotIn("rows passed; those that failed", shown)
            # what the page says of others stays, but for those that are no more
            with open(os.path.join(here, "RESULTS.md"), "a", encoding="utf-8") as f:
                f.write("\n## kept\n\n| a | b |\n\n## gone\n\nold.\n")
            results_page.record(folder, ["one"], here, {"one": os.path.join(here, "room", "one"), "kept": "elsewhere"})
            with open(os.path.join(here, "RESULTS.md"), encoding="utf-8") as f:
                text = f.read()
            self.assertEqual(text.count("## one\n\na title.\n\n"), 1)
            self.assertIn("\n\n## kept\n\n| a | b |\n\n## one", text)
            self.assertNotIn("## gone", text)
            # another case is added to those stored; a whole run begins anew
            other = verdicts.Checks("two", lambda row: None)
            results_page.write(folder, [results_page.Result("b", other, 1.0)], keep=True)
            self.assertEqual(sorted(os.listdir(os.path.join(folder, "cases"))), ["one.json", "two.json"])
            results_page.write(folder, [results_page.Result("b", other, 1.0)], keep=False)
            self.assertEqual(os.listdir(os.path.join(folder, "cases")), ["two.json"])

    def test_of_many_rows_those_that_failed(self):
        checks = verdicts.Checks("many", lambda row: None)
        for k in range(41):
            checks.true(f"row {k} & more", k != 7)
        with tempfile.TemporaryDirectory() as folder:
            picture = os.path.join(folder, "drawn.png")
            open(picture, "w", encoding="utf-8").close()
            checks.picture(picture)
            with open(results_page.write(folder, [results_page.Result("t", checks, 1.0)], keep=False),
                      encoding="utf-8") as f:
                shown = f.read()
            self.assertIn("<p>40 rows passed; those that failed:</p>", shown)
            self.assertIn("<td>row 7 &amp; more</td>", shown)
            self.assertNotIn("row 8 ", shown)
            self.assertIn('<img src="cases/many-1.png"', shown)
            self.assertTrue(os.path.isfile(os.path.join(folder, "cases", "many-1.png")))


if __name__ == "__main__":
    unittest.main()
