// SPDX-License-Identifier: MIT
#include "evolve/pain/pain_drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "database/export/figure_drawing.h"

namespace flinch::evolve {
namespace {

using database::svg_text;
using Eigen::Vector3f;
using motion::Body;

/// A quadrilateral on the surface of a body.
struct Facet {
  std::array<Vector3f, 4> corners;  // world, counter-clockwise from outside
  PainRegion region;
};

/// A point on a body's surface in the frame of its shape; `u` and `v` in [0, 1] run round a capsule
/// and from its bottom to its top, or across one face of a box.
Vector3f on_capsule(const motion::Shape& shape, float u, float v) {
  const float azimuth = 2 * std::numbers::pi_v<float> * u;
  // The path from pole to pole in parts of equal height: what the patches of a head are bounded by.
  const float height = (2 * v - 1) * (shape.half_length + shape.radius);
  const float in_cap = std::max(std::abs(height) - shape.half_length, 0.0F);
  const float across = std::sqrt(std::max(shape.radius * shape.radius - in_cap * in_cap, 0.0F));
  return {across * std::cos(azimuth), across * std::sin(azimuth), height};
}

Vector3f on_box(const motion::Shape& shape, int face, float u, float v) {
  const int axis = face / 2;
  const float side = face % 2 == 0 ? 1.0F : -1.0F;
  Vector3f unit;
  unit[axis] = side;
  unit[(axis + 1) % 3] = (2 * u - 1) * side;  // keeps the order counter-clockwise from outside
  unit[(axis + 2) % 3] = 2 * v - 1;
  return shape.half_extents.cwiseProduct(unit);
}

class Surface {
 public:
  explicit Surface(const motion::Figure& figure)
      : figure_(figure),
        frames_(
            motion::forward_kinematics(figure.skeleton(), motion::rest_pose(figure.skeleton()))) {}

  /// `fineness` multiplies how many facets a capsule has in either direction.
  std::vector<Facet> facets(Body body, int fineness = 1) const {
    const motion::Shape& shape = figure_.bodies[body].shape;
    std::vector<Facet> all;
    if (shape.kind == motion::Shape::Kind::capsule) {
      const int count = (body == Body::head ? 24 : 16) * fineness;
      add(
          body, count, count, [&](float u, float v) { return on_capsule(shape, u, v); }, all);
    } else {
      for (int face = 0; face < 6; ++face)
        add(
            body, 2, 2, [&](float u, float v) { return on_box(shape, face, u, v); }, all);
    }
    return all;
  }

  std::array<Body, motion::kBodyCount> far_to_near(const Vector3f& toward_eye) const {
    std::array<Body, motion::kBodyCount> order = motion::kBodies;
    std::ranges::stable_sort(order, {}, [&](Body body) {
      return toward_eye.dot(centre_of_mass(figure_.bodies, frames_, body));
    });
    return order;
  }

 private:
  template <class PointAt>
  void add(Body body, int columns, int rows, PointAt point_at, std::vector<Facet>& all) const {
    const motion::Shape& shape = figure_.bodies[body].shape;
    const auto in_joint = [&](float column, float row) {
      return Vector3f(shape.centre +
                      shape.orientation * point_at(column / static_cast<float>(columns),
                                                   row / static_cast<float>(rows)));
    };
    const auto in_world = [&](int column, int row) {
      const motion::Role role = motion::role_of(body);
      return Vector3f(frames_.position[role] +
                      frames_.orientation[role] *
                          in_joint(static_cast<float>(column), static_cast<float>(row)));
    };
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        const Vector3f middle =
            in_joint(static_cast<float>(column) + 0.5F, static_cast<float>(row) + 0.5F);
        all.push_back({{in_world(column, row), in_world(column + 1, row),
                        in_world(column + 1, row + 1), in_world(column, row + 1)},
                       pain_region_at(figure_.bodies, body, middle)});
      }
    }
  }

  const motion::Figure& figure_;
  motion::JointFrames frames_;
};

