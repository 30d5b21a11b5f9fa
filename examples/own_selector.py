#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Fits a selector written in this script and compares it with Flinch's: for researchers.

Usage: own_selector.py FLINCH STORE CHART.svg

FLINCH is the program, STORE a file that `flinch simulate` made. Three steps, with Python's
standard library alone:

1. Load: `flinch export` writes the scenarios as CSV, with their features and what each clip cost.
2. Fit: the selector remembers the scenarios that it may learn from. For a new one it takes the
   mean cost of each clip over the nearest of them, weighted by 1 / distance, and chooses the
   cheapest clip.
3. Compare: mean cost and protection on the scenarios that `flinch compare` tests on (every fourth),
   beside the rows of `flinch compare`, as a table and as a chart. Protection is 0 for a character
   that stands still and 1 for the oracle, which simulates every clip.

To try another idea, replace the class Selector. What this example leaves out: choosing the number of
neighbours by cross-validation, and a confidence interval for its own row (`flinch compare` bootstraps
those of its rows).
"""

import csv
import json
import subprocess
import sys
import tempfile
from pathlib import Path

NEIGHBOURS = 20


class Scenario:
    """A row of the exported CSV: its number, features, and the cost of every clip tried on it."""

    def __init__(self, row, feature_names):
        self.number = int(row["number"])
        self.label_cost_ns = float(row["cost_ns"])  # of the clip that the oracle chooses
        self.features = [float(row[name]) for name in feature_names]
        self.cost_ns = {name.removeprefix("cost_ns_"): float(value) for name, value in row.items()
                        if name.startswith("cost_ns_") and value}


class Selector:
    """Expects each clip to cost what it cost on average in the nearest scenarios."""

    def __init__(self, scenarios):
        self.scenarios = scenarios
        columns = list(zip(*(s.features for s in scenarios)))
        self.low = [min(column) for column in columns]
        self.width = [max(max(column) - min(column), 1e-9) for column in columns]
        self.scaled = [self.scale(s.features) for s in scenarios]

    def scale(self, features):
        return [(x - low) / width for x, low, width in zip(features, self.low, self.width)]

    def choose(self, scenario):
        x = self.scale(scenario.features)
        distances = [sum((a - b) ** 2 for a, b in zip(x, y)) ** 0.5 for y in self.scaled]
        nearest = sorted(range(len(distances)), key=distances.__getitem__)[:NEIGHBOURS]
        expected_ns = {}
        for clip in scenario.cost_ns:  # the clips that may answer this scenario
            known = [(1 / (distances[i] + 1e-3), self.scenarios[i].cost_ns[clip])
                     for i in nearest if clip in self.scenarios[i].cost_ns]
            if known:
                expected_ns[clip] = sum(w * c for w, c in known) / sum(w for w, _ in known)
        return min(expected_ns, key=expected_ns.get)


def load(flinch, store):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "scenarios.csv"
        subprocess.run([flinch, "export", store, "--out", path], check=True, capture_output=True)
        with path.open(newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
    names = list(rows[0])
    feature_names = names[names.index("target") + 1:names.index("label")]
    return [Scenario(row, feature_names) for row in rows]


def compared(flinch, store):
    """The rows of `flinch compare`: {name: (mean cost, protection)}."""
    run = subprocess.run([flinch, "compare", store, "--models", "knn", "knn_cost", "--json"],
                         check=True, capture_output=True, text=True)
    return {row["name"]: (row["mean_cost"], row["protection"])
            for row in json.loads(run.stdout)["rows"]}


def chart(rows):
    """Protection as horizontal bars, SVG."""
    bars = []
    for i, (name, (_, protection)) in enumerate(rows.items()):
        y, length = 20 + 26 * i, 300 * max(protection, 0)
        bars.append(f'<text x="170" y="{y + 13}" text-anchor="end">{name}</text>'
                    f'<rect x="180" y="{y}" width="{length:.1f}" height="18" fill="#2b4c7e"/>'
                    f'<text x="{188 + length:.1f}" y="{y + 13}">{protection:.3f}</text>')
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 560 {40 + 26 * len(rows)}" '
            f'font-family="sans-serif" font-size="13"><title>Protection by selector</title>'
            f'<rect width="100%" height="100%" fill="#fff"/>{"".join(bars)}</svg>\n')


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    flinch, store, chart_path = sys.argv[1:]
    scenarios = load(flinch, store)
    tested = [s for s in scenarios if s.number % 4 == 3]
    selector = Selector([s for s in scenarios if s.number % 4 != 3])
    rows = compared(flinch, store)
    idle_ns, oracle_ns = rows["idle"][0], rows["oracle"][0]

    # Equal mean costs of the oracle show that flinch compare uses the same scenarios and costs.
    label_ns = sum(s.label_cost_ns for s in tested) / len(tested)
    if abs(label_ns - oracle_ns) > 1e-9:
        sys.exit(f"the oracle costs {label_ns} N s here and {oracle_ns} N s in flinch compare")

    own_ns = sum(s.cost_ns[selector.choose(s)] for s in tested) / len(tested)
    rows["own"] = (own_ns, (idle_ns - own_ns) / (idle_ns - oracle_ns))
    for name, (cost_ns, protection) in sorted(rows.items(), key=lambda row: row[1][1]):
        print(f"{name:20} mean cost {cost_ns:6.3f} N s   protection {protection:6.3f}")
    ordered = dict(sorted(rows.items(), key=lambda row: row[1][1]))
    Path(chart_path).write_text(chart(ordered), encoding="utf-8")


if __name__ == "__main__":
    main()
