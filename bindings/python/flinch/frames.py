# SPDX-License-Identifier: MIT
"""Stores and comparisons as frames of pandas."""

from __future__ import annotations

from typing import Any

import numpy
import pandas

from ._flinch import BODIES, TARGETS, Store


def scenarios(store: Store, brawn: float | None = None,
              vulnerability: str | None = None) -> pandas.DataFrame:
    """A row per scenario: its number, target and features, the best clip, and its cost and that of
    standing idle, N s. Columns and numbers are those of `flinch export STORE --out FILE.csv`,
    without the costs of all clips."""
    label, cost = store.label(**_given(brawn=brawn, vulnerability=vulnerability))
    names = numpy.array(store.clips)
    row = numpy.arange(len(store))
    frame = pandas.DataFrame({"number": store.number, "target": numpy.array(TARGETS)[store.target]})
    frame[store.feature_names] = store.features
    frame["label"] = label
    frame["clip"] = names[label]
    frame["cost_ns"] = cost[row, label]
    frame["idle_cost_ns"] = cost[:, store.idle]
    return frame


def trials(store: Store, brawn: float | None = None,
           vulnerability: str | None = None) -> pandas.DataFrame:
    """A row per clip that was tried on a scenario: number, clip, work, J, cost, N s, and the impulse
    on each body, N s."""
    _, cost = store.label(**_given(brawn=brawn, vulnerability=vulnerability))
    row, clip = numpy.nonzero(~numpy.isnan(store.work_j))
    frame = pandas.DataFrame({"number": store.number[row], "clip": numpy.array(store.clips)[clip],
                              "work_j": store.work_j[row, clip], "cost_ns": cost[row, clip]})
    impulses = pandas.DataFrame(store.impulse_ns[row, clip],
                                columns=[f"{body}_impulse_ns" for body in BODIES])
    return pandas.concat([frame, impulses], axis="columns")


def rows(comparison: dict[str, Any]) -> pandas.DataFrame:
    """The rows of a comparison, by name; an interval is two columns, `..._low` and `..._high`."""
    return pandas.DataFrame([_flat(row) for row in comparison["rows"]]).set_index("name")


def _given(**options: Any) -> dict[str, Any]:
    return {name: value for name, value in options.items() if value is not None}


def _flat(row: dict[str, Any]) -> dict[str, Any]:
    flat: dict[str, Any] = {}
    for key, value in row.items():
        if isinstance(value, list):
            flat[f"{key}_low"], flat[f"{key}_high"] = value
        else:
            flat[key] = value
    return flat
