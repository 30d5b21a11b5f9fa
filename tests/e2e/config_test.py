#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""--config FILE sets a command's options; what is wrong in the file is told with its line."""

import json
import unittest

from flinch_program import ProgramTest, make_library


class Config(ProgramTest):
    def setUp(self):
        super().setUp()
        self.library = self.folder / "a.flinchlib"
        make_library(self.library)
        self.config = self.folder / "experiment.toml"

    def simulated(self, *options):
        """Returns the bytes of a store simulated with these options."""
        store = self.folder / "store"
        store.unlink(missing_ok=True)
        self.succeed("simulate", *options, "--out", store)
        return store.read_bytes()

    def test_a_table_sets_what_the_command_line_leaves_out(self):
        self.config.write_text(f"""[simulate]
LIB = "{self.library}"  # an argument
n = 3
seed = 5

[train]
model = "knn"
""")
        self.assertEqual(self.simulated("--config", self.config),
                         self.simulated(self.library, "-n", 3, "--seed", 5))
        self.assertEqual(self.simulated("--config", self.config, "--seed", 6),
                         self.simulated(self.library, "-n", 3, "--seed", 6))

    def test_lists_and_flags_are_set(self):
        store = self.folder / "store"
        self.succeed("simulate", self.library, "--out", store, "-n", 12)
        self.config.write_text("[compare]\nmodels = [\"knn\", \"svm\"]\njson = true\n")
        from_file = json.loads(self.succeed("compare", store, "--config", self.config).stdout)
        from_options = self.document("compare", store, "--models", "knn,svm")
        self.assertEqual(from_file["rows"], from_options["rows"])

    def test_errors_name_file_and_line(self):
        wrong = {
            "[simulate]\n\nsede = 5\n": (3, 'has the key "sede", which is no option'),
            "[simulate]\nconfig = \"b.toml\"\n": (2, 'has the key "config", which is no option'),
            "[simulate]\nseed = -1\n": (2, "Value -1 is not a whole number"),
            "[simulate]\nseed = [1, 2]\n": (2, "--seed"),
            "[simulate]\nseed = 2020-01-01\n": (2, "needs a string, a number"),
            "[simulate]\nseed = []\n": (2, "needs a string, a number"),
            "seed = 5\n": (1, 'has "seed" outside of a table of a command, such as [simulate]'),
            "[simulat]\nseed = 5\n": (1, 'has "simulat" outside of a table of a command'),
            "[simulate]\nseed 5\n": (2, "not TOML"),
        }
        for text, (line, words) in wrong.items():
            with self.subTest(text=text):
                self.config.write_text(text)
                told = self.fail_with(1, "simulate", self.library, "-n", 3, "--out",
                                      self.folder / "store", "--config", self.config)
                self.assertIn(f"{self.config}:{line}: ", told)
                self.assertIn(words, told)
                self.assertFalse((self.folder / "store").exists())

    def test_a_file_without_the_commands_table_is_refused(self):
        self.config.write_text("[train]\nmodel = \"knn\"\n")
        told = self.fail_with(1, "simulate", self.library, "--config", self.config)
        self.assertIn(f"{self.config}: has no table [simulate]", told)


if __name__ == "__main__":
    unittest.main()
