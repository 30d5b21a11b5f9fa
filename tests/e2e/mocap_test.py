#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The five commands of the main path with motion capture, if there is any."""

import os
import re
import subprocess
import sys
import unittest

from flinch_program import MOCAP, ProgramTest


class Mocap(ProgramTest):
    def test_from_recorded_motion_to_a_clip(self):
        library, store = self.folder / "real.flinchlib", self.folder / "real.flinchobs"
        selector = self.folder / "real.flinch"
        made = self.document("import", MOCAP, "--manifest", MOCAP / "manifest.toml", "--out", library)
        self.assertGreaterEqual(made["mirrored_count"], 60)
        self.assertEqual(self.document("info", library)["hash"], made["hash"])
        self.succeed("simulate", library, "--out", store, "-n", 16, "--seed", 1)
        self.document("train", store, "--out", selector)
        rows = self.document("compare", store)["rows"]
        self.assertLessEqual({"idle", "knn", "svm", "oracle"}, {row["name"] for row in rows})
        answer = self.document("select", selector, "--azimuth", 40, "--speed", 24, "--target",
                               "head", "--time-to-impact", 0.5)
        names = [clip["name"] for clip in self.document("info", library)["clips"]]
        self.assertIn(answer["clip"], names)

    def test_drafts_agree_with_annotations_made_by_hand(self):
        study = subprocess.run([os.environ["FLINCH_ANNOTATE_STUDY"], MOCAP / "manifest.toml"],
                               capture_output=True, text=True, check=True).stdout
        row, = [line for line in study.splitlines() if line.startswith("| all |")]
        onset, peak, kind = [int(share) for share in re.findall(r"\((\d+) %\)", row)[:3]]
        self.assertGreaterEqual(min(onset, peak, kind), 70, row)
        seconds = float(re.search(r"A take of 35 s at 120 Hz: ([\d.]+) s", study)[1])
        self.assertLess(seconds, 3)

    def test_a_time_range_outside_its_file_is_refused(self):
        text = (MOCAP / "manifest.toml").read_text()
        start = text.index("[[clip]]")
        line_number = text[:start].count("\n") + 1
        clip, _, rest = text[start:].partition("\n\n")
        beyond = re.sub(r"(?m)^(end *=).*$", r"\1 99999.0", clip, count=1)
        self.assertNotEqual(beyond, clip)
        manifest = self.folder / "beyond.toml"
        manifest.write_text(text[:start] + beyond + "\n\n" + rest)
        out = self.folder / "out"
        line = self.fail_with(1, "import", MOCAP, "--manifest", manifest, "--out", out)
        number = int(re.search(r"beyond\.toml:(\d+): ", line)[1])
        self.assertLess(abs(number - line_number), 20)
        self.assertFalse(out.exists())


if __name__ == "__main__":
    if not (MOCAP / "manifest.toml").is_file():
        print(f"skipped: there is no motion capture in {MOCAP}")
        sys.exit(77)
    unittest.main()
