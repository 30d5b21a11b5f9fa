#!/bin/sh
# SPDX-License-Identifier: MIT
# SQLite 3.40.1 (Debian sqlite3 3.40.1-2+deb12u2): after .import of a table with numbers, the greatest of 9.5,
# 10.25 and 100 is 9.5, while their mean is right.
#
# Expected: a column in which each cell is a number is one of numbers, as in a spreadsheet, R or pandas.
# SQLite has types by value.
# Seen: .import makes a new table whose columns are TEXT. avg() and sum() convert, so they are right; max(),
# ORDER BY and "pain > 20" compare texts by their letters, with no error: the worst clip is the wrong
# one. Into a table that was made before with REAL columns the same file comes in as numbers.
# Flinch: exports such tables; docs/program.md says to make a table with types first.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in sqlite3=3.40.1-2+deb12u2 libsqlite3-0=3.40.1-2+deb12u2; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
printf '%s\n' clip,pain duck,9.5 stand,10.25 step,100 >pain.csv
cat >commands <<'SQL'
.import --csv pain.csv as_it_is
CREATE TABLE typed (clip TEXT, pain REAL);
.import --csv --skip 1 pain.csv typed
SELECT 'as it is: greatest ' || max(pain) || ', mean ' || round(avg(pain), 1) || ', above 20: ' ||
  (SELECT group_concat(clip) FROM as_it_is WHERE pain > 20) FROM as_it_is;
SELECT 'typed: greatest ' || max(pain) || ', mean ' || round(avg(pain), 1) || ', above 20: ' ||
  (SELECT group_concat(clip) FROM typed WHERE pain > 20) FROM typed;
SQL
LD_LIBRARY_PATH=usr/lib/x86_64-linux-gnu usr/bin/sqlite3 -batch :memory: <commands | tee seen
cmp -s - seen <<'TEXT' || {
as it is: greatest 9.5, mean 39.9, above 20: duck
typed: greatest 100.0, mean 39.9, above 20: step
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
