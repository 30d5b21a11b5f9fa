#!/bin/sh
# SPDX-License-Identifier: MIT
# sql.js 1.17.0 (npm): a rate of two JavaScript numbers is 0 where both are whole, and large integers
# come back as others.
#
# Expected: JavaScript has doubles, so they are bound as REAL, and 7 / 10 is 0.7 as 7.5 / 10 is 0.75.
# Seen: a number that equals its 32-bit integer is bound as INTEGER, each value for itself, so of the
# same column of successes without a type some rows are integers and their rate is 0. A column of type
# REAL is right. The other way, an integer of 64 bits is read as a double: a seed of 9007199254740993
# comes back as ...992 without a word, and selecting by it finds nothing.
# Flinch: who reads a store by sql.js selects its checksums with CAST(checksum AS TEXT).
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix . sql.js@1.17.0 >/dev/null
cat >rates.mjs <<'JS'
import open from 'sql.js';

const { Database } = await open();
const database = new Database();
const rows = (sql, values) => database.exec(sql, values)[0].values;
database.run('CREATE TABLE typed(hits REAL, throws REAL); CREATE TABLE untyped(hits, throws)');
for (const hits of [7, 7.5]) {
  for (const table of ['typed', 'untyped']) {
    database.run(`INSERT INTO ${table} VALUES(?, ?)`, [hits, 10]);
  }
  console.log(`SELECT ? / ? of ${hits} and 10: ${rows('SELECT ? / ?', [hits, 10])[0][0]}`);
}
for (const table of ['typed', 'untyped']) {
  console.log(`${table} columns: ${rows(`SELECT hits / throws FROM ${table}`).join(' and ')}`);
}
database.run('CREATE TABLE run(seed INTEGER); INSERT INTO run VALUES(9007199254740993)');
const [[seed]] = rows('SELECT seed FROM run');
const [[found]] = rows('SELECT count(*) FROM run WHERE seed = ?', [seed]);
console.log(`seed 9007199254740993: read as ${seed}, by which ${found} rows are found`);
JS
node rates.mjs | tee seen
printf '%s\n' 'SELECT ? / ? of 7 and 10: 0' 'SELECT ? / ? of 7.5 and 10: 0.75' \
  'typed columns: 0.7 and 0.75' 'untyped columns: 0 and 0.75' \
  'seed 9007199254740993: read as 9007199254740992, by which 0 rows are found' | cmp -s - seen || {
  echo "the behaviour has changed" >&2
  exit 1
}
