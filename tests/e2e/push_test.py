#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A push, from labels to the animation that answers it."""

import pathlib
import tempfile
import unittest

from flinch_program import ProgramTest, make_library

PUSH = ["--at", "left_shoulder", "--from", 180, "--speed", 1.2]


class Push(ProgramTest):
    @classmethod
    def setUpClass(cls):
        cls.made = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.made.cleanup)
        folder = pathlib.Path(cls.made.name)
        cls.library, cls.store = folder / "a.flinchlib", folder / "a.flinchobs"
        cls.labels = folder / "a.flinchlabels"
        cls.plain, cls.selector = folder / "plain.flinch", folder / "a.flinch"
        maker = ProgramTest("document")
        make_library(cls.library, "pushes")
        maker.succeed("simulate", cls.library, "--out", cls.store, "-n", 12)
        for selector in (cls.plain, cls.selector):
            maker.succeed("train", cls.store, "--out", selector, "--model", "knn")
        cls.judged = maker.document("label", cls.library, "--out", cls.labels, "--proxy", 150)
        cls.trained = maker.document("train-realism", cls.labels, "--into", cls.selector)

    def test_info_tells_the_pushes_of_a_library(self):
        clips = self.document("info", self.library)["clips"]
        pushes = {clip["name"]: clip["push"] for clip in clips if "push" in clip}
        self.assertEqual(len(pushes), 6)
        self.assertEqual(pushes["from_left"]["place"], "chest")
        self.assertAlmostEqual(pushes["from_left"]["direction_degrees"], 90, places=1)
        self.assertAlmostEqual(pushes["from_left_mirrored"]["direction_degrees"], -90, places=1)
        self.assertIn("m/s", self.succeed("info", self.library).stdout)

    def test_every_report_names_the_proxy(self):
        for document in (self.judged, self.trained):
            self.assertIn("proxy", document["judge"])
        self.assertEqual(self.trained["labels"], 150)
        self.assertEqual(self.trained["sittings"], 10)
        self.assertTrue(0 <= self.trained["agreement"] <= 1)

    def test_a_push_is_answered_and_reaches_the_asked_speed(self):
        out = self.folder / "push.glb"
        played = self.document("push", self.selector, *PUSH, "--out", out)
        self.assertEqual(out.read_bytes()[:4], b"glTF")
        self.assertGreater(played["candidates"][0]["realism"], 0.5)
        self.assertAlmostEqual(played["reached_mps"], 1.2, delta=0.2)
        again = self.document("push", self.selector, *PUSH, "--out", out, "--repeat", 0.4)
        self.assertGreater(again["duration_s"], played["duration_s"])
        self.assertIn("proxy", self.succeed("push", self.selector, *PUSH, "--out", out).stdout)

    def test_the_papers_model_is_fitted_too(self):
        copy = self.folder / "b.flinch"
        copy.write_bytes(self.selector.read_bytes())
        trained = self.document("train-realism", self.labels, "--into", copy, "--realism", "paper")
        self.assertNotEqual(copy.read_bytes(), self.selector.read_bytes())
        self.assertGreater(trained["auc"], 0)

    def test_bad_input_gets_one_clear_line(self):
        out = self.folder / "push.glb"
        self.assertIn("train-realism", self.fail_with(1, "push", self.plain, *PUSH, "--out", out))
        told = self.fail_with(1, "push", self.selector, "--from", 45, "--speed", 15, "--out", out)
        self.assertIn("no response to the push would look real", told)
        self.fail_with(2, "push", self.selector, "--at", "left_foot", "--out", out)
        self.fail_with(2, "push", self.selector, "--speed", 0, "--out", out)
        other = self.folder / "other.flinchlib"
        make_library(other)
        self.assertIn("no clip with a push",
                      self.fail_with(1, "label", other, "--out", self.folder / "b.flinchlabels"))
        cut = self.folder / "cut.flinchlabels"
        cut.write_text(self.labels.read_text()[:-7])
        self.assertIn("is cut short", self.fail_with(1, "train-realism", cut, "--into",
                                                     self.selector))
        few = self.folder / "few.flinchlabels"
        few.write_text("".join(self.labels.read_text().splitlines(True)[:5]))
        self.assertIn("4 labels", self.fail_with(1, "train-realism", few, "--into", self.selector))
        self.assertFalse(out.exists())


if __name__ == "__main__":
    unittest.main()
