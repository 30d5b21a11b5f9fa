#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""--quiet and --log-level choose what goes to standard error; results are the same."""

import unittest

from flinch_program import ProgramTest, make_library, run


class Log(ProgramTest):
    def setUp(self):
        super().setUp()
        self.library = self.folder / "a.flinchlib"
        make_library(self.library)
        self.store = self.folder / "a.flinchobs"
        self.selector = self.folder / "a.flinch"

    def simulated(self, *options, count=40):
        """Simulates anew; returns what goes to standard error, and the store."""
        self.store.unlink(missing_ok=True)
        done = self.succeed("simulate", self.library, "--out", self.store, "-n", count, "--threads", 1, *options)
        return done.stderr.splitlines(), self.store.read_bytes()

    def test_each_level_leaves_out_the_ones_below(self):
        store = self.simulated()[1]
        for options in ([], ["--log-level", "info"]):
            info, same = self.simulated(*options)
            self.assertEqual(same, store)
            progress = [line for line in info if "left" in line or line.startswith("memory: ")]
            notes = [line for line in info if line.startswith("note: no clip is made")]
            self.assertGreater(len(progress), 1)
            self.assertGreater(len(notes), 1)
            self.assertEqual(set(info), {*progress, *notes})
        self.assertEqual(self.simulated("--log-level", "warning"), (notes, store))
        self.assertEqual(self.simulated("--log-level", "error"), ([], store))
        self.assertEqual(self.simulated("--quiet"), ([], store))

    def test_results_are_the_same_and_hold_no_notes(self):
        self.simulated()
        train = ["train", self.store, "--out", self.selector, "--model", "knn"]
        loud, quiet = self.succeed(*train), self.succeed(*train, "--quiet")
        self.assertEqual(quiet.stdout, loud.stdout)
        self.assertEqual(quiet.stderr, "")
        self.assertIn("note: 40 scenarios are too few to trust the selector", loud.stderr)
        self.assertNotIn("note: ", loud.stdout)

    def test_what_takes_long_says_what_it_does(self):
        self.simulated()
        compare = ["compare", self.store, "--models", "knn", "--curves"]
        self.assertIn("fitting knn\n", self.succeed(*compare).stderr)
        self.assertEqual(self.succeed(*compare, "--log-level", "warning").stderr, "")

    def test_skipped_files_are_warnings_and_errors_always_told(self):
        motion = self.folder / "motion"
        motion.mkdir()
        (motion / "odd\x1b.bvh").write_text("HIERARCHY\n")
        (motion / "other.bvh").write_text("HIERARCHY\n")
        out = self.folder / "out"
        done = self.told_by("import", motion, "--out", out)
        self.assertEqual(len(done), 3)
        self.assertIn("odd\\x1b.bvh", done[0])
        self.assertTrue(done[0].startswith("skipped "))
        self.assertEqual(self.told_by("import", motion, "--out", out, "--quiet"), done[2:])
        self.assertTrue(done[2].startswith("flinch: "))

    def told_by(self, *arguments):
        """The lines on standard error of a command that fails."""
        done = run(*arguments)
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        return done.stderr.splitlines()

    def test_a_file_sets_them_too(self):
        config = self.folder / "quiet.toml"
        config.write_text("[simulate]\nquiet = true\n")
        self.assertEqual(self.simulated("--config", config)[0], [])
        config.write_text('[simulate]\nlog-level = "warning"\n')
        self.assertEqual({line[:6] for line in self.simulated("--config", config)[0]}, {"note: "})

    def test_the_command_line_goes_before_a_file(self):
        config = self.folder / "log.toml"
        config.write_text('[simulate]\nlog-level = "info"\n')
        self.assertEqual(self.simulated("--config", config, "--quiet")[0], [])
        config.write_text("[simulate]\nquiet = true\n")
        told = self.simulated("--config", config, "--log-level", "warning")[0]
        self.assertEqual({line[:6] for line in told}, {"note: "})

    def test_other_levels_are_wrong_usage(self):
        self.assertIn("excludes", self.fail_with(2, "info", self.library, "--quiet", "--log-level",
                                                 "info"))
        self.assertIn("--log-level", self.fail_with(2, "info", self.library, "--log-level", "loud"))


unittest.main()
