// SPDX-License-Identifier: MIT
// endurance CALLS THREADS SEED: makes CALLS calls of the C interface, good and bad, on each of
// THREADS threads that share one library, and prints what it found as one line. Exits with 1 where
// a property of call_sequence.h does not hold, where memory has grown, or where threads that were
// given the same seed differ.
#include <malloc.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <random>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "database/author/authored_library.h"
#include "motion/default_character.h"
#include "tests/endurance/call_sequence.h"
#include "tests/runtime/made_up_selector.h"

namespace flinch::tests {
namespace {

/// What the allocator and threads may keep, however many calls there are.
constexpr std::int64_t kAllowedGrowth = 16 * 1024;

/// What one thread found.
struct Finding {
  std::string fault;
  std::int64_t calls = 0;
  std::int64_t refused = 0;
  float max_excess = 0;
  float max_unit_error = 0;
  std::uint64_t pose_hash = 0;
};

Finding make_calls(flinch_library* library, std::int64_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  CallSequence sequence(library, [&random] { return static_cast<std::uint32_t>(random()); });
  Finding finding;
  while (finding.calls < count) {
    ++finding.calls;
    if (!sequence.call()) {
      finding.fault = "call " + std::to_string(finding.calls) + ": " + sequence.fault();
      break;
    }
  }
  for (const auto& [status, times] : sequence.statuses()) {
    if (status < 0) finding.refused += times;
  }
  finding.max_excess = sequence.max_excess();
  finding.max_unit_error = sequence.max_unit_error();
  finding.pose_hash = sequence.pose_hash();
  return finding;
}

/// One thread for each finding, all with the same seed.
void make_calls(flinch_library* library, std::int64_t count, std::uint64_t seed,
                std::span<Finding> findings) {
  std::vector<std::thread> threads;
  for (Finding& finding : findings)
    threads.emplace_back([&] { finding = make_calls(library, count, seed); });
  for (std::thread& thread : threads) thread.join();
}

flinch_library* load_library() {
  const std::string file =
      made_up_selector(database::authored_library(motion::default_character()), 60, ModelKind::knn)
          .file();
  flinch_library* library = nullptr;
  return flinch_library_load_memory(file.data(), file.size(), &library) == FLINCH_OK ? library
                                                                                     : nullptr;
}

/// Bytes that the process has allocated and not freed; 0 under sanitizers, which have their own.
std::size_t allocated_bytes() {
  return mallinfo2().uordblks;
}

int run(std::int64_t calls, std::int64_t thread_count, std::uint64_t seed) {
  flinch_library* library = load_library();
  if (library == nullptr) {
    std::fputs("endurance: the selector cannot be loaded\n", stderr);
    return 1;
  }
  std::vector<Finding> findings(static_cast<std::size_t>(thread_count));
  make_calls(library, std::min<std::int64_t>(calls, 1000), seed, findings);  // warms up
  const std::size_t bytes_before = allocated_bytes();
  make_calls(library, calls, seed, findings);
  const auto growth = static_cast<std::int64_t>(allocated_bytes() - bytes_before);
  flinch_library_free(library);

  const Finding& first = findings.front();
  std::printf(
      "%lld calls on each of %lld threads, %lld of them refused; joints at most %.4f rad beyond "
      "their limits; quaternions unit to %.1e; %lld bytes more than before; poses %016llx\n",
      static_cast<long long>(first.calls), static_cast<long long>(thread_count),
      static_cast<long long>(first.refused), static_cast<double>(first.max_excess),
      static_cast<double>(first.max_unit_error), static_cast<long long>(growth),
      static_cast<unsigned long long>(first.pose_hash));
  bool is_good = true;
  for (const Finding& finding : findings) {
    if (!finding.fault.empty()) {
      std::fprintf(stderr, "endurance: %s\n", finding.fault.c_str());
      return 1;
    }
    is_good = is_good && finding.pose_hash == first.pose_hash;
  }
  if (!is_good) std::fputs("endurance: threads with the same seed differ\n", stderr);
  if (growth > kAllowedGrowth)
    std::fprintf(stderr, "endurance: memory has grown by %lld bytes\n",
                 static_cast<long long>(growth));
  return is_good && growth <= kAllowedGrowth ? 0 : 1;
}

}  // namespace
}  // namespace flinch::tests

int main(int argc, char** argv) {
  std::array<std::int64_t, 3> numbers{};
  bool is_usable = argc == 4;
  for (int i = 1; is_usable && i < argc; ++i) {
    const char* end = argv[i] + std::strlen(argv[i]);
    auto& number = numbers[static_cast<std::size_t>(i - 1)];
    const auto [rest, error] = std::from_chars(argv[i], end, number);
    is_usable = error == std::errc() && rest == end && number > 0;
  }
  if (!is_usable) {
    std::fputs("Usage: endurance CALLS THREADS SEED\n", stderr);
    return 2;
  }
  return flinch::tests::run(numbers[0], numbers[1], static_cast<std::uint64_t>(numbers[2]));
}
