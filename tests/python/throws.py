# SPDX-License-Identifier: MIT
"""throws.py SELECTOR: does by the Python package what tests/throws/throws.c does, and prints the same."""

import sys

import numpy

import flinch

THROWS, HITS, FRAMES = 300, 20, 20
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
    pose = character.pose()
    print("pose", *(f"{number:.9g}" for number in (*pose.root_position, *pose.rotation.flat)))


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


main()
