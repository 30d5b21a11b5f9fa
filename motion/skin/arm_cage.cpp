// SPDX-License-Identifier: MIT
#include "motion/skin/limb_cage.h"

namespace flinch::motion {
namespace {

using Eigen::Vector3f;

// Front, up, back, down; shirt to the middle of the upper arm.
constexpr LimbRow kArmRows[] = {
    {Role::left_upper_arm, 0.14F, {1.20F, 1.22F, 1.25F, 1.15F}, 0.12F, 0, Covering::shirt},
    {Role::left_upper_arm, 0.38F, {1.10F, 1.10F, 1.12F, 1.06F}, 0, 0, Covering::shirt},
    {Role::left_upper_arm, 0.58F, {1.06F, 1.04F, 1.06F, 1.04F}, 0, 0, Covering::shirt},
    {Role::left_upper_arm, 0.64F, {0.92F, 0.90F, 0.92F, 0.90F}, 0, 0, Covering::shirt},
    {Role::left_upper_arm, 0.88F, {0.84F, 0.80F, 0.84F, 0.80F}, 0, 0.08F, Covering::skin},
    {Role::left_forearm, 0.00F, {1.04F, 1.00F, 1.04F, 1.00F}, 0.50F, 0, Covering::skin},
    {Role::left_forearm, 0.13F, {1.14F, 1.04F, 1.08F, 1.04F}, 0.06F, 0, Covering::skin},
    {Role::left_forearm, 0.34F, {1.08F, 0.98F, 1.02F, 0.98F}, 0, 0, Covering::skin},
    {Role::left_forearm, 0.68F, {0.84F, 0.76F, 0.80F, 0.76F}, 0, 0, Covering::skin},
    {Role::left_forearm, 0.94F, {0.74F, 0.54F, 0.70F, 0.54F}, 0, 0.25F, Covering::skin},
};

// In half extents of the hand's box.
constexpr LimbRow kPalmRows[] = {
    {Role::left_hand, 0.06F, {0.68F, 1.25F, 0.64F, 1.25F, 0.78F}, 0.20F, 0, Covering::skin},
    {Role::left_hand, 0.26F, {0.84F, 1.20F, 0.82F, 1.15F, 0.80F}, 0, 0, Covering::skin},
    {Role::left_hand, 0.50F, {0.94F, 0.95F, 0.90F, 0.95F, 0.80F}, 0, 0, Covering::skin},
};

class HandBuilder {
 public:
  HandBuilder(const CageGuide& guide, Side side, CageBuilder& builder)
      : side_(side),
        hand_(role_on(side, Role::left_hand)),
        tip_(guide.character.skeleton.tip[hand_]),
        axes_(limb_axes(side, tip_, sign_of(side) * Vector3f::UnitY())),
        weights_(joint_weights({{hand_, 1}})),
        builder_(builder) {}

  // A tube from `base` in this direction: `growth` times as thick as that, then tapered.
  void add_digit(const Ring& base, const Vector3f& direction, float growth, float taper) {
    Vector3f middle = Vector3f::Zero();
    for (const std::uint32_t vertex : base) {
      middle += builder_.position(vertex) / static_cast<float>(base.size());
    }
    Ring below = base;
    for (const float along : {0.12F, 0.55F, 1.0F}) {
      const float scale = growth * (1 - taper * along);
      Ring ring;
      for (const std::uint32_t vertex : base) {
        Vector3f across = builder_.position(vertex) - middle;
        across -= across.dot(direction.normalized()) * direction.normalized();
        ring.push_back(builder_.add(middle + along * direction + scale * across, weights_));
      }
      builder_.join(below, ring, Covering::skin, is_mirrored());
      below = ring;
    }
    builder_.face(below, Covering::skin, is_mirrored());
  }

  void add_fingers(const Ring& knuckles) {
    const Vector3f rest = 0.5F * tip_;
    const Vector3f forward = rest.norm() * axes_.front;
    const Vector3f down = -0.06F * rest.norm() * axes_.side;
    const auto finger = [&](std::initializer_list<std::size_t> corners, float length, float spread,
                            float growth) {
      Ring base;
      for (const std::size_t corner : corners) base.push_back(knuckles[corner]);
      add_digit(base, length * rest + spread * forward + down, growth, 0.3F);
    };
    finger({7, 0, 1}, 0.92F, 0.10F, 1.15F);
    finger({7, 1, 2, 6}, 1.02F, 0.02F, 0.80F);
    finger({6, 2, 3, 5}, 0.96F, -0.06F, 0.80F);
    finger({5, 3, 4}, 0.80F, -0.16F, 1.15F);
  }

  // From the front of the palm, between two of its rings.
  void add_thumb(const Ring& near_ring, const Ring& far_ring) {
    const Ring base{near_ring[7], near_ring[0], near_ring[1],
                    far_ring[1],  far_ring[0],  far_ring[7]};
    const float length = 0.36F * tip_.norm();
    add_digit(base, length * (0.66F * axes_.front + 0.72F * axes_.along - 0.2F * axes_.side), 0.62F,
              0.35F);
  }

 private:
  bool is_mirrored() const { return side_ == Side::left; }

  Side side_;
  Role hand_;
  Vector3f tip_;
  LimbAxes axes_;
  JointWeights weights_;
  CageBuilder& builder_;
};

}  // namespace

// Seen from outside with the shoulder below, the rings of the left arm run to the left.
void add_arm(const CageGuide& guide, Side side, const Ring& shoulder, CageBuilder& builder) {
  const bool is_mirrored = side == Side::left;
  Ring below = shoulder;
  const auto join_next = [&](const LimbRow& row) {
    const Ring ring = add_limb_row(guide, side, row, builder);
    builder.join(below, ring, row.covering, is_mirrored);
    below = ring;
  };
  for (const LimbRow& row : kArmRows) join_next(row);
  join_next(kPalmRows[0]);

  HandBuilder hand(guide, side, builder);
  const Ring wrist = below;
  const Ring palm = add_limb_row(guide, side, kPalmRows[1], builder);
  for (std::size_t k = 1; k < 7; ++k) {
    builder.face({wrist[k], wrist[k + 1], palm[k + 1], palm[k]}, Covering::skin, is_mirrored);
  }
  hand.add_thumb(wrist, palm);
  below = palm;
  join_next(kPalmRows[2]);
  hand.add_fingers(below);
}

}  // namespace flinch::motion
