#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""From a raw take to a library: annotate drafts a manifest, import accepts it."""

import unittest
import xml.etree.ElementTree

from flinch_program import ProgramTest
from takes import take

def raised_for_a_moment(time_s):
    """Up by 150 degrees from 2.0 to 2.5 s, down by 3.2 s."""
    x = min(max((time_s - 2) / 0.5, 0), 1) if time_s < 2.5 else min(max((3.2 - time_s) / 0.7, 0), 1)
    return 150 * x ** 3 * (10 - 15 * x + 6 * x * x)


class Annotate(ProgramTest):
    def setUp(self):
        super().setUp()
        self.take = self.folder / "take.bvh"
        self.take.write_text(take(150, raised_for_a_moment))

    def test_from_a_take_to_a_library(self):
        draft = self.document("annotate", self.take)
        self.assertEqual(draft["file"], str(self.folder / "take.toml"))
        self.assertEqual(len(draft["clips"]), 1)
        clip = draft["clips"][0]
        self.assertEqual(clip["kind"]["value"], "block")
        self.assertEqual(clip["target"]["value"], "head")
        self.assertEqual(clip["direction"]["value"], 45)
        self.assertAlmostEqual(clip["onset_s"], 2.0, delta=0.15)
        self.assertAlmostEqual(clip["peak_s"], 2.5, delta=0.15)
        for guess in (clip["kind"], clip["target"], clip["direction"]):
            self.assertTrue(0 <= guess["confidence"] <= 1 and guess["reason"])
        sheet = xml.etree.ElementTree.parse(self.folder / "take.svg").getroot()
        self.assertIn(clip["name"], "".join(sheet.itertext()))
        library = self.folder / "a.flinchlib"
        made = self.document("import", self.folder, "--manifest", draft["file"], "--out", library)
        self.assertEqual([c["name"] for c in made["clips"]], ["idle", clip["name"]])
        self.assertEqual(made["mirrored_count"], 1)
        self.assertTrue(made["clips"][1]["annotated"])

    def test_a_draft_in_another_folder_finds_its_take(self):
        elsewhere = self.folder / "drafts"
        elsewhere.mkdir()
        done = self.succeed("annotate", self.take, "--out", elsewhere / "d.toml", "--unit", "cm")
        self.assertIn("look at", done.stdout)
        self.assertTrue((elsewhere / "d.svg").is_file())
        self.assertIn('units = "cm"', (elsewhere / "d.toml").read_text())
        self.succeed("import", elsewhere, "--manifest", elsewhere / "d.toml", "--out",
                     self.folder / "a.flinchlib")

    def test_a_draft_keeps_the_options_that_its_take_was_read_with(self):
        toml = self.folder / "d.toml"
        self.succeed("annotate", self.take, "--out", toml, "--rate-of-file", 29.97, "--frames",
                     "4:148", "--skip-first", "--rest", self.take)
        text = toml.read_text()
        for line in ("rate_of_file = 29.97\n", 'frames = "4:148"\n', "skip_first = true\n",
                     'rest = "take.bvh"\n'):
            self.assertIn(line, text)
        made = self.document("import", self.folder, "--manifest", toml, "--out",
                             self.folder / "a.flinchlib")
        source = made["sources"][0]
        self.assertEqual((source["first_frame"], source["frame_count"]), (4, 145))
        self.assertAlmostEqual(source["frame_time_s"], 1 / 29.97)

    def test_files_that_exist_are_kept(self):
        for name, option in (("take.toml", "--out"), ("take.svg", "--sheet")):
            with self.subTest(file=name):
                path = self.folder / name
                path.write_text("corrected by hand")
                line = self.fail_with(1, "annotate", self.take)
                self.assertIn(name, line)
                self.assertIn(option, line)
                self.assertEqual(path.read_text(), "corrected by hand")
                path.unlink()

    def test_takes_that_cannot_be_annotated(self):
        lines = self.take.read_text().splitlines()
        walk = take(150, lambda time_s: 150 * abs((time_s * 4) % 2 - 1)).splitlines()
        for k in range(len(walk) - 150, len(walk)):
            walk[k] = f"0 90 {6 * (k % 1000)} " + walk[k].split(" ", 3)[3]
        cases = {
            "one frame": "\n".join(lines[:-149]).replace("Frames: 150", "Frames: 1") + "\n",
            "never still": "\n".join(walk) + "\n",
            "text file": "Dear Sir,\n",
        }
        for words, text in cases.items():
            with self.subTest(words):
                path = self.folder / "bad.bvh"
                path.write_text(text)
                line = self.fail_with(1, "annotate", path)
                self.assertIn("bad.bvh", line)
                if words != "text file":
                    self.assertIn(words, line)
                self.assertEqual(sorted(p.name for p in self.folder.iterdir()),
                                 ["bad.bvh", "take.bvh"])


if __name__ == "__main__":
    unittest.main()
