#!/bin/sh
# SPDX-License-Identifier: MIT
# static-kdtree 1.0.2 (npm): knn and nn take their largest distance squared, rnn does not.
#
# Expected: with a largest distance of 0.3, knn gives the nearest points within 0.3, "within distance <
# maxDistance", which are those that rnn visits with a radius of 0.3.
# Seen: it gives all within 0.55, the root of 0.3, so nearly twice as many as there are along a line; of
# distances above 1 it leaves near ones out: with 2, nn finds nothing where a point is 1.5 off. rnn is
# right. So a limit for "nothing like this was ever seen" lets through what it should stop, or the reverse.
# Flinch: searches by FLANN.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . static-kdtree@1.0.2 >/dev/null
cat >within.cjs <<'JS'
const createTree = require('static-kdtree');

const points = Array.from({ length: 401 }, (_, i) => [i / 100]);
const tree = createTree(points);
for (const distance of [0.3, 2, 3]) {
  const places = tree.knn([0], 401, distance).map((i) => points[i][0]);
  let visited = 0;
  tree.rnn([0], distance, (i) => void (visited = Math.max(visited, points[i][0])));
  console.log(`within ${distance}: knn up to ${Math.max(...places)}, rnn up to ${visited}, ` +
      `nn from 1.5 off ${tree.nn([-1.5], distance) < 0 ? 'finds none' : 'finds one'}`);
}
JS
node within.cjs | tee seen
cmp -s - seen <<'TEXT' || {
within 0.3: knn up to 0.54, rnn up to 0.3, nn from 1.5 off finds none
within 2: knn up to 1.41, rnn up to 2, nn from 1.5 off finds none
within 3: knn up to 1.73, rnn up to 3, nn from 1.5 off finds one
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
