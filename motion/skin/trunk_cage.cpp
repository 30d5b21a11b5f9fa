// SPDX-License-Identifier: MIT
#include <array>

#include "motion/skin/figure_cage.h"

namespace flinch::motion {
namespace {

using Eigen::Vector3f;

// What a vertex is placed from, and the unit of its coordinates: the centre of a box of the trunk
// and its half extents, or the near joint of a limb and the limb's radius.
enum class Anchor : std::uint8_t { pelvis, abdomen, chest, neck, shoulder, hip };

struct Share {
  Role joint = Role::pelvis;
  float weight = 0;
};
using Shares = std::array<Share, 4>;

// A vertex of the middle or of the left side; `y` is outward. The right side is mirrored.
struct Point {
  Anchor anchor;
  float x, y, z;
  Shares shares;
};

// The middle of the front, five points of the left side from front to back, the middle of the back.
using HalfRing = std::array<Point, 7>;

constexpr Shares only(Role joint) {
  return {{{joint, 1}}};
}
constexpr Shares between(Role lower, Role upper, float upper_weight) {
  return {{{lower, 1 - upper_weight}, {upper, upper_weight}}};
}
constexpr Shares kMidHip{
    {{Role::pelvis, 0.8F}, {Role::left_thigh, 0.1F}, {Role::right_thigh, 0.1F}}};
constexpr Shares hip(float thigh) {
  return between(Role::pelvis, Role::left_thigh, thigh);
}
constexpr Shares shoulder(float clavicle, float upper_arm) {
  return {{{Role::chest, 1 - clavicle - upper_arm},
           {Role::left_clavicle, clavicle},
           {Role::left_upper_arm, upper_arm}}};
}
constexpr Shares collar(float clavicle, float neck) {
  return {
      {{Role::chest, 1 - clavicle - neck}, {Role::left_clavicle, clavicle}, {Role::neck, neck}}};
}

// A ring around one box, all of whose points move alike.
struct BoxRow {
  Anchor box;
  Shares shares;
  std::array<std::array<float, 3>, 7> points;
};
constexpr HalfRing ring_of(const BoxRow& row) {
  HalfRing ring{};
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const auto& [x, y, z] = row.points[k];
    ring[k] = {row.box, x, y, z, row.shares};
  }
  return ring;
}

constexpr HalfRing kGroin{{
    {Anchor::pelvis, 0.78F, 0, -0.55F, kMidHip},
    {Anchor::hip, 1.12F, -0.42F, -0.25F, hip(0.40F)},
    {Anchor::hip, 0.88F, 0.45F, 0.20F, hip(0.45F)},
    {Anchor::hip, 0, 0.98F, 0.40F, hip(0.40F)},
    {Anchor::hip, -1.00F, 0.50F, -0.30F, hip(0.45F)},
    {Anchor::hip, -1.35F, -0.35F, -0.75F, hip(0.45F)},
    {Anchor::pelvis, -0.85F, 0, -1.00F, kMidHip},
}};
constexpr Point kCrotch{Anchor::pelvis, -0.05F, 0, -1.22F, kMidHip};

constexpr HalfRing kHips = ring_of({Anchor::pelvis,
                                    only(Role::pelvis),
                                    {{{0.94F, 0, 0.02F},
                                      {0.90F, 0.35F, 0.02F},
                                      {0.66F, 0.78F, 0.06F},
                                      {-0.05F, 1.03F, 0.10F},
                                      {-0.82F, 0.80F, -0.02F},
                                      {-1.18F, 0.42F, -0.12F},
                                      {-1.06F, 0, -0.10F}}}});
constexpr HalfRing kBelt = ring_of({Anchor::pelvis,
                                    between(Role::pelvis, Role::abdomen, 0.12F),
                                    {{{0.98F, 0, 0.55F},
                                      {0.92F, 0.37F, 0.55F},
                                      {0.66F, 0.78F, 0.58F},
                                      {-0.05F, 1.00F, 0.62F},
                                      {-0.76F, 0.78F, 0.55F},
                                      {-1.06F, 0.40F, 0.48F},
                                      {-0.98F, 0, 0.48F}}}});
constexpr HalfRing kNavel = ring_of({Anchor::abdomen,
                                     between(Role::pelvis, Role::abdomen, 0.6F),
                                     {{{0.94F, 0, -0.90F},
                                       {0.88F, 0.38F, -0.90F},
                                       {0.62F, 0.76F, -0.90F},
                                       {-0.02F, 0.96F, -0.88F},
                                       {-0.62F, 0.74F, -0.90F},
                                       {-0.84F, 0.38F, -0.90F},
                                       {-0.76F, 0, -0.90F}}}});
constexpr HalfRing kWaist = ring_of({Anchor::abdomen,
                                     between(Role::abdomen, Role::chest, 0.1F),
                                     {{{0.96F, 0, -0.15F},
                                       {0.90F, 0.38F, -0.15F},
                                       {0.64F, 0.76F, -0.15F},
                                       {0, 0.93F, -0.12F},
                                       {-0.62F, 0.74F, -0.15F},
                                       {-0.82F, 0.38F, -0.15F},
                                       {-0.72F, 0, -0.15F}}}});
constexpr HalfRing kRibs = ring_of({Anchor::abdomen,
                                    between(Role::abdomen, Role::chest, 0.5F),
                                    {{{1.00F, 0, 0.60F},
                                      {0.96F, 0.40F, 0.60F},
                                      {0.68F, 0.80F, 0.60F},
                                      {0, 1.00F, 0.60F},
                                      {-0.70F, 0.80F, 0.60F},
                                      {-0.98F, 0.40F, 0.60F},
                                      {-0.88F, 0, 0.60F}}}});
constexpr HalfRing kBreast = ring_of({Anchor::chest,
                                      between(Role::abdomen, Role::chest, 0.9F),
                                      {{{0.94F, 0, -0.60F},
                                        {1.00F, 0.42F, -0.60F},
                                        {0.72F, 0.84F, -0.58F},
                                        {0, 1.04F, -0.58F},
                                        {-0.72F, 0.86F, -0.58F},
                                        {-0.98F, 0.42F, -0.60F},
                                        {-0.88F, 0, -0.60F}}}});
constexpr HalfRing kArmpits{{
    {Anchor::chest, 0.96F, 0, -0.10F, only(Role::chest)},
    {Anchor::chest, 1.00F, 0.45F, -0.10F, only(Role::chest)},
    {Anchor::shoulder, 1.35F, -0.60F, -1.30F, shoulder(0.10F, 0.15F)},
    {Anchor::shoulder, -0.10F, -0.35F, -1.55F, shoulder(0.05F, 0.30F)},
    {Anchor::shoulder, -1.45F, -0.60F, -1.35F, shoulder(0.10F, 0.15F)},
    {Anchor::chest, -0.94F, 0.50F, -0.10F, only(Role::chest)},
    {Anchor::chest, -0.80F, 0, -0.10F, only(Role::chest)},
}};
// Its point on the side is within the arm, and left out.
constexpr HalfRing kShoulders{{
    {Anchor::chest, 0.86F, 0, 0.40F, only(Role::chest)},
    {Anchor::chest, 0.86F, 0.46F, 0.42F, shoulder(0.15F, 0)},
    {Anchor::shoulder, 1.25F, -0.50F, -0.10F, shoulder(0.30F, 0.35F)},
    {},
    {Anchor::shoulder, -1.35F, -0.50F, -0.05F, shoulder(0.30F, 0.35F)},
    {Anchor::chest, -0.88F, 0.50F, 0.40F, shoulder(0.20F, 0)},
    {Anchor::chest, -0.78F, 0, 0.40F, only(Role::chest)},
}};
constexpr HalfRing kShoulderTops{{
    {Anchor::chest, 0.62F, 0, 0.78F, only(Role::chest)},
    {Anchor::chest, 0.58F, 0.46F, 0.86F, shoulder(0.30F, 0)},
    {Anchor::shoulder, 0.90F, -0.55F, 1.00F, shoulder(0.50F, 0.20F)},
    {Anchor::shoulder, -0.10F, -0.50F, 1.30F, shoulder(0.55F, 0.35F)},
    {Anchor::shoulder, -1.10F, -0.55F, 1.05F, shoulder(0.50F, 0.20F)},
    {Anchor::chest, -0.74F, 0.46F, 0.92F, shoulder(0.30F, 0)},
    {Anchor::chest, -0.70F, 0, 0.90F, only(Role::chest)},
}};
constexpr HalfRing kCollar{{
    {Anchor::neck, 1.10F, 0, -0.25F, collar(0, 0.1F)},
    {Anchor::neck, 1.00F, 0.75F, -0.12F, collar(0.1F, 0.1F)},
    {Anchor::neck, 0.60F, 1.35F, 0.10F, collar(0.2F, 0.1F)},
    {Anchor::neck, -0.25F, 1.55F, 0.32F, collar(0.2F, 0.1F)},
    {Anchor::neck, -0.95F, 1.30F, 0.35F, collar(0.2F, 0.1F)},
    {Anchor::neck, -1.40F, 0.75F, 0.35F, collar(0.1F, 0.1F)},
    {Anchor::neck, -1.45F, 0, 0.35F, collar(0, 0.1F)},
}};
constexpr Shares kThroat = between(Role::chest, Role::neck, 0.75F);
constexpr HalfRing kNeck{{
    {Anchor::neck, 0.92F, 0, 0.35F, kThroat},
    {Anchor::neck, 0.85F, 0.55F, 0.45F, kThroat},
    {Anchor::neck, 0.50F, 0.95F, 0.60F, kThroat},
    {Anchor::neck, -0.10F, 1.05F, 0.85F, kThroat},
    {Anchor::neck, -0.65F, 0.95F, 1.05F, kThroat},
    {Anchor::neck, -1.05F, 0.55F, 1.15F, kThroat},
    {Anchor::neck, -1.10F, 0, 1.20F, kThroat},
}};

class TrunkBuilder {
 public:
  TrunkBuilder(const CageGuide& guide, CageBuilder& builder) : guide_(guide), builder_(builder) {}

