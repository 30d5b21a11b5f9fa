#!/bin/sh
# SPDX-License-Identifier: MIT
# libsvm 3.24 (Debian libsvm-tools 3.24+ds-6): with -b 1, svm-predict gives other classes for the same
# model.
#
# Expected: -b 1 prints probabilities beside the answers, and the answers stay those of the machine
# that was fitted.
# Seen: the answer becomes the class of the greatest probability. The probabilities are fitted by
# sigmoids to decision values of a cross-validation, and coupled over pairs, so they need not
# agree with the votes. For 3 of 60 training points the class changes, and so does the accuracy that
# is printed.
# Flinch: trains without probabilities and answers by votes.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libsvm-tools libsvm3; do
  apt-get -o APT::Sandbox::User=root download -q "$package=3.24+ds-6" >/dev/null
  dpkg-deb -x "$package"_3.24+ds-6_*.deb .
done
LD_LIBRARY_PATH=$(dirname "$(find . -name 'libsvm.so*' | head -n 1)")
export LD_LIBRARY_PATH
# Three classes that overlap, 20 points of each.
python3 - >points <<'PY'
import random

draw = random.Random(3)
for i in range(60):
    x, y = draw.gauss(0, 1), draw.gauss(0, 1)
    middle = ((0, 0), (1.2, 0.2), (0.4, 1.2))[i % 3]
    print(f"{i % 3 + 1} 1:{x + middle[0]:.3f} 2:{y + middle[1]:.3f}")
PY
usr/bin/svm-train -q -b 1 points model
usr/bin/svm-predict points model votes >/dev/null 2>&1
usr/bin/svm-predict -b 1 points model probabilities >/dev/null
differ=$(tail -n +2 probabilities | cut -d ' ' -f 1 | paste -d ' ' votes - | awk '$1 != $2' | wc -l)
echo "of 60 points $differ are of another class with -b 1"
[ "$differ" -gt 0 ] || { echo "the behaviour has changed" >&2; exit 1; }
