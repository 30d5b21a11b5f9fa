# SPDX-License-Identifier: MIT
"""throws.py SELECTOR LIBRARY: does by the Python package what tests/throws/throws.c does, and prints the same."""

import pathlib
import sys

import numpy

import flinch

THROWS, HITS, WALKS, FRAMES = 300, 20, 30, 20
ANSWERS = {"ok": 0, "misses": 1, "unnoticed": 2, "outside_training": 3}
F = numpy.float32


class Random:
    """The generator of throws.c, in single precision as there."""

    def __init__(self):
        self.state = 1

    def uniform(self, low, high):
        self.state = (self.state * 6364136223846793005 + 1442695040888963407) % 2**64
        return F(low) + (F(high) - F(low)) * F(self.state >> 40) / F(1 << 24)


def ball(random):
    while True:
        x, y = random.uniform(-9, 9), random.uniform(-9, 9)
        if 9 <= x * x + y * y <= 81:
            break
    start = [x, y, random.uniform(0.5, 2)]
    end = [random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), random.uniform(0.3, 1.8)]
    flight_s = random.uniform(0.3, 1.1)
    velocity = [(b - a) / flight_s for a, b in zip(start, end)]
    velocity[2] += F(9.81) * flight_s / F(2)
    return flinch.Threat(start, velocity, random.uniform(0.03, 0.2), random.uniform(0.1, 1))


def play_and_print(character):
    for _ in range(FRAMES):
        character.update(1 / 60)
    print_pose(character.pose())


def print_numbers(numbers):
    print("pose", *(f"{number:.9g}" for number in numbers))


def print_pose(pose):
    print_numbers((*pose.root_position, *pose.rotation.flat))


def answer_by_steps(character, threat):
    hits, noticed = character.notice(threat)
    print("notices", ANSWERS[hits], flinch.TARGETS.index(noticed.target) if noticed else 0)
    if noticed is None:
        return
    best = character.rank(noticed)
    clip = best[0]["clip"]
    print_numbers(character.plan(noticed, clip).values())
    print_pose(character.planned_pose(noticed, clip, 0.3))
    print("answers", ANSWERS[character.answer(noticed, clip, best)], character.clip)
    play_and_print(character)


def walk(file, random):
    library = flinch.Library.take(pathlib.Path(file).read_bytes())
    character = flinch.Character(library)
    character.walk(flinch.MotionGraph(library), 7, 0, 0, 3)
    for _ in range(WALKS):
        threat = ball(random)
        play_and_print(character)
        print("braces", ANSWERS[character.brace(threat)], character.clip)


def main():
    library = flinch.Library(sys.argv[1])
    character = flinch.Character(library, reacting=True)
    random = Random()
    for _ in range(THROWS):
        threat = ball(random)
        character.place(0, 0, 0, 0.5)
        print("perceives", ANSWERS[character.perceive(threat)], character.clip)
        play_and_print(character)
        play_and_print(character)
    for _ in range(HITS):
        threat = ball(random)
        character.place(0, 0, 0, 0.5)
        answer = character.look_ahead([threat], candidates=4)["answer"]
        print("looks ahead", ANSWERS[answer], character.clip)
        character.place(0, 0, 0, 0.5)
        character.react_to(threat)
        play_and_print(character)
        play_and_print(character)
        character.place(0, 0, 0, 0.5)
        answer_by_steps(character, threat)
    walk(sys.argv[2], random)


main()
