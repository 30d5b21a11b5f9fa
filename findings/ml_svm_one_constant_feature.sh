#!/bin/sh
# SPDX-License-Identifier: MIT
# ml-svm 2.1.2 (npm): one feature that is the same in all training rows makes every answer -1.
#
# Expected: a constant feature tells nothing and changes nothing, as in libsvm, where scaling leaves it
# out; or the fit refuses it.
# Seen: the machine scales each feature by its range, unless whitening is false. The range is 0, so all of
# the feature is NaN, no comparison of the fit holds, and it ends at once, without an error: no
# support vectors, and the answer -1 to every row, also to those of the other class. A character's own
# height is such a feature while there is one character. margin() of one row, which its
# documentation allows, is a list of NaN in every machine; margin([row]) is the number.
# Flinch: scales its features by their ranges, too, and makes a constant one 0.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . ml-svm@2.1.2 >/dev/null
cat >duck.cjs <<'JS'
const SVM = require('ml-svm');

let state = 1;
const random = () => (state = (state * 16807) % 2147483647) / 2147483647;
const heights = Array.from({ length: 40 }, (_, i) => (i % 2) * 2 + random());
const answers = heights.map((_, i) => (i % 2 ? 1 : -1));

function tell(name, rows, options) {
  const machine = new SVM({ random, ...options });
  machine.train(rows, answers);
  const right = machine.predict(rows).filter((answer, i) => answer === answers[i]).length;
  console.log(`${name}: ${right} of 40 right, ${machine.supportVectors().length} support vectors`);
  return machine;
}

const machine = tell('height of the blow', heights.map((height) => [height]));
tell('and a constant, linear', heights.map((height) => [height, 1.8]));
tell('and a constant, rbf', heights.map((height) => [height, 1.8]), { kernel: 'rbf' });
tell('and a constant, not whitened', heights.map((height) => [height, 1.8]), { whitening: false });
console.log('margin of one row:', machine.margin([heights[1]]), '; of a list of one:',
    machine.margin([[heights[1]]]).map((x) => x > 0));
JS
node duck.cjs | tee seen
cmp -s - seen <<'TEXT' || {
height of the blow: 40 of 40 right, 18 support vectors
and a constant, linear: 20 of 40 right, 0 support vectors
and a constant, rbf: 20 of 40 right, 0 support vectors
and a constant, not whitened: 40 of 40 right, 4 support vectors
margin of one row: [ NaN ] ; of a list of one: [ true ]
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
