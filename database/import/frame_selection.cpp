// SPDX-License-Identifier: MIT
#include "database/import/frame_selection.h"

#include <charconv>
#include <cstdio>
#include <system_error>

#include "motion/error.h"

namespace flinch::database {
namespace {

std::optional<int> number_from(std::string_view text) {
  int number = 0;
  const char* const end = text.data() + text.size();
  const auto [last, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{} || last != end || number < 1) return std::nullopt;
  return number;
}

std::string shortest(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

void set_rate(Bvh& bvh, const FrameOptions& options) {
  if (options.rate_hz) bvh.frame_time_s = 1 / *options.rate_hz;
  const double rate_hz = 1 / bvh.frame_time_s;
  if (rate_hz >= kMinSourceRate_hz && rate_hz <= kMaxSourceRate_hz) return;
  throw Error(bvh.path, "has " + shortest(bvh.frame_time_s) +
                            " s per frame, which no motion capture has; give its real frame rate, "
                            "in Hz, with --rate-of-file, or rate_of_file in a manifest");
}

// The selected frames as [first, end), from 0.
struct Selected {
  int first = 0;
  int end = 0;
};

Selected selected(const Bvh& bvh, const FrameOptions& options) {
  const FrameRange range = options.range.value_or(FrameRange{});
  Selected frames{range.first - 1, range.last.value_or(bvh.frame_count)};
  if (frames.end > bvh.frame_count || frames.first >= bvh.frame_count) {
    throw Error(bvh.path, "has " + std::to_string(bvh.frame_count) + " frames, so not the frames " +
                              text_of(range));
  }
  if (options.skip_first.value_or(false) && frames.first == 0) frames.first = 1;
  if (frames.first >= frames.end) throw Error(bvh.path, "has no frame after its first");
  return frames;
}

}  // namespace

std::optional<FrameRange> frame_range_from(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos || text.size() == 1) return std::nullopt;
  const std::string_view first = text.substr(0, colon);
  const std::string_view last = text.substr(colon + 1);
  FrameRange range;
  if (!first.empty()) {
    const std::optional<int> number = number_from(first);
    if (!number) return std::nullopt;
    range.first = *number;
  }
  if (!last.empty()) {
    range.last = number_from(last);
    if (!range.last || *range.last < range.first) return std::nullopt;
  }
  return range;
}

std::string text_of(const FrameRange& range) {
  return std::to_string(range.first) + ":" + (range.last ? std::to_string(*range.last) : "");
}

void select_frames(Bvh& bvh, const FrameOptions& options) {
  set_rate(bvh, options);
  const Selected frames = selected(bvh, options);
  const int count = frames.end - frames.first;
  if (count > kMaxFrames) {
    throw Error(bvh.path, "has " + std::to_string(count) + " frames, more than " +
                              std::to_string(kMaxFrames) +
                              " at a time; choose some with --frames A:B, or frames in a manifest");
  }
  if (count == bvh.frame_count) return;
  const auto at = [&](int frame) {
    return bvh.values.begin() + static_cast<std::ptrdiff_t>(frame) * bvh.channel_count;
  };
  bvh.values.erase(at(frames.end), bvh.values.end());
  bvh.values.erase(bvh.values.begin(), at(frames.first));
  bvh.frame_count = count;
  bvh.first_frame += frames.first;
}

}  // namespace flinch::database
