#!/bin/sh
# SPDX-License-Identifier: MIT
# pure-rand 8.4.2, d3-random 3.0.2 and vega-statistics 2.0.0 (npm): the first draws of the seeds 1, 2, 3
# and so on count down or stay the same.
#
# Expected: a generator of its own for each run, seeded by the run's number, draws unrelated numbers
# from the first one on.
# Seen: the first digit that pure-rand's xoroshiro128plus draws, the generator of its README, is 6, 5,
# 4, 3, 2, 1, 0, 9, ... for the seeds 1, 2, 3, ...: its state is the seed and constants, and its first
# outputs sum them before anything is mixed. Its mersenne is right. randomLcg of d3-random draws
# about 0.24 first for each of twelve seeds, and vega's randomLCG draws a half and nothing in turns. So
# runs that draw one number each, such as which clip or which side, are alike.
# Flinch: does not use them. Who does draws some numbers first, or hashes the run's number.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . pure-rand@8.4.2 d3-random@3.0.2 \
  vega-statistics@2.0.0 >/dev/null
cat >draws.mjs <<'JS'
import { randomLcg } from 'd3-random';
import { uniformInt } from 'pure-rand/distribution/uniformInt';
import { mersenne } from 'pure-rand/generator/mersenne';
import { xoroshiro128plus } from 'pure-rand/generator/xoroshiro128plus';
import { randomLCG } from 'vega-statistics';

const digits = {
  'pure-rand, xoroshiro128plus': (seed) => uniformInt(xoroshiro128plus(seed), 0, 9),
  'pure-rand, mersenne': (seed) => uniformInt(mersenne(seed), 0, 9),
  'd3-random, randomLcg': (seed) => Math.floor(10 * randomLcg(seed)()),
  'vega-statistics, randomLCG': (seed) => Math.floor(10 * randomLCG(seed)()),
};
for (const [name, digit] of Object.entries(digits)) {
  console.log(`${name}: ${Array.from({ length: 12 }, (_, i) => digit(i + 1)).join(' ')}`);
}
JS
node draws.mjs | tee seen
printf '%s\n' 'pure-rand, xoroshiro128plus: 6 5 4 3 2 1 0 9 8 7 6 5' \
  'pure-rand, mersenne: 3 6 8 2 9 2 3 5 8 9 9 1' 'd3-random, randomLcg: 2 2 2 2 2 2 2 2 2 2 2 2' \
  'vega-statistics, randomLCG: 5 0 5 0 5 0 5 1 6 1 6 1' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
