// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "database/import/bvh.h"

namespace flinch::database {

/// The most frames that one source and one clip may have: 4.6 hours at 60 Hz. Bounds what a single
/// number in a text can cost.
inline constexpr int kMaxFrames = 1'000'000;

/// Frame rates of motion capture, Hz. What is outside is a mistake.
inline constexpr double kMinSourceRate_hz = 0.1;
inline constexpr double kMaxSourceRate_hz = 10'000;

/// Frames of a file, numbered from 1; both ends belong to it.
struct FrameRange {
  int first = 1;
  std::optional<int> last{};  ///< none: the file's last
};

/// Reads "A:B", "A:" or ":B". Returns nothing for other text, for A below 1 or B below A.
std::optional<FrameRange> frame_range_from(std::string_view text);

/// Returns the range as frame_range_from reads it.
std::string text_of(const FrameRange& range);

/// Which of a file's frames to use, and how fast they follow each other. None: as in the file.
struct FrameOptions {
  std::optional<double> rate_hz{};  ///< what the file's frame rate really is
  std::optional<FrameRange> range{};
  std::optional<bool> skip_first{};  ///< leaves out frame 1, into which exporters write a T-pose
};

/// Leaves only the frames that the options select, at their rate; first_frame is then the number of
/// frames before them. Throws Error if the file has no such frames, if more than kMaxFrames are
/// left, or if the rate is outside kMinSourceRate_hz to kMaxSourceRate_hz.
void select_frames(Bvh& bvh, const FrameOptions& options);

}  // namespace flinch::database
