// SPDX-License-Identifier: MIT
#include "train/store/store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "motion/error.h"
#include "tests/scenes/error_of.h"
#include "tests/scenes/file_damage.h"
#include "tests/train/store/made_up_store.h"
#include "train/store/sqlite.h"
#include "train/store/store_places.h"
#include "train/store/store_trials.h"

namespace flinch::train {
namespace {

using testing::HasSubstr;
using testing::Not;
using tests::error_of;

TEST(Store, RoundTripsBitForBit) {
  const TemporaryFolder folder;
  const StoreHeader header = made_up_header();
  write_store(folder / "a.flinchobs", header, 40);
  const Store store = read_store(folder / "a.flinchobs");
  EXPECT_EQ(store.header.library_hash, header.library_hash);
  EXPECT_EQ(store.header.library_name, header.library_name);
  EXPECT_TRUE(store.header.library_file == header.library_file);
  EXPECT_EQ(store.header.seed, header.seed);
  EXPECT_EQ(store.header.reference_impulse_ns, header.reference_impulse_ns);
  EXPECT_EQ(store.header.reference_work_j, header.reference_work_j);
  EXPECT_EQ(store.header.clip_work_j, header.clip_work_j);
  EXPECT_TRUE(store.header.keeps_places);
  ASSERT_EQ(store.header.clips.size(), header.clips.size());
  for (std::size_t i = 0; i < header.clips.size(); ++i) {
    EXPECT_EQ(store.header.clips[i].name, header.clips[i].name);
    ASSERT_EQ(store.header.clips[i].annotation.has_value(), header.clips[i].annotation.has_value());
    if (!header.clips[i].annotation) continue;
    EXPECT_EQ(store.header.clips[i].annotation->target, header.clips[i].annotation->target);
    EXPECT_NEAR(store.header.clips[i].annotation->direction, header.clips[i].annotation->direction,
                1e-6F);
    EXPECT_EQ(store.header.clips[i].annotation->peak_s, header.clips[i].annotation->peak_s);
  }
  EXPECT_EQ(store.header.idle_target_centres, header.idle_target_centres);
  ASSERT_EQ(store.observations.size(), 40U);
  for (std::uint64_t number = 0; number < 40; ++number) {
    const Observation expected = made_up_observation(header, number);
    const Observation& found = store.observations[number];
    EXPECT_EQ(found.number, number);
    EXPECT_EQ(found.scenario.target, expected.scenario.target);
    EXPECT_EQ(found.scenario.threat.position, expected.scenario.threat.position);
    EXPECT_EQ(found.scenario.threat.velocity, expected.scenario.threat.velocity);
    EXPECT_EQ(found.scenario.state.idle_time_s, expected.scenario.state.idle_time_s);
    EXPECT_EQ(found.features, expected.features);
    EXPECT_EQ(encode_trials(found.trials), encode_trials(expected.trials));
    EXPECT_EQ(encode_places(found.places), encode_places(expected.places));
  }
}

TEST(Store, HasTheSameBytesWhereverItIsInterrupted) {
  const TemporaryFolder folder;
  const StoreHeader header = made_up_header();
  write_store(folder / "whole", header, 70);
  for (const std::uint64_t stop : {0U, 16U, 21U, 64U}) {
    const std::string path = folder / ("stopped-at-" + std::to_string(stop));
    {
      StoreWriter writer(path, header, kWanted);
      if (stop > 0) writer.append(made_up_observations(header, 0, stop));
      EXPECT_FALSE(std::filesystem::exists(path)) << "nothing stands under the final name yet";
    }
    write_store(path, header, 70);
    EXPECT_TRUE(read_file(path) == read_file(folder / "whole")) << "stopped after " << stop;
    EXPECT_FALSE(std::filesystem::exists(path + ".partial"));
  }
}

TEST(Store, KeepsCommittedScenariosWhenKilledDuringATransaction) {
  const TemporaryFolder folder;
  const StoreHeader header = made_up_header();
  write_store(folder / "whole", header, 32);
  const std::string path = folder / "killed";
  const pid_t child = fork();
  if (child == 0) {
    StoreWriter writer(path, header, kWanted);
    writer.append(made_up_observations(header, 0, 16));
    // The next transaction is in the file and its journal is hot when the process is killed.
    raise(SIGSTOP);
    writer.append(made_up_observations(header, 16, 32));
    _exit(0);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, WUNTRACED), child);
  ASSERT_TRUE(WIFSTOPPED(status));
  EXPECT_THAT(error_of([&] { StoreWriter(path, header, kWanted); }), HasSubstr("another process"));
  kill(child, SIGKILL);
  waitpid(child, &status, 0);
  {
    const StoreWriter writer(path, header, kWanted);
    EXPECT_EQ(writer.count(), 16U);
  }
  write_store(path, header, 32);
  EXPECT_TRUE(read_file(path) == read_file(folder / "whole"));
}

TEST(Store, AnExtendedStoreHasTheSameBytes) {
  const TemporaryFolder folder;
  const StoreHeader header = made_up_header();
  write_store(folder / "whole", header, 50);
  write_store(folder / "grown", header, 21);
  write_store(folder / "grown", header, 50);
  EXPECT_TRUE(read_file(folder / "grown") == read_file(folder / "whole"));
}

TEST(Store, KeepsTheKindOfEachThreat) {
  const TemporaryFolder folder;
  StoreHeader header = made_up_header();
  header.kinds = {
      {.name = "stone",
       .radius_m = {0.125, 0.25},
       .mass_kg = {0.5, 0.75},
       .speed_mps = {1, 2},
       .elevation = {-0.5, 0.5},
       .time_to_impact_s = {0.25, 0.75},
       .bounce = {0.25, 0.75},
       .falls = false},
      {.name = "ball", .bounce = {0.5, 0.125}},
      {.name = "jab", .falls = false, .shape = features::ThreatShape::fist, .reach_m = {0.5, 0.75}},
      {.name = "bat",
       .radius_m = {0.03, 0.03},
       .falls = false,
       .shape = features::ThreatShape::rod,
       .reach_m = {0.5, 0.75},
       .rod = {.length_m = {0.75, 1},
               .strikes_at = {0.5, 1},
               .tilt = {-0.5, 0.25},
               .grip_share = {0.125, 0.25},
               .balance = 0.625,
               .grip_mass_kg = 2}},
      {.name = "stick",
       .radius_m = {0.03, 0.03},
       .shape = features::ThreatShape::rod,
       .rod = {.length_m = {0.75, 1}, .spin = {1, 2}, .balance = 0.5}}};
  std::vector<Observation> observations = made_up_observations(header, 0, 6);
  observations[1].scenario.threat.kind = observations[2].scenario.threat.kind = 1;
  observations[3].scenario.threat.kind = 2;
  observations[3].scenario.threat.stroke = {0.25F, 0.0625F};
  features::Threat& bat = observations[4].scenario.threat;
  bat.kind = 3;
  bat.stroke = {0.5F, 0.25F};
  bat.rod = features::Rod{{0, 0.8F, 0.6F}, {4, 0, 0}, 0, 0.75F, 0.46875F, 2};
  features::Threat& stick = observations[5].scenario.threat;
  stick.kind = 4;
  stick.rod = features::Rod{{0, 1, 0}, {0, 0, 3}, 0.375F, 0.375F, 0, 0};
  StoreWriter writer(folder / "a", header, {0, 6});
  writer.append(observations);
  writer.finish();
  const Store store = read_store(folder / "a");
  EXPECT_EQ(store.header.kinds, header.kinds);
  for (std::size_t i = 0; i < 6; ++i) {
    const features::Threat& threat = store.observations[i].scenario.threat;
    const std::size_t kind = std::array{0U, 1U, 1U, 2U, 3U, 4U}[i];
    ASSERT_EQ(threat.rod.has_value(), kind >= 3);
    if (threat.rod) {
      const features::Rod& rod = *observations[i].scenario.threat.rod;
      EXPECT_EQ(threat.rod->axis, rod.axis);
      EXPECT_EQ(threat.rod->angular_velocity, rod.angular_velocity);
      EXPECT_EQ(threat.rod->to_butt_m, rod.to_butt_m);
      EXPECT_EQ(threat.rod->to_tip_m, rod.to_tip_m);
      EXPECT_EQ(threat.rod->to_mass_m, rod.to_mass_m);
      EXPECT_EQ(threat.rod->grip_mass_kg, rod.grip_mass_kg);
    }
    EXPECT_EQ(threat.kind, static_cast<int>(kind));
    EXPECT_EQ(threat.bounce, header.kinds[kind].bounce);
    EXPECT_EQ(threat.falls, header.kinds[kind].falls);
    ASSERT_EQ(threat.stroke.has_value(), kind == 2 || kind == 3);
    if (kind != 2) continue;
    EXPECT_EQ(threat.stroke->starts_in_s, 0.25F);
    EXPECT_EQ(threat.stroke->lasts_s, 0.0625F);
  }
}

TEST(Store, OfAnotherRunIsRejectedAndUnchanged) {
  const TemporaryFolder folder;
  const StoreHeader header = made_up_header();
  const std::string path = folder / "a.flinchobs";
  write_store(path, header, 10);
  const std::string before = read_file(path);
  StoreHeader other = header;
  other.library_hash = 1;
  EXPECT_THAT(error_of([&] { StoreWriter(path, other, kWanted); }), HasSubstr("another library"));
  other = header;
  other.seed = 6;
  EXPECT_THAT(error_of([&] { StoreWriter(path, other, kWanted); }), HasSubstr("--seed 5"));
  other = header;
  other.distribution = "{}";
  EXPECT_THAT(error_of([&] { StoreWriter(path, other, kWanted); }),
              HasSubstr("scenario distribution"));
  other = header;
  other.kinds[0].bounce.restitution = 0.5;
  EXPECT_THAT(error_of([&] { StoreWriter(path, other, kWanted); }),
              HasSubstr("scenario distribution"));
  other = header;
  other.simulation = "{}";
  EXPECT_THAT(error_of([&] { StoreWriter(path, other, kWanted); }),
              HasSubstr("another simulation"));
  EXPECT_TRUE(read_file(path) == before);
}

TEST(Store, RejectsOtherFilesByName) {
  const TemporaryFolder folder;
  EXPECT_THAT(error_of([&] { read_store(folder / "none"); }),
              HasSubstr("none: cannot be read: No such file"));
  EXPECT_THAT(error_of([&] { read_store(folder.write("empty", "")); }), HasSubstr("empty"));
  EXPECT_THAT(error_of([&] { read_store(folder.write("text", "HIERARCHY")); }),
              HasSubstr("not a store"));
  {
    Database database(folder / "other.db", Database::Mode::create);
    database.execute("CREATE TABLE t(x)");
  }
  EXPECT_THAT(error_of([&] { read_store(folder / "other.db"); }), HasSubstr("not a store"));
  write_store(folder / "a", made_up_header(), 30);
  const std::string whole = read_file(folder / "a");
  for (const std::size_t length : {100UL, 5000UL, whole.size() / 2, whole.size() - 1}) {
    const std::string message =
        error_of([&] { read_store(folder.write("cut", whole.substr(0, length))); });
    EXPECT_THAT(message, HasSubstr("cut: ")) << length;
    EXPECT_THAT(message, Not(HasSubstr("\n"))) << length;
  }
  Database database(folder / "a", Database::Mode::write);
  database.execute("PRAGMA user_version = 99");
  EXPECT_THAT(error_of([&] { read_store(folder / "a"); }), HasSubstr("format 99"));
}

TEST(Store, RejectsDamagedRows) {
  const TemporaryFolder folder;
  for (const char* damage : {"UPDATE observation SET trials = x'0000' WHERE number = 3",
                             "UPDATE observation SET target = 'nose' WHERE number = 3",
                             "UPDATE observation SET threat_x = 1e999 WHERE number = 3",
                             "UPDATE observation SET mass_kg = 0.28 WHERE number = 3",
                             "UPDATE observation SET number = 5 WHERE number = 4",
                             "DELETE FROM observation WHERE number = 4",
                             "DELETE FROM observation",
                             "UPDATE kind SET restitution = 0.5",
                             "UPDATE kind SET kind = 1",
                             "DELETE FROM kind",
                             "UPDATE observation SET kind = 1 WHERE number = 3",
                             "UPDATE seal SET scenarios = 4",
                             "UPDATE clip SET work_j = 1 WHERE clip = 2",
                             "UPDATE body SET name = 'nose' WHERE body = 2",
                             "DROP TABLE observation",
                             "UPDATE meta SET value = 999 WHERE key = 'idle_clip'",
                             "DELETE FROM meta",
                             "DELETE FROM clip",
                             "DELETE FROM library",
                             "UPDATE library SET file = x'464C'",
                             "UPDATE library SET file = substr(file, 1, length(file) - 1)",
                             "UPDATE meta SET value = '1' WHERE key = 'library_hash'"}) {
    const std::string path = folder / "damaged";
    std::filesystem::remove(path);
    write_store(path, made_up_header(), 5);
    Database(path, Database::Mode::write).execute(damage);
    EXPECT_THAT(error_of([&] { read_store(path); }), HasSubstr("damaged")) << damage;
  }
}

TEST(Store, NamesAMissingScenario) {
  const TemporaryFolder folder;
  write_store(folder / "a", made_up_header(), 5);
  Database(folder / "a", Database::Mode::write)
      .execute("DELETE FROM observation WHERE number IN (2, 3)");
  EXPECT_THAT(error_of([&] { read_store(folder / "a"); }),
              HasSubstr("a: the store lacks scenarios 2 to 3"));
}

/// Everything that a reader gets from a store, as bytes; for a damaged store, the error in one
/// line.
std::string content_of(const std::string& path) {
  std::string content;
  const auto add = [&content](const auto& values) {
    content.append(reinterpret_cast<const char*>(values.data()),
                   values.size() * sizeof *values.data());
  };
  const std::string message = error_of([&] {
    const Store store = read_store(path);
    content = store.header.distribution + store.header.simulation + store.header.library_name;
    add(store.header.library_file);
    add(store.header.clip_work_j);
    for (const models::ClipSummary& clip : store.header.clips) content += clip.name;
    for (const Observation& observation : store.observations) {
      add(observation.features);
      add(encode_trials(observation.trials));
      add(encode_places(observation.places));
    }
  });
  EXPECT_THAT(message, Not(HasSubstr("\n")));
  return message.empty() ? content : "refused";
}

TEST(Store, AChangedByteIsDetectedOrWithoutEffect) {
  const TemporaryFolder folder;
  write_store(folder / "whole", made_up_header(), 60);
  const std::string whole = read_file(folder / "whole");
  const std::string content = content_of(folder / "whole");
  ASSERT_NE(content, "refused");
  features::Random random(3, features::RandomStream::baseline, 0);
  // The library has its own tests, so half of the flips hit the file's ends, and half an
  // observation, which ends with the trials and some hundred bytes before them.
  const std::size_t ends = 50'000;
  ASSERT_GT(whole.size(), 2 * ends);
  std::vector<tests::Flip> flips;
  for (int flip = 0; flip < 400; ++flip) {
    std::size_t place = random.index(2 * ends);
    if (place >= ends) place += whole.size() - 2 * ends;
    if (flip % 2 == 0) {
      const std::vector<std::byte> trials =
          encode_trials(made_up_observation(made_up_header(), random.index(60)).trials);
      place = whole.find(std::string(reinterpret_cast<const char*>(trials.data()), trials.size()));
      ASSERT_NE(place, std::string::npos);
      place += random.index(100 + trials.size()) - 100;
    }
    flips.push_back({place, 1 << random.index(8)});
  }
  std::size_t refused = 0;
  tests::for_each_flip(whole, flips, [&](const std::string& flipped, const tests::Flip& flip) {
    const std::string found = content_of(folder.write("flipped", flipped));
    refused += found == "refused" ? 1U : 0U;
    EXPECT_TRUE(found == "refused" || found == content) << flip.byte;
  });
  EXPECT_GT(refused, 200U);
}

TEST(Store, HasTheSameBytesInAnyOrderOfWriting) {
  const TemporaryFolder folder;
  const StoreHeader header = made_up_header();
  const ScenarioRange wanted{30, 40};
  const auto fill = [&](const std::string& path, std::vector<ScenarioRange> pieces) {
    StoreWriter writer(path, header, wanted);
    for (const ScenarioRange& piece : pieces)
      writer.append(made_up_observations(header, piece.first, piece.end()));
    EXPECT_EQ(writer.count(), 40U);
    EXPECT_TRUE(writer.missing().empty());
    writer.finish();
  };
  fill(folder / "in-order", {{30, 40}});
  fill(folder / "backwards", {{50, 20}, {40, 10}, {30, 10}});
  fill(folder / "mixed", {{41, 1}, {31, 9}, {42, 28}, {30, 1}, {40, 1}});
  EXPECT_TRUE(read_file(folder / "backwards") == read_file(folder / "in-order"));
  EXPECT_TRUE(read_file(folder / "mixed") == read_file(folder / "in-order"));
  const StoreSummary summary = summarise_store(folder / "mixed");
  EXPECT_EQ(summary.range, wanted);
  EXPECT_TRUE(summary.holds({35, 5}));
  EXPECT_FALSE(summary.holds({29, 5}));
}

TEST(Store, KnowsItsMissingScenariosAfterAnInterruption) {
  const TemporaryFolder folder;
  const StoreHeader header = made_up_header();
  {
    StoreWriter writer(folder / "a", header, {10, 30});
    writer.append(made_up_observations(header, 15, 20));
    writer.append(made_up_observations(header, 30, 31));
    const Observation there = made_up_observation(header, 16);
    EXPECT_TRUE(writer.holds(there));
    Observation other = there;
    other.trials[1].impulse[motion::Body::head] += 1;
    EXPECT_FALSE(writer.holds(other));
    EXPECT_FALSE(writer.holds(made_up_observation(header, 20)));
    EXPECT_THAT(error_of([&] { writer.append(made_up_observations(header, 19, 21)); }),
                HasSubstr("not missing"));
    EXPECT_THAT(error_of([&] { writer.append(made_up_observations(header, 39, 41)); }),
                HasSubstr("not missing"));
    EXPECT_THAT(error_of([&] { writer.finish(); }), HasSubstr("lacks scenarios 10 to 14"));
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "a"));
  const std::vector<ScenarioRange> expected{{5, 10}, {20, 10}, {31, 9}};
  EXPECT_EQ(StoreWriter(folder / "a", header, {5, 35}).missing(), expected);
}

