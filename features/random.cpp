// SPDX-License-Identifier: MIT
#include "features/random.h"

#include <cmath>
#include <utility>

#include "features/portable_math.h"

namespace flinch::features {

std::array<std::uint32_t, 4> philox4x32(std::array<std::uint32_t, 4> counter,
                                        std::array<std::uint32_t, 2> key) {
  constexpr std::uint64_t kMultiplier0 = 0xD2511F53;
  constexpr std::uint64_t kMultiplier1 = 0xCD9E8D57;
  constexpr std::uint32_t kWeyl0 = 0x9E3779B9;  // golden ratio
  constexpr std::uint32_t kWeyl1 = 0xBB67AE85;  // sqrt(3) - 1
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t product0 = kMultiplier0 * counter[0];
    const std::uint64_t product1 = kMultiplier1 * counter[2];
    counter = {static_cast<std::uint32_t>(product1 >> 32) ^ counter[1] ^ key[0],
               static_cast<std::uint32_t>(product1),
               static_cast<std::uint32_t>(product0 >> 32) ^ counter[3] ^ key[1],
               static_cast<std::uint32_t>(product0)};
    key[0] += kWeyl0;
    key[1] += kWeyl1;
  }
  return counter;
}

Random::Random(std::uint64_t seed, RandomStream stream, std::uint64_t substream)
    : seed_(seed), stream_(stream), substream_(substream) {}

std::uint64_t Random::bits() {
  if (used_ == words_.size()) {
    const auto block = philox4x32(
        {block_++, static_cast<std::uint32_t>(stream_), static_cast<std::uint32_t>(substream_),
         static_cast<std::uint32_t>(substream_ >> 32)},
        {static_cast<std::uint32_t>(seed_), static_cast<std::uint32_t>(seed_ >> 32)});
    words_ = {block[0] | std::uint64_t{block[1]} << 32, block[2] | std::uint64_t{block[3]} << 32};
    used_ = 0;
  }
  return words_[used_++];
}

double Random::uniform() {
  return static_cast<double>(bits() >> 11) * 0x1p-53;
}

double Random::uniform(double min, double max) {
  return min + (max - min) * uniform();
}

// Box and Muller (1958): sqrt(-2 ln u) cos(2 pi v), u in (0, 1].
double Random::normal() {
  const double u = 1 - uniform();
  const double v = uniform();
  return std::sqrt(-2 * portable_log(u)) * cos_of_turns(v);
}

std::uint64_t Random::index(std::uint64_t count) {
  // Draws below 2^64 mod count would favour low indices, so they are rejected.
  const std::uint64_t reject_below = (0 - count) % count;
  std::uint64_t draw = bits();
  while (draw < reject_below) draw = bits();
  return draw % count;
}

// Fisher and Yates' shuffle. An index below count is the upper half of count times 32 random bits;
// the lower half tells the draws that must be rejected, which hardly ever takes a division (Lemire
// 2019, "Fast random integer generation in an interval").
void Random::shuffle(std::span<int> items) {
  std::uint64_t word = 0;
  bool has_half = false;
  const auto draw = [&](std::uint32_t count) {
    word = has_half ? word >> 32 : bits();
    has_half = !has_half;
    return std::uint64_t{count} * static_cast<std::uint32_t>(word);
  };
  for (auto count = static_cast<std::uint32_t>(items.size()); count > 1; --count) {
    std::uint64_t product = draw(count);
    if (static_cast<std::uint32_t>(product) < count) {
      const std::uint32_t reject_below = (0 - count) % count;
      while (static_cast<std::uint32_t>(product) < reject_below) product = draw(count);
    }
    std::swap(items[count - 1], items[product >> 32]);
  }
}

}  // namespace flinch::features
