#!/bin/sh
# SPDX-License-Identifier: MIT
# @tensorflow-models/knn-classifier 1.2.6 (npm, with @tensorflow/tfjs 4.22.0): the nearest neighbours
# are those in the same direction, at whatever distance.
#
# Expected: the nearest of five rows at about (1, 0.5) and of five at about (9, 6) are those of the
# smallest Euclidean distance, as in other packages of that name.
# Seen: every row is divided by its length, and the nearest are those of the largest cosine. A row
# beside the first five gets the class of the others if their direction fits better. Features that are
# a speed and a distance, whose size tells what happens, lose it: twice as fast from twice as far is the
# same row. The interface has no option for it.
# Flinch: searches by Euclidean distance between scaled features.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --ignore-scripts --prefix . @tensorflow/tfjs@4.22.0 \
  @tensorflow-models/knn-classifier@1.2.6 >/dev/null
cat >nearest.mjs <<'JS'
import knn from '@tensorflow-models/knn-classifier';
import * as tf from '@tensorflow/tfjs';

await tf.setBackend('cpu');
const classifier = knn.create();
for (let i = 0; i < 5; ++i) {
  classifier.addExample(tf.tensor1d([1 + 0.01 * i, 0.5]), 'slow ball');
  classifier.addExample(tf.tensor1d([9 + 0.01 * i, 6]), 'fast ball');
}
for (const row of [[1, 0.5], [1.02, 0.66], [9, 6], [9, 4.6]]) {
  const { label } = await classifier.predictClass(tf.tensor1d(row), 3);
  console.log(`${row.join(', ')}: ${label}`);
}
JS
node nearest.mjs 2>/dev/null | tail -n 4 | tee seen
cmp -s - seen <<'TEXT' || {
1, 0.5: slow ball
1.02, 0.66: fast ball
9, 6: fast ball
9, 4.6: slow ball
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
