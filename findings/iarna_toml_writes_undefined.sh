#!/bin/sh
# SPDX-License-Identifier: MIT
# @iarna/toml 3.0.0 (npm): 1e-7 is written as 1e-7.undefined, which no reader of TOML takes.
#
# Expected: stringify writes every finite number as a TOML float.
# Seen: it splits the number's text at the point and writes both halves. JavaScript writes a number
# below 1e-6 that has one digit without a point, so the second half is "undefined". 1e-6, 1.5e-7
# and 1e21 are right. A tolerance or a learning rate of 1e-7 makes a file that nothing reads, not
# @iarna/toml either, and the error comes only when it is read.
# Flinch: writes no TOML by it; database/files/toml_reader.cpp refuses such a file with its line.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . @iarna/toml@3.0.0 smol-toml@1.9.1 >/dev/null
cat >write.mjs <<'JS'
import iarna from '@iarna/toml';
import * as smol from 'smol-toml';

function reads(reader, text) {
  try {
    return String(reader.parse(text).tolerance);
  } catch {
    return 'an error';
  }
}
for (const tolerance of [1e-6, 1.5e-7, 1e-7, 3e-10]) {
  const text = iarna.stringify({ tolerance });
  console.log(`${text.trim()}: @iarna/toml reads ${reads(iarna, text)}, smol-toml ${reads(smol, text)}`);
}
JS
node write.mjs | tee seen
printf '%s\n' 'tolerance = 0.000001: @iarna/toml reads 0.000001, smol-toml 0.000001' \
  'tolerance = 1.5e-7: @iarna/toml reads 1.5e-7, smol-toml 1.5e-7' \
  'tolerance = 1e-7.undefined: @iarna/toml reads an error, smol-toml an error' \
  'tolerance = 3e-10.undefined: @iarna/toml reads an error, smol-toml an error' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
