// SPDX-License-Identifier: MIT
#include "database/import/bvh_motion.h"

#include <algorithm>
#include <limits>

namespace flinch::database {
namespace {

/// Tracks how the lines of the motion divide into frames.
///
/// A frame may span several lines and a line may hold several whole frames. A frame that ends in
/// the middle of a line indicates a missing or extra value, unless the whole text was wrapped
/// without regard to frames.
class FrameLines {
 public:
  explicit FrameLines(std::size_t width) : width_(width) {}

  /// Adds one line with `count` > 0 values, the first of which is value `first` of the motion.
  void add(std::size_t line, std::size_t first, std::size_t count) {
    const std::size_t begun = first % width_;
    if (begun == 0) {
      frame_ = {.line = line, .values_on_line = count, .number = first / width_ + 1};
    }
    const bool holds_whole_frames = begun == 0 && count % width_ == 0;
    if (begun + count > width_ && !holds_whole_frames && crossing_.line == 0) crossing_ = frame_;
    if (begun == 0 && count == width_) some_line_is_a_frame_ = true;
  }

  struct Frame {
    std::size_t line = 0;  ///< where it begins, from 1; 0 for no frame
    std::size_t values_on_line = 0;
    std::size_t number = 0;  ///< from 1
  };
  /// The first frame that ends in the middle of a line, if any does.
  const Frame& crossing() const { return crossing_; }
  bool some_line_is_a_frame() const { return some_line_is_a_frame_; }

 private:
  std::size_t width_;
  Frame frame_;
  Frame crossing_;
  bool some_line_is_a_frame_ = false;
};

std::string plural(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

/// Values declared in the header of the motion.
struct Declared {
  std::size_t frames = 0;
  std::size_t frames_line = 0;
  std::size_t channels = 0;
};

Declared parse_motion_header(BvhLexer& lexer, Bvh& bvh) {
  if (!lexer.accept_label("frames")) {
    const std::string found = quoted(lexer.peek_word());
    lexer.fail("expected `Frames:` after MOTION, found " + found);
  }
  const long long frames = lexer.next_whole_number("the number of frames");
  const std::size_t frames_line = lexer.line();
  if (frames < 1 || frames > std::numeric_limits<int>::max()) {
    lexer.fail("declares " + std::to_string(frames) + " frames; there must be at least one");
  }
  bvh.frame_count = static_cast<int>(frames);

  if (!lexer.accept_label("frame") || !lexer.accept_label("time")) {
    const std::string found = quoted(lexer.peek_word());
    lexer.fail("expected `Frame Time:` after the number of frames, found " + found);
  }
  bvh.frame_time_s = lexer.next_number("the frame time");
  if (bvh.frame_time_s <= 0) lexer.fail("the frame time must be above 0 seconds");
  return {.frames = static_cast<std::size_t>(frames),
          .frames_line = frames_line,
          .channels = static_cast<std::size_t>(bvh.channel_count)};
}

[[noreturn]] void fail_at_crossing(const BvhLexer& lexer, const FrameLines::Frame& frame,
                                   const Declared& declared) {
  lexer.fail_at(frame.line, "frame " + std::to_string(frame.number) + " begins with " +
                                plural(frame.values_on_line, "value") + " on this line and ends " +
                                "inside a line, but the CHANNELS of the hierarchy make " +
                                plural(declared.channels, "value") + " a frame");
}

/// The rows that are there, when they are not as many as declared.
struct Found {
  std::size_t frames = 0;            ///< whole ones
  std::size_t values_after = 0;      ///< of a frame that is not whole
  std::size_t last_line = 0;         ///< of the motion
  std::size_t first_line_after = 0;  ///< with values after the last declared frame; 0: none
};

std::string mismatch(const Found& found, const Declared& declared) {
  std::string what = plural(found.frames, "whole frame");
  if (found.values_after > 0) what += " and " + plural(found.values_after, "value") + " of another";
  return what + " of " + plural(declared.channels, "value") + " are there, but line " +
         std::to_string(declared.frames_line) + " declares " + plural(declared.frames, "frame");
}

/// Whether the rows are beyond doubt, so that only the declared number is wrong or the last row cut
/// short. Where most rows are missing, it is the file that is wrong.
bool can_be_read(const Found& found, const FrameLines& lines, const Declared& declared) {
  return lines.some_line_is_a_frame() && 2 * found.frames > declared.frames;
}

[[noreturn]] void fail_with_wrong_count(const BvhLexer& lexer, const Found& found,
                                        const Declared& declared) {
  if (found.first_line_after == 0) {
    lexer.fail_at(found.last_line,
                  mismatch(found, declared) + "; get the whole file or correct that line");
  }
  lexer.fail_at(
      found.first_line_after,
      mismatch(found, declared) + "; correct that line, or the CHANNELS of the hierarchy");
}

std::string note_on_wrong_count(const BvhLexer& lexer, const Found& found,
                                const Declared& declared) {
  return lexer.where(found.last_line) + ": " + mismatch(found, declared) +
         "; the whole frames are read" +
         (found.frames < declared.frames ? ", but the file may be cut short" : "");
}

}  // namespace

void parse_bvh_motion(BvhLexer& lexer, Bvh& bvh) {
  const Declared declared = parse_motion_header(lexer, bvh);
  const std::size_t expected = declared.frames * declared.channels;
  // A value takes at least two bytes of text, so a wrong count cannot reserve more than that.
  bvh.values.reserve(std::min(expected, lexer.bytes_left() / 2 + 1));

  FrameLines lines(declared.channels);
  std::size_t first_line_too_many = 0;
  std::size_t last_line = lexer.line();
  do {
    const std::size_t first = bvh.values.size();
    double value = 0;
    while (lexer.next_number_on_line(value)) bvh.values.push_back(value);
    const std::size_t count = bvh.values.size() - first;
    if (count == 0) continue;
    last_line = lexer.line();
    lines.add(last_line, first, count);
    if (bvh.values.size() > expected && first_line_too_many == 0) first_line_too_many = last_line;
  } while (lexer.next_line());

  const std::size_t found_values = bvh.values.size();
  if (lines.crossing().line != 0) {
    if (found_values != expected || lines.some_line_is_a_frame()) {
      fail_at_crossing(lexer, lines.crossing(), declared);
    }
    bvh.warnings.push_back(lexer.where(lines.crossing().line) +
                           ": lines break without regard to frames; read as one run of values");
  }
  if (found_values == expected) return;
  const Found found{.frames = found_values / declared.channels,
                    .values_after = found_values % declared.channels,
                    .last_line = last_line,
                    .first_line_after = first_line_too_many};
  if (!can_be_read(found, lines, declared)) fail_with_wrong_count(lexer, found, declared);
  bvh.warnings.push_back(note_on_wrong_count(lexer, found, declared));
  bvh.frame_count = static_cast<int>(found.frames);
  bvh.values.resize(found.frames * declared.channels);
}

}  // namespace flinch::database
