// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "tests/scenes/error_of.h"
#include "tests/scenes/read_cost.h"
#include "tests/train/store/forged_store.h"
#include "train/store/store_rows.h"

namespace flinch::train {
namespace {

constexpr std::uint64_t kMutantCount = 24;  // several pages of observations

using Random = std::mt19937_64;

/// Changes the trees of pages that SQLite keeps: kinds, counts, pointers to cells, to pages and to
/// the rest of a row, sizes of rows, and the header of the file.
void change_pages(std::string& file, Random& random) {
  const auto pages = static_cast<std::uint32_t>(file.size() / kPageSize);
  const auto any = [&random](std::size_t below) {
    return static_cast<std::uint32_t>(random() % below);
  };
  const auto any_page = [&] { return 1 + any(pages); };
  const std::size_t at = tree_header(any_page());
  const std::size_t page = at / kPageSize * kPageSize;
  const std::uint32_t cells = number_at(file, at + 3, 2);
  const bool is_interior = file[at] == 2 || file[at] == 5;
  const std::size_t pointers = at + (is_interior ? 12 : 8);
  const std::size_t pointer = pointers + 2 * (random() % (cells % 4000 + 1));
  const std::size_t cell = page + number_at(file, pointer, 2) % (kPageSize - 16);
  constexpr std::array<char, 6> kKinds{2, 5, 10, 13, 0, 1};
  switch (random() % 10) {
    case 0:
      file[at] = kKinds[random() % kKinds.size()];
      break;
    case 1:
      put_number(file, at + 3, 2, random() % 2 == 0 ? cells + 1 : any(5000));
      break;
    case 2:
      put_number(file, at + 1 + 2 * (random() % 3), 2, any(kPageSize));
      break;
    case 3:
      put_number(file, at + 8, 4, any_page());
      break;
    case 4:
      put_number(file, pointer, 2, number_at(file, pointers + 2 * (random() % 8), 2));
      break;
    case 5:
      put_number(file, cell, 4, any_page());
      break;
    case 6:  // the size, the key and the types of a row
      file[cell + random() % 16] = static_cast<char>(random());
      break;
    case 7:  // a page of the rest of a row refers to another
      put_number(file, (any_page() - 1) * kPageSize, 4, any_page());
      break;
    case 8:
      file[16 + random() % 84] = static_cast<char>(random() % 2 == 0 ? random() : random() % 4);
      break;
    default:
      file[random() % 4096] = static_cast<char>(random());
  }
}

/// Changes values and makes all checksums right again.
void change_values(const std::string& path, Random& random) {
  const auto extreme = [&random] {
    constexpr std::array kValues{
        "0",    "-1",     "1e38",  "-1e300", "9e999",    "9223372036854775807",
        "NULL", "'text'", "x'00'", "1e-310", "char(27)", "zeroblob(100000)"};
    return std::string(kValues[random() % kValues.size()]);
  };
  const auto one_of = [&random](std::initializer_list<const char*> texts) {
    return std::string(texts.begin()[random() % texts.size()]);
  };
  Database database(path, Database::Mode::write);
  database.trust();
  database.execute("PRAGMA synchronous = OFF");
  std::string sql;
  switch (random() % 5) {
    case 0:
      sql = "UPDATE meta SET value = " + extreme() + " WHERE key = '" +
            one_of({"library_name", "seed", "distribution", "simulation", "reference_impulse_ns",
                    "reference_work_j", "idle_clip", "keeps_places"}) +
            "'";
      break;
    case 1:
      sql = "UPDATE clip SET " +
            one_of({"name", "work_j", "target", "direction_degrees", "degree", "onset_s", "peak_s",
                    "end_s"}) +
            " = " + extreme() + " WHERE clip = " + std::to_string(random() % 11);
      break;
    case 2:
      sql = "UPDATE target SET " + one_of({"x", "y", "z"}) + " = " + extreme();
      break;
    case 3:
      sql = "UPDATE kind SET " +
            one_of({"kind", "name", "min_radius_m", "max_radius_m", "min_mass_kg", "max_mass_kg",
                    "min_speed_mps", "max_speed_mps", "min_elevation", "max_elevation",
                    "min_time_to_impact_s", "max_time_to_impact_s", "restitution", "friction",
                    "falls"}) +
            " = " + extreme();
      break;
    default:
      break;
  }
  if (!sql.empty()) {
    tests::error_of([&] { database.execute(sql); });  // some values a column does not take
  } else {
    constexpr std::array kFloats{0.0F,
                                 -1.0F,
                                 1e9F,
                                 1e38F,
                                 std::numeric_limits<float>::infinity(),
                                 std::numeric_limits<float>::quiet_NaN()};
    const float value = kFloats[random() % kFloats.size()];
    const StoreHeader header = made_up_header();
    Observation observation = made_up_observation(header, random() % kMutantCount);
    features::Scenario& scenario = observation.scenario;
    float* const places[] = {&scenario.threat.position.x(),
                             &scenario.threat.velocity.z(),
                             &scenario.threat.radius,
                             &scenario.threat.mass_kg,
                             &scenario.time_to_impact_s,
                             &scenario.state.idle_time_s,
                             &scenario.state.facing,
                             &observation.trials.back().work_j,
                             &observation.trials.front().impulse.values[3],
                             &observation.places.back().impulse_ns};
    *places[random() % std::size(places)] = value;
    if (random() % 4 == 0) scenario.threat.kind = static_cast<int>(random() % 40) - 4;
    if (random() % 4 == 0) observation.trials.back().clip += static_cast<int>(random() % 2000);
    if (random() % 4 == 0) observation.places.back().clip += static_cast<int>(random() % 2000);
    if (random() % 8 == 0) observation.places.resize(random() % 4000, observation.places.back());
    database.execute("DELETE FROM observation WHERE number = " +
                     std::to_string(observation.number));
    Statement statement = prepare_insert(database, header);
    tests::error_of([&] { insert(statement, observation, header); });
  }
  break_seal(database);
  write_seal(database, {0, kMutantCount});
}

void expect_finite(const Store& store) {
  for (const Observation& observation : store.observations) {
    for (const float x : observation.features) ASSERT_TRUE(std::isfinite(x));
    for (const Trial& trial : observation.trials) {
      ASSERT_TRUE(std::isfinite(trial.work_j));
      ASSERT_LT(trial.clip, static_cast<int>(store.header.clips.size()));
    }
  }
}

TEST(StoreMutant, IsRefusedOrSoundAtTheCostOfAWholeStore) {
  const TemporaryFolder folder;
  write_made_up_store(folder / "whole", kMutantCount);
  const std::string whole = read_file(folder / "whole");
  const std::size_t allowed = tests::ReadCost::allowance(whole.size());
  const int count = tests::soak_samples(400, 100'000);
  int refused = 0;
  Random random(17);
  for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE(i);
    std::string file = whole;
    const bool has_new_values = i % 4 == 0;
    for (auto changes = has_new_values ? 0 : 1 + random() % 3; changes > 0; --changes) {
      change_pages(file, random);
    }
    const std::string path = folder.write("mutant", file);
    if (has_new_values) change_values(path, random);
    sqlite3_memory_highwater(1);
    const tests::ReadCost cost;
    Store store;
    std::string message = tests::error_of([&] { store = read_store(path); });
    if (message.empty()) message = tests::error_of([&] { summarise_store(path); });
    cost.expect_below(allowed);
    EXPECT_LT(sqlite3_memory_highwater(0), static_cast<sqlite3_int64>(allowed));
    EXPECT_THAT(message, testing::Not(testing::HasSubstr("\n")));
    refused += message.empty() ? 0 : 1;
    if (message.empty()) expect_finite(store);
  }
  EXPECT_GT(refused, count / 4);
  EXPECT_LT(refused, count);
}

}  // namespace
}  // namespace flinch::train
