// SPDX-License-Identifier: MIT
#include <array>

#include "motion/skin/figure_cage.h"

namespace flinch::motion {
namespace {

using Eigen::Vector3f;

// Half a ring of the head: the middle of the front, five points of the left side, the middle of the
// back. Forward and outward in radii of the head's outline, up in half its height, from its centre.
struct HeadRow {
  float neck;  // weight of the neck, the rest is the head's
  std::array<std::array<float, 3>, 7> points;
};

constexpr HeadRow kJaw{0.5F,
                       {{{0.45F, 0, -0.95F},
                         {0.42F, 0.30F, -0.93F},
                         {0.25F, 0.55F, -0.80F},
                         {-0.15F, 0.62F, -0.62F},
                         {-0.55F, 0.55F, -0.50F},
                         {-0.75F, 0.32F, -0.42F},
                         {-0.80F, 0, -0.40F}}}};
constexpr HeadRow kChin{0.08F,
                        {{{1.12F, 0, -0.95F},
                          {1.00F, 0.26F, -0.93F},
                          {0.56F, 0.65F, -0.74F},
                          {-0.05F, 0.78F, -0.52F},
                          {-0.60F, 0.72F, -0.40F},
                          {-0.93F, 0.40F, -0.30F},
                          {-1.00F, 0, -0.28F}}}};
constexpr HeadRow kMouth{0,
                         {{{1.10F, 0, -0.68F},
                           {1.04F, 0.28F, -0.68F},
                           {0.62F, 0.71F, -0.56F},
                           {-0.05F, 0.86F, -0.40F},
                           {-0.65F, 0.79F, -0.28F},
                           {-1.02F, 0.45F, -0.18F},
                           {-1.12F, 0, -0.16F}}}};
constexpr HeadRow kLip{0,
                       {{{1.14F, 0, -0.46F},
                         {1.08F, 0.24F, -0.48F},
                         {0.68F, 0.74F, -0.40F},
                         {-0.05F, 0.89F, -0.28F},
                         {-0.67F, 0.82F, -0.18F},
                         {-1.05F, 0.47F, -0.10F},
                         {-1.16F, 0, -0.08F}}}};
constexpr HeadRow kNose{0,
                        {{{1.52F, 0, -0.33F},
                          {1.10F, 0.17F, -0.35F},
                          {0.72F, 0.75F, -0.24F},
                          {-0.05F, 0.90F, -0.14F},
                          {-0.68F, 0.84F, -0.06F},
                          {-1.08F, 0.48F, 0.02F},
                          {-1.18F, 0, 0.04F}}}};
constexpr HeadRow kEyes{0,
                        {{{1.14F, 0, 0.06F},
                          {0.98F, 0.18F, 0.02F},
                          {0.76F, 0.70F, 0.02F},
                          {-0.05F, 0.90F, 0.06F},
                          {-0.68F, 0.86F, 0.12F},
                          {-1.10F, 0.50F, 0.17F},
                          {-1.20F, 0, 0.18F}}}};
constexpr HeadRow kBrow{0,
                        {{{1.16F, 0, 0.23F},
                          {1.14F, 0.22F, 0.23F},
                          {0.82F, 0.70F, 0.23F},
                          {-0.05F, 0.90F, 0.26F},
                          {-0.66F, 0.85F, 0.30F},
                          {-1.06F, 0.50F, 0.34F},
                          {-1.16F, 0, 0.35F}}}};
constexpr HeadRow kHairline{0,
                            {{{0.98F, 0, 0.58F},
                              {0.94F, 0.28F, 0.58F},
                              {0.62F, 0.66F, 0.60F},
                              {-0.06F, 0.82F, 0.62F},
                              {-0.56F, 0.76F, 0.62F},
                              {-0.90F, 0.44F, 0.62F},
                              {-1.00F, 0, 0.62F}}}};
constexpr HeadRow kLastRow{0,
                           {{{0.62F, 0, 0.88F},
                             {0.59F, 0.20F, 0.88F},
                             {0.40F, 0.44F, 0.89F},
                             {-0.06F, 0.56F, 0.90F},
                             {-0.44F, 0.50F, 0.89F},
                             {-0.64F, 0.27F, 0.88F},
                             {-0.70F, 0, 0.87F}}}};
constexpr float kCrown[3] = {-0.03F, 0, 1.04F};

class HeadBuilder {
 public:
  HeadBuilder(const CageGuide& guide, CageBuilder& builder)
      : shape_(guide.bodies[Body::head].shape),
        centre_(guide.joint(Role::head) + shape_.centre),
        builder_(builder) {}

