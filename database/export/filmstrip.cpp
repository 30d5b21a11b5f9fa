// SPDX-License-Identifier: MIT
#include "database/export/filmstrip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "motion/body_distance.h"

namespace flinch::database {
namespace {

using motion::Body;
using motion::JointFrames;
using motion::Shape;

constexpr int kInstants = 8;
constexpr float kScale = 100;  // drawing units per metre
constexpr float kColumn = 150;
constexpr float kRow = 230;
constexpr float kGround = 205;  // height of the ground line within a row

// Axes of one of the two views: which direction is right, and which is towards the viewer.
struct View {
  Eigen::Vector3f right;
  Eigen::Vector3f toward_eye;
};
const std::array<View, 2> kViews{{{Eigen::Vector3f::UnitX(), -Eigen::Vector3f::UnitY()},
                                  {Eigen::Vector3f::UnitY(), Eigen::Vector3f::UnitX()}}};

std::string printed(const char* format, auto... values) {
  std::array<char, 512> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

Eigen::Vector2f on_paper(const View& view, const Eigen::Vector3f& point) {
  return {kScale * view.right.dot(point), -kScale * point.z()};
}

// The near side is darker, to distinguish left from right.
const char* colour_of(Body body, const View& view) {
  const std::string_view name = motion::name_of(body);
  const bool left = name.starts_with("left");
  const bool right = name.starts_with("right");
  if (body == Body::head) return "#d9a06b";
  if (!left && !right) return "#5b7fa6";
  if (view.toward_eye.x() > 0.5F) return left ? "#3c8d5a" : "#b5533c";
  return left ? "#3c8d5a88" : "#b5533c";
}

std::string capsule_line(const View& view, const motion::Capsule& capsule, const char* colour) {
  const Eigen::Vector2f a = on_paper(view, capsule.from);
  const Eigen::Vector2f b = on_paper(view, capsule.to);
  return printed("<path d='M%.0f %.0fL%.0f %.0f' stroke='%s' stroke-width='%.0f'/>", a.x(), a.y(),
                 b.x() + 0.1F, b.y(), colour, std::max(2 * kScale * capsule.radius, 3.0F));
}

// The silhouette of a box's eight corners, by gift wrapping.
std::string box_outline(const View& view, const std::array<Eigen::Vector3f, 8>& corners,
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
        printed(turn == 0 ? "M%.0f %.0f" : "L%.0f %.0f", points[current].x(), points[current].y());
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

// Bodies from far to near.
std::string figure_drawing(const motion::Figure& figure, const JointFrames& frames,
                           const View& view) {
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

// Path of the threat to the centre of its target, from one metre away to a third of a metre.
std::string arrow(const Eigen::Vector3f& target, float direction, const View& view) {
  const Eigen::Vector3f from(std::cos(direction), std::sin(direction), 0);
  const Eigen::Vector2f tail = on_paper(view, target + 0.7F * from);
  const Eigen::Vector2f tip = on_paper(view, target + 0.35F * from);
  if ((tail - tip).norm() < 5) {  // towards the viewer or away
    return printed("<circle cx='%.0f' cy='%.0f' r='10' stroke='#c00' stroke-width='1.5'/>", tip.x(),
                   tip.y());
  }
  return printed(
      "<path d='M%.0f %.0fL%.0f %.0f' stroke='#c00' stroke-width='2' marker-end='url(#a)'/>",
      tail.x(), tail.y(), tip.x(), tip.y());
}

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

}  // namespace

std::string filmstrip_svg(const motion::Figure& figure, const motion::Clip& clip) {
  std::string svg = printed(
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 %.0f %.0f' font-family='sans-serif' "
      "font-size='11'><defs><marker id='a' orient='auto' viewBox='0 0 6 6' refX='5' refY='3' "
      "markerWidth='5' markerHeight='5'><path d='M0 0L6 3L0 6z' fill='#c00'/></marker></defs>"
      "<rect width='100%%' height='100%%' fill='#fff'/>",
      kColumn * kInstants, 2 * kRow);
  svg += "<text x='6' y='14'>" + clip.name + "</text>";
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
          printed("<g transform='translate(%.0f %.0f)' stroke-linecap='round' fill='none'>", x, y);
      svg += "<path d='M-70 1H70' stroke='#bbb'/>";
      svg += figure_drawing(figure, frames, kViews[row]);
      if (clip.annotation) {
        svg += arrow(motion::target_centre(figure.bodies, first, clip.annotation->target),
                     clip.annotation->direction, kViews[row]);
      }
      svg += printed("<text x='-10' y='16' fill='#333'>%.2f</text></g>", times[column]);
    }
  }
  return svg + "</svg>\n";
}

}  // namespace flinch::database
