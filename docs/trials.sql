-- SPDX-License-Identifier: MIT
-- Views of a store's trials for the sqlite3 shell, Python and whatever else runs SQL:
--
--   trial(number, clip, work_j)                     a clip that was tried in a scenario
--   impulse(number, clip, body, name, impulse_ns)   what it left a body with, where that is not 0
--
-- They are temporary, since Flinch refuses a store that holds a view, and write nothing. They read
-- the bytes of observation.trials as docs/store.md describes them. SQL has no function for that, so
-- they take the hexadecimal digits of a byte, and the place of a digit in '123456789ABCDEF'
-- is its number: 0 where it is not there.

-- Where the trials are: byte `place` of their scenario's, from 1, of clip `clip` + 1 at least. One
-- trial leads to the next, and the end of a scenario to the next scenario, so this takes the memory
-- of a single row. `head` has the digits of a trial's first two bytes; none at an end.
CREATE TEMP VIEW trial_place AS
WITH RECURSIVE walk(number, place, clip, head) AS (
  SELECT number, 1, -1, hex(substr(trials, 1, 2))
  FROM observation WHERE number = (SELECT min(number) FROM observation)
  UNION ALL
  SELECT
    observation.number,
    CASE head WHEN '' THEN 1 ELSE place + 6 + 5 * (
      instr('123456789ABCDEF', substr(head, 2, 1)) + instr('123456789ABCDEF', substr(head, 1, 1)) % 2 * 16) END,
    CASE head WHEN '' THEN -1 ELSE clip + instr('123456789ABCDEF', substr(head, 1, 1)) / 2 +
      instr('123456789ABCDEF', substr(head, 4, 1)) * 8 + instr('123456789ABCDEF', substr(head, 3, 1)) * 128 END,
    hex(substr(trials, CASE head WHEN '' THEN 1 ELSE place + 6 + 5 * (
      instr('123456789ABCDEF', substr(head, 2, 1)) + instr('123456789ABCDEF', substr(head, 1, 1)) % 2 * 16) END, 2))
  FROM walk JOIN observation ON observation.number = walk.number + (head = ''))
SELECT number, place, clip + instr('123456789ABCDEF', substr(head, 1, 1)) / 2 + instr('123456789ABCDEF', substr(head, 4, 1)) * 8 +
    instr('123456789ABCDEF', substr(head, 3, 1)) * 128 AS clip,
  instr('123456789ABCDEF', substr(head, 2, 1)) + instr('123456789ABCDEF', substr(head, 1, 1)) % 2 * 16 AS bodies
FROM walk WHERE head <> '';

-- Numbers of 32 bits from their 8 digits: sign, exponent, and the digits after the point in units
-- of 2^-23, as IEEE 754 has them. What follows divides by powers of 2 that fit into 63 bits, which
-- is exact.
CREATE TEMP VIEW trial AS
SELECT number, clip,
  CASE WHEN bits >= 1 << 31 THEN -1.0 ELSE 1.0 END *
    (bits % (1 << 23) + CASE exponent WHEN 0 THEN 0 ELSE 1 << 23 END) *
    (1 << max(exponent - 150, 0)) / (1 << min(max(150 - max(exponent, 1), 0), 60)) /
    (1 << min(max(90 - max(exponent, 1), 0), 60)) / (1 << max(30 - max(exponent, 1), 0)) AS work_j
FROM (
  SELECT number, clip, bits, (bits >> 23) % 256 AS exponent
  FROM (
    SELECT number, clip,
      (instr('123456789ABCDEF', substr(digits, 1, 1)) * 16 + instr('123456789ABCDEF', substr(digits, 2, 1))) * 1
      + (instr('123456789ABCDEF', substr(digits, 3, 1)) * 16 + instr('123456789ABCDEF', substr(digits, 4, 1))) * 256
      + (instr('123456789ABCDEF', substr(digits, 5, 1)) * 16 + instr('123456789ABCDEF', substr(digits, 6, 1))) * 65536
      + (instr('123456789ABCDEF', substr(digits, 7, 1)) * 16 + instr('123456789ABCDEF', substr(digits, 8, 1))) * 16777216 AS bits
    FROM (
      SELECT trial_place.number, clip, hex(substr(trials, place + 2, 4)) AS digits
      FROM trial_place JOIN observation USING (number))));

CREATE TEMP VIEW impulse AS
SELECT number, clip, body, name,
  CASE WHEN bits >= 1 << 31 THEN -1.0 ELSE 1.0 END *
    (bits % (1 << 23) + CASE exponent WHEN 0 THEN 0 ELSE 1 << 23 END) *
    (1 << max(exponent - 150, 0)) / (1 << min(max(150 - max(exponent, 1), 0), 60)) /
    (1 << min(max(90 - max(exponent, 1), 0), 60)) / (1 << max(30 - max(exponent, 1), 0))
    AS impulse_ns
FROM (
  SELECT number, clip, hit, bits, (bits >> 23) % 256 AS exponent
  FROM (
    SELECT number, clip, hit,
      (instr('123456789ABCDEF', substr(digits, 1, 1)) * 16 + instr('123456789ABCDEF', substr(digits, 2, 1))) * 1
      + (instr('123456789ABCDEF', substr(digits, 3, 1)) * 16 + instr('123456789ABCDEF', substr(digits, 4, 1))) * 256
      + (instr('123456789ABCDEF', substr(digits, 5, 1)) * 16 + instr('123456789ABCDEF', substr(digits, 6, 1))) * 65536
      + (instr('123456789ABCDEF', substr(digits, 7, 1)) * 16 + instr('123456789ABCDEF', substr(digits, 8, 1))) * 16777216 AS bits
    FROM (
      SELECT trial_place.number, clip, hex(substr(trials, place + 6 + 5 * body.body, 1)) AS hit,
        hex(substr(trials, place + 7 + 5 * body.body, 4)) AS digits
      FROM trial_place JOIN observation USING (number)
      JOIN body ON body.body < bodies)))
JOIN body ON body.body = instr('123456789ABCDEF', substr(hit, 1, 1)) * 16 + instr('123456789ABCDEF', substr(hit, 2, 1));
