# SPDX-License-Identifier: MIT
"""Answers a ball by the steps of perceiving: python3 steps.py SELECTOR"""

import sys

import flinch

library = flinch.Library(sys.argv[1])
character = flinch.Character(library)
ball = flinch.Threat(position=[9, 1, 1.4], velocity=[-20, -2.2, 2.8])
answer, noticed = character.notice(ball)
for candidate in character.rank(noticed):
    plan = character.plan(noticed, candidate["clip"])
    print(candidate["clip"], candidate["expected_cost_ns"], plan["peak_s"])
character.answer(noticed, candidate["clip"])
print(f"plays the last of them: {library.clips[character.clip]['name']}")
