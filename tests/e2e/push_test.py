#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A push, from labels to the animation that answers it."""

import json
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

    def test_the_report_has_learning_curves_and_names_the_proxy(self):
        copy, report = self.folder / "c.flinch", self.folder / "report"
        copy.write_bytes(self.selector.read_bytes())
        # A program without the packages of the page says so on stderr.
        trained = json.loads(self.succeed("train-realism", self.labels, "--into", copy, "--report",
                                          report, "--json").stdout)
        document = json.loads((report / "report.json").read_text())
        self.assertTrue(document["is_proxy"])
        self.assertEqual(document["labels"], 150)
        ours = document["rows"][0]
        self.assertEqual([ours["name"], ours["agreement"], ours["auc"]],
                         ["ours", trained["agreement"], trained["auc"]])
        self.assertEqual(document["chance"], trained["chance"])
        self.assertEqual([(row["name"], row["labels"]) for row in document["curve"]],
                         [("ours", 50), ("ours", 100), ("paper", 50), ("paper", 100)])
        lines = (report / "learning_curve.csv").read_text().splitlines()
        self.assertEqual(lines[0], "name,labels,agreement,auc")
        self.assertEqual(len(lines), 5)
        # The selector is the same with and without a report.
        again = self.folder / "d.flinch"
        again.write_bytes(self.selector.read_bytes())
        self.document("train-realism", self.labels, "--into", again)
        self.assertEqual(copy.read_bytes(), again.read_bytes())
        # An earlier report is replaced, a file of another kind is not.
        (report / "report.json").write_bytes(self.selector.read_bytes())
        self.assertIn("--force", self.fail_with(
            1, "train-realism", self.labels, "--into", copy, "--report", report))
        header, *lines = self.labels.read_text().splitlines()
        one = self.folder / "one.flinchlabels"
        sitting = json.loads(lines[0])["sitting"]
        one.write_text("\n".join([header, *(line for line in lines
                                            if json.loads(line)["sitting"] == sitting)]) + "\n")
        self.assertIn("one sitting", self.fail_with(
            1, "train-realism", one, "--into", copy, "--report", self.folder / "none"))
        self.assertFalse((self.folder / "none").exists())

    def test_questions_are_asked_answered_and_merged_once(self):
        questions, labels = self.folder / "questions", self.folder / "b.flinchlabels"
        asked = self.document("label", self.library, "--out", self.labels, "--ask", questions,
                              "--motions", 4)
        self.assertEqual(asked["motions"], 4)
        file = questions / "questions.flinchlabels"
        header, *lines = file.read_text().splitlines()
        for number, line in enumerate(map(json.loads, lines)):
            self.assertIsNone(line["realism"])
            self.assertTrue(0 <= line["estimate"] <= 1)
            self.assertEqual((questions / line["motion"]).read_bytes()[:4], b"glTF")
        self.assertIn("is there already", self.fail_with(
            1, "label", self.library, "--out", labels, "--ask", questions))
        # A script answers all but the last.
        answered = [dict(json.loads(line), judge="Eva", sitting="1", realism=0.25 * k)
                    for k, line in enumerate(lines[:-1])]
        file.write_text("\n".join([header, *map(json.dumps, answered), lines[-1]]) + "\n")
        first = self.document("label", self.library, "--out", labels, "--merge", file)
        self.assertEqual([first[key] for key in ("added", "known", "unanswered")], [3, 0, 1])
        again = self.document("label", self.library, "--out", labels, "--merge", file, self.labels)
        self.assertEqual([again[key] for key in ("added", "known", "unanswered")], [150, 3, 1])
        told = self.fail_with(2, "label", self.library, "--out", labels, "--merge", file,
                              "--proxy", 3)
        self.assertIn("one of", told)

    def test_the_papers_test_is_counted(self):
        header = self.labels.read_text().splitlines()[0].replace("labels", "study")
        # Figure 5 of Arikan et al. 2005, the graduates.
        counts = {"good": (39, 0, 39), "bad": (2, 0, 38), "recording": (12, 0, 11)}
        lines = [json.dumps({"judge": "a", "shown": shown, "answer": answer})
                 for shown, numbers in counts.items()
                 for answer, number in zip(("yes", "unsure", "no"), numbers) for _ in range(number)]
        answers = self.folder / "a.flinchstudy"
        answers.write_text("\n".join([header, *lines]) + "\n")
        study = self.document("label", self.library, "--study", answers)
        self.assertEqual([[row[key] for key in ("yes", "unsure", "no")] for row in study["rows"]],
                         [list(numbers) for numbers in counts.values()])
        self.assertAlmostEqual(study["good_against_recordings"], 0.96, places=2)
        self.assertAlmostEqual(study["agreement"], 0.65, places=2)
        self.assertIn("0.96 times", self.succeed("label", self.library, "--study", answers).stdout)
        self.assertIn("needs --out", self.fail_with(2, "label", self.library))

    def test_bad_input_gets_one_clear_line(self):
        out = self.folder / "push.glb"
        self.assertIn("ends in .glb", self.fail_with(
            1, "push", self.selector, *PUSH, "--out", self.folder / "push.svg"))
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
