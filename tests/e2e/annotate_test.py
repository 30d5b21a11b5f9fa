#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""From a raw take to a library: annotate drafts a manifest, import accepts it."""

import unittest
import xml.etree.ElementTree

from flinch_program import ProgramTest

ZXY = "CHANNELS 3 Zrotation Xrotation Yrotation"
# A standing figure in centimetres, Y up, Z forward: joint, its parent, its OFFSET.
JOINTS = [("Hips", None, (0, 0, 0)), ("Spine", "Hips", (0, 12, 0)), ("Chest", "Spine", (0, 15, 0)),
          ("Neck", "Chest", (0, 25, 0)), ("Head", "Neck", (0, 9, 0))]
END_SITES = {"Head": (0, 18, 0)}
for side, sign in (("Left", 1), ("Right", -1)):
    JOINTS += [(side + "Shoulder", "Chest", (sign * 3, 18, 0)),
               (side + "Arm", side + "Shoulder", (sign * 15, 0, 0)),
               (side + "ForeArm", side + "Arm", (sign * 28, 0, 0)),
               (side + "Hand", side + "ForeArm", (sign * 25, 0, 0)),
               (side + "UpLeg", "Hips", (sign * 9, 0, 0)),
               (side + "Leg", side + "UpLeg", (0, -42, 0)),
               (side + "Foot", side + "Leg", (0, -41, 0)),
               (side + "Toe", side + "Foot", (0, -7, 14))]
    END_SITES |= {side + "Hand": (sign * 18, 0, 0), side + "Toe": (0, 0, 6)}


def joint_text(name, offset):
    lines = [("JOINT " if name != "Hips" else "ROOT ") + name, "{",
             "OFFSET {} {} {}".format(*offset)]
    lines.append(ZXY if name != "Hips" else
                 "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation")
    lines += [joint_text(child, at) for child, parent, at in JOINTS if parent == name]
    if name in END_SITES:
        lines.append("End Site {{ OFFSET {} {} {} }}".format(*END_SITES[name]))
    return "\n".join(lines + ["}"])


def depth_first(name="Hips"):
    yield name
    for child, parent, _ in JOINTS:
        if parent == name:
            yield from depth_first(child)


def take(frames, degrees_at):
    """A BVH file at 30 Hz. `degrees_at` gives how far the left arm is raised sideways from below."""
    rows = []
    for frame in range(frames):
        row = ["0 90 0 0 0 0"]
        for joint in list(depth_first())[1:]:
            angle = {"LeftArm": degrees_at(frame / 30) - 90, "RightArm": 90}.get(joint, 0)
            row.append(f"{angle} 0 0")
        rows.append(" ".join(row))
    return (f"HIERARCHY\n{joint_text('Hips', (0, 0, 0))}\nMOTION\nFrames: {frames}\n"
            "Frame Time: 0.0333333\n" + "\n".join(rows) + "\n")


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
