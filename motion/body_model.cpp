// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "motion/body.h"
#include "motion/de_leva.h"
#include "motion/foot.h"
#include "motion/rotation.h"

namespace flinch::motion {
namespace {

// Widths and depths that bone lengths do not determine, as fractions of the stature. Breadths of
// chest and hips, head height and foot breadth are from Drillis and Contini (1966), "Body segment
// parameters". The others are estimates for mean adults.
constexpr float kChinToCrown = 0.130F;
constexpr float kChestBreadth = 0.174F;
constexpr float kChestDepth = 0.140F;
constexpr float kAbdomenBreadth = 0.174F;
constexpr float kAbdomenDepth = 0.128F;
constexpr float kPelvisBreadth = 0.191F;
constexpr float kPelvisDepth = 0.130F;
constexpr float kPelvisBelowHips = 0.030F;
constexpr float kChinAboveNeck = 0.010F;

// Estimates for mean adults, as fractions of the body part's own length.
constexpr float kHeadRadius = 0.382F;  // geometric mean of half breadth and half length
constexpr float kHeadForward = 0.05F;  // the skull's middle is in front of the joint at its base
constexpr float kHandBreadth = 0.45F;
constexpr float kHandThickness = 0.15F;
constexpr float kFootBreadth = 0.362F;  // 0.055 / 0.152 of the stature
constexpr float kFootHeight = 0.6F;     // of the ankle's height: the foot slopes down to the toes

constexpr float kLimbDensity = 1060;         // kg/m^3, of muscle
constexpr float kMaxRadiusToLength = 0.45F;  // radius / length below 0.5 keeps it a capsule
constexpr float kClearance = 0.95F;          // fraction used of the space between neighbours
constexpr float kMinExtent = 0.005F;         // m, for bones of zero length

// De Leva treats head and neck as one segment. The head alone of a man of 75 kg weighs 4.4 kg
// (within the range reviewed by Yoganandan et al. 2009, "Physical properties of the human head", J.
// Biomechanics 42(9)); the same share of head and neck is used for women.
constexpr float kHeadShare = 4.4F / 75 / 0.0694F;

// The rest pose. All joint frames are parallel to the world's there, so a point minus the joint's
// position is that point in the joint's frame.
struct RestGeometry {
  PerRole<Eigen::Vector3f> joint;
  Eigen::Vector3f middle_of_hips;
  Eigen::Vector3f crown;
  float stature;  // m
};

RestGeometry rest_geometry_of(const Skeleton& skeleton) {
  RestGeometry rest;
  rest.joint = forward_kinematics(skeleton, rest_pose(skeleton)).position;
  rest.middle_of_hips = 0.5F * (rest.joint[Role::left_thigh] + rest.joint[Role::right_thigh]);
  rest.crown = rest.joint[Role::head] + skeleton.tip[Role::head];
  rest.stature = rest.crown.z();
  return rest;
}

Eigen::Vector3f point_along(const Eigen::Vector3f& near_end, const Eigen::Vector3f& far_end,
                            float percent) {
  return near_end + percent / 100 * (far_end - near_end);
}

Eigen::Quaternionf rotation_onto_line(const Eigen::Vector3f& from_axis,
                                      const Eigen::Vector3f& to_line) {
  // an outline's axis has no direction
  const float sense = from_axis.dot(to_line) < 0 ? -1.0F : 1.0F;
  return rotation_between<float>(from_axis, sense * to_line);
}

// Radius of the capsule of overall length L that holds the mass at limb density, by fixed-point
// iteration:
//   V = pi r^2 (L - 2 r / 3).
float capsule_radius(float mass_kg, float length_m) {
  const float volume = mass_kg / kLimbDensity;
  const float max_radius = kMaxRadiusToLength * length_m;
  float radius = 0;
  for (int i = 0; i < 30; ++i) {
    radius = std::sqrt(volume / (std::numbers::pi_v<float> * (length_m - 2 * radius / 3)));
    radius = std::min(radius, max_radius);
  }
  return radius;
}

// A capsule from the joint to the far end, which includes its caps.
Shape limb_capsule(const Eigen::Vector3f& far_end, float mass_kg,
                   float max_radius = std::numeric_limits<float>::infinity()) {
  const float length = std::max(far_end.norm(), 2 * kMinExtent);
  Shape shape;
  shape.kind = Shape::Kind::capsule;
  shape.centre = 0.5F * far_end;
  shape.orientation = rotation_onto_line(Eigen::Vector3f::UnitZ(), far_end);
  shape.radius = std::min(capsule_radius(mass_kg, length), max_radius);
  shape.half_length = 0.5F * length - shape.radius;
  return shape;
}

Shape upright_box(const Eigen::Vector3f& bottom, const Eigen::Vector3f& top, float depth,
                  float breadth) {
  Shape shape;
  shape.kind = Shape::Kind::box;
  shape.centre = 0.5F * (bottom + top);
  shape.half_extents = {0.5F * depth, 0.5F * breadth,
                        std::max(0.5F * (top.z() - bottom.z()), kMinExtent)};
  return shape;
}

void set_trunk(BodyModel& model, const RestGeometry& rest, const de_leva::Table& table) {
  const Eigen::Vector3f& pelvis = rest.joint[Role::pelvis];
  const Eigen::Vector3f& abdomen = rest.joint[Role::abdomen];
  const Eigen::Vector3f& chest = rest.joint[Role::chest];
  const Eigen::Vector3f& neck = rest.joint[Role::neck];
  const float stature = rest.stature;

  const Eigen::Vector3f below_hips(0, 0, -kPelvisBelowHips * stature);
  model[Body::pelvis] = {
      table.lower_trunk.mass_percent,
      point_along(abdomen, rest.middle_of_hips, table.lower_trunk.centre_percent) - pelvis,
      upright_box(rest.middle_of_hips + below_hips - pelvis, abdomen - pelvis,
                  kPelvisDepth * stature, kPelvisBreadth * stature)};
  model[Body::abdomen] = {table.middle_trunk.mass_percent,
                          point_along(chest, abdomen, table.middle_trunk.centre_percent) - abdomen,
                          upright_box(Eigen::Vector3f::Zero(), chest - abdomen,
                                      kAbdomenDepth * stature, kAbdomenBreadth * stature)};
  const float between_shoulders =
      rest.joint[Role::left_upper_arm].y() - rest.joint[Role::right_upper_arm].y();
  model[Body::chest] = {
      table.upper_trunk.mass_percent,
      point_along(neck, chest, table.upper_trunk.centre_percent) - chest,
      upright_box(Eigen::Vector3f::Zero(), neck - chest, kChestDepth * stature,
                  std::min(kChestBreadth * stature, kClearance * between_shoulders))};
}

// An upright capsule around the skull from chin to crown, in front of its joint.
Shape head_capsule(const RestGeometry& rest) {
  const Eigen::Vector3f& joint = rest.joint[Role::head];
  const float above_neck =
      rest.crown.z() - rest.joint[Role::neck].z() - kChinAboveNeck * rest.stature;
  const float height = std::max(std::min(kChinToCrown * rest.stature, above_neck), 2 * kMinExtent);
  Shape shape;
  shape.kind = Shape::Kind::capsule;
  shape.centre = {kHeadForward * height, 0, rest.crown.z() - 0.5F * height - joint.z()};
  shape.radius = kHeadRadius * height;
  shape.half_length = 0.5F * height - shape.radius;
  return shape;
}

// The neck's centre of mass is in its middle. The head's is where the two together have de Leva's:
//   m c = m_head c_head + m_neck c_neck
void set_head_and_neck(BodyModel& model, const RestGeometry& rest, const de_leva::Table& table,
                       float mass_kg) {
  const Eigen::Vector3f& neck = rest.joint[Role::neck];
  const Eigen::Vector3f& head = rest.joint[Role::head];
  const float both = table.head_and_neck.mass_percent;
  const float head_mass = kHeadShare * both;
  const float neck_mass = both - head_mass;
  const Eigen::Vector3f centre = point_along(rest.crown, neck, table.head_and_neck.centre_percent);
  const Eigen::Vector3f neck_centre = 0.5F * (neck + head);
  const Eigen::Vector3f head_centre = (both * centre - neck_mass * neck_centre) / head_mass;

  model[Body::neck] = {neck_mass, neck_centre - neck,
                       limb_capsule(head - neck, neck_mass / 100 * mass_kg)};
  model[Body::head] = {head_mass, head_centre - head, head_capsule(rest)};
}

// A flat box from wrist to fingertips; the palm faces down in the rest pose.
Shape hand_box(const Eigen::Vector3f& fingertip) {
  const float length = std::max(fingertip.norm(), 2 * kMinExtent);
  Shape shape;
  shape.kind = Shape::Kind::box;
  shape.centre = 0.5F * fingertip;
  shape.orientation = rotation_onto_line(Eigen::Vector3f::UnitY(), fingertip);
  shape.half_extents = 0.5F * length * Eigen::Vector3f(kHandBreadth, 1, kHandThickness);
  return shape;
}

void set_arm(BodyModel& model, const Skeleton& skeleton, const de_leva::Table& table, float mass_kg,
             Body upper_arm, Body forearm, Body hand) {
  const Eigen::Vector3f& elbow = skeleton.offset[role_of(forearm)];
  const Eigen::Vector3f& wrist = skeleton.offset[role_of(hand)];
  const Eigen::Vector3f& fingertip = skeleton.tip[role_of(hand)];
  const auto limb = [&](const de_leva::Segment& segment, const Eigen::Vector3f& far_end) {
    return BodyProperties{segment.mass_percent,
                          point_along(Eigen::Vector3f::Zero(), far_end, segment.centre_percent),
                          limb_capsule(far_end, segment.mass_percent / 100 * mass_kg)};
  };
  model[upper_arm] = limb(table.upper_arm, elbow);
  model[forearm] = limb(table.forearm, wrist);
  model[hand] = {table.hand.mass_percent,
                 point_along(Eigen::Vector3f::Zero(), table.knuckle_length * fingertip,
                             table.hand.centre_percent),
                 hand_box(fingertip)};
}

// A box on the ground from the heel to the tip of the toes; the toes have no body of their own.
BodyProperties foot_properties(const Skeleton& skeleton, const de_leva::Segment& segment,
                               Side side) {
  const FootDimensions foot = measure_foot(skeleton, side);
  const float height = std::max(kFootHeight * foot.ankle_height, 2 * kMinExtent);
  const Eigen::Vector3f heel = foot.heel + 0.5F * height * Eigen::Vector3f::UnitZ();
  const Eigen::Vector3f toe_tip = heel + foot.length * foot.forward;

  BodyProperties properties;
  properties.mass_kg = segment.mass_percent;
  properties.centre_of_mass = point_along(heel, toe_tip, segment.centre_percent);
  properties.shape.kind = Shape::Kind::box;
  properties.shape.centre = 0.5F * (heel + toe_tip);
  properties.shape.orientation = rotation_onto_line(Eigen::Vector3f::UnitX(), foot.forward);
  properties.shape.half_extents =
      0.5F * Eigen::Vector3f(foot.length, kFootBreadth * foot.length, height);
  return properties;
}

void set_leg(BodyModel& model, const Skeleton& skeleton, const RestGeometry& rest,
             const de_leva::Table& table, float mass_kg, Body thigh, Body shin, Body foot,
             Side side) {
  const Eigen::Vector3f& knee = skeleton.offset[role_of(shin)];
  const Eigen::Vector3f& ankle = skeleton.offset[role_of(foot)];
  const auto limb = [&](const de_leva::Segment& segment, const Eigen::Vector3f& far_end) {
    const float to_middle = std::abs(rest.joint[role_of(thigh)].y());
    return BodyProperties{
        segment.mass_percent, point_along(Eigen::Vector3f::Zero(), far_end, segment.centre_percent),
        limb_capsule(far_end, segment.mass_percent / 100 * mass_kg, kClearance * to_middle)};
  };
  model[thigh] = limb(table.thigh, knee);
  model[shin] = limb(table.shank, ankle);
  model[foot] = foot_properties(skeleton, table.foot, side);
}

}  // namespace

BodyModel make_body_model(const Physique& character) {
  const Skeleton& skeleton = character.skeleton;
  const de_leva::Table& table = de_leva::table(character.sex);
  const float mass_kg = character.mass_kg;
  const RestGeometry rest = rest_geometry_of(skeleton);

  BodyModel model;
  set_trunk(model, rest, table);
  set_head_and_neck(model, rest, table, mass_kg);
  set_arm(model, skeleton, table, mass_kg, Body::left_upper_arm, Body::left_forearm,
          Body::left_hand);
  set_arm(model, skeleton, table, mass_kg, Body::right_upper_arm, Body::right_forearm,
          Body::right_hand);
  set_leg(model, skeleton, rest, table, mass_kg, Body::left_thigh, Body::left_shin, Body::left_foot,
          Side::left);
  set_leg(model, skeleton, rest, table, mass_kg, Body::right_thigh, Body::right_shin,
          Body::right_foot, Side::right);

  // So far the masses are percentages from the table, rounded, so they may not add up to 100.
  float sum = 0;
  for (const BodyProperties& body : model) sum += body.mass_kg;
  for (BodyProperties& body : model) body.mass_kg *= mass_kg / sum;
  return model;
}

}  // namespace flinch::motion
