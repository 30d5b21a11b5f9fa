#!/bin/sh
# SPDX-License-Identifier: MIT
# simple-statistics 7.12.1 (npm): the normal distribution is a table of 310 steps that ends at 0.999.
#
# Expected: cumulativeStdNormalProbability(z) is the distribution function to many digits, and
# probit its inverse.
# Seen: z is rounded to two digits and looked up in a printed table of four digits, whose last entry
# is for 3.09. So no two-sided p value is below 0.002, and a hundred clips tested at once by
# Bonferroni's 0.0005 are never significant: at z = 5 the p value is 3500 times too large. probit is of
# another formula with an error of 0.003 to 0.01, so the two do not undo each other and a 99 %
# interval is too narrow. jStat 1.9.6 is right.
# Flinch: its intervals are by bootstrap.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . simple-statistics@7.12.1 jstat@1.9.6 >/dev/null
cat >normal.mjs <<'JS'
import jstat from 'jstat';
import { cumulativeStdNormalProbability, probit } from 'simple-statistics';

for (const z of [2.5758, 3.5, 5]) {
  const [table, exact] = [cumulativeStdNormalProbability(z), jstat.normal.cdf(z, 0, 1)];
  console.log(`z = ${z}: two-sided p ${(2 * (1 - table)).toPrecision(2)}, ` +
      `jStat ${(2 * (1 - exact)).toPrecision(2)}`);
}
console.log(`z of 0.995: probit ${probit(0.995).toFixed(4)}, ` +
    `jStat ${jstat.normal.inv(0.995, 0, 1).toFixed(4)}`);
JS
node normal.mjs | tee seen
printf '%s\n' 'z = 2.5758: two-sided p 0.0098, jStat 0.010' 'z = 3.5: two-sided p 0.0020, jStat 0.00047' \
  'z = 5: two-sided p 0.0020, jStat 5.7e-7' 'z of 0.995: probit 2.5692, jStat 2.5758' |
  cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
