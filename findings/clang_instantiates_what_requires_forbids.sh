#!/bin/sh
# SPDX-License-Identifier: MIT
# Clang 14.0.6 (Debian clang-14 1:14.0.6-12): an explicit instantiation of a class template also
# instantiates members whose requires-clause is false.
#
# Expected: `template struct Sum<Opaque>;` instantiates the members whose constraints Opaque meets, as
# C++20 says ([temp.explicit]), and as GCC 12 does.
# Seen: Clang 14 instantiates all of them, so the body of a member that Opaque is not to have is
# compiled and refused. A class that is only used, without explicit instantiation, compiles.
# Flinch: the tests compile the public headers with both compilers.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
[ "$(dpkg-query -W -f '${Version}' clang-14 2>/dev/null || true)" = 1:14.0.6-12 ] ||
  apt-get install -q -y --no-install-recommends clang-14=1:14.0.6-12 >/dev/null
cat >sum.cpp <<'CPP'
template <class T>
concept Addable = requires(T t) { t + t; };

template <class T>
struct Sum {
  T value;
  T twice() const requires Addable<T> { return value + value; }
};
struct Opaque {};

#ifdef EXPLICIT
template struct Sum<Opaque>;
#else
Sum<Opaque> sum;
#endif
CPP
for compiler in g++-12 clang++-14; do
  for use in IMPLICIT EXPLICIT; do
    $compiler -std=c++20 -D$use -c sum.cpp -o sum.o 2>errors && result=compiles ||
      result=$(grep -o 'invalid operands' errors | head -n 1)
    echo "$compiler, $use: $result"
  done
done | tee seen
printf '%s\n' 'g++-12, IMPLICIT: compiles' 'g++-12, EXPLICIT: compiles' \
  'clang++-14, IMPLICIT: compiles' 'clang++-14, EXPLICIT: invalid operands' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
