#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""scripts/selector_study writes its tables into the pages: on the smallest stores, in a copy."""

import os
import pathlib
import shutil
import subprocess
import sys
import unittest

from flinch_program import FLINCH, StoreTest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = ("selectors.md", "selector_tables.md")


def section(page, name):
    """The page's text before, in and after the section."""
    before, rest = page.split(f"<!-- {name} -->\n")
    inside, after = rest.split(f"<!-- end of {name} -->")
    return before, inside, after


class SelectorStudy(StoreTest):
    scenarios = 40

    def setUp(self):
        super().setUp()
        for folder in ("scripts", "docs", "build/release"):
            (self.folder / folder).mkdir(parents=True)
        shutil.copy(ROOT / "scripts/selector_study", self.folder / "scripts")
        for page in PAGES:
            shutil.copy(ROOT / "docs" / page, self.folder / "docs")
        os.symlink(FLINCH, self.folder / "build/release/flinch")

    def study(self, *arguments):
        return subprocess.run([sys.executable, self.folder / "scripts/selector_study", *arguments],
                              capture_output=True, text=True, check=False)

    def make_repository(self):
        git = ["git", "-c", "user.name=test", "-c", "user.email=test", "-C", self.folder]
        subprocess.run([*git, "init", "--quiet"], check=True)
        subprocess.run([*git, "commit", "--quiet", "--allow-empty", "--message", "a"], check=True)

    def test_replaces_one_section_of_each_page_by_whole_tables(self):
        self.make_repository()
        self.make_whole()
        test = self.folder / "test"
        self.succeed(*self.command(test, "--first", self.scenarios, scenarios=20))
        done = self.study("mocap", self.whole, test)
        self.assertEqual(done.returncode, 0, done.stderr)
        for name in PAGES:
            old = section((ROOT / "docs" / name).read_text(), "mocap")
            new = section((self.folder / "docs" / name).read_text(), "mocap")
            self.assertEqual((old[0], old[2]), (new[0], new[2]))
            self.assertIn(f"fitted to {self.scenarios} scenarios", new[1])
            # The same tables with the same rows and columns, but for rows of groups and studies.
            headers = [line for line in new[1].splitlines() if line.startswith("| selector |")]
            self.assertEqual(headers, [line for line in old[1].splitlines()
                                       if line.startswith("| selector |")])
            for table in new[1].split("\n\n"):
                rows = [row.count("|") for row in table.strip().splitlines() if row[0] == "|"]
                self.assertEqual(len(set(rows)), min(len(rows), 1), table)
        rows = section((self.folder / "docs" / PAGES[0]).read_text(), "mocap")[1]
        for selector in ("idle", "svm", "oracle", "network+8", "random+16"):
            self.assertIn(f"| `{selector}` |", rows)
        self.assertNotIn("nan", rows)

    def test_a_page_without_the_section_is_told_before_anything_is_compared(self):
        done = self.study("other", "no store", "no store")
        self.assertEqual((done.returncode, done.stderr),
                         (1, "selector_study: selectors.md has no section other\n"))
        self.assertEqual(self.study("mocap").returncode, 2)


if __name__ == "__main__":
    unittest.main()
