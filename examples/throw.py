#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Throws one ball at a character: throw.py SELECTOR, with the Python package."""

import sys

import flinch

library = flinch.Library(sys.argv[1])
character = flinch.Character(library)
ball = flinch.Threat(position=[9, 1, 1.4], velocity=[-20, -2.2, 2.8])
print(character.perceive(ball), library.clips[character.clip]["name"])
for frame in range(60):
    character.update(1 / 60)
    positions, orientations = library.joint_frames(character.pose())
    print(character.phase, f"{positions[flinch.JOINTS.index('head'), 2]:.2f} m")
