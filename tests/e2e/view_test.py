#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The page with selectors in it. tests/page opens it in a browser."""

import base64
import json
import re
import shutil
import subprocess
import unittest

from flinch_program import FLINCH, ProgramTest, make_library, run, shared_folder

PAGE = ('<!doctype html><head><meta name="generator" content="Flinch" /></head>'
        "<body><p>é</p><!-- selectors --><script>0</script></body>")


def selector(model):
    """A selector, made once."""
    made = shared_folder() / f"{model}.flinch"
    if not made.exists():
        library, store = shared_folder() / "a.flinchlib", shared_folder() / "a.flinchobs"
        if not store.exists():
            make_library(library)
            assert run("simulate", library, "--out", store, "-n", 12).returncode == 0
        done = run("train", store, "--out", made, "--model", model)
        assert done.returncode == 0, done.stderr
    return made


class View(ProgramTest):
    def setUp(self):
        super().setUp()
        for model in ("knn", "svm"):
            shutil.copy(selector(model), self.folder)

    def program_with(self, page, program="bin/flinch"):
        """Copies the program to a place with this page, or none, and returns its path."""
        copy = self.folder / program
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(FLINCH, copy)
        if page is not None:
            page = self.folder / page
            page.parent.mkdir(parents=True)
            page.write_text(PAGE, encoding="utf-8")
        return copy

    def run_copy(self, program, *arguments):
        return subprocess.run([program, *map(str, arguments)], capture_output=True, text=True,
                              check=False, cwd=self.folder)

    def view(self, program, *arguments):
        done = self.run_copy(program, "view", *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def refuse(self, code, words, program, *arguments):
        before = sorted(self.folder.glob("**/*"))
        done = self.run_copy(program, "view", *arguments)
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertRegex(done.stderr, rf"\Aflinch: .*({words}).*\n\Z")
        self.assertEqual(sorted(self.folder.glob("**/*")), before)

    def test_the_page_holds_the_selectors_byte_for_byte_and_is_otherwise_unchanged(self):
        for place, page in (("build/flinch", "build/page/index.html"),
                            ("usr/bin/flinch", "usr/share/flinch/page.html")):
            program = self.program_with(page, place)
            self.view(program, "svm.flinch", "knn.flinch", "--out", "a/b")
            html = (self.folder / "a/b/index.html").read_text(encoding="utf-8")
            found = re.findall(r'<script type="application/octet-stream" '
                               r'data-selector="([^"]*)">([^<]*)</script>\n', html)
            self.assertEqual([name for name, _ in found], ["svm.flinch", "knn.flinch"])
            for name, text in found:
                data = base64.b64decode(text, validate=True)
                self.assertEqual(data, (self.folder / name).read_bytes())
            rest = re.sub(r"(<script type=.*</script>\n)+", "<!-- selectors -->", html)
            self.assertEqual(rest, PAGE)
            shutil.rmtree(self.folder / "a")

    def test_it_says_how_to_open_the_page(self):
        program = self.program_with("bin/page/index.html")
        text = self.view(program, "knn.flinch")
        place = (self.folder / "flinch_page/index.html").resolve()
        self.assertEqual(text, f"flinch_page/index.html: open file://{place} in a browser\n")
        document = json.loads(self.view(program, "knn.flinch", "svm.flinch", "--json"))
        self.assertEqual(document, {"kind": "page", "file": "flinch_page/index.html",
                                    "selectors": ["knn.flinch", "svm.flinch"]})

    def test_without_a_page_it_says_what_to_build(self):
        self.refuse(1, "no page beside this program; scripts/page builds it",
                    self.program_with(None), "knn.flinch")
        damaged = self.program_with("bin/page/index.html")
        (self.folder / "bin/page/index.html").write_text("<!doctype html>")
        self.refuse(1, "damaged: build it again", damaged, "knn.flinch")

    def test_refuses_what_no_page_can_hold(self):
        program = self.program_with("bin/page/index.html")
        shutil.copy(shared_folder() / "a.flinchobs", self.folder)
        self.refuse(1, "a.flinchobs: .*not a selector", program, "knn.flinch", "a.flinchobs")
        self.refuse(1, "missing.flinch: ", program, "missing.flinch")
        self.refuse(2, "at most 3 selectors", program, *["knn.flinch"] * 4)
        self.refuse(2, "SELECTOR", program)

    def test_replaces_its_own_page_and_no_other_file(self):
        program = self.program_with("bin/page/index.html")
        page = self.folder / "site/index.html"
        self.view(program, "knn.flinch", "--out", "site")
        first = page.read_bytes()
        self.view(program, "knn.flinch", "--out", "site")
        self.assertEqual(page.read_bytes(), first)
        page.write_text("<!doctype html><title>My diary</title>")
        self.refuse(1, "--force", program, "knn.flinch", "--out", "site")
        self.view(program, "knn.flinch", "--out", "site", "--force")
        self.assertEqual(page.read_bytes(), first)
        self.refuse(1, "is a file; name a folder", program, "knn.flinch", "--out", "svm.flinch")

    def test_no_name_of_a_file_becomes_markup(self):
        program = self.program_with("bin/page/index.html")
        name = '"><script>alert(1)&é.flinch'
        shutil.copy(self.folder / "knn.flinch", self.folder / name)
        self.view(program, name)
        html = (self.folder / "flinch_page/index.html").read_text(encoding="utf-8")
        self.assertRegex(html, r'data-selector="___script_alert_1_+\.flinch"')
        self.assertNotIn("alert(1)", html)


if __name__ == "__main__":
    unittest.main()
