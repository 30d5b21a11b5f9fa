#!/bin/sh
# SPDX-License-Identifier: MIT
# Chance 1.1.13 (npm): of several seeds, different ones draw the same numbers.
#
# Expected: new Chance(run, throw) draws numbers of its own for each run and throw, as several seeds
# are there for.
# Seen: numbers are summed with the weights n, n - 1, ... 1 into one seed, so (1, 2), (2, 0), (0, 4) and
# (4) are one. Of 100 runs of 100 throws, 10,000 pairs, 298 draw different numbers. Strings are summed
# likewise, each by a hash: a name and a number, as "run" and 7, keep apart.
# Flinch: does not use it. Who does joins the numbers into one string.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . chance@1.1.13 >/dev/null
cat >seeds.mjs <<'JS'
import Chance from 'chance';

const first = (...seeds) => new Chance(...seeds).integer({ min: 0, max: 1e9 });
const alike = [[2, 0], [0, 4], [4]].every((seeds) => first(...seeds) === first(1, 2));
console.log(`(1, 2), (2, 0), (0, 4) and (4) draw ${alike ? 'the same number' : 'different numbers'}`);
const pairs = Array.from({ length: 1e4 }, (_, i) => [Math.floor(i / 100), i % 100]);
const different = (draw) => new Set(pairs.map(draw)).size;
console.log(`10000 pairs of numbers: ${different(([run, ball]) => first(run, ball))} different draws`);
console.log(`joined to strings: ${different(([run, ball]) => first(`${run},${ball}`)) > 9000 ?
  'more than 9000' : 'fewer than 9000'} different draws`);
JS
node seeds.mjs | tee seen
printf '%s\n' '(1, 2), (2, 0), (0, 4) and (4) draw the same number' \
  '10000 pairs of numbers: 298 different draws' \
  'joined to strings: more than 9000 different draws' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
