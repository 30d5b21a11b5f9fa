// SPDX-License-Identifier: MIT
#include "train/store/store_trials.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>

#include "features/random.h"
#include "motion/error.h"

namespace flinch::train {
namespace {

using motion::Body;

std::vector<std::byte> bytes(std::initializer_list<int> values) {
  std::vector<std::byte> result;
  for (const int value : values) result.push_back(static_cast<std::byte>(value));
  return result;
}

std::vector<Trial> random_trials(features::Random& random) {
  std::vector<Trial> trials(1 + random.index(100));
  int clip = -1;
  for (Trial& trial : trials) {
    clip += 1 + static_cast<int>(random.index(random.index(50) == 0 ? 2047 : 3));
    trial.clip = clip;
    trial.work_j = static_cast<float>(random.uniform(0, 900));
    const std::uint64_t sparsity = 1 + random.index(20);
    for (float& impulse : trial.impulse)
      if (random.index(sparsity) == 0) impulse = static_cast<float>(random.uniform(-1, 20));
  }
  return trials;
}

void expect_same(std::span<const Trial> a, std::span<const Trial> b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].clip, b[i].clip);
    EXPECT_EQ(a[i].work_j, b[i].work_j);
    for (const Body body : motion::kBodies)
      EXPECT_EQ(std::bit_cast<std::uint32_t>(a[i].impulse[body]),
                std::bit_cast<std::uint32_t>(b[i].impulse[body]));
  }
}

TEST(StoreTrials, HaveTheDocumentedBytes) {
  std::vector<Trial> trials(2);
  trials[0].clip = 0;
  trials[1].clip = 300;
  trials[1].work_j = 1.5F;
  trials[1].impulse[Body::head] = 2;
  trials[1].impulse[Body::right_foot] = -0.0F;
  // Steps of 1 and 300: 1 * 32 + 0 hits; 300 * 32 + 2 hits = 9602 = 0x2582.
  EXPECT_EQ(encode_trials(trials), bytes({0x20, 0,    0, 0, 0,    0,     //
                                          0x82, 0x25, 0, 0, 0xC0, 0x3F,  //
                                          4,    0,    0, 0, 0x40,        //
                                          16,   0,    0, 0, 0x80}));
}

TEST(StoreTrials, RoundTripBitForBit) {
  features::Random random(1, features::RandomStream::baseline, 0);
  for (int i = 0; i < 300; ++i) {
    const std::vector<Trial> trials = random_trials(random);
    expect_same(decode_trials(encode_trials(trials)), trials);
  }
  EXPECT_TRUE(decode_trials({}).empty());
}

TEST(StoreTrials, RejectTrialsThatCannotBeEncoded) {
  std::vector<Trial> trials(2);
  trials[0].clip = 5;
  for (const int clip : {5, 4, 5 + 2048}) {
    trials[1].clip = clip;
    EXPECT_THROW(encode_trials(trials), Error) << clip;
  }
  trials[1].clip = 5 + 2047;
  EXPECT_EQ(decode_trials(encode_trials(trials))[1].clip, 5 + 2047);
}

TEST(StoreTrials, DamagedBytesAreRejectedOrDecodeToValidTrials) {
  EXPECT_THROW(decode_trials(bytes({0x20, 0, 0, 0, 0})), Error) << "cut short";
  EXPECT_THROW(decode_trials(bytes({0, 0, 0, 0, 0, 0})), Error) << "no step";
  EXPECT_THROW(decode_trials(bytes({0x21, 0, 0, 0, 0, 0, 17, 0, 0, 0, 0})), Error) << "no body";
  EXPECT_THROW(decode_trials(bytes({0x22, 0, 0, 0, 0, 0, 3, 0, 0, 0, 1, 3, 0, 0, 0, 1})), Error)
      << "a body twice";
  features::Random random(2, features::RandomStream::baseline, 0);
  std::size_t refused = 0;
  for (int i = 0; i < 2000; ++i) {
    std::vector<std::byte> damaged = encode_trials(random_trials(random));
    damaged[random.index(damaged.size())] ^= static_cast<std::byte>(1 + random.index(255));
    if (random.index(4) == 0) damaged.resize(random.index(damaged.size()));
    try {
      for (const Trial& trial : decode_trials(damaged)) EXPECT_GE(trial.clip, 0);
    } catch (const Error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 200U);
}

}  // namespace
}  // namespace flinch::train
