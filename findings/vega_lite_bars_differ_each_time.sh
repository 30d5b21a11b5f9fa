#!/bin/sh
# SPDX-License-Identifier: MIT
# vega-lite 6.5.0 and vega 6.4.0 (npm): the confidence bars of the same data and specification end
# elsewhere each time that the chart is drawn.
#
# Expected: a chart is a function of its specification and its data, as all else in Vega-Lite is, so an
# error bar with the extent "ci" has the same ends in the paper, on the page and in the test's picture.
# Seen: the ends are a bootstrap's of 1000 resamples, which Vega draws by Math.random. Of 20 values
# five drawings have five different bars, and where an end is near 0 or near another bar it is on either
# side. A specification has no seed; vega.setRandom(vega.randomLCG(1)) before each drawing ends it, and
# "stderr" and "stdev" are the same each time.
# Flinch: computes its intervals itself from a seed; who charts its tables gives the ends as columns.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --ignore-scripts --prefix . vega@6.4.0 vega-lite@6.5.0 >/dev/null
cat >bars.mjs <<'JS'
import * as vega from 'vega';
import { compile } from 'vega-lite';

const values = Array.from({ length: 20 }, (_, i) => ({ selector: 'kNN', score: (i * 7) % 20 }));
async function bar(extent) {
  const specification = {
    data: { values },
    mark: { type: 'errorbar', extent },
    encoding: { x: { field: 'selector', type: 'nominal' }, y: { field: 'score', type: 'quantitative' } },
  };
  const view = new vega.View(vega.parse(compile(specification).spec), { renderer: 'none' });
  await view.runAsync();
  const [{ lower_score: lower, upper_score: upper }] = view.data('data_0');
  return `${lower} ${upper}`;
}
async function drawings(extent, before) {
  const bars = new Set();
  for (let i = 0; i < 5; ++i) {
    before?.();
    bars.add(await bar(extent));
  }
  return bars.size > 1 ? 'different bars' : 'the same bar';
}
console.log(`stderr: five drawings have ${await drawings('stderr')}`);
console.log(`ci: five drawings have ${await drawings('ci')}`);
const seed = () => vega.setRandom(vega.randomLCG(1));
console.log(`ci after setRandom: five drawings have ${await drawings('ci', seed)}`);
JS
node bars.mjs | tee seen
printf '%s\n' 'stderr: five drawings have the same bar' 'ci: five drawings have different bars' \
  'ci after setRandom: five drawings have the same bar' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
