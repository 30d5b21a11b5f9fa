#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The page of a report. tests/page opens it in a browser."""

import json
import re
import shutil
import subprocess
import unittest

from flinch_program import FLINCH, StoreTest, make_library

PAGE = ('<!doctype html><head><meta name="generator" content="Flinch" /></head>'
        "<body><p>é</p><!-- report --><script>0</script></body>")
ELEMENT = re.compile(r'<script type="application/json" id="report">(.*)</script>(?=<script>0)')


class ReportPage(StoreTest):
    scenarios = 12

    def compare(self, *options, page=None, place="bin/page/report.html"):
        """Runs a copy of the program that finds this page, or none, and returns its stderr."""
        program = self.folder / "bin/flinch"
        program.parent.mkdir(exist_ok=True)
        shutil.copy(FLINCH, program)
        if page is not None:
            (self.folder / place).parent.mkdir(parents=True, exist_ok=True)
            (self.folder / place).write_text(page, encoding="utf-8")
        done = subprocess.run([program, "compare", "whole", "--models", "knn", "--report", "report",
                               *options], capture_output=True, text=True, check=False,
                              cwd=self.folder)
        self.code = done.returncode
        return done.stderr

    def setUp(self):
        super().setUp()
        self.make_whole()
        self.report = self.folder / "report"

    def test_holds_the_report_and_the_times_and_is_otherwise_unchanged(self):
        for place in ("bin/page/report.html", "share/flinch/report.html"):
            self.assertEqual(self.compare("--force", page=PAGE, place=place), "")
            html = (self.report / "report.html").read_text(encoding="utf-8")
            document = json.loads(ELEMENT.search(html)[1])
            timing = json.loads((self.report / "timing.json").read_text())
            report = json.loads((self.report / "report.json").read_text())
            self.assertEqual(document, {**report, "timing": timing})
            self.assertEqual(ELEMENT.sub("<!-- report -->", html), PAGE)
            shutil.rmtree(self.folder / "bin")

    def test_says_what_made_it(self):
        self.compare(page=PAGE)
        report = json.loads((self.report / "report.json").read_text())
        version = subprocess.run([FLINCH, "--version"], capture_output=True, text=True,
                                 check=True).stdout.split()[1]
        self.assertEqual(report["version"], version)
        self.assertEqual(report["options"], {"feature_set": "geometry", "curves": False,
                                             "transfer": False, "ablation": False})
        for name, count in (("fitted", 9), ("tested", 3)):
            self.assertEqual(report["stores"][name]["scenarios"], count)
            self.assertEqual(report["stores"][name]["seed"], report["seed"])
            self.assertIn("kinds", report["stores"][name]["distribution"])

    def test_without_a_page_says_so_and_writes_the_data(self):
        self.assertEqual(self.compare(page=PAGE), "")
        shutil.rmtree(self.folder / "bin")
        line = self.compare("--force")
        self.assertEqual(self.code, 0)
        self.assertRegex(line, r"\Athere will be no report.html, only its data: .*scripts/setup.*\n\Z")
        names = {path.name for path in self.report.iterdir()}
        self.assertLessEqual({"report.json", "timing.json", "scenarios.csv", "groups.csv"}, names)
        self.assertNotIn("report.html", names)  # it would be an earlier report's

    def test_a_damaged_page_is_refused_before_the_work(self):
        line = self.compare(page="<!doctype html>")
        self.assertEqual(self.code, 1)
        self.assertRegex(line, r"\Aflinch: .*damaged: build it again.*\n\Z")
        self.assertFalse(self.report.exists())

    def test_no_text_of_a_report_becomes_markup(self):
        self.library = self.folder / "named.flinchlib"
        name = "</script><script>alert(1)</script><!-- <script>"
        make_library(self.library, name)
        self.whole.unlink()
        self.succeed(*self.command(self.whole))
        self.compare(page=PAGE)
        html = (self.report / "report.html").read_text(encoding="utf-8")
        text = ELEMENT.search(html)[1]
        self.assertNotIn("<", text)
        self.assertEqual(json.loads(text)["library"], name)


if __name__ == "__main__":
    unittest.main()
