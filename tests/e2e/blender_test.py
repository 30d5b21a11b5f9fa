#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Blender opens what Flinch writes, by scripts/blender_open. Skipped where there is no Blender."""

import json
import os
import pathlib
import shutil
import subprocess
import unittest

from flinch_program import ProgramTest, make_library

SCRIPT = pathlib.Path(os.environ["FLINCH_EXAMPLES"]).parent.parent / "scripts/blender_open"
FRAMES = (0, 10, 20)
READ = f"""
import bpy, json, sys
def read(path):
    bpy.ops.wm.open_mainfile(filepath=path)
    scene = bpy.context.scene
    figure = next(o for o in bpy.data.objects if o.type == 'ARMATURE')
    places = []
    for frame in {FRAMES}:
        scene.frame_set(frame)
        joint = lambda name: list(figure.matrix_world @ figure.pose.bones[name].head)
        places.append([joint(name) for name in ('pelvis', 'head', 'left_hand', 'right_foot')])
    return dict(rate=scene.render.fps / scene.render.fps_base, end=scene.frame_end, places=places)
print('read: ' + json.dumps([read(p) for p in sys.argv[sys.argv.index('--') + 1:]]))
"""


@unittest.skipUnless(shutil.which("blender"), "there is no Blender")
class Blender(ProgramTest):
    def test_opens_both_formats_at_their_rate_and_in_the_same_place(self):
        library = self.folder / "a.flinchlib"
        make_library(library)
        opened = []
        for kind in ("glb", "bvh"):
            clips = self.folder / kind
            self.succeed("export", library, "--clips", clips, "--clip-format", kind)
            clip = sorted(clips.iterdir())[0]
            opened.append(self.folder / f"{kind}.blend")
            done = subprocess.run([SCRIPT, clip, "--save", opened[-1]], capture_output=True,
                                  text=True, check=False)
            if "python3-numpy" in done.stderr:
                self.skipTest("Blender has no numpy")
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        done = subprocess.run(["blender", "-b", "--python-exit-code", "1", "--python-expr", READ,
                               "--", *opened], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        line = next(line for line in done.stdout.splitlines() if line.startswith("read: "))
        glb, bvh = json.loads(line.removeprefix("read: "))
        for found in (glb, bvh):
            self.assertAlmostEqual(found["rate"], 60, places=3)
        self.assertEqual(glb["end"], bvh["end"])
        moved = 0
        for a, b, first in zip(glb["places"], bvh["places"], [glb["places"][0]] * len(FRAMES)):
            for joint, other, start in zip(a, b, first):
                for i in range(3):
                    self.assertAlmostEqual(joint[i], other[i], delta=0.001)
                    moved = max(moved, abs(joint[i] - start[i]))
        self.assertGreater(glb["places"][0][1][2], 1)  # the head is up, in metres
        self.assertGreater(moved, 0.05)

    def test_says_what_it_cannot_open(self):
        for name, words in (("missing.glb", "there is no such file"), (__file__, "neither .glb nor .bvh")):
            done = subprocess.run([SCRIPT, name], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 1)
            self.assertIn(words, done.stderr)


if __name__ == "__main__":
    unittest.main()
