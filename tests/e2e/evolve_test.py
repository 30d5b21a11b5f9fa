#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Pain by place, and poses that evolve."""

import pathlib
import unittest

from flinch_program import ProgramTest, make_library

DOCS = pathlib.Path(__file__).resolve().parents[2] / "docs"


class Pain(ProgramTest):
    def setUp(self):
        super().setUp()
        self.library = self.folder / "default.flinchlib"

    def test_the_drawing_in_the_docs_is_of_the_default_library(self):
        self.succeed("author", "--out", self.library)
        drawn = self.folder / "pain.svg"
        self.succeed("info", self.library, "--pain", drawn)
        self.assertEqual(drawn.read_text(), (DOCS / "pain.svg").read_text())
        self.succeed("info", self.library, "--pain", drawn)  # its own file

    def test_refuses_to_draw_over_other_files_or_what_is_no_library(self):
        make_library(self.library)
        note = self.folder / "note.svg"
        note.write_text("<svg>mine</svg>\n")
        self.assertIn("--force", self.fail_with(1, "info", self.library, "--pain", note))
        self.assertEqual(note.read_text(), "<svg>mine</svg>\n")
        self.fail_with(1, "info", self.library, "--pain", self.library)
        self.fail_with(1, "info", note, "--pain", self.folder / "pain.svg")


if __name__ == "__main__":
    unittest.main()
