// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace flinch::features {

/// Philox4x32-10 of Salmon, Moraes, Dror and Shaw (2011), "Parallel random numbers: as easy as 1,
/// 2, 3": a keyed bijection of 128-bit counters with random-looking output. Stateless: the same
/// counter and key give the same four words on every machine.
std::array<std::uint32_t, 4> philox4x32(std::array<std::uint32_t, 4> counter,
                                        std::array<std::uint32_t, 2> key);

/// Purpose of a stream of random numbers. Draws from one stream do not affect the others.
enum class RandomStream : std::uint32_t {
  scenario,
  baseline,
  bootstrap,
  cross_validation,
  perception,
  fitting,
  noise,
  evolution,
  threat_grid,
  realism,
  motion_walk
};

/// The random numbers of one (seed, stream, substream), in order. Scenarios use their number as the
/// substream, so that a scenario does not depend on which others are drawn, or by which thread.
/// Uses no distributions of the standard library, whose results differ between implementations.
class Random {
 public:
  Random(std::uint64_t seed, RandomStream stream, std::uint64_t substream);

  /// Returns 64 uniformly random bits.
  std::uint64_t bits();
  /// Returns a number uniform in [0, 1): the upper 53 bits as a fraction, so every value is exact.
  double uniform();
  /// Returns a number uniform in [min, max).
  double uniform(double min, double max);
  /// Returns a normally distributed number with mean 0 and standard deviation 1, from two uniform
  /// draws.
  double normal();
  /// Returns an index uniform in [0, count), without bias. `count` is positive.
  std::uint64_t index(std::uint64_t count);
  /// Reorders fewer than 2^32 items; all orders are equally likely. Cheaper than index() per item,
  /// as one block of the generator serves four.
  void shuffle(std::span<int> items);

 private:
  std::uint64_t seed_;
  RandomStream stream_;
  std::uint64_t substream_;
  std::uint32_t block_ = 0;  ///< number of the next block of four words
  std::array<std::uint64_t, 2> words_{};
  std::size_t used_ = 2;  ///< of words_
};

}  // namespace flinch::features
