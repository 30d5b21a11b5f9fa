#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""scripts/threat_gallery draws its filmstrips: from few scenarios, in a copy."""

import os
import pathlib
import shutil
import subprocess
import unittest
import xml.etree.ElementTree

from flinch_program import FLINCH, ProgramTest

ROOT = pathlib.Path(__file__).resolve().parents[2]
NAMES = {f"{threat}_from_{start}.svg" for threat in ("bat", "punch", "thrown_knife")
         for start in ("idle", "guard", "walk")}


class ThreatGallery(ProgramTest):
    def draw(self, *arguments):
        for path, of in (("flinch", FLINCH), ("tests/e2e/make_synthetic_library",
                          os.environ["FLINCH_MAKE_LIBRARY"])):
            link = self.folder / "build/release" / path
            link.parent.mkdir(parents=True, exist_ok=True)
            os.symlink(of, link)
        (self.folder / "scripts").mkdir()
        script = shutil.copy(ROOT / "scripts/threat_gallery", self.folder / "scripts")
        return subprocess.run([script, *arguments], capture_output=True, text=True, check=False)

    def test_draws_each_threat_from_each_start(self):
        done = self.draw("12")
        self.assertEqual(done.returncode, 0, done.stderr)
        drawn = {path.name: path.read_text()
                 for path in (self.folder / "docs/gallery/threats").iterdir()}
        self.assertEqual(set(drawn), NAMES)
        self.assertEqual(len(set(drawn.values())), len(NAMES))
        for name, text in drawn.items():
            xml.etree.ElementTree.fromstring(text)
            self.assertIn("#e08010", text, name)  # the threat

    def test_the_pictures_in_the_docs_are_those(self):
        self.assertEqual({path.name for path in (ROOT / "docs/gallery/threats").iterdir()}, NAMES)

    def test_refuses_other_arguments(self):
        done = self.draw("12", "13")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("Usage: scripts/threat_gallery", done.stderr)


if __name__ == "__main__":
    unittest.main()
