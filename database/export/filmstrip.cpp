// SPDX-License-Identifier: MIT
#include "database/export/filmstrip.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "database/export/figure_drawing.h"

namespace flinch::database {
namespace {

using motion::JointFrames;

constexpr int kInstants = 8;
constexpr float kColumn = 150;
constexpr float kRow = 230;
constexpr float kGround = 205;  // height of the ground line within a row

const std::array<DrawingView, 2> kViews{{{Eigen::Vector3f::UnitX(), -Eigen::Vector3f::UnitY()},
                                         {Eigen::Vector3f::UnitY(), Eigen::Vector3f::UnitX()}}};

std::array<float, kInstants> instants_of(const motion::Clip& clip) {
  std::array<float, kInstants> times{};
  const float end = clip.motion.duration_s();
  const float peak = clip.annotation ? clip.annotation->peak_s : 0.5F * end;
  for (std::size_t i = 0; i < kInstants; ++i) {
    const auto part = static_cast<float>(i);
    times[i] = i <= 4 ? peak * part / 4 : peak + (end - peak) * (part - 4) / 3;
  }
  return times;
}

/// The threat at a time, if it is visible and in the figure's column.
std::string threat_at(const BallTrack& threat, const motion::Clip& clip, float time_s,
                      const DrawingView& view) {
  const auto last = static_cast<float>(threat.positions.size() - 1);
  const auto pose =
      static_cast<std::size_t>(std::lround(std::clamp(time_s * clip.motion.rate_hz, 0.0F, last)));
  const std::optional<Eigen::Vector3f>& centre = threat.positions[pose];
  if (!centre) return "";
  const Eigen::Vector3f half = threat.axes.empty()
                                   ? Eigen::Vector3f(Eigen::Vector3f::Zero())
                                   : Eigen::Vector3f(threat.half_length * threat.axes[pose]);
  return threat_drawing(*centre - half, *centre + half, threat.radius, view);
}

}  // namespace

std::string filmstrip_svg(const motion::Figure& figure, const motion::Clip& clip,
                          const BallTrack* threat) {
  std::string svg = svg_text(
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 %.0f %.0f' font-family='sans-serif' "
      "font-size='11'>",
      kColumn * kInstants, 2 * kRow);
  svg += std::string(kArrowMarker) + "<rect width='100%' height='100%' fill='#fff'/>";
  svg += "<text x='6' y='14'>" + xml_escaped(clip.name) + "</text>";
  const std::array<float, kInstants> times = instants_of(clip);
  const JointFrames first =
      motion::forward_kinematics(figure.skeleton(), clip.motion.poses.front());
  for (std::size_t row = 0; row < kViews.size(); ++row) {
    for (std::size_t column = 0; column < times.size(); ++column) {
      const JointFrames frames =
          motion::forward_kinematics(figure.skeleton(), motion::sample(clip.motion, times[column]));
      const float x = kColumn * (static_cast<float>(column) + 0.5F);
      const float y = kRow * static_cast<float>(row) + kGround;
      svg +=
          svg_text("<g transform='translate(%.0f %.0f)' stroke-linecap='round' fill='none'>", x, y);
      svg += "<path d='M-70 1H70' stroke='#bbb'/>";
      svg += figure_drawing(figure, frames, kViews[row]);
      if (clip.annotation) {
        svg += threat_arrow(motion::target_centre(figure.bodies, first, clip.annotation->target),
                            clip.annotation->direction, kViews[row]);
      }
      if (threat) svg += threat_at(*threat, clip, times[column], kViews[row]);
      svg += svg_text("<text x='-10' y='16' fill='#333'>%.2f</text></g>", times[column]);
    }
  }
  return svg + "</svg>\n";
}

}  // namespace flinch::database
