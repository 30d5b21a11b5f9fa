// SPDX-License-Identifier: MIT
#include "motion/skin/limb_cage.h"

namespace flinch::motion {
namespace {

using Eigen::Vector3f;

// Front, outward, back, inward.
constexpr LimbRow kLegRows[] = {
    {Role::left_thigh, 0.20F, {1.00F, 0.98F, 1.05F, 0.90F}, 0.10F, 0, Covering::trousers},
    {Role::left_thigh, 0.42F, {0.98F, 0.94F, 0.96F, 0.88F}, 0, 0, Covering::trousers},
    {Role::left_thigh, 0.66F, {0.86F, 0.82F, 0.82F, 0.80F}, 0, 0, Covering::trousers},
    {Role::left_thigh, 0.88F, {0.76F, 0.70F, 0.70F, 0.70F}, 0, 0.08F, Covering::trousers},
    {Role::left_shin, 0.00F, {1.25F, 1.16F, 1.12F, 1.16F}, 0.50F, 0, Covering::trousers},
    {Role::left_shin, 0.11F, {1.16F, 1.12F, 1.18F, 1.12F}, 0.06F, 0, Covering::trousers},
    {Role::left_shin, 0.32F, {1.04F, 1.10F, 1.34F, 1.08F}, 0, 0, Covering::trousers},
    {Role::left_shin, 0.58F, {0.92F, 0.94F, 1.10F, 0.92F}, 0, 0, Covering::trousers},
    {Role::left_shin, 0.80F, {0.88F, 0.88F, 0.96F, 0.86F}, 0, 0, Covering::trousers},
    {Role::left_shin, 0.94F, {0.92F, 0.90F, 0.96F, 0.88F}, 0, 0.15F, Covering::trousers},
    {Role::left_shin, 0.95F, {0.74F, 0.70F, 0.76F, 0.70F}, 0, 0.25F, Covering::trousers},
};

// A ring of the foot: its top and bottom point, forward of the ankle in lengths of the foot and
// above the ground in heights of the ankle; its half width in half widths of the foot's box; the
// weights of shin and toes.
struct FootRow {
  float top_x, top_z, bottom_x, bottom_z, width, shin, toes;
  Covering covering;
};
constexpr FootRow kFootRows[] = {
    {0.140F, 1.14F, -0.160F, 1.00F, 0.76F, 0.30F, 0, Covering::shoes},
    {0.200F, 1.08F, -0.262F, 0.55F, 0.80F, 0.05F, 0, Covering::shoes},
    {0.280F, 0.98F, -0.245F, -0.02F, 0.84F, 0, 0, Covering::shoes},
    {0.380F, 0.86F, 0.060F, -0.02F, 0.92F, 0, 0, Covering::shoes},
    {0.530F, 0.68F, 0.450F, -0.02F, 1.06F, 0, 0.45F, Covering::shoes},
    {0.700F, 0.56F, 0.690F, -0.02F, 0.98F, 0, 1, Covering::shoes},
    {0.765F, 0.38F, 0.770F, 0.04F, 0.70F, 0, 1, Covering::shoes},
};

Ring add_foot_row(const CageGuide& guide, Side side, const FootRow& row, CageBuilder& builder) {
  const FootDimensions foot = measure_foot(guide.character.skeleton, side);
  const Role joint = role_on(side, Role::left_foot);
  const Shape& box = guide.bodies[body_of(joint)].shape;
  const Vector3f ground = guide.joint(joint) - foot.ankle_height * Vector3f::UnitZ();
  const float height = foot.ankle_height;
  const auto at = [&](float x, float z) -> Vector3f {
    return ground + foot.length * x * foot.forward + height * z * Vector3f::UnitZ();
  };
  const Vector3f top = at(row.top_x, row.top_z);
  const Vector3f bottom = at(row.bottom_x, row.bottom_z);
  const Vector3f middle = 0.5F * (top + bottom);
  const Vector3f up = 0.5F * (top - bottom);
  const Vector3f out = sign_of(side) * row.width * box.half_extents.y() *
                       Vector3f::UnitZ().cross(foot.forward).normalized();
  constexpr float kTop = 0.74F;  // of the corners: the instep is round, the sole flat
  constexpr float kSole = 0.92F;
  const Vector3f points[8] = {
      middle + up, middle + kTop * (up + out),   middle + out, middle + kSole * (-up + out),
      middle - up, middle + kSole * (-up - out), middle - out, middle + kTop * (up - out)};
  return builder.add(points, joint_weights({{role_on(side, Role::left_shin), row.shin},
                                            {joint, 1 - row.shin - row.toes},
                                            {role_on(side, Role::left_toes), row.toes}}));
}

}  // namespace

// Seen from outside with the hip below, the rings of the left leg run to the left.
void add_leg(const CageGuide& guide, Side side, const Ring& hip, CageBuilder& builder) {
  const bool is_mirrored = side == Side::left;
  Ring below = hip;
  for (const LimbRow& row : kLegRows) {
    const Ring ring = add_limb_row(guide, side, row, builder);
    builder.join(below, ring, row.covering, is_mirrored);
    below = ring;
  }
  for (const FootRow& row : kFootRows) {
    const Ring ring = add_foot_row(guide, side, row, builder);
    builder.join(below, ring, row.covering, is_mirrored);
    below = ring;
  }
  // The toes' end: three strips between the halves of the last ring.
  for (std::size_t k = 0; k < 3; ++k) {
    builder.face({below[k], below[k + 1], below[6 - k], below[7 - k]}, Covering::shoes,
                 is_mirrored);
  }
}

}  // namespace flinch::motion
