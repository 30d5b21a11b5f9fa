// SPDX-License-Identifier: MIT
#include "database/import/source_character.h"

#include <algorithm>

#include "motion/default_character.h"

namespace flinch::database {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;
using motion::kRoles;
using motion::mirrored;
using motion::PerRole;
using motion::Role;
using motion::Skeleton;

// Allowed range of spine joints between the hips and the neck's base, as fractions of that line.
// The default character has the abdomen at 0.22 and the chest at 0.59.
constexpr double kMinAbdomen = 0.10;
constexpr double kMaxAbdomen = 0.35;
constexpr double kMinChest = 0.45;
constexpr double kMaxChest = 0.75;
// Height of the neck's base between the shoulders' line and the head joint, as in the default
// character, rounded.
constexpr double kNeckAboveShoulders = 0.3;

// Greatest distance of a clavicle's joint from the plane of symmetry over that of the shoulder. The
// default character has 0.12.
constexpr double kMaxClavicle = 0.35;
// A hand's length over the forearm's. The default character has 0.70.
constexpr double kMinHand = 0.5;
constexpr double kMaxHand = 1;

// Lengths of a source's reference pose: metres, left side, averaged with the right.
class SourceMeasurements {
 public:
  explicit SourceMeasurements(const Source& source) : source_(source) {
    const motion::JointFrames rest =
        forward_kinematics(proportions_, motion::rest_pose(proportions_));
    for (Role role : kRoles) default_height_[role] = rest.position[role].z();
    scale_ = (place(Role::head).z() - place(Role::left_foot).z()) /
             (default_height_[Role::head] - default_height_[Role::left_foot]);
  }

  bool has(Role role) const { return source_.figure.has(role); }
  bool has_end(Role role) const {
    return source_.figure.end[role].has_value() && source_.figure.end[mirrored(role)].has_value();
  }

  // Returns a joint's position, with the pelvis at the origin.
  Vector3d place(Role role) const { return symmetric(source_.reference.position, role); }
  // Returns the far end of its segment.
  Vector3d end(Role role) const { return symmetric(source_.reference.end, role); }
  // Returns the length of its segment.
  double length(Role role) const {
    const auto of = [&](Role one) {
      return (source_.reference.end[one] - source_.reference.position[one]).norm();
    };
    return 0.5 * source_.metres_per_unit * (of(role) + of(mirrored(role)));
  }
  // Returns the default character's offset, scaled to this figure.
  Vector3d default_offset(Role role) const {
    return scale_ * proportions_.offset[role].cast<double>();
  }
  Vector3d default_tip(Role role) const { return scale_ * proportions_.tip[role].cast<double>(); }
  double default_height(Role role) const { return scale_ * default_height_[role]; }
  double default_fraction(Role role) const {
    return (default_height_[role] - default_height_[Role::left_thigh]) /
           (default_height_[Role::neck] - default_height_[Role::left_thigh]);
  }

 private:
  Vector3d symmetric(const PerRole<Vector3d>& values, Role role) const {
    Vector3d other = values[mirrored(role)];
    other.y() = -other.y();
    return 0.5 * source_.metres_per_unit * (values[role] + other);
  }

