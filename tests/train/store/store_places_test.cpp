// SPDX-License-Identifier: MIT
#include "train/store/store_places.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "tests/scenes/error_of.h"
#include "tests/train/store/forged_store.h"
#include "train/store/store_rows.h"

namespace flinch::train {
namespace {

using motion::Body;
using testing::HasSubstr;
using tests::error_of;

std::vector<std::byte> place_bytes(std::initializer_list<int> values) {
  std::vector<std::byte> result;
  for (const int value : values) result.push_back(static_cast<std::byte>(value));
  return result;
}

TEST(StorePlaces, HaveTheDocumentedBytes) {
  const std::vector<HitPlace> places{{0, Body::head, 2, {1, -1, 256}},
                                     {300, Body::right_foot, 1.5F, {0, 0, -2}}};
  EXPECT_EQ(encode_places(places),
            place_bytes({0,    0, 4,  0, 0, 0,    0x40, 1, 0, 255, 255, 0,   1,  //
                         0x2C, 1, 16, 0, 0, 0xC0, 0x3F, 0, 0, 0,   0,   254, 255}));
}

TEST(StorePlaces, RoundTripAndKeepTheirPointsToTheMillimetre) {
  features::Random random(1, features::RandomStream::baseline, 0);
  for (int i = 0; i < 100; ++i) {
    std::vector<HitPlace> places(random.index(200));
    int clip = 0;
    for (HitPlace& place : places) {
      clip += static_cast<int>(random.index(3));
      place.clip = clip;
      place.body = static_cast<Body>(random.index(motion::kBodyCount));
      place.impulse_ns = static_cast<float>(random.uniform(0, 30));
      for (std::int16_t& x : place.point_mm)
        x = static_cast<std::int16_t>(static_cast<int>(random.index(1200)) - 600);
    }
    const std::vector<HitPlace> found = decode_places(encode_places(places));
    ASSERT_EQ(found.size(), places.size());
    for (std::size_t k = 0; k < places.size(); ++k) {
      EXPECT_EQ(found[k].clip, places[k].clip);
      EXPECT_EQ(found[k].body, places[k].body);
      EXPECT_EQ(found[k].impulse_ns, places[k].impulse_ns);
      EXPECT_EQ(found[k].point_mm, places[k].point_mm);
    }
  }
  EXPECT_TRUE(
      point_of({0, Body::head, 1, {1, -20, 300}}).isApprox(Eigen::Vector3f(0.001F, -0.02F, 0.3F)));
}

TEST(StorePlaces, DamagedBytesAreRefused) {
  const std::vector<HitPlace> places{{3, Body::head, 2, {}}, {3, Body::neck, 2, {}}};
  std::vector<std::byte> whole = encode_places(places);
  EXPECT_EQ(decode_places(whole).size(), 2U);
  EXPECT_THROW(decode_places(std::span(whole).first(25)), Error) << "cut short";
  std::vector<std::byte> no_body = whole;
  no_body[2] = std::byte{17};
  EXPECT_THROW(decode_places(no_body), Error);
  std::vector<std::byte> descending = whole;
  descending[kPlaceBytes] = std::byte{2};
  EXPECT_THROW(decode_places(descending), Error);
  EXPECT_THROW(encode_places(std::vector<HitPlace>{{3, {}, 1, {}}, {2, {}, 1, {}}}), Error);
  EXPECT_THROW(encode_places(std::vector<HitPlace>{{65536, {}, 1, {}}}), Error);
}

/// Replaces a scenario of a store of ten.
std::string with_places(const std::string& path,
                        const std::function<void(std::vector<HitPlace>&)>& change) {
  write_made_up_store(path, 10);
  const StoreHeader header = made_up_header();
  Observation observation = made_up_observation(header, 4);
  change(observation.places);
  Database database(path, Database::Mode::write);
  database.trust();
  database.execute("DELETE FROM observation WHERE number = 4");
  Statement statement = prepare_insert(database, header);
  insert(statement, observation, header);
  return path;
}

TEST(StorePlaces, ThatNoSimulationGivesAreRefused) {
  const tests::TemporaryFolder folder;
  const auto refused = [&](const std::function<void(std::vector<HitPlace>&)>& change) {
    const std::string path = folder / "store";
    std::filesystem::remove(path);
    with_places(path, change);
    return error_of([&] { read_store(path); });
  };
  EXPECT_EQ(refused([](auto&) {}), "");
  EXPECT_EQ(refused([](auto& places) { places.clear(); }), "");
  EXPECT_THAT(refused([](auto& places) { places.back().clip = 1000; }), HasSubstr("damaged"))
      << "a clip that was not tried";
  EXPECT_THAT(refused([](auto& places) { places.back().impulse_ns = -1; }), HasSubstr("damaged"));
  EXPECT_THAT(refused([](auto& places) { places.back().impulse_ns = std::nanf(""); }),
              HasSubstr("damaged"));
  EXPECT_THAT(refused([](auto& places) { places.resize(places.size() + 256, places.back()); }),
              HasSubstr("damaged"))
      << "too many of one trial";
}

TEST(StorePlaces, DoNotStandInAStoreThatKeepsNone) {
  const tests::TemporaryFolder folder;
  StoreHeader header = made_up_header();
  header.keeps_places = false;
  const std::string path = folder / "store";
  {
    StoreWriter writer(path, header, {0, 3});
    writer.append(made_up_observations(header, 0, 3));
    writer.finish();
  }
  EXPECT_THAT(error_of([&] { read_store(path); }), HasSubstr("damaged"));
}

TEST(StorePlaces, DistinguishRuns) {
  const tests::TemporaryFolder folder;
  write_made_up_store(folder / "store", 3);
  StoreHeader header = made_up_header();
  header.keeps_places = false;
  EXPECT_THAT(error_of([&] {
                StoreWriter(folder / "store", header, {0, 5});
              }),
              HasSubstr("store: made with --places; choose another --out"));
}

}  // namespace
}  // namespace flinch::train
