#!/bin/sh
# SPDX-License-Identifier: MIT
# regression 2.0.1 (npm): a line of slope 0.0012 becomes a constant.
#
# Expected: the manual says that the option precision, by default 2, is the number of significant figures
# to which the output is rounded, so a slope of 0.00123 comes out as 0.0012, and the line fits.
# Seen: it is the number of decimals, so the slope is 0. It is rounded before the intercept is computed
# and before points are predicted, so the line through the origin becomes 11.7 everywhere, with an r2 of
# 0. The same points in other units fit well: with x in thousands the slope is 1.23.
# An exponent and the factors of a polynomial go the same way. precision: 10 keeps them.
# Flinch: does not use it.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . regression@2.0.1 >/dev/null
cat >line.mjs <<'JS'
import regression from 'regression';

const points = Array.from({ length: 20 }, (_, i) => [1000 * i, 0.00123 * 1000 * i]);
const thousands = points.map(([x, y]) => [x / 1000, y]);
const tell = (name, { equation: [slope, intercept], r2 }) =>
    console.log(`${name}: ${slope} x + ${intercept}, r2 = ${Math.abs(r2).toFixed(1)}`);
tell('as it is', regression.linear(points));
tell('x in thousands', regression.linear(thousands));
tell('precision 10', regression.linear(points, { precision: 10 }));
JS
node line.mjs | tee seen
printf '%s\n' 'as it is: 0 x + 11.68, r2 = 0.0' 'x in thousands: 1.23 x + 0, r2 = 1.0' \
  'precision 10: 0.00123 x + 0, r2 = 1.0' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
