// SPDX-License-Identifier: MIT
#include "database/export/solid_mesh.h"

#include <cmath>
#include <map>
#include <numbers>

namespace flinch::database {
namespace {

// Cosine and sine of i / segments of a quarter turn, exact at both ends.
Eigen::Vector2f quarter(int i, int segments) {
  if (i == 0) return {1, 0};
  if (i == segments) return {0, 1};
  const float angle =
      std::numbers::pi_v<float> / 2 * static_cast<float>(i) / static_cast<float>(segments);
  return {std::cos(angle), std::sin(angle)};
}

// The corner of a box that is nearest to a surface point, and the direction from there.
struct Direction {
  Eigen::Vector3f sign;
  Eigen::Vector3f normal;
};

// A sphere cut by its coordinate planes into eight octants, which move with the corners of the
// core: rows from pole to pole, columns once around. Rows and columns on the cuts occur twice, once
// for each side.
class Grid {
 public:
  explicit Grid(int segments) : segments_(segments) {}

  int rows() const { return 2 * (segments_ + 1); }
  int columns() const { return 4 * (segments_ + 1); }

  Direction at(int row, int column) const {
    const bool is_north = row <= segments_;
    const Eigen::Vector2f latitude =
        is_north ? quarter(segments_ - row, segments_) : quarter(row - segments_ - 1, segments_);
    const Eigen::Vector2f across = quarter(column % (segments_ + 1), segments_);
    const Eigen::Vector2f longitudes[4] = {{across.x(), across.y()},
                                           {-across.y(), across.x()},
                                           {-across.x(), -across.y()},
                                           {across.y(), -across.x()}};
    const int quadrant = column % columns() / (segments_ + 1);
    const Eigen::Vector2f longitude = longitudes[quadrant];
    const float up = is_north ? 1.0F : -1.0F;
    return {{quadrant == 0 || quadrant == 3 ? 1.0F : -1.0F, quadrant < 2 ? 1.0F : -1.0F, up},
            {latitude.x() * longitude.x(), latitude.x() * longitude.y(), up * latitude.y()}};
  }

 private:
  int segments_;
};

// Merges coinciding vertices, and drops triangles without area.
class Welder {
 public:
  std::uint32_t vertex(const Eigen::Vector3f& position, const Eigen::Vector3f& normal) {
    const std::array<float, 6> key{position.x(), position.y(), position.z(),
                                   normal.x(),   normal.y(),   normal.z()};
    const auto [place, is_new] =
        index_.try_emplace(key, static_cast<std::uint32_t>(mesh_.positions.size()));
    if (is_new) {
      mesh_.positions.push_back(position);
      mesh_.normals.push_back(normal);
    }
    return place->second;
  }

  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a != b && b != c && c != a) mesh_.triangles.push_back({a, b, c});
  }

  Mesh mesh() && { return std::move(mesh_); }

 private:
  std::map<std::array<float, 6>, std::uint32_t> index_;
  Mesh mesh_;
};

}  // namespace

Mesh rounded_solid(const Eigen::Vector3f& core, float radius, int segments) {
  const Grid grid(segments);
  Welder welder;
  const auto vertex = [&](int row, int column) {
    const Direction direction = grid.at(row, column);
    return welder.vertex(direction.sign.cwiseProduct(core) + radius * direction.normal,
                         direction.normal);
  };
  for (int row = 0; row + 1 < grid.rows(); ++row) {
    for (int column = 0; column < grid.columns(); ++column) {
      const std::uint32_t above = vertex(row, column);
      const std::uint32_t below = vertex(row + 1, column);
      const std::uint32_t below_next = vertex(row + 1, column + 1);
      welder.triangle(above, below, below_next);
      welder.triangle(above, below_next, vertex(row, column + 1));
    }
  }
  // At the poles the separated octants leave a rectangular hole.
  const int quadrant = segments + 1;
  const int last = grid.rows() - 1;
  welder.triangle(vertex(0, 0), vertex(0, quadrant), vertex(0, 2 * quadrant));
  welder.triangle(vertex(0, 0), vertex(0, 2 * quadrant), vertex(0, 3 * quadrant));
  welder.triangle(vertex(last, 0), vertex(last, 2 * quadrant), vertex(last, quadrant));
  welder.triangle(vertex(last, 0), vertex(last, 3 * quadrant), vertex(last, 2 * quadrant));
  return std::move(welder).mesh();
}

void append(const Mesh& part, const Eigen::Quaternionf& orientation, const Eigen::Vector3f& centre,
            Mesh& whole) {
  const auto first = static_cast<std::uint32_t>(whole.positions.size());
  for (const Eigen::Vector3f& position : part.positions) {
    whole.positions.push_back(orientation * position + centre);
  }
  for (const Eigen::Vector3f& normal : part.normals) {
    whole.normals.push_back((orientation * normal).normalized());
  }
  for (const auto& [a, b, c] : part.triangles) {
    whole.triangles.push_back({first + a, first + b, first + c});
  }
}

}  // namespace flinch::database
