// SPDX-License-Identifier: MIT
// The BVH reader, and what an import finds out about a file: roles, units, axes, calibration.
#include <algorithm>
#include <cmath>
#include <utility>

#include "database/import/source_motion.h"
#include "motion/error.h"
#include "tests/fuzz/fuzz.h"

namespace {

using flinch::tests::require;

void read(std::string_view text) {
  flinch::database::Bvh bvh = flinch::database::parse_bvh(text, "input.bvh");
  require(bvh.frame_count >= 1 && bvh.channel_count >= 1, "there are frames and channels");
  require(bvh.values.size() == static_cast<std::size_t>(bvh.frame_count) *
                                   static_cast<std::size_t>(bvh.channel_count),
          "there is a value for each channel of each frame");
  require(bvh.frame_time_s > 0 && std::isfinite(bvh.frame_time_s), "the frame time is positive");
  require(std::ranges::all_of(bvh.values, [](double x) { return std::isfinite(x); }),
          "values are finite");
  const flinch::database::Source source = analyse_source(std::move(bvh));
  const flinch::database::SourceMotion motion = source_motion(source);
  require(motion.frames.size() == static_cast<std::size_t>(source.bvh.frame_count),
          "every frame is analysed");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    read(flinch::tests::text_of(data, size));
  } catch (const flinch::Error&) {
  }
  return 0;
}
