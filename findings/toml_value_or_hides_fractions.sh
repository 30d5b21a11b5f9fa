#!/bin/sh
# SPDX-License-Identifier: MIT
# toml++ 3.3.0 (Debian libtomlplusplus-dev 3.3.0+ds-1): value_or() answers with its default where the
# file has a number that does not fit the default's type.
#
# Expected: `table["rate"].value_or(60)` gives 60 where the file has no rate, and the file's where it
# has one: 59 or 59.94 for 59.94, or an error.
# Seen: the default decides the type, int here, and a value that is no int without loss counts as
# absent. So 59.94 gives 60. A default of 60.0 takes whole numbers too, but only those that a double
# holds. A setting is ignored, and nothing tells it from one that is absent.
# Flinch: database/files/toml_reader.cpp reads by type, and names the line of what it cannot take.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -o APT::Sandbox::User=root download -q libtomlplusplus-dev=3.3.0+ds-1 >/dev/null
dpkg-deb -x libtomlplusplus-dev_3.3.0+ds-1_*.deb .
cat >rate.cpp <<'CPP'
#include <toml++/toml.h>
#include <iostream>

int main() {
  for (const char* rate : {"120", "60.0", "59.94", "9223372036854775807"}) {
    const toml::table table = toml::parse(std::string("rate = ") + rate);
    std::cout << "rate = " << rate << ": value_or(60) is " << table["rate"].value_or(60)
              << ", value_or(60.0) is " << table["rate"].value_or(60.0) << '\n';
  }
}
CPP
g++ -std=c++17 -DTOML_HEADER_ONLY=1 -I usr/include rate.cpp -o rate
./rate | tee seen
printf 'rate = %s: value_or(60) is %s, value_or(60.0) is %s\n' 120 120 120 60.0 60 60 59.94 60 59.94 \
  9223372036854775807 60 60 | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
