// SPDX-License-Identifier: MIT
#include "database/annotate/draft_toml.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "database/files/toml_string.h"
#include "motion/rotation.h"

namespace flinch::database {
namespace {

std::string decimal(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

// The shortest number that reads as the same double.
std::string exact_decimal(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

// One line; a comment starts in a column of its own.
std::string line(const std::string& key, const std::string& value,
                 const std::string& comment = "") {
  std::string text = key + " = " + value;
  if (!comment.empty()) {
    text.resize(std::max<std::size_t>(text.size() + 2, 28), ' ');
    text += "# " + comment;
  }
  return text + "\n";
}

std::string time_line(const std::string& key, double time_s, const std::string& comment = "") {
  return line(key, decimal(time_s, 3), comment);
}

template <class Value>
std::string why(const Guess<Value>& guess) {
  return decimal(static_cast<double>(guess.confidence), 2) + ": " + guess.reason;
}

std::string heading_line(float heading) {
  return line("heading", decimal(static_cast<double>(motion::degrees(heading)), 1),
              "from the pelvis' facing to the head's");
}

std::string direction_line(const Guess<float>& direction) {
  return line("direction", std::to_string(whole_degrees(direction.value)), why(direction));
}

std::string idle_text(const DraftIdle& idle, const DraftPaths& paths) {
  return "[[idle]]\n" + line("name", "\"idle\"") + line("file", toml_string(paths.take)) +
         time_line("start", idle.start_s,
                   decimal(static_cast<double>(idle.confidence), 2) + ": " + idle.reason) +
         time_line("end", idle.end_s) + heading_line(idle.heading);
}

std::string push_text(const DraftClip& clip, const DraftPaths& paths) {
  const bool strong = clip.protection.degree == motion::Degree::exaggerated;
  return "[[push]]                    # " + why(clip.kind) + "\n" +
         line("name", toml_string(clip.name)) + line("file", toml_string(paths.take)) +
         time_line("start", clip.start_s) + time_line("end", clip.end_s) +
         time_line("contact", clip.onset_s, "the chest begins to move") +
         direction_line(clip.protection.direction) +
         line("strength", strong ? "\"strong\"" : "\"mild\"") + heading_line(clip.heading);
}

std::string clip_text(const DraftClip& clip, const DraftPaths& paths) {
  if (clip.kind.value == MovementKind::push) return push_text(clip, paths);
  const Protection& protection = clip.protection;
  return "[[clip]]\n" + line("name", toml_string(clip.name)) +
         line("file", toml_string(paths.take)) + time_line("start", clip.start_s) +
         time_line("onset", clip.onset_s) + time_line("peak", clip.peak_s) +
         time_line("end", clip.end_s) +
         line("kind", toml_string(std::string(name_of(clip.kind.value))), why(clip.kind)) +
         line("target", toml_string(std::string(motion::name_of(protection.target.value))),
              why(protection.target)) +
         direction_line(protection.direction) +
         line("degree", toml_string(std::string(motion::name_of(protection.degree)))) +
         heading_line(clip.heading);
}

std::string frames_text(const FrameOptions& options) {
  std::string text;
  if (options.rate_hz) text += line("rate_of_file", exact_decimal(*options.rate_hz));
  if (options.range) text += line("frames", toml_string(text_of(*options.range)));
  if (options.skip_first) text += line("skip_first", *options.skip_first ? "true" : "false");
  return text;
}

std::string source_text(const DraftPaths& paths, const SourceOptions& options) {
  std::string text;
  if (options.unit) text += line("units", toml_string(std::string(name_of(*options.unit))));
  if (options.up) text += line("up", toml_string(std::string(name_of(*options.up))));
  if (!paths.rest.empty()) text += line("rest", toml_string(paths.rest));
  text += frames_text(options.frames);
  if (!options.roles.empty()) {
    text += "roles = {";
    const char* separator = " ";
    for (const auto& [role, joint] : options.roles) {
      text += separator + std::string(motion::name_of(role)) + " = " + toml_string(joint);
      separator = ", ";
    }
    text += " }\n";
  }
  return text.empty() ? "" : "\n[source." + toml_string(paths.take) + "]\n" + text;
}

}  // namespace

std::string draft_toml(const Draft& draft, const DraftPaths& paths, const SourceOptions& options) {
  std::string text =
      "# Drafted from a take by flinch annotate; times in seconds, angles in degrees. Each guess "
      "has\n"
      "# its confidence, from 0 to 1, and its reason beside it. Look at the contact sheet,\n"
      "# " +
      toml_string(paths.sheet) + ": correct what is wrong, delete what is no clip.\n\n";
  text += idle_text(draft.idle, paths);
  for (const DraftClip& clip : draft.clips) {
    text += "\n";
    text += clip_text(clip, paths);
  }
  return text + source_text(paths, options);
}

}  // namespace flinch::database
