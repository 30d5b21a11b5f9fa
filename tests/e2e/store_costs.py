# SPDX-License-Identifier: MIT
"""Costs from a store's impulses and work by the formula alone: no code of the program's."""

import sqlite3
import struct

TRIAL = struct.Struct("<Hf17f")  # clip, work, impulse of each body


def costs(store, vulnerability, brawn):
    """{scenario number: {clip: cost}}; vulnerability is {body name: value}."""
    with sqlite3.connect(f"file:{store}?mode=ro", uri=True) as database:
        meta = dict(database.execute("SELECT key, value FROM meta"))
        bodies = [name for (name,) in database.execute("SELECT name FROM body ORDER BY body")]
        v = [vulnerability[name] for name in bodies]
        reference_damage = max(v) * meta["reference_impulse_ns"]
        result = {}
        for number, trials in database.execute("SELECT number, trials FROM observation"):
            result[number] = {}
            for clip, work, *impulse in TRIAL.iter_unpack(trials):
                damage = sum(a * b for a, b in zip(v, impulse))
                result[number][clip] = ((1 - brawn) * damage
                                        + brawn * work * reference_damage / meta["reference_work_j"])
        return result