TEST(Store, RejectsInvalidRanges) {
  const TemporaryFolder folder;
  const StoreHeader header = made_up_header();
  const std::uint64_t last = kScenarioNumberEnd - 1;
  for (const ScenarioRange& range :
       {ScenarioRange{last, 2}, ScenarioRange{~std::uint64_t{0}, 1},
        ScenarioRange{kScenarioNumberEnd, 1}, ScenarioRange{1, ~std::uint64_t{0}}})
    EXPECT_THAT(error_of([&] { StoreWriter(folder / "a", header, range); }),
                HasSubstr("go past the last number, 9223372036854775807"));
  EXPECT_THAT(error_of([&] {
                StoreWriter(folder / "a", header, {3, 0});
              }),
              HasSubstr("no scenario"));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << "nothing is left behind";
  EXPECT_EQ(StoreWriter(folder / "end", header, {last, 1}).missing().front().first, last);
}

TEST(Store, RejectsARangeThatOmitsStoredScenarios) {
  const TemporaryFolder folder;
  const StoreHeader header = made_up_header();
  write_store(folder / "a", header, 20);
  const std::string before = read_file(folder / "a");
  EXPECT_THAT(error_of([&] {
                StoreWriter(folder / "a", header, {10, 30});
              }),
              HasSubstr("a: holds scenarios 0 to 19"));
  EXPECT_THAT(error_of([&] {
                StoreWriter(folder / "a", header, {20, 30});
              }),
              HasSubstr("a: holds scenarios 0 to 19, 20 in all, and --first 20 is beyond its end; "
                        "begin at 0"));
  EXPECT_FALSE(std::filesystem::exists(folder / "a.partial"));
  EXPECT_TRUE(read_file(folder / "a") == before);
  { StoreWriter(folder / "b", header, {0, 20}).append(made_up_observations(header, 0, 20)); }
  EXPECT_THAT(error_of([&] {
                StoreWriter(folder / "b", header, {0, 10});
              }),
              HasSubstr("b.partial: holds scenarios 0 to 19"));
  EXPECT_EQ(StoreWriter(folder / "b", header, {0, 20}).count(), 20U);
}

