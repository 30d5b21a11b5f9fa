#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A library's clips as files for other tools."""

import json
import unittest

from flinch_program import ProgramTest, make_library, shared_folder


def document_of(glb):
    """The JSON of a .glb file."""
    data = glb.read_bytes()
    return json.loads(data[20:20 + int.from_bytes(data[12:16], "little")])


class Clips(ProgramTest):
    def setUp(self):
        super().setUp()
        self.library = shared_folder() / "a.flinchlib"
        if not self.library.exists():
            make_library(self.library)
        self.clips = self.document("info", self.library)["clips"]
        self.out = self.folder / "a/clips"

    def export(self, *arguments):
        return self.document("export", self.library, "--clips", self.out, *arguments)

    def expect_facts(self, animation, clip):
        extras = animation["extras"]
        self.assertEqual(extras["clip"], clip["name"])
        annotation = clip["annotation"] or {}
        self.assertEqual(set(extras), {"clip", *annotation})
        for key, value in annotation.items():
            if isinstance(value, str):
                self.assertEqual(extras[key], value)
            else:
                self.assertAlmostEqual(extras[key], value, places=4)

    def test_one_file_has_an_animation_for_every_clip(self):
        told = self.export()
        self.assertEqual(told, {"kind": "clips", "folder": str(self.out), "files": ["clips.glb"],
                                "clips": len(self.clips)})
        animations = document_of(self.out / "clips.glb")["animations"]
        self.assertEqual(len(animations), len(self.clips))
        self.assertTrue(any(clip["annotation"] for clip in self.clips))
        for animation, clip in zip(animations, self.clips):
            self.assertRegex(animation["name"], "^[a-z0-9_]+$")
            self.expect_facts(animation, clip)
        text = self.succeed("export", self.library, "--clips", self.out).stdout
        self.assertEqual(text, f"{self.out}: {len(self.clips)} clips in 1 file\n")

    def test_or_every_clip_has_a_file(self):
        for kind in ("glb", "bvh"):
            files = self.export("--clip-format", kind)["files"]
            self.assertEqual(len(files), len(self.clips))
            for name, clip in zip(files, self.clips):
                if kind == "glb":
                    [animation] = document_of(self.out / name)["animations"]
                    self.expect_facts(animation, clip)
                else:
                    read = self.document("info", self.out / name)
                    self.assertAlmostEqual(read["duration_s"], clip["duration_s"], delta=0.05)

    def test_replaces_its_own_files_and_no_others(self):
        self.export()
        first = (self.out / "clips.glb").read_bytes()
        self.export()
        self.assertEqual((self.out / "clips.glb").read_bytes(), first)
        (self.out / "clips.glb").write_text("Dear Sir,")
        line = self.fail_with(1, "export", self.library, "--clips", self.out)
        self.assertIn("--force", line)
        self.export("--force")
        self.assertEqual((self.out / "clips.glb").read_bytes(), first)

    def test_wants_a_library_and_one_output(self):
        line = self.fail_with(2, "export", self.library)
        self.assertIn("--clips FOLDER", line)
        self.fail_with(2, "export", self.library, "--clips", self.out, "--out", "a.csv")
        self.fail_with(2, "export", self.library, "--clips", self.out, "--clip-format", "fbx")
        text = self.folder / "a.txt"
        text.write_text("Dear Sir,")
        self.assertIn("not a library", self.fail_with(1, "export", text, "--clips", self.out))
        self.assertFalse(self.out.exists())


if __name__ == "__main__":
    unittest.main()
