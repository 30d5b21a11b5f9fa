#!/bin/sh
# SPDX-License-Identifier: MIT
# vega-loader 5.1.3 (npm, the reader of Vega and Vega-Lite): with parse "auto", a column of names
# such as "walk 1" becomes dates, and different names become the same one.
#
# Expected: "auto" finds out which columns of a .csv are numbers or dates, and leaves names alone.
# Seen: a date is what JavaScript's Date.parse takes, and in V8 that is also a word with a month's
# or a year's number behind it: "walk 1" is the first of January 2001, "run 1" too, and "fall 40" is
# in the year 2040. Bars for each clip are then bars for each month, and the means of "walk 1" and
# "run 1" are one. One name in the column that V8 does not take, "walk 13", and all of them stay
# names. The predecessor has an open issue about it (vega/datalib 95); Vega's documentation of
# "auto" does not speak of it.
# Flinch: its tables hold clips' names as they are, and its own charts are not by Vega. Who charts a
# table by Vega says parse: {"clip": "string"}.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . vega-loader@5.1.3 >/dev/null
cat >names.mjs <<'JS'
import { read } from 'vega-loader';

for (const clips of [['walk 1', 'walk 2', 'run 1'], ['walk 1', 'walk 2', 'walk 13']]) {
  const table = 'clip,score\n' + clips.map((clip, score) => `${clip},${score}\n`).join('');
  const read_as = read(table, { type: 'csv', parse: 'auto' }).map(({ clip }) =>
      typeof clip === 'string' ? clip : new Date(clip).toDateString());
  console.log(`${clips.join(', ')}: ${read_as.join(', ')}`);
}
JS
TZ=UTC node names.mjs | tee seen
printf '%s\n' 'walk 1, walk 2, run 1: Mon Jan 01 2001, Thu Feb 01 2001, Mon Jan 01 2001' \
  'walk 1, walk 2, walk 13: walk 1, walk 2, walk 13' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