// From pale to red by the root of the multiplier; regions of equal multipliers look alike.
std::string colour_of(const PainMap& map, PainRegion region) {
  const double most = std::max(*std::ranges::max_element(map.multiplier), 1e-9);
  const double share = std::sqrt(map.multiplier[region] / most);
  return svg_text("hsl(%.0f %.0f%% %.0f%%)", 50 - 50 * share, 60 + 30 * share, 82 - 45 * share);
}

struct View {
  Vector3f right;
  Vector3f toward_eye;
  float scale;      // drawing units per metre
  Vector3f centre;  // of what is shown, world, m
  float x, y;       // where that is on paper
};

/// Draws a convex body: of its facets that face the eye none hides another, so those of a region
/// are one path.
void draw(const std::vector<Facet>& facets, const PainMap& map, const View& view,
          std::string& svg) {
  PerPainRegion<std::string> paths;
  for (const Facet& facet : facets) {
    const Vector3f normal =
        (facet.corners[2] - facet.corners[0]).cross(facet.corners[3] - facet.corners[1]);
    if (normal.dot(view.toward_eye) <= 0) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      const Vector3f from_centre = facet.corners[k] - view.centre;
      paths[facet.region] += svg_text(k == 0 ? "M%.1f %.1f" : "L%.1f %.1f",
                                      view.x + view.scale * view.right.dot(from_centre),
                                      view.y - view.scale * from_centre.z());
    }
    paths[facet.region] += "z";
  }
  for (const PainRegion region : kPainRegions) {
    if (paths[region].empty()) continue;
    const std::string colour = colour_of(map, region);
    svg += "<path fill='" + colour + "' stroke='" + colour + "' d='" + paths[region] + "'/>";
  }
}

std::string legend(const PainMap& map) {
  std::string svg;
  float y = 30;
  for (const PainRegion region : kPainRegions) {
    std::string name(name_of(region));
    std::ranges::replace(name, '_', ' ');
    svg += svg_text("<rect x='20' y='%.0f' width='18' height='14' stroke='#888' fill='%s'/>", y,
                    colour_of(map, region).c_str());
    svg += svg_text(
        "<text x='46' y='%.0f'>%s</text><text x='190' y='%.0f' text-anchor='end'>%g</text>", y + 12,
        name.c_str(), y + 12, map.multiplier[region]);
    y += 22;
  }
  return svg;
}

}  // namespace

std::string pain_svg(const motion::Figure& figure, const PainMap& map) {
  const Surface surface(figure);
  const float stature = motion::stature(figure.skeleton());
  const float scale = 190 * 1.75F / stature;
  const Vector3f middle(0, 0, 0.5F * stature);
  const Vector3f face =
      figure.bodies[Body::head].shape.centre +
      motion::forward_kinematics(figure.skeleton(), motion::rest_pose(figure.skeleton()))
          .position[motion::Role::head];
  std::string svg = std::string(kPainDrawingMark) +
                    "1180 400' font-family='sans-serif' font-size='14'>"
                    "<rect width='1180' height='400' fill='#fff'/><g stroke-width='0.6'>";
  const Vector3f x = Vector3f::UnitX();
  const Vector3f y = Vector3f::UnitY();
  for (const View& view :
       {View{y, x, scale, middle, 390, 200}, View{-y, -x, scale, middle, 750, 200}}) {
    for (const Body body : surface.far_to_near(view.toward_eye))
      draw(surface.facets(body), map, view, svg);
  }
  const std::vector<Facet> head = surface.facets(Body::head, 2);
  draw(head, map, {y, x, 4 * scale, face, 1030, 105}, svg);
  draw(head, map, {-x, y, 4 * scale, face, 1030, 295}, svg);
  svg += "</g>" + legend(map) +
         "<text x='390' y='390' text-anchor='middle'>front</text>"
         "<text x='750' y='390' text-anchor='middle'>back</text></svg>\n";
  return svg;
}

}  // namespace flinch::evolve
