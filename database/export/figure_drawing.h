// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdio>
#include <string>

#include "motion/figure.h"

namespace flinch::database {

/// Drawing units of an SVG per metre.
inline constexpr float kDrawingScale = 100;

/// Axes of a drawing: which direction is right on paper, and which is towards the viewer. Unit,
/// horizontal and perpendicular; Z is up.
struct DrawingView {
  Eigen::Vector3f right;
  Eigen::Vector3f toward_eye;
};

/// Returns a format of printf with its values filled in, at most 511 characters.
std::string svg_text(const char* format, auto... values) {
  std::array<char, 512> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

/// Returns a text as the content of an element.
std::string xml_escaped(const std::string& text);

/// Draws the outlines of a figure's bodies as elements of SVG, the nearer ones over the farther.
/// The world's origin is the drawing's. Left limbs are green, right ones red.
std::string figure_drawing(const motion::Figure& figure, const motion::JointFrames& frames,
                           const DrawingView& view);

/// Draws a threat's path to the centre of its target, which comes from `direction`, radians; a
/// circle where it comes towards the viewer or from behind. Needs the marker "a" in the SVG's
/// definitions, see kArrowMarker.
std::string threat_arrow(const Eigen::Vector3f& target, float direction, const DrawingView& view);

/// Draws a threat as a line as thick as it is, from one end to the other; nothing where it is more
/// than kMaxThreatDistance_m of paper from the world's origin.
std::string threat_drawing(const Eigen::Vector3f& from, const Eigen::Vector3f& to, float radius,
                           const DrawingView& view);
inline constexpr float kMaxThreatDistance_m = 0.75F;  ///< to the side

/// The definitions that threat_arrow needs, once in each document.
inline constexpr const char* kArrowMarker =
    "<defs><marker id='a' orient='auto' viewBox='0 0 6 6' refX='5' refY='3' markerWidth='5' "
    "markerHeight='5'><path d='M0 0L6 3L0 6z' fill='#c00'/></marker></defs>";

}  // namespace flinch::database