  std::uint32_t add(const Point& point, Side side) {
    JointWeights weights = joint_weights({});
    for (const auto& [joint, weight] : point.shares) weights[role_on(side, joint)] += weight;
    return builder_.add(position_of(point, side), weights);
  }

  // Twelve vertices: the front, the left side, the back, the right side.
  Ring add(const HalfRing& half) {
    Ring ring;
    for (std::size_t k = 0; k < 12; ++k) {
      ring.push_back(k <= 6 ? add(half[k], Side::left) : add(half[12 - k], Side::right));
    }
    return ring;
  }

 private:
  Vector3f position_of(const Point& point, Side side) const {
    const Vector3f place(point.x, sign_of(side) * point.y, point.z);
    const auto in_box = [&](Body body) -> Vector3f {
      const Shape& box = guide_.bodies[body].shape;
      return guide_.joint(role_of(body)) + box.centre + box.half_extents.cwiseProduct(place);
    };
    const auto at_joint = [&](Body limb) -> Vector3f {
      return guide_.joint(role_of(limb)) + guide_.bodies[limb].shape.radius * place;
    };
    switch (point.anchor) {
      case Anchor::pelvis:
        return in_box(Body::pelvis);
      case Anchor::abdomen:
        return in_box(Body::abdomen);
      case Anchor::chest:
        return in_box(Body::chest);
      case Anchor::neck:
        return at_joint(Body::neck);
      case Anchor::shoulder:
        return at_joint(side == Side::left ? Body::left_upper_arm : Body::right_upper_arm);
      case Anchor::hip:
        break;
    }
    return at_joint(side == Side::left ? Body::left_thigh : Body::right_thigh);
  }

