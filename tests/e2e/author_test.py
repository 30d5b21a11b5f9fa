#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The default library: made by rule, for any character, and effective against threats."""

import os
import pathlib
import shutil
import sqlite3
import unittest

from flinch_program import ProgramTest, shared_folder
from store_costs import costs

GALLERY = pathlib.Path(__file__).resolve().parents[2] / "docs" / "gallery"


class Author(ProgramTest):
    def setUp(self):
        super().setUp()
        self.library = self.folder / "default.flinchlib"

    def author_default(self):
        """Writes `library`, the default one, and `drawn`, its gallery. Authored once."""
        made = shared_folder() / "default.flinchlib"
        self.drawn = shared_folder() / "gallery"
        if not made.exists():
            self.succeed("author", "--out", made, "--gallery", self.drawn)
        shutil.copy(made, self.library)

    def test_same_character_same_bytes(self):
        self.author_default()
        again = self.folder / "again.flinchlib"
        self.succeed("author", "--out", again)
        self.assertEqual(self.library.read_bytes(), again.read_bytes())

    def test_all_clips_keep_all_bounds_of_quality(self):
        self.author_default()
        quality = self.document("info", self.library, "--quality")["quality"]
        self.assertGreaterEqual(len(quality["clips"]), 120)
        self.assertEqual([c["name"] for c in quality["clips"] if c["breaks"]], [])
        text = self.succeed("info", self.library, "--quality").stdout
        count = len(quality["clips"])
        self.assertIn(f"{count} of {count} clips meet all bounds", text)

    def test_the_gallery_in_the_docs_shows_every_clip(self):
        self.author_default()
        shown = set(os.listdir(GALLERY)) - {"evolved", "threats"}  # which are not authored
        self.assertEqual(sorted(os.listdir(self.drawn)), sorted(shown))
        self.assertEqual((self.drawn / "README.md").read_text(),
                         (GALLERY / "README.md").read_text())

    def test_takes_a_character_from_toml_and_from_a_library(self):
        person = self.folder / "small.toml"
        person.write_text('height_m = 1.5\nmass_kg = 50\nsex = "female"\n')
        self.succeed("author", "--character", person, "--out", self.library)
        small = self.document("info", self.library)
        self.assertEqual(small["mass_kg"], 50)
        self.assertEqual(small["sex"], "female")
        other = self.folder / "other.flinchlib"
        self.succeed("author", "--character", self.library, "--out", other)
        self.assertEqual(self.document("info", other)["hash"], small["hash"])

    def test_refuses_impossible_characters(self):
        person = self.folder / "odd.toml"
        person.write_text("height_m = 1.7\n[proportions]\nlegs = 4\n")
        line = self.fail_with(1, "author", "--character", person, "--out", self.library)
        self.assertIn(f"{person}:3: ", line)
        self.assertFalse(self.library.exists())

    def test_prevents_most_of_the_cost_of_staying_idle(self):
        self.author_default()
        store = self.folder / "a.flinchobs"
        self.succeed("simulate", self.library, "--out", store, "-n", 56)
        document = self.document("compare", store, "--brawn", 0.1)
        row = document["prevention"][0]
        self.assertEqual((row["group"], row["value"]), ("all", "0.50 s or more"))
        with sqlite3.connect(store) as database:
            in_time = [number for (number,) in database.execute(
                "SELECT number FROM observation WHERE time_to_impact_s >= 0.5")]
            idle = database.execute("SELECT clip FROM clip WHERE name = 'idle'").fetchone()[0]
        known = costs(store, document["cost_model"]["vulnerability"],
                      document["cost_model"]["brawn"])
        idle_cost = sum(known[number][idle] for number in in_time)
        least_cost = sum(min(known[number].values()) for number in in_time)
        self.assertEqual(row["scenarios"], len(in_time))
        # Near ties, up to 1 % of the cost, are labelled with the clip of less work.
        self.assertAlmostEqual(row["prevented"], 1 - least_cost / idle_cost, delta=0.005)
        self.assertGreater(row["prevented"], 0.6)


if __name__ == "__main__":
    unittest.main()
