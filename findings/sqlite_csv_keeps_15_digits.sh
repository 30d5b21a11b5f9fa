#!/bin/sh
# SPDX-License-Identifier: MIT
# SQLite 3.40.1 (Debian sqlite3 3.40.1-2+deb12u2): sqlite3 -csv writes nine of ten doubles so that they
# do not read back, sqlite3 -json writes all so that they do.
#
# Expected: what a shell exports from a REAL column reads back as the same double, whichever format it
# is told to write.
# Seen: -csv, -list, -column and -box write 15 digits, as do || '', CAST(x AS TEXT), json_array(x) and
# group_concat; 0.1 + 0.2 comes out as 0.3. -json, -quote and .dump write 20. Of 1000 doubles 915
# are others after .mode csv and .import, and rows that were equal in two tables are not any more after
# one went through a .csv. printf('%!.17g', x) in the query keeps them.
# Flinch: its store has REAL columns: export a table of it by -json, or with printf('%!.17g', x).
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in sqlite3 libsqlite3-0; do
  apt-get -o APT::Sandbox::User=root download -q "$package=3.40.1-2+deb12u2" >/dev/null
done
apt-get -o APT::Sandbox::User=root download -q libreadline8 libtinfo6 >/dev/null
for package in *.deb; do dpkg-deb -x "$package" .; done
LD_LIBRARY_PATH=$PWD/usr/lib/x86_64-linux-gnu:$PWD/lib/x86_64-linux-gnu
export LD_LIBRARY_PATH
cat >doubles.py <<'PY'
import random

draw = random.Random(1)
print("CREATE TABLE here(row INTEGER PRIMARY KEY, x REAL);")
for row in range(1000):
    print(f"INSERT INTO here VALUES({row}, {draw.random()!r});")
PY
python3 doubles.py | usr/bin/sqlite3 store
usr/bin/sqlite3 -csv store 'SELECT row, x FROM here' >plain.csv
usr/bin/sqlite3 -csv store "SELECT row, printf('%!.17g', x) FROM here" >printf.csv
usr/bin/sqlite3 -json store 'SELECT row, x FROM here' >table.json
cat >compare.sql <<'SQL'
CREATE TABLE there(row INTEGER PRIMARY KEY, x REAL);
.mode csv
.import plain.csv there
.mode list
SELECT 'csv: ' || sum(here.x = there.x) || ' of 1000 are the same' FROM here JOIN there USING(row);
DELETE FROM there;
.mode csv
.import printf.csv there
.mode list
SELECT 'csv by printf: ' || sum(here.x = there.x) || ' of 1000 are the same'
  FROM here JOIN there USING(row);
SELECT 'json: ' || sum(here.x = json_extract(value, '$.x')) || ' of 1000 are the same'
  FROM json_each(readfile('table.json')) JOIN here ON here.row = json_extract(value, '$.row');
SELECT 'as text, 0.1 + 0.2 is ' || (0.1 + 0.2);
SQL
usr/bin/sqlite3 store <compare.sql | tee seen
printf '%s\n' 'csv: 85 of 1000 are the same' 'csv by printf: 1000 of 1000 are the same' \
  'json: 1000 of 1000 are the same' 'as text, 0.1 + 0.2 is 0.3' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
