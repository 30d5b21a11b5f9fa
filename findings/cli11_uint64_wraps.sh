#!/bin/sh
# SPDX-License-Identifier: MIT
# CLI11 2.1.2 (Debian libcli11-dev 2.1.2+ds-1): an option of type uint64_t takes a negative number,
# and one that is too large.
#
# Expected: `--first -3` is refused, as `--count -3` is, whose type is uint32_t, and so is a number
# above 2^64 - 1.
# Seen: the 64-bit option becomes 18446744073709551613, and parsing succeeds. The narrower one is
# refused only because the wrapped value does not fit. A number of 23 digits becomes 2^64 - 1. So `--seed -1` runs with another seed than the
# one that was meant, and says nothing.
# Flinch: program/command_line.cpp checks digits first.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -o APT::Sandbox::User=root download -q libcli11-dev=2.1.2+ds-1 >/dev/null
dpkg-deb -x libcli11-dev_2.1.2+ds-1_all.deb .
cat >numbers.cpp <<'CPP'
#include <CLI/CLI.hpp>
#include <cstdint>
#include <iostream>

int main(int argc, char** argv) {
  CLI::App app;
  std::uint64_t first = 0;
  std::uint32_t count = 0;
  app.add_option("--first", first);
  app.add_option("--count", count);
  CLI11_PARSE(app, argc, argv);
  std::cout << first << '\n';
}
CPP
g++ -std=c++17 -I usr/include numbers.cpp -o numbers
seen=$(./numbers --first -3) || seen=refused
large=$(./numbers --first 99999999999999999999999) || large=refused
narrow=$(./numbers --count -3 2>&1 >/dev/null) && narrow="taken"
echo "--first -3 (uint64_t): $seen"
echo "--first 99999999999999999999999: $large"
echo "--count -3 (uint32_t): $narrow"
case "$seen $large $narrow" in
  "18446744073709551613 18446744073709551615 Could not convert: --count = -3"*) ;;
  *) echo "the behaviour has changed" >&2; exit 1 ;;
esac
