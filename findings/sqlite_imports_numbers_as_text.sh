#!/bin/sh
# SPDX-License-Identifier: MIT
# SQLite 3.40.1 (Debian sqlite3 3.40.1-2+deb12u2): after .import of a table with numbers, the greatest of
# 9.5, 10.25 and 100 is 9.5, and an empty cell is a 0 in the mean.
#
# Expected: a column in which each cell is a number or empty is one of numbers, as in a spreadsheet, R or
# pandas. SQLite has types by value, and NULL.
# Seen: .import makes a new table whose columns are TEXT. max(), ORDER BY and "pain > 20" compare texts by
# their letters, so the worst clip is the wrong one; avg() and sum() convert, an empty text to 0. Into a
# table that was made before with REAL columns the same file comes in as numbers, but an empty cell is still
# a text, greater than each number and 0 in the mean, until it is set to NULL. There is no error.
# Flinch: exports such tables; docs/program.md says what to do.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in sqlite3=3.40.1-2+deb12u2 libsqlite3-0=3.40.1-2+deb12u2; do
  apt-get -o APT::Sandbox::User=root download -q "$package" >/dev/null
done
for package in *.deb; do dpkg-deb -x "$package" .; done
printf '%s\n' clip,pain duck,9.5 stand,10.25 step,100 crouch, >pain.csv
cat >commands <<'SQL'
.import --csv pain.csv untyped
CREATE TABLE typed (clip TEXT, pain REAL);
.import --csv --skip 1 pain.csv typed
CREATE TABLE mended AS SELECT clip, NULLIF(pain, '') AS pain FROM typed;
SELECT 'untyped: greatest "' || max(pain) || '", mean ' || round(avg(pain), 1) || ', above 20: ' ||
  (SELECT group_concat(clip) FROM untyped WHERE pain > 20) FROM untyped;
SELECT 'typed: greatest "' || max(pain) || '", mean ' || round(avg(pain), 1) || ', above 20: ' ||
  (SELECT group_concat(clip) FROM typed WHERE pain > 20) FROM typed;
SELECT 'with NULL: greatest "' || max(pain) || '", mean ' || round(avg(pain), 1) || ', above 20: ' ||
  (SELECT group_concat(clip) FROM mended WHERE pain > 20) FROM mended;
SQL
LD_LIBRARY_PATH=usr/lib/x86_64-linux-gnu usr/bin/sqlite3 -batch :memory: <commands | tee seen
cmp -s - seen <<'TEXT' || {
untyped: greatest "9.5", mean 29.9, above 20: duck
typed: greatest "", mean 29.9, above 20: step,crouch
with NULL: greatest "100.0", mean 39.9, above 20: step
TEXT
  echo "the behaviour has changed" >&2
  exit 1
}
