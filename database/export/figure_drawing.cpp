// SPDX-License-Identifier: MIT
#include "database/export/figure_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "motion/body_distance.h"

namespace flinch::database {
namespace {

using motion::Body;
using motion::JointFrames;
using motion::Shape;

Eigen::Vector2f on_paper(const DrawingView& view, const Eigen::Vector3f& point) {
  return {kDrawingScale * view.right.dot(point), -kDrawingScale * point.z()};
}

// The near side is darker, to distinguish left from right.
const char* colour_of(Body body, const DrawingView& view) {
  const std::string_view name = motion::name_of(body);
  const bool left = name.starts_with("left");
  const bool right = name.starts_with("right");
  if (body == Body::head) return "#d9a06b";
  if (!left && !right) return "#5b7fa6";
  if (view.toward_eye.x() > 0.5F) return left ? "#3c8d5a" : "#b5533c";
  return left ? "#3c8d5a88" : "#b5533c";
}

std::string capsule_line(const DrawingView& view, const motion::Capsule& capsule,
                         const char* colour) {
  const Eigen::Vector2f a = on_paper(view, capsule.from);
  const Eigen::Vector2f b = on_paper(view, capsule.to);
  return svg_text("<path d='M%.0f %.0fL%.0f %.0f' stroke='%s' stroke-width='%.0f'/>", a.x(), a.y(),
                  b.x() + 0.1F, b.y(), colour, std::max(2 * kDrawingScale * capsule.radius, 3.0F));
}

// The silhouette of a box's eight corners, by gift wrapping.
std::string box_outline(const DrawingView& view, const std::array<Eigen::Vector3f, 8>& corners,
                        const char* colour) {
  std::vector<Eigen::Vector2f> points;
  for (const Eigen::Vector3f& corner : corners) points.push_back(on_paper(view, corner));
  std::size_t start = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i].x() < points[start].x()) start = i;
  }
  std::string path = "<path stroke='none' fill='" + std::string(colour) + "' d='";
  std::size_t current = start;
  for (std::size_t turn = 0; turn < points.size(); ++turn) {
    path +=
        svg_text(turn == 0 ? "M%.0f %.0f" : "L%.0f %.0f", points[current].x(), points[current].y());
    std::size_t next = (current + 1) % points.size();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector2f a = points[next] - points[current];
      const Eigen::Vector2f b = points[i] - points[current];
      if (a.x() * b.y() - a.y() * b.x() < 0) next = i;
    }
    current = next;
    if (current == start) break;
  }
  return path + "z'/>";
}

std::array<Eigen::Vector3f, 8> corners_of(const motion::Figure& figure, const JointFrames& frames,
                                          Body body) {
  const Shape& shape = figure.bodies[body].shape;
  const motion::Role role = motion::role_of(body);
  std::array<Eigen::Vector3f, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector3f signs((i & 1U) != 0 ? 1.0F : -1.0F, (i & 2U) != 0 ? 1.0F : -1.0F,
                                (i & 4U) != 0 ? 1.0F : -1.0F);
    const Eigen::Vector3f local =
        shape.centre + shape.orientation * shape.half_extents.cwiseProduct(signs);
    corners[i] = frames.position[role] + frames.orientation[role] * local;
  }
  return corners;
}

}  // namespace

std::string xml_escaped(const std::string& text) {
  std::string escaped;
  for (const char character : text) {
    switch (character) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      default:
        escaped += character;
    }
  }
  return escaped;
}

std::string figure_drawing(const motion::Figure& figure, const JointFrames& frames,
                           const DrawingView& view) {
  // Bodies from far to near.
  std::array<Body, motion::kBodyCount> order = motion::kBodies;
  const auto nearness = [&](Body body) {
    return view.toward_eye.dot(motion::centre_of_mass(figure.bodies, frames, body));
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](Body a, Body b) { return nearness(a) < nearness(b); });
  std::string drawing;
  for (Body body : order) {
    const char* colour = colour_of(body, view);
    drawing += figure.bodies[body].shape.kind == Shape::Kind::capsule
                   ? capsule_line(view, capsule_of(figure, frames, body), colour)
                   : box_outline(view, corners_of(figure, frames, body), colour);
  }
  return drawing;
}

std::string threat_drawing(const Eigen::Vector3f& from, const Eigen::Vector3f& to, float radius,
                           const DrawingView& view) {
  const Eigen::Vector2f a = on_paper(view, from);
  const Eigen::Vector2f b = on_paper(view, to);
  if (std::abs(a.x() + b.x()) > 2 * kMaxThreatDistance_m * kDrawingScale) return "";
  constexpr float kMinWidth = 7;  // of the point of a knife, too
  // A line of no length is drawn as a dot by its round ends.
  return svg_text("<path d='M%.0f %.0fL%.2f %.2f' stroke='#e08010' stroke-width='%.1f'/>", a.x(),
                  a.y(), b.x() + 0.01F, b.y(), std::max(2 * radius * kDrawingScale, kMinWidth));
}

std::string threat_arrow(const Eigen::Vector3f& target, float direction, const DrawingView& view) {
  const Eigen::Vector3f from(std::cos(direction), std::sin(direction), 0);
  const Eigen::Vector2f tail = on_paper(view, target + 0.7F * from);
  const Eigen::Vector2f tip = on_paper(view, target + 0.35F * from);
  if ((tail - tip).norm() < 5) {  // towards the viewer or away
    return svg_text("<circle cx='%.0f' cy='%.0f' r='10' stroke='#c00' stroke-width='1.5'/>",
                    tip.x(), tip.y());
  }
  return svg_text(
      "<path d='M%.0f %.0fL%.0f %.0f' stroke='#c00' stroke-width='2' marker-end='url(#a)'/>",
      tail.x(), tail.y(), tip.x(), tip.y());
}

}  // namespace flinch::database