  const Source& source_;
  const Skeleton proportions_ = motion::default_character().skeleton;
  PerRole<double> default_height_;
  double scale_ = 1;
};

void set_offset(Skeleton& skeleton, Role left, const Vector3d& offset) {
  skeleton.offset[left] = offset.cast<float>();
  if (mirrored(left) == left) {
    skeleton.offset[left].y() = 0;
    return;
  }
  skeleton.offset[mirrored(left)] = skeleton.offset[left];
  skeleton.offset[mirrored(left)].y() = -skeleton.offset[left].y();
}

void set_tip(Skeleton& skeleton, Role left, const Vector3d& tip) {
  skeleton.tip[left] = tip.cast<float>();
  skeleton.tip[mirrored(left)] = skeleton.tip[left];
  skeleton.tip[mirrored(left)].y() = -skeleton.tip[left].y();
}

// Returns the height of a spine joint, m, between those of hips and neck.
double spine_height(const SourceMeasurements& measures, Role role, double hips, double neck,
                    double min_fraction, double max_fraction) {
  const double fraction =
      measures.has(role) ? (measures.place(role).z() - hips) / (neck - hips) : 0;
  const bool plausible = fraction >= min_fraction && fraction <= max_fraction;
  return hips + (plausible ? fraction : measures.default_fraction(role)) * (neck - hips);
}

// The trunk's joints relative to the pelvis joint, m, in the plane of symmetry.
struct Trunk {
  Vector3d abdomen, chest, neck, head;
};

// Returns the point at a height of the line from the hips through the source's spine joints to the
// neck.
Vector3d point_of_spine(const SourceMeasurements& measures, const Vector3d& neck, double height) {
  Vector3d below = measures.place(Role::left_thigh);
  below.y() = 0;
  for (Role role : {Role::abdomen, Role::chest}) {
    const Vector3d joint = measures.place(role);
    const bool is_next = measures.has(role) && joint.z() > below.z() && joint.z() < neck.z();
    if (!is_next) continue;
    if (height <= joint.z()) {
      return below + (height - below.z()) / (joint.z() - below.z()) * (joint - below);
    }
    below = joint;
  }
  return below + (height - below.z()) / (neck.z() - below.z()) * (neck - below);
}

Trunk measure_trunk(const SourceMeasurements& measures) {
  const double hips = measures.place(Role::left_thigh).z();
  Vector3d shoulders = measures.place(Role::left_upper_arm);
  shoulders.y() = 0;
  Trunk trunk;
  trunk.head = measures.place(Role::head);
  trunk.neck = shoulders + kNeckAboveShoulders * (trunk.head - shoulders);
  const double neck_length = measures.default_offset(Role::head).z();
  if (measures.has(Role::neck)) {
    trunk.neck = measures.place(Role::neck);
  } else if (trunk.head.z() - shoulders.z() < 0.5 * neck_length) {
    // A head joint at the height of the shoulders is a neck.
    trunk.neck = trunk.head;
    trunk.head.z() += neck_length;
  }
  // No neck leans more than 45 degrees while its owner stands.
  const double height = std::abs(trunk.head.z() - trunk.neck.z());
  trunk.head.x() = std::clamp(trunk.head.x(), trunk.neck.x() - height, trunk.neck.x() + height);
  const double neck = trunk.neck.z();
  trunk.abdomen =
      point_of_spine(measures, trunk.neck,
                     spine_height(measures, Role::abdomen, hips, neck, kMinAbdomen, kMaxAbdomen));
  trunk.chest = point_of_spine(
      measures, trunk.neck, spine_height(measures, Role::chest, hips, neck, kMinChest, kMaxChest));
  return trunk;
}

void set_trunk(Skeleton& skeleton, const SourceMeasurements& measures, const Trunk& trunk) {
  set_offset(skeleton, Role::abdomen, trunk.abdomen);
  set_offset(skeleton, Role::chest, trunk.chest - trunk.abdomen);
  set_offset(skeleton, Role::neck, trunk.neck - trunk.chest);
  set_offset(skeleton, Role::head, trunk.head - trunk.neck);
  // A head's End Site is its crown only if it is about as high as one.
  const double crown = measures.default_tip(Role::head).z();
  const double own = measures.has_end(Role::head)
                         ? measures.end(Role::head).z() - measures.place(Role::head).z()
                         : 0;
  set_tip(skeleton, Role::head, {0, 0, own > 0.5 * crown && own < 2 * crown ? own : crown});
}

void set_arms(Skeleton& skeleton, const SourceMeasurements& measures, const Trunk& trunk) {
  const Vector3d shoulder = measures.place(Role::left_upper_arm);
  const double between = measures.default_offset(Role::left_clavicle).y() /
                         (measures.default_offset(Role::left_clavicle).y() +
                          measures.default_offset(Role::left_upper_arm).y());
  Vector3d clavicle = measures.place(Role::left_clavicle);
  if (!measures.has(Role::left_clavicle) || clavicle.y() > kMaxClavicle * shoulder.y()) {
    clavicle = {shoulder.x(), between * shoulder.y(), shoulder.z()};
  }
  set_offset(skeleton, Role::left_clavicle, clavicle - trunk.chest);
  set_offset(skeleton, Role::left_upper_arm, shoulder - clavicle);
  set_offset(skeleton, Role::left_forearm, {0, measures.length(Role::left_upper_arm), 0});
  const double forearm = measures.has_end(Role::left_forearm)
                             ? measures.length(Role::left_forearm)
                             : measures.default_offset(Role::left_hand).y();
  set_offset(skeleton, Role::left_hand, {0, forearm, 0});
  // An end at the palm or at the knuckles is no fingertip.
  const double own = measures.has_end(Role::left_hand) ? measures.length(Role::left_hand) : 0;
  const bool is_hand = own >= kMinHand * forearm && own <= kMaxHand * forearm;
  set_tip(skeleton, Role::left_hand,
          {0, is_hand ? own : measures.default_tip(Role::left_hand).y(), 0});
}

// Returns the height of the ankle above the ground, m.
double set_legs(Skeleton& skeleton, const SourceMeasurements& measures) {
  const Role foot = Role::left_foot;
  Vector3d hip = measures.place(Role::left_thigh);
  set_offset(skeleton, Role::left_thigh, hip);
  set_offset(skeleton, Role::left_shin, {0, 0, -measures.length(Role::left_thigh)});
  set_offset(skeleton, foot, {0, 0, -measures.length(Role::left_shin)});

  const Vector3d ball = measures.end(foot) - measures.place(foot);
  const double sole = measures.default_height(Role::left_toes);  // below the ball
  const double ankle = std::max(measures.default_height(foot), sole - ball.z());
  set_offset(skeleton, Role::left_toes, {ball.x(), 0, std::min(ball.z(), 0.0)});
  const double toes_to_ball =
      measures.default_tip(Role::left_toes).x() / measures.default_offset(Role::left_toes).x();
  const double toes = measures.has_end(Role::left_toes) ? measures.length(Role::left_toes)
                                                        : toes_to_ball * ball.head<2>().norm();
  set_tip(skeleton, Role::left_toes, {toes, 0, 0});
  return ankle;
}

// The far end of a segment with a joint after it is that joint.
void set_inner_tips(Skeleton& skeleton) {
  for (Role next : kRoles) {
    const std::optional<Role> role = motion::parent_of(next);
    if (!role) continue;
    const bool branch = *role == Role::pelvis || *role == Role::chest;
    const bool along_spine = next == Role::abdomen || next == Role::neck;
    if (!branch || along_spine) skeleton.tip[*role] = skeleton.offset[next];
  }
}

}  // namespace