  const CageGuide& guide_;
  CageBuilder& builder_;
};

// The vertex of a ring of the trunk that is number k from the front on this side.
std::uint32_t at(const Ring& ring, Side side, std::size_t k) {
  return ring[side == Side::left ? k : (12 - k) % 12];
}

}  // namespace

Role role_on(Side side, Role left) {
  return side == Side::left ? left : mirrored(left);
}

TrunkEnds add_trunk(const CageGuide& guide, CageBuilder& builder) {
  TrunkBuilder trunk(guide, builder);
  const Ring groin = trunk.add(kGroin);
  const std::uint32_t crotch = trunk.add(kCrotch, Side::left);
  Ring below = groin;
  const auto join_next = [&](const HalfRing& half, Covering covering) {
    const Ring ring = trunk.add(half);
    builder.join(below, ring, covering, false);
    below = ring;
  };
  join_next(kHips, Covering::trousers);
  join_next(kBelt, Covering::shirt);
  join_next(kNavel, Covering::shirt);
  join_next(kWaist, Covering::shirt);
  join_next(kRibs, Covering::shirt);
  join_next(kBreast, Covering::shirt);
  join_next(kArmpits, Covering::shirt);

  const Ring armpits = below;
  const Ring tops = trunk.add(kShoulderTops);
  TrunkEnds ends;
  PerSide<Ring> shoulders;
  for (const Side side : kSides) {
    for (std::size_t k = 0; k < 7; ++k) {
      const bool is_shared = side == Side::right && (k == 0 || k == 6);
      shoulders[side].push_back(k == 3      ? 0
                                : is_shared ? shoulders[Side::left][k]
                                            : trunk.add(kShoulders[k], side));
    }
    const Ring& middle = shoulders[side];
    const bool is_mirrored = side == Side::right;
    const auto join_columns = [&](std::size_t k) {
      builder.face({at(armpits, side, k), at(armpits, side, k + 1), middle[k + 1], middle[k]},
                   Covering::shirt, is_mirrored);
      builder.face({middle[k], middle[k + 1], at(tops, side, k + 1), at(tops, side, k)},
                   Covering::shirt, is_mirrored);
    };
    for (const std::size_t k : {0U, 1U, 4U, 5U}) join_columns(k);
    ends.arms[side] = {middle[2], at(tops, side, 2),    at(tops, side, 3),    at(tops, side, 4),
                       middle[4], at(armpits, side, 4), at(armpits, side, 3), at(armpits, side, 2)};
    ends.legs[side] = {at(groin, side, 1),
                       at(groin, side, 2),
                       at(groin, side, 3),
                       at(groin, side, 4),
                       at(groin, side, 5),
                       at(groin, side, 6),
                       crotch,
                       at(groin, side, 0)};
  }
  below = tops;
  join_next(kCollar, Covering::shirt);
  join_next(kNeck, Covering::skin);
  ends.neck = below;
  return ends;
}

}  // namespace flinch::motion
