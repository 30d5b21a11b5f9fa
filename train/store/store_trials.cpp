// SPDX-License-Identifier: MIT
#include "train/store/store_trials.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "motion/error.h"

namespace flinch::train {

namespace {

static_assert(std::endian::native == std::endian::little,
              "trials are stored in little-endian order");

constexpr int kImpulseCountBits = 5;  // enough for 17 bodies
constexpr int kImpulseCountMask = (1 << kImpulseCountBits) - 1;
constexpr int kMaxClipStep = (1 << (16 - kImpulseCountBits)) - 1;
constexpr std::size_t kTrialBytes = sizeof(std::uint16_t) + sizeof(float);
constexpr std::size_t kImpulseBytes = sizeof(std::uint8_t) + sizeof(float);
static_assert(motion::kBodyCount <= kImpulseCountMask);
static_assert(kMaxTrialBytes == kTrialBytes + motion::kBodyCount * kImpulseBytes);

/// Only positive zero is left out.
bool is_hit(float impulse) {
  return std::bit_cast<std::uint32_t>(impulse) != 0;
}

template <class T>
void put(std::vector<std::byte>& bytes, T value) {
  const auto* first = reinterpret_cast<const std::byte*>(&value);
  bytes.insert(bytes.end(), first, first + sizeof value);
}

template <class T>
T value_at(std::span<const std::byte> bytes, std::size_t place) {
  T value;
  std::memcpy(&value, bytes.data() + place, sizeof value);
  return value;
}

[[noreturn]] void refuse() {
  throw Error("", "the trials of a scenario are damaged; simulate it again");
}

/// Returns how many trials these bytes hold, reading only the trials' headers.
std::size_t trial_count(std::span<const std::byte> bytes) {
  std::size_t count = 0;
  std::size_t place = 0;
  while (place < bytes.size()) {
    if (bytes.size() - place < kTrialBytes) refuse();
    const auto hits =
        static_cast<std::size_t>(value_at<std::uint16_t>(bytes, place) & kImpulseCountMask);
    place += kTrialBytes + hits * kImpulseBytes;
    ++count;
  }
  if (place != bytes.size()) refuse();
  return count;
}

}  // namespace

std::vector<std::byte> encode_trials(std::span<const Trial> trials) {
  std::vector<std::byte> bytes;
  bytes.reserve(trials.size() * (kTrialBytes + 2 * kImpulseBytes));
  int before = -1;
  for (const Trial& trial : trials) {
    const int step = trial.clip - before;
    if (step < 1 || step > kMaxClipStep)
      throw Error("", "clip " + std::to_string(trial.clip) + " cannot be stored after clip " +
                          std::to_string(before) + "; clips must ascend, by " +
                          std::to_string(kMaxClipStep) + " at most");
    const auto hits = std::ranges::count_if(trial.impulse, is_hit);
    put(bytes, static_cast<std::uint16_t>(step << kImpulseCountBits | static_cast<int>(hits)));
    put(bytes, trial.work_j);
    for (const motion::Body body : motion::kBodies) {
      if (!is_hit(trial.impulse[body])) continue;
      put(bytes, static_cast<std::uint8_t>(body));
      put(bytes, trial.impulse[body]);
    }
    before = trial.clip;
  }
  return bytes;
}

std::vector<Trial> decode_trials(std::span<const std::byte> bytes) {
  std::vector<Trial> trials(trial_count(bytes));
  std::size_t place = 0;
  int clip = -1;
  for (Trial& trial : trials) {
    const int head = value_at<std::uint16_t>(bytes, place);
    if (head >> kImpulseCountBits == 0) refuse();
    clip += head >> kImpulseCountBits;
    trial.clip = clip;
    trial.work_j = value_at<float>(bytes, place + sizeof(std::uint16_t));
    place += kTrialBytes;
    int before = -1;
    for (int hit = 0; hit < (head & kImpulseCountMask); ++hit, place += kImpulseBytes) {
      const int body = value_at<std::uint8_t>(bytes, place);
      if (body <= before || body >= motion::kBodyCount) refuse();
      trial.impulse[static_cast<motion::Body>(body)] = value_at<float>(bytes, place + 1);
      before = body;
    }
  }
  return trials;
}

}  // namespace flinch::train
