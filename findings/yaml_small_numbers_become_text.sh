#!/bin/sh
# SPDX-License-Identifier: MIT
# yaml 2.9.1 (npm) and PyYAML 6.0 (Debian python3-yaml 6.0-3+b2): a tolerance of 1e-7 that the one writes
# is text when the other reads it, and a clip called 1_000 is a number.
#
# Expected: a file of numbers and names that one reader and writer of YAML has written is read by
# another one as the same numbers and names.
# Seen: yaml writes YAML 1.2, where 1e-7 is a number and 1_000, 12:30:45 and on are text, so it
# writes all of them plain. PyYAML reads YAML 1.1, where it is the other way: it gives the text "1e-7",
# 1000, 45045 (a number in base 60) and True. Python compares "1e-7" to a number with an error at best;
# a name that has become a number is found nowhere. With { version: "1.1" } yaml quotes the names and
# still writes 1e-7. js-yaml 5.5.0 writes 1.e-7 and quotes the names, which all read.
# Flinch: reads TOML, where all of these have one meaning.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -o APT::Sandbox::User=root download -q python3-yaml=6.0-3+b2 libyaml-0-2 >/dev/null
for package in *.deb; do dpkg-deb -x "$package" .; done
npm install --silent --no-audit --no-fund --prefix . yaml@2.9.1 js-yaml@5.5.0 >/dev/null
cat >write.mjs <<'JS'
import { writeFileSync } from 'node:fs';
import { dump } from 'js-yaml';
import { stringify } from 'yaml';

const values = [1e-7, '1_000', '12:30:45', 'on'];
writeFileSync('yaml', stringify(values));
writeFileSync('yaml as 1.1', stringify(values, { version: '1.1' }));
writeFileSync('js-yaml', dump(values));
JS
node write.mjs
cat >read.py <<'PY'
import yaml

for writer in "yaml", "yaml as 1.1", "js-yaml":
    with open(writer) as file:
        print(f"{writer}: {yaml.safe_load(file)}")
PY
PYTHONPATH=usr/lib/python3/dist-packages LD_LIBRARY_PATH=usr/lib/x86_64-linux-gnu /usr/bin/python3 read.py |
  tee seen
cmp -s - seen <<'TEXT' || {
yaml: ['1e-7', 1000, 45045, True]
yaml as 1.1: ['1e-7', '1_000', '12:30:45', 'on']
js-yaml: [1e-07, '1_000', '12:30:45', 'on']
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