motion::Physique character_of(const Source& source, const CharacterOptions& options) {
  const SourceMeasurements measures(source);
  const Trunk trunk = measure_trunk(measures);
  motion::Physique character;
  Skeleton& skeleton = character.skeleton;
  set_trunk(skeleton, measures, trunk);
  set_arms(skeleton, measures, trunk);
  const double ankle = set_legs(skeleton, measures);
  const Vector3f to_ankle = skeleton.offset[Role::left_thigh] + skeleton.offset[Role::left_shin] +
                            skeleton.offset[Role::left_foot];
  skeleton.offset[Role::pelvis] = {0, 0, static_cast<float>(ankle) - to_ankle.z()};
  set_inner_tips(skeleton);

  const auto stature = [&] {
    const motion::JointFrames rest = forward_kinematics(skeleton, motion::rest_pose(skeleton));
    return rest.position[Role::head].z() + skeleton.tip[Role::head].z();
  };
  if (options.height_m) {
    const float scale = *options.height_m / stature();
    for (Role role : kRoles) {
      skeleton.offset[role] *= scale;
      skeleton.tip[role] *= scale;
    }
  }
  character.sex = options.sex;
  character.mass_kg = options.mass_kg.value_or(kDefaultBodyMassIndex * stature() * stature());
  return character;
}

}  // namespace flinch::database
