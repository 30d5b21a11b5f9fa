#!/bin/sh
# SPDX-License-Identifier: MIT
# jStat 1.9.6 (npm jstat): the z-test of a sample does not look at the sample's size, and the quartiles
# of 1 to 7 are 2, 4 and 5.
#
# Expected: ztest(value, sample, 2) asks whether the sample's mean is the value, as ttest(value, sample, 2)
# does and as the interval of normalci() around the mean does; with more rows it is surer. Quartiles
# of mirrored numbers are the mirrored quartiles.
# Seen: ztest asks whether one row could be the value. Of 400 success rates around 0.500 it says p = 0.62
# of 0.450, as it does of 40 such rates, where ttest says 0.00 and the 95 % interval begins at 0.490. The
# quartiles of -7 to -1 are -6, -4 and -3: in both rows the lower one is 2 from the median, the upper one 1.
# Flinch: has no such tests; its intervals are by bootstrap, and its percentiles interpolate.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . jstat@1.9.6 >/dev/null
cat >tests.cjs <<'JS'
const { jStat } = require('jstat');

for (const n of [40, 400]) {
  const rates = Array.from({ length: n }, (_, i) => 0.5 + (i % 2 ? 0.1 : -0.1));
  const [z, t] = [jStat.ztest(0.45, rates, 2), jStat.ttest(0.45, rates, 2)];
  const [low] = jStat.normalci(jStat.mean(rates), 0.05, rates);
  console.log(`${n} rows: p by z ${z.toFixed(2)}, by t ${t.toFixed(2)}; 95 % from ${low.toFixed(3)}`);
}
console.log(`quartiles of 1 to 7: ${jStat.quartiles([1, 2, 3, 4, 5, 6, 7]).join(' ')}`);
console.log(`quartiles of -7 to -1: ${jStat.quartiles([-7, -6, -5, -4, -3, -2, -1]).join(' ')}`);
JS
node tests.cjs | tee seen
printf '%s\n' '40 rows: p by z 0.62, by t 0.00; 95 % from 0.469' \
  '400 rows: p by z 0.62, by t 0.00; 95 % from 0.490' 'quartiles of 1 to 7: 2 4 5' \
  'quartiles of -7 to -1: -6 -4 -3' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