/// A store of scenarios that begin in two stances of a library that has them.
struct StanceStore {
  StanceStore() {
    motion::Clip guard = library.clips[0];
    guard.name = "guard";
    guard.purpose = motion::Purpose::stance;
    guard.kind = "guard";
    library.clips.push_back(guard);
    const std::string file = database::library_bytes(library);
    const auto bytes = std::as_bytes(std::span(file));
    header.library_file.assign(bytes.begin(), bytes.end());
    header.library_hash = database::verify_file(database::kLibraryFormat, bytes).hash;
    header.clips.push_back({"guard", std::nullopt});
    header.clip_work_j.push_back(0);
    header.stances = stance_names(library);
  }

  void write(const std::string& path, int last_stance) const {
    StoreWriter writer(path, header, {0, 4});
    std::vector<Observation> observations = made_up_observations(header, 0, 4);
    observations[1].scenario.state = {0.25F, {0.5F, -1}, 0.125F, 1};
    observations[3].scenario.state.stance = last_stance;
    writer.append(observations);
    writer.finish();
  }

  database::ClipLibrary library = scenes::synthetic_library();
  StoreHeader header = made_up_header();
};

TEST(Store, KeepsTheStancesInWhichScenariosBegin) {
  const TemporaryFolder folder;
  const StanceStore made;
  made.write(folder / "a.flinchobs", 1);
  const Store store = read_store(folder / "a.flinchobs");
  EXPECT_EQ(store.header.format_version, kStanceStoreFormatVersion);
  EXPECT_EQ(store.header.stances, made.header.stances);
  const features::CharacterState& state = store.observations[1].scenario.state;
  EXPECT_EQ(state.stance, 1);
  EXPECT_EQ(state.idle_time_s, 0.25F);
  EXPECT_EQ(state.position, Eigen::Vector2f(0.5F, -1));
  EXPECT_EQ(state.facing, 0.125F);
  EXPECT_EQ(store.observations[0].scenario.state.stance, 0);
  write_store(folder / "idle.flinchobs", made_up_header(), 4);
  EXPECT_EQ(read_store(folder / "idle.flinchobs").header.format_version, kStoreFormatVersion);
}

TEST(Store, RefusesAStanceThatTheLibraryDoesNotHave) {
  const TemporaryFolder folder;
  for (const int stance : {-1, 2}) {
    StanceStore().write(folder / std::to_string(stance), stance);
    EXPECT_THAT(error_of([&] { read_store(folder / std::to_string(stance)); }),
                HasSubstr("the store is damaged"));
  }
}

}  // namespace
}  // namespace flinch::train
