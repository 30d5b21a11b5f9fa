#!/bin/sh
# SPDX-License-Identifier: MIT
# cubic-spline 3.0.3 (npm): before its first key a spline goes on, after its last it is not a number, and
# keys in another order make another curve.
#
# Expected: outside its keys a spline does the same at both ends, and a set of keys is one curve in whatever
# order it is given, or the order is refused.
# Seen: one second before the first key there is a number, one second after the last NaN. The keys 0, 1, 0
# and 1 at 0 to 3 s, given from the last to the first, make a curve that is 14 at 0 s and NaN at 3 s.
# Flinch: holds the first and the last key, and its keys are in the order of time.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . cubic-spline@3.0.3 >/dev/null
cat >ends.mjs <<'JS'
import Spline from 'cubic-spline';

const curves = {
  'in order': new Spline([0, 1, 2, 3], [0, 1, 0, 1]),
  'from the last': new Spline([3, 2, 1, 0], [1, 0, 1, 0]),
};
for (const [name, curve] of Object.entries(curves))
  console.log(`${name}: ${[-1, 0, 1, 3, 4].map((s) => `${curve.at(s).toFixed(2)} at ${s} s`).join(', ')}`);
JS
node ends.mjs | tee seen
printf '%s\n' 'in order: -1.00 at -1 s, 0.00 at 0 s, 1.00 at 1 s, 1.00 at 3 s, NaN at 4 s' \
  'from the last: 37.00 at -1 s, 14.00 at 0 s, 3.00 at 1 s, NaN at 3 s, NaN at 4 s' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
