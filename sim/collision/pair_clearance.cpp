// SPDX-License-Identifier: MIT
#include "sim/collision/pair_clearance.h"

#include <array>
#include <limits>

namespace flinch::sim {
namespace {

struct Sphere {
  Eigen::Vector3d centre;
  double radius;
};

constexpr int kMaxSpheres = 9;

/// Spheres inside a part that touch its surface: along a capsule's axis; at a box's corners and,
/// the largest, in its middle.
class InnerSpheres {
 public:
  explicit InnerSpheres(const MovingShape& shape) {
    if (shape.kind == motion::Shape::Kind::capsule) {
      const Eigen::Vector3d axis = shape.orientation * Eigen::Vector3d::UnitZ();
      for (int i = -2; i <= 2; ++i) {
        add({shape.centre + 0.5 * i * shape.half_length * axis, shape.radius});
      }
      return;
    }
    add({shape.centre, shape.half_extents.minCoeff()});
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3d side(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
      add({shape.centre + shape.orientation * shape.half_extents.cwiseProduct(side), 0});
    }
  }

  const Sphere* begin() const { return spheres_.data(); }
  const Sphere* end() const { return spheres_.data() + count_; }

 private:
  void add(const Sphere& sphere) { spheres_[count_++] = sphere; }

  std::array<Sphere, kMaxSpheres> spheres_;
  std::size_t count_ = 0;
};

/// The inner sphere that is nearest to the other part.
struct NearestSphere {
  NearestSphere(const InnerSpheres& spheres, const MovingShape& shape) : sphere(spheres.begin()) {
    for (const Sphere& candidate : spheres) {
      const double candidate_gap = motion::gap(candidate.centre, candidate.radius, shape);
      if (candidate_gap >= gap) continue;
      gap = candidate_gap;
      sphere = &candidate;
    }
  }

  const Sphere* sphere;
  double gap = std::numeric_limits<double>::infinity();
};

}  // namespace

motion::Clearance clearance(const MovingShape& first, const MovingShape& second) {
  const InnerSpheres in_first(first);
  const InnerSpheres in_second(second);
  const NearestSphere on_second(in_first, second);
  const NearestSphere on_first(in_second, first);
  if (on_second.gap <= on_first.gap) {
    return clearance(on_second.sphere->centre, on_second.sphere->radius, second);
  }
  motion::Clearance near = clearance(on_first.sphere->centre, on_first.sphere->radius, first);
  near.normal = -near.normal;
  return near;
}

}  // namespace flinch::sim
