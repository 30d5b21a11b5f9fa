// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/scenes/error_of.h"
#include "tests/scenes/read_cost.h"
#include "tests/train/store/forged_store.h"
#include "train/store/merge.h"

namespace flinch::train {
namespace {

using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;
using tests::error_of;

constexpr std::uint64_t kForgedCount = 6;

/// Expects that every use of the store ends with one line that says so, for little time and memory.
void expect_refused(const std::string& path, const std::string& what) {
  SCOPED_TRACE(what);
  const std::size_t allowed = (64U << 20) + 4 * std::filesystem::file_size(path);
  const StoreHeader header = made_up_header();
  const std::string merged = path + ".merged";
  const std::function<void()> uses[] = {
      [&] { read_store(path); },
      [&] { count_contents(path); },
      [&] { summarise_store(path), count_contents(path); },
      [&] { merge_stores({{path}}, merged); },
      [&] {
        StoreWriter(path, header, {0, 200});
      },
      [&] {
        StoreWriter(path.substr(0, path.rfind('.')), header, {0, 200});
      },  // x.partial of x
  };
  for (const std::function<void()>& use : uses) {
    sqlite3_memory_highwater(1);
    const tests::ReadCost cost;
    const std::string message = error_of(use);
    cost.expect_below(allowed);
    EXPECT_LT(sqlite3_memory_highwater(0), static_cast<sqlite3_int64>(allowed));
    EXPECT_THAT(message, AnyOf(HasSubstr("damaged"), HasSubstr("something else"),
                               HasSubstr("not a store"), HasSubstr("lacks scenarios")));
    EXPECT_THAT(message, Not(HasSubstr("\n")));
  }
}

TEST(HostileStore, MayHoldOnlyTheTablesOfAStore) {
  for (const char* sql : {
           // Views that never end, and that make gigabytes of a number.
           "DROP TABLE observation; CREATE VIEW observation AS WITH RECURSIVE n(number) AS (SELECT "
           "0 UNION ALL SELECT number + 1 FROM n) SELECT number FROM n",
           "DROP TABLE library; CREATE VIEW library AS SELECT zeroblob(900000000) AS file",
           "DROP TABLE target; CREATE VIEW target AS SELECT hex(zeroblob(400000000)) AS name, 0.0 "
           "AS x, 0.0 AS y, 0.0 AS z",
           // Columns that are computed.
           "DROP TABLE body; CREATE TABLE body(body INTEGER PRIMARY KEY, name TEXT AS "
           "(hex(zeroblob(400000000)))); INSERT INTO body VALUES (1)",
           // What runs when the store is continued.
           "CREATE TRIGGER t AFTER DELETE ON seal BEGIN DELETE FROM observation; END",
           "CREATE TRIGGER t AFTER INSERT ON observation BEGIN INSERT INTO observation SELECT "
           "new.number + 1, 'head', 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, x'', 0; END",
           "CREATE TABLE other(x)",
           "CREATE INDEX i ON observation(target)",
           "CREATE INDEX i ON meta(abs(length(value)))",
           "CREATE VIRTUAL TABLE words USING fts5(x)",
           "ANALYZE",
           "ALTER TABLE clip RENAME COLUMN work_j TO work",
           "ALTER TABLE body ADD COLUMN more TEXT DEFAULT 'x'",
           "PRAGMA writable_schema = ON; UPDATE sqlite_master SET sql = 'CREATE TABLE clip(clip)' "
           "WHERE name = 'clip'",
           "PRAGMA writable_schema = ON; INSERT INTO sqlite_master SELECT * FROM sqlite_master",
           "PRAGMA writable_schema = ON; UPDATE sqlite_master SET type = 'view'",
       }) {
    const TemporaryFolder folder;
    const std::string path = folder / "forged.partial";
    write_made_up_store(path, kForgedCount);
    forge(path, sql);
    expect_refused(path, sql);
  }
}

TEST(HostileStore, WithATableOfEndlessRowsIsRefused) {
  const TemporaryFolder folder;
  for (const char* table :
       {"observation", "body", "clip", "library", "meta", "target", "kind", "seal"}) {
    const std::string path = folder / "forged.partial";
    std::filesystem::remove(path);
    write_made_up_store(path, kForgedCount);
    forge(path, "UPDATE body SET name = hex(zeroblob(300))");
    if (std::string(table) == "observation")
      forge(path, "DELETE FROM seal");  // so rows are counted
    const std::uint32_t root = root_of(path, table);
    folder.write("forged.partial", with_endless_table(read_file(path), root, 4));
    expect_refused(path, table);
  }
}

TEST(HostileStore, WithALogOfItsOwnIsRefusedAndLeavesNoFile) {
  const TemporaryFolder folder;
  const std::string path = folder / "forged";
  write_made_up_store(path, kForgedCount);
  std::string file = read_file(path);
  file[18] = file[19] = 2;  // says that it has a write-ahead log
  folder.write("forged", file);
  EXPECT_THAT(error_of([&] { read_store(path); }), HasSubstr("damaged"));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(HostileStore, ValuesOutOfBoundsAreRefusedThoughTheChecksumIsRight) {
  for (const char* sql : {
           "UPDATE meta SET value = hex(zeroblob(40000)) WHERE key = 'distribution'",
           "UPDATE meta SET value = char(27) || '[2J' WHERE key = 'distribution'",
           "UPDATE meta SET value = char(10) WHERE key = 'library_name'",
           "UPDATE meta SET value = 9e999 WHERE key = 'reference_work_j'",
           "UPDATE meta SET value = -1 WHERE key = 'reference_impulse_ns'",
           "UPDATE meta SET value = -1 WHERE key = 'idle_clip'",
           "UPDATE clip SET name = CAST(x'FF' AS TEXT) WHERE clip = 1",
           "UPDATE clip SET name = 'other' WHERE clip = 1",
           "UPDATE clip SET work_j = 9e999 WHERE clip = 1",
           "UPDATE clip SET onset_s = -1 WHERE clip = 1",
           "UPDATE clip SET peak_s = 1e300 WHERE clip = 1",
           "UPDATE clip SET direction_degrees = 1e300 WHERE clip = 1",
           "UPDATE target SET x = 1e300",
           "UPDATE kind SET restitution = 1.5",
           "UPDATE kind SET friction = -1",
           "UPDATE kind SET name = ''",
           "UPDATE kind SET min_mass_kg = 9e999",
           "UPDATE kind SET min_speed_mps = 40",
           "UPDATE kind SET kind = 1",
           "DELETE FROM kind",
           "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n LIMIT 40) INSERT INTO "
           "kind SELECT i, 'k' || i, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 1, 'ball', 0, 0, 0, 0, 0, "
           "0, 0, 0, 0, 0, 0, 0, 0, 0 FROM n",
           "UPDATE kind SET shape = 'net'",
           "UPDATE kind SET max_reach_m = 1",
           "UPDATE kind SET shape = 'fist', falls = 0, max_reach_m = 1",
           "WITH RECURSIVE n(i) AS (SELECT 10 UNION ALL SELECT i + 1 FROM n LIMIT 20000) INSERT "
           "INTO clip(clip, name, work_j) SELECT i, 'c' || i, 1 FROM n",
       }) {
    SCOPED_TRACE(sql);
    const TemporaryFolder folder;
    const std::string path = folder / "forged";
    write_made_up_store(path, kForgedCount);
    forge(path, sql);
    seal_again(path, kForgedCount);
    EXPECT_THAT(error_of([&] { read_store(path); }), HasSubstr("damaged"));
  }
}

TEST(HostileStore, SealedRangesThatOverflowAreRefused) {
  const TemporaryFolder folder;
  for (const ScenarioRange range :
       {ScenarioRange{1, ~std::uint64_t{0}}, ScenarioRange{kScenarioNumberEnd, 1},
        ScenarioRange{0, kScenarioNumberEnd + 1}}) {
    const std::string path = folder / "forged";
    std::filesystem::remove(path);
    write_made_up_store(path, kForgedCount);
    {
      Database database(path, Database::Mode::write);
      database.trust();
      break_seal(database);
      write_seal(database, range);
    }
    EXPECT_THAT(error_of([&] { summarise_store(path); }), HasSubstr("damaged"));
  }
}

}  // namespace
}  // namespace flinch::train
