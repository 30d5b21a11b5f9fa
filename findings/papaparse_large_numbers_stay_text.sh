#!/bin/sh
# SPDX-License-Identifier: MIT
# papaparse 5.7.1 (npm): with dynamicTyping, a number above 2^53 stays text among numbers.
#
# Expected: dynamicTyping makes a number of what is one, as its manual says, and a double holds 1e16
# as well as 1e15. A column of costs is a column of numbers.
# Seen: a value that is not between -2^53 and 2^53 stays a string, and errors is empty. That keeps
# the digits of long ids, but it takes floats as well: 1e16 and -2e20 are text. So the sum of 1, 2,
# 1e16 and 3 is "31e163", and of two such costs the greater is the one whose text is, 9e16 rather
# than 1e17. A leading plus, as C's printf("%+g") writes it, leaves text too.
# Flinch: does not use it. The costs that it writes are far below 2^53.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . papaparse@5.7.1 >/dev/null
cat >costs.mjs <<'JS'
import Papa from 'papaparse';

const table = 'cost\n1\n2\n1e16\n3\n9e16\n1e17\n-2e20\n+4';
const { data, errors } = Papa.parse(table, { header: true, dynamicTyping: true, delimiter: ',' });
const costs = data.map(({ cost }) => cost);
console.log(costs.map((cost) => (typeof cost === 'string' ? `"${cost}"` : cost)).join(' '));
console.log(`${errors.length} errors`);
console.log(`sum of the first four: ${costs.slice(0, 4).reduce((sum, cost) => sum + cost)}`);
console.log(`9e16 > 1e17: ${costs[4] > costs[5]}`);
JS
node costs.mjs | tee seen
printf '%s\n' '1 2 "1e16" 3 "9e16" "1e17" "-2e20" "+4"' '0 errors' 'sum of the first four: 31e163' \
  '9e16 > 1e17: true' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
