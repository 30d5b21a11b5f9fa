#!/bin/sh
# SPDX-License-Identifier: MIT
# toml11 3.7.1 (Debian libtoml11-dev 3.7.1-3): what is written by operator<< has six digits, and where
# a file says 1, find_or<double> takes its default.
#
# Expected: file << value writes numbers that read back as they were, as toml::format(value) does. A
# number that may be 0.5 or 1 is read by find_or<double>(table, "gain", 9.0) as 0.5 or 1.
# Seen: operator<< takes the stream's precision, which is 6 until somebody sets it, so 0.123456789
# becomes 0.123457; format writes 17 digits. find_or gives 9 where the file says 1, as an integer is
# not a double for it and any error means the default; find<double> throws there. Writers that have
# one kind of number, such as smol-toml 1.9.1 (npm), write 1.0 as 1, so a file that a page saved again is
# read with other values than before.
# Flinch: takes an integer where a file may have a float, and reads by toml++.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -o APT::Sandbox::User=root download -q libtoml11-dev=3.7.1-3 >/dev/null
dpkg-deb -x libtoml11-dev_*.deb .
npm install --silent --no-audit --no-fund --prefix . smol-toml@1.9.1 >/dev/null
cat >resave.mjs <<'JS'
import { readFileSync, writeFileSync } from 'node:fs';
import { parse, stringify } from 'smol-toml';

writeFileSync('resaved.toml', stringify(parse(readFileSync('first.toml', 'utf8'))));
JS
cat >digits.cpp <<'CPP'
#include <fstream>
#include <iostream>
#include <toml.hpp>

int main() {
  const toml::value settings{{"gain", 1.0}, {"length", 0.123456789}};
  std::ofstream("streamed.toml") << settings;
  std::ofstream("first.toml") << toml::format(settings);
  std::cout << "length by operator<<: " << toml::find(toml::parse("streamed.toml"), "length")
            << ", by format: " << toml::format(toml::find(toml::parse("first.toml"), "length")) << "\n";
  if (std::system("node resave.mjs") != 0) return 1;
  for (const char* file : {"first.toml", "resaved.toml"}) {
    std::cout << file << ": find_or<double>(gain, 9.0) is "
              << toml::find_or<double>(toml::parse(file), "gain", 9.0) << "\n";
  }
}
CPP
g++ -std=c++17 -w -I usr/include digits.cpp -o digits
./digits | tee seen
printf '%s\n' 'length by operator<<: 0.123457, by format: 0.123456789' \
  'first.toml: find_or<double>(gain, 9.0) is 1' \
  'resaved.toml: find_or<double>(gain, 9.0) is 9' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
