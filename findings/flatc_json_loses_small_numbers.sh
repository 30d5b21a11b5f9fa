#!/bin/sh
# SPDX-License-Identifier: MIT
# FlatBuffers 2.0.8 (Debian flatbuffers-compiler 2.0.8+dfsg1-2): flatc turns 1e-9 into 0.0 when it
# prints a binary as JSON.
#
# Expected: what flatc --binary made of a JSON file comes back by flatc --json with the same numbers,
# or at least with the same leading digits, whatever their size.
# Seen: a float is printed with six digits after its point, a double with twelve, in fixed notation.
# Whatever is smaller becomes 0.0 and comes back as zero; 0.0012345678 keeps four digits. Integers
# keep all of their digits, and nothing is said.
# Flinch: prints nothing by flatc; `flinch info` and `flinch export` read its files themselves.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -o APT::Sandbox::User=root download -q flatbuffers-compiler=2.0.8+dfsg1-2 >/dev/null
dpkg-deb -x flatbuffers-compiler_2.0.8+dfsg1-2_*.deb .
cat >numbers.fbs <<'FBS'
table Numbers { floats:[float]; doubles:[double]; count:ulong; }
root_type Numbers;
FBS
echo '{"floats": [0.0012345678, 1e-9], "doubles": [0.0012345678, 1e-13],
  "count": 18446744073709551615}' >numbers.json
usr/bin/flatc --binary numbers.fbs numbers.json
usr/bin/flatc --json --raw-binary --strict-json -o back numbers.fbs -- numbers.bin
tr -d ' \n' <back/numbers.json | tee seen
echo
printf '{"floats":[0.001235,0.0],"doubles":[0.0012345678,0.0],"count":18446744073709551615}' |
  cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
