#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A game loop in Python: a ball flies at a character, which simulates its best answers before it
chooses one, and the script prints what it does.

Usage: game_loop.py LIBFLINCH SELECTOR

LIBFLINCH is the shared library (libflinch.so), SELECTOR a file that `flinch train` makes. Needs
nothing but Python. Left out: drawing, and what happens when the ball hits.
"""

import ctypes
import sys
from ctypes import POINTER, byref, c_char_p, c_float, c_int32, c_uint32, c_void_p

JOINTS = 21
HEAD = 4
PHASE_PROTECTING = 5


class Sized(ctypes.Structure):
    """A struct of the C interface: begins with its own size."""

    def __init__(self, **values):
        super().__init__(size=ctypes.sizeof(self), **values)


class Threat(Sized):
    _fields_ = [("size", c_uint32), ("position", c_float * 3), ("velocity", c_float * 3),
                ("radius", c_float), ("mass_kg", c_float)]


class Pose(Sized):
    _fields_ = [("size", c_uint32), ("root_position", c_float * 3),
                ("rotation", c_float * 4 * JOINTS)]


class JointFrames(Sized):
    _fields_ = [("size", c_uint32), ("position", c_float * 3 * JOINTS),
                ("orientation", c_float * 4 * JOINTS)]


class CharacterState(Sized):
    _fields_ = [("size", c_uint32), ("phase", c_int32), ("clip", c_int32), ("target", c_int32),
                ("time_to_impact_s", c_float), ("position", c_float * 2), ("facing", c_float)]


class LookAheadOptions(Sized):
    _fields_ = [("size", c_uint32), ("candidates", c_int32), ("budget_us", c_float),
                ("reserved", c_int32), ("now_us", c_void_p), ("clock", c_void_p)]


class Foreseen(ctypes.Structure):
    _fields_ = [("clip", c_int32), ("foreseen", c_int32), ("work_j", c_float),
                ("damage_ns", c_float), ("cost_ns", c_float), ("contact_s", c_float)]


class LookAheadStatus(Sized):
    _fields_ = [("size", c_uint32), ("candidate_count", c_int32), ("tried", c_int32),
                ("encounters", c_int32), ("chosen", c_int32), ("threats", c_int32),
                ("ignored", c_int32), ("is_complete", c_int32), ("candidate", Foreseen * 16)]


class Flinch:
    """The library's functions, which raise ValueError for a status below 0."""

    # Handles are pointers, which ctypes would truncate to an int without these types.
    ARGUMENTS = {
        "flinch_library_load": [c_char_p, POINTER(c_void_p)],
        "flinch_library_joint_frames": [c_void_p, POINTER(Pose), POINTER(JointFrames)],
        "flinch_library_free": [c_void_p],
        "flinch_look_ahead_create": [c_void_p, POINTER(c_void_p)],
        "flinch_look_ahead_free": [c_void_p],
        "flinch_character_create": [c_void_p, POINTER(c_void_p)],
        "flinch_character_free": [c_void_p],
        "flinch_character_look_ahead": [c_void_p, POINTER(Threat), c_int32,
                                        POINTER(LookAheadOptions), c_void_p,
                                        POINTER(LookAheadStatus)],
        "flinch_character_update": [c_void_p, c_float],
        "flinch_character_pose": [c_void_p, POINTER(Pose)],
        "flinch_character_describe": [c_void_p, POINTER(CharacterState)],
    }

    def __init__(self, path: str):
        self.library = ctypes.CDLL(path)
        for name in ("flinch_status_message", "flinch_phase_name", "flinch_foreseen_name"):
            function = getattr(self.library, name)
            function.argtypes, function.restype = [c_int32], c_char_p
        for name, arguments in self.ARGUMENTS.items():
            function = getattr(self.library, name)
            function.argtypes, function.restype, function.errcheck = arguments, c_int32, self.check
        self.phase_name = lambda phase: self.library.flinch_phase_name(phase).decode()
        self.foreseen_name = lambda foreseen: self.library.flinch_foreseen_name(foreseen).decode()
        self.message = lambda status: self.library.flinch_status_message(status).decode()

    def check(self, status, function, _):
        if status < 0:
            raise ValueError(f"{function.__name__}: {self.message(status)}")
        return status

    def __getattr__(self, name):
        return getattr(self.library, "flinch_" + name)


def head_height(flinch, library, character):
    pose, frames = Pose(), JointFrames()
    flinch.character_pose(character, byref(pose))
    flinch.library_joint_frames(library, byref(pose), byref(frames))
    return frames.position[HEAD][2]


def print_why(flinch, found):
    for i, candidate in enumerate(found.candidate[:found.candidate_count]):
        print("->" if i == found.chosen else "  ", f"clip {candidate.clip:3}:",
              f"{flinch.foreseen_name(candidate.foreseen):9}  damage {candidate.damage_ns:6.3f} N s,",
              f"work {candidate.work_j:4.0f} J, cost {candidate.cost_ns:6.3f} N s")


def play(flinch, library, look_ahead, character):
    """Returns whether the character answered the ball and came back to idle."""
    ball = Threat(position=(9, 1, 1.4), velocity=(-20, -2.2, 2.8), radius=0.105, mass_kg=0.27)
    state = CharacterState()
    time_s, phase, answered, thrown = 0.0, 0, False, False
    while time_s < 4:
        if not thrown and time_s >= 0.5:
            thrown = True
            found = LookAheadStatus()
            status = flinch.character_look_ahead(character, byref(ball), 1,
                                                 byref(LookAheadOptions(candidates=8)), look_ahead,
                                                 byref(found))
            print("a ball is thrown:", flinch.message(status))
            print_why(flinch, found)
        dt_s = 1 / 30 if int(time_s * 10) % 3 == 0 else 1 / 90  # uneven, as in games
        flinch.character_update(character, dt_s)
        time_s += dt_s
        flinch.character_describe(character, byref(state))
        if state.phase != phase:
            phase = state.phase
            answered |= phase == PHASE_PROTECTING
            print(f"{time_s:5.2f} s  {flinch.phase_name(phase):10}  clip {state.clip:3}  "
                  f"head at {head_height(flinch, library, character):.2f} m")
    return answered and phase == 0


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    flinch = Flinch(sys.argv[1])
    library, look_ahead, character = c_void_p(), c_void_p(), c_void_p()
    flinch.library_load(sys.argv[2].encode(), byref(library))
    flinch.look_ahead_create(library, byref(look_ahead))
    flinch.character_create(library, byref(character))
    is_right = play(flinch, library, look_ahead, character)
    flinch.character_free(character)
    flinch.look_ahead_free(look_ahead)
    flinch.library_free(library)
    sys.exit(0 if is_right else 1)


if __name__ == "__main__":
    main()
