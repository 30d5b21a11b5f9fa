#!/bin/sh
# SPDX-License-Identifier: MIT
# libsvm 3.24 (Debian libsvm-tools 3.24+ds-6): a tie of votes goes to the class that stands first in
# the training file.
#
# Expected: the same training points in another order fit the same classifier.
# Seen: classes are numbered in the order in which the file first names them, and a tie of the
# one-against-one votes goes to the lowest number. With three classes around a middle the three
# machines vote in a circle there, and the answer is whichever class the file begins with.
# Flinch: orders classes by clip before it fits, so a merged or shuffled store fits the same selector.
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
# A pinwheel: at the origin class 2 beats 1, 3 beats 2 and 1 beats 3.
cat >points <<'TEXT'
1 1:1 2:0
1 1:1 2:1
2 1:-0.5 2:0.866
2 1:-1.366 2:0.366
3 1:-0.5 2:-0.866
3 1:0.366 2:-1.366
TEXT
echo '1 1:0 2:0' >middle
seen=
for first in 1 2 3; do
  { grep "^$first" points; grep -v "^$first" points; } >ordered
  usr/bin/svm-train -q -t 0 -c 1000 ordered model
  usr/bin/svm-predict middle model answer >/dev/null
  echo "training file begins with class $first: the middle is of class $(cat answer)"
  seen="$seen$(cat answer)"
done
[ "$seen" = 123 ] || { echo "the behaviour has changed" >&2; exit 1; }
