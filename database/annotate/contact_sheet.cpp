// SPDX-License-Identifier: MIT
#include "database/annotate/contact_sheet.h"

#include <array>
#include <cmath>
#include <optional>

#include "database/export/figure_drawing.h"
#include "motion/rotation.h"

namespace flinch::database {
namespace {

constexpr std::size_t kPoses = 8;
constexpr float kLabelWidth = 290;
constexpr float kColumnWidth = 130;
constexpr float kStripHeight = 240;
constexpr float kGroundHeight = 208;  // of the ground line below a strip's top
constexpr float kTitleHeight = 34;
constexpr float kMark_m = 0.5F;
constexpr std::size_t kOnsetColumn = 1;
constexpr std::size_t kPeakColumn = 4;

// From the actor's right and front, 32 degrees from the side: neither a lean to the side nor one
// forward is hidden, and none of the eight directions comes straight at the viewer.
const DrawingView kThreeQuarter{Eigen::Vector3f(0.848F, 0.530F, 0),
                                Eigen::Vector3f(0.530F, -0.848F, 0)};

struct Note {
  std::string text;
  bool is_reason = false;
};

struct Strip {
  std::string name;
  std::vector<Note> notes;
  std::array<double, kPoses> times_s;  // from the start of the file
  std::array<const char*, kPoses> captions{};
  float heading = 0;
  std::optional<Protection> protection;
};

std::array<double, kPoses> times_of_clip(const DraftClip& clip) {
  const double out = clip.peak_s - clip.onset_s;
  const double back = clip.end_s - clip.peak_s;
  return {
      clip.start_s, clip.onset_s,           clip.onset_s + out / 3,     clip.onset_s + 2 * out / 3,
      clip.peak_s,  clip.peak_s + back / 3, clip.peak_s + 2 * back / 3, clip.end_s};
}

std::array<double, kPoses> even_times(double start_s, double end_s) {
  std::array<double, kPoses> times{};
  for (std::size_t i = 0; i < kPoses; ++i) {
    times[i] = start_s + (end_s - start_s) * static_cast<double>(i) / (kPoses - 1);
  }
  return times;
}

// A guess, and below it the reason.
template <class Value>
void add_guess(std::vector<Note>& notes, const std::string& what, const std::string& value,
               const Guess<Value>& guess) {
  notes.push_back(
      {what + " " + value + svg_text(" (%.2f)", static_cast<double>(guess.confidence))});
  notes.push_back({guess.reason, true});
}

Strip idle_strip(const DraftIdle& idle) {
  Strip strip;
  strip.name = "idle";
  strip.notes = {
      {svg_text("%.2f s (%.2f)", idle.end_s - idle.start_s, static_cast<double>(idle.confidence))},
      {idle.reason, true}};
  strip.times_s = even_times(idle.start_s, idle.end_s);
  strip.captions.front() = "start";
  strip.captions.back() = "end";
  strip.heading = idle.heading;
  return strip;
}

Strip clip_strip(const DraftClip& clip) {
  const Protection& protection = clip.protection;
  Strip strip;
  strip.name = clip.name;
  add_guess(strip.notes, "kind", std::string(name_of(clip.kind.value)), clip.kind);
  add_guess(strip.notes, "target", std::string(motion::name_of(protection.target.value)),
            protection.target);
  add_guess(strip.notes, "direction",
            std::to_string(whole_degrees(protection.direction.value)) + "\u00B0",
            protection.direction);
  strip.notes.push_back({"degree " + std::string(motion::name_of(protection.degree))});
  strip.times_s = times_of_clip(clip);
  strip.captions = {"start", clip.kind.value == MovementKind::push ? "contact" : "onset"};
  strip.captions[kPeakColumn] = "peak";
  strip.captions.back() = "end";
  strip.heading = clip.heading;
  strip.protection = protection;
  return strip;
}

motion::Pose pose_at(const Take& take, double time_s) {
  return motion::sample(take.motion, static_cast<float>(time_s - take.start_s));
}

// The marks on the ground in a column: the figure stands `gone` to the right of where it started.
std::string ground(float gone) {
  const float half = kColumnWidth / 2;
  std::string marks = svg_text("<path d='M%.0f 1H%.0f", -half, half);
  const float spacing = kDrawingScale * kMark_m * kThreeQuarter.right.x();
  const float offset = std::remainder(-kDrawingScale * gone, spacing);
  for (float x = offset - 4 * spacing; x < half; x += spacing) {
    if (std::abs(x) < half) marks += svg_text("M%.1f 1v7", x);
  }
  return marks + "' stroke='#888'/>";
}

std::string column(const Take& take, const Strip& strip, std::size_t index) {
  const motion::Pose first = pose_at(take, strip.times_s.front());
  const float yaw = -(motion::facing(first) + strip.heading);
  motion::Pose pose =
      motion::placed(pose_at(take, strip.times_s[index]), yaw, Eigen::Vector3f::Zero());
  const Eigen::Vector3f start =
      motion::rotation_about(Eigen::Vector3f::UnitZ(), yaw) * first.root_position;
  const Eigen::Vector3f travel = pose.root_position - start;
  pose.root_position.head<2>().setZero();
  const motion::JointFrames frames = motion::forward_kinematics(take.figure.skeleton(), pose);
  std::string drawing =
      ground(kThreeQuarter.right.dot(travel)) + figure_drawing(take.figure, frames, kThreeQuarter);
  if (strip.protection && index == kPeakColumn) {
    drawing += threat_arrow(
        motion::target_centre(take.figure.bodies, frames, strip.protection->target.value),
        strip.protection->direction.value, kThreeQuarter);
  }
  drawing += svg_text("<text y='19' fill='#333' text-anchor='middle'>%s%s%.2f</text>",
                      strip.captions[index] ? strip.captions[index] : "",
                      strip.captions[index] ? " " : "", strip.times_s[index]);
  return drawing;
}

std::string strip_drawing(const Take& take, const Strip& strip, float top) {
  std::string drawing = svg_text("<g transform='translate(0 %.0f)'>", top);
  if (strip.protection) {
    for (const std::size_t index : {kOnsetColumn, kPeakColumn}) {
      drawing += svg_text("<rect x='%.0f' y='6' width='%.0f' height='%.0f' fill='%s'/>",
                          kLabelWidth + kColumnWidth * static_cast<float>(index), kColumnWidth,
                          kStripHeight - 10, index == kPeakColumn ? "#fbe9e4" : "#eef5ec");
    }
  }
  drawing += "<text x='12' y='26' font-size='14' font-weight='bold'>" + xml_escaped(strip.name) +
             "</text>";
  float y = 48;
  for (const Note& text : strip.notes) {
    drawing += svg_text("<text x='%d' y='%.0f' fill='%s'>", text.is_reason ? 24 : 12, y,
                        text.is_reason ? "#888" : "#333") +
               xml_escaped(text.text) + "</text>";
    y += 17;
  }
  for (std::size_t index = 0; index < kPoses; ++index) {
    drawing +=
        svg_text("<g transform='translate(%.0f %.0f)' stroke-linecap='round' fill='none'>",
                 kLabelWidth + kColumnWidth * (static_cast<float>(index) + 0.5F), kGroundHeight) +
        column(take, strip, index) + "</g>";
  }
  return drawing + svg_text("<path d='M0 %.0fH%.0f' stroke='#ddd'/></g>", kStripHeight,
                            kLabelWidth + kColumnWidth * kPoses);
}

}  // namespace

std::string contact_sheet_svg(const Take& take, const Draft& draft) {
  std::vector<Strip> strips{idle_strip(draft.idle)};
  for (const DraftClip& clip : draft.clips) strips.push_back(clip_strip(clip));
  const float width = kLabelWidth + kColumnWidth * kPoses;
  std::string svg = svg_text(
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 %.0f %.0f' font-family='sans-serif' "
      "font-size='12'>",
      width, kTitleHeight + kStripHeight * static_cast<float>(strips.size()));
  svg += std::string(kArrowMarker) + "<rect width='100%' height='100%' fill='#fff'/>";
  svg += "<text x='12' y='22' font-size='15'>" + xml_escaped(take.source.path) +
         svg_text(": %zu clips; times in s, confidence in brackets</text>", draft.clips.size());
  float top = kTitleHeight;
  for (const Strip& strip : strips) {
    svg += strip_drawing(take, strip, top);
    top += kStripHeight;
  }
  return svg + "</svg>\n";
}

}  // namespace flinch::database
