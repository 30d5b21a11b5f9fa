// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <random>
#include <span>
#include <string>

#include "database/files/library_writer.h"
#include "database/import/bvh.h"
#include "database/library/library_file.h"
#include "tests/database/library/random_library.h"

namespace flinch::database {
namespace {

/// A minute at 120 Hz of 32 joints in one chain, 99 channels with six digits after the point, as
/// recordings have: about 8 MB.
std::string minute_of_bvh() {
  constexpr int kJoints = 32;
  constexpr int kFrames = 7200;
  std::string text =
      "HIERARCHY\nROOT joint\n{\nOFFSET 0 0 0\nCHANNELS 6 Xposition Yposition "
      "Zposition Zrotation Xrotation Yrotation\n";
  for (int i = 1; i < kJoints; ++i) {
    text += "JOINT joint" + std::to_string(i) +
            "\n{\nOFFSET 0 10.5 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n";
  }
  text += std::string(kJoints, '}') + "\nMOTION\nFrames: " + std::to_string(kFrames) +
          "\nFrame Time: 0.0083333\n";
  std::mt19937 random(1);
  std::uniform_real_distribution<double> degrees(-180, 180);
  for (int frame = 0; frame < kFrames; ++frame) {
    for (int channel = 0; channel < 3 + 3 * kJoints; ++channel) {
      text += std::to_string(degrees(random)) + ' ';
    }
    text += '\n';
  }
  return text;
}

void parse_minute_of_bvh(benchmark::State& state) {
  const std::string text = minute_of_bvh();
  double checksum = 0;
  for (auto _ : state) checksum = parse_bvh(text, "minute").values.back();
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * text.size()));
  state.counters["megabytes"] = static_cast<double>(text.size()) / 1e6;
  state.counters["checksum"] = checksum;
}
BENCHMARK(parse_minute_of_bvh)->Unit(benchmark::kMillisecond);

void forward_kinematics_of_bvh_frame(benchmark::State& state) {
  const Bvh bvh = parse_bvh(minute_of_bvh(), "minute");
  int frame = 0;
  double checksum = 0;
  for (auto _ : state) {
    checksum = forward_kinematics(bvh, frame).position.back().y();
    benchmark::DoNotOptimize(checksum);
    frame = (frame + 1) % bvh.frame_count;
  }
}
BENCHMARK(forward_kinematics_of_bvh_frame)->Unit(benchmark::kMicrosecond);

/// A library of four clips, about 5 minutes of poses at 60 Hz.
void load_library_of_five_minutes(benchmark::State& state) {
  const std::string bytes = library_bytes(tests::random_library(1, 6000));
  ClipLibrary library;
  for (auto _ : state) {
    if (read_library(std::as_bytes(std::span(bytes)), library) != LoadStatus::ok) {
      state.SkipWithError("the library was refused");
    }
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * bytes.size()));
  state.counters["megabytes"] = static_cast<double>(bytes.size()) / 1e6;
}
BENCHMARK(load_library_of_five_minutes)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace flinch::database
