#!/bin/sh
# SPDX-License-Identifier: MIT
# GCC 12.2.0 (Debian g++-12 12.2.0-14+deb12u1): where an aggregate's first member is initialised by {} and
# its second one's initialiser throws, parts of the first one are destroyed twice.
#
# Expected: in Pair pair{{}, fails()} the members that were made are destroyed once, when the exception
# leaves: as many destructors as constructors run. Clang 14 does so.
# Seen: two destructors more than constructors, with and without optimisation, where the first member is an
# aggregate of members with default initialisers. Where one of them is a std::vector, the program ends by
# "double free". With Pair pair{Part{}, fails()} it is right.
# Flinch: train/report/comparison.cpp makes the aggregate first, and then fills in what may throw.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
[ "$(dpkg-query -W -f '${Version}' g++-12 2>/dev/null || true)" = 12.2.0-14+deb12u1 ] ||
  apt-get install -q -y --no-install-recommends g++-12=12.2.0-14+deb12u1 >/dev/null
cat >twice.cpp <<'CPP'
#include <iostream>
#include <stdexcept>

struct Counted {
  static inline int alive = 0;
  Counted() { ++alive; }
  Counted(const Counted&) { ++alive; }
  ~Counted() { --alive; }
};
Counted make() { return {}; }
struct Inner { Counted counted = make(); };
struct Part { Inner one; int number = 0; Inner two; };
struct Pair { Part part; int other; };
int fails() { throw std::runtime_error("no"); }

int main() {
  try { Pair pair{{}, fails()}; } catch (const std::exception&) {}
  std::cout << "{}: " << Counted::alive;
  Counted::alive = 0;
  try { Pair pair{Part{}, fails()}; } catch (const std::exception&) {}
  std::cout << ", Part{}: " << Counted::alive << '\n';
}
CPP
g++-12 -std=c++17 -O2 twice.cpp -o twice
seen=$(./twice)
echo "alive at the end, with $seen"
[ "$seen" = '{}: -2, Part{}: 0' ] || { echo "the behaviour has changed" >&2; exit 1; }