  std::uint32_t add(float x, float y, float z, float neck) {
    const float height = shape_.half_length + shape_.radius;
    return builder_.add(centre_ + Vector3f(shape_.radius * x, shape_.radius * y, height * z),
                        joint_weights({{Role::neck, neck}, {Role::head, 1 - neck}}));
  }

  Ring add(const HeadRow& row) {
    Ring ring;
    for (std::size_t k = 0; k < 12; ++k) {
      const auto& [x, y, z] = row.points[k <= 6 ? k : 12 - k];
      ring.push_back(add(x, k <= 6 ? y : -y, z, row.neck));
    }
    return ring;
  }

  // A closed blob around a point, with these half extents.
  void add_blob(const Vector3f& middle, const Vector3f& extents, Covering covering) {
    Ring corners;
    for (int i = 0; i < 8; ++i) {
      const Vector3f sign(i & 1 ? 1.0F : -1.0F, i & 2 ? 1.0F : -1.0F, i & 4 ? 1.0F : -1.0F);
      const Vector3f corner = middle + extents.cwiseProduct(sign);
      corners.push_back(add(corner.x(), corner.y(), corner.z(), 0));
    }
    constexpr std::uint32_t kSides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                            {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& [a, b, c, d] : kSides) {
      builder_.face({corners[a], corners[b], corners[c], corners[d]}, covering, false);
    }
  }

 private:
  const Shape& shape_;
  Vector3f centre_;
  CageBuilder& builder_;
};

}  // namespace

void add_head(const CageGuide& guide, const Ring& neck, CageBuilder& builder) {
  HeadBuilder head(guide, builder);
  Ring below = neck;
  // Hair covers the columns of the back half, as many as are given, from front to back.
  const auto join_next = [&](const HeadRow& row, std::size_t first_hair) {
    const Ring ring = head.add(row);
    for (std::size_t k = 0; k < 12; ++k) {
      const std::size_t column = k < 6 ? k : 11 - k;
      const std::size_t next = (k + 1) % 12;
      builder.face({below[k], below[next], ring[next], ring[k]},
                   column >= first_hair ? Covering::hair : Covering::skin, false);
    }
    below = ring;
  };
  constexpr std::size_t kNoHair = 6;
  join_next(kJaw, kNoHair);
  join_next(kChin, kNoHair);
  join_next(kMouth, 4);
  join_next(kLip, 4);
  join_next(kNose, 4);
  join_next(kEyes, 3);
  join_next(kBrow, 3);
  join_next(kHairline, 2);
  join_next(kLastRow, 0);
  const std::uint32_t crown = head.add(kCrown[0], kCrown[1], kCrown[2], 0);
  for (std::size_t k = 0; k < 12; ++k) {
    builder.face({below[k], below[(k + 1) % 12], crown}, Covering::hair, false);
  }
  for (const Side side : kSides) {
    const float sign = sign_of(side);
    head.add_blob({0.87F, sign * 0.36F, 0.04F}, {0.14F, 0.15F, 0.085F}, Covering::eyes);
    head.add_blob({0.96F, sign * 0.38F, 0.22F}, {0.12F, 0.22F, 0.04F}, Covering::hair);
    head.add_blob({-0.08F, sign * 0.92F, -0.08F}, {0.18F, 0.10F, 0.26F}, Covering::skin);
  }
  head.add_blob({1.05F, 0, -0.63F}, {0.08F, 0.26F, 0.045F}, Covering::lips);
}

}  // namespace flinch::motion
