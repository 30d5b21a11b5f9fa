# SPDX-License-Identifier: MIT
"""Computes costs from a store's impulses and work by the formula, without the program's code."""

import sqlite3
import struct


def trials_of(blob):
    """Yields each trial's clip, work and {body: impulse}."""
    place, clip = 0, -1
    while place < len(blob):
        head, work = struct.unpack_from("<Hf", blob, place)
        place, clip = place + 6, clip + head // 32
        end = place + 5 * (head % 32)
        yield clip, work, dict(struct.iter_unpack("<Bf", blob[place:end]))
        place = end


def costs(store, vulnerability, brawn):
    """Returns {scenario number: {clip: cost}}; vulnerability is {body name: value}."""
    with sqlite3.connect(f"file:{store}?mode=ro", uri=True) as database:
        meta = dict(database.execute("SELECT key, value FROM meta"))
        bodies = [name for (name,) in database.execute("SELECT name FROM body ORDER BY body")]
        v = [vulnerability[name] for name in bodies]
        reference_damage = [max(v) * (1 + restitution) * mass * speed for restitution, mass, speed in
                            database.execute("SELECT restitution, max_mass_kg, max_speed_mps "
                                             "FROM kind ORDER BY kind")]
        result = {}
        for number, kind, trials in database.execute("SELECT number, kind, trials FROM observation"):
            result[number] = {}
            for clip, work, impulse in trials_of(trials):
                damage = sum(v[body] * i for body, i in sorted(impulse.items()))
                result[number][clip] = ((1 - brawn) * damage
                                        + brawn * work * reference_damage[int(kind)]
                                        / meta["reference_work_j"])
        return result
