// SPDX-License-Identifier: MIT
#include "database/import/trunk_fit.h"

#include "motion/rotation.h"

namespace flinch::database {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaternionf;
using Eigen::Vector3d;
using Eigen::Vector3f;
using motion::PerRole;
using motion::Role;

// How much an error of the end weighs against a turn, m/rad: 1 cm as much as 0.2 rad (11 degrees)
// of the spine or 1 rad of a clavicle, which is never near a singular position.
constexpr double kSpineDamping = 0.01 / 0.2;
constexpr double kClavicleDamping = 0.01;
constexpr int kSteps = 2;  // the second changes most clips by less than 1 mm

// Returns how a turn w of a segment u moves its far end: w x u = J w.
Matrix3d lever(const Vector3f& segment) {
  const Vector3d u = segment.cast<double>();
  Matrix3d result;
  result << 0, u.z(), -u.y(), -u.z(), 0, u.x(), u.y(), -u.x(), 0;
  return result;
}

// Returns the turns w that minimise |e - J w|^2 + k^2 |w|^2 for an error e of the ends.
template <int Ends, int Turns>
Eigen::Vector<double, Turns> damped_turns(const Eigen::Matrix<double, Ends, Turns>& jacobian,
                                          const Eigen::Vector<double, Ends>& error,
                                          double damping) {
  Eigen::Matrix<double, Ends, Ends> matrix = jacobian * jacobian.transpose();
  matrix.diagonal().array() += damping * damping;
  return jacobian.transpose() * matrix.llt().solve(error);
}

Quaternionf turned(const Quaternionf& orientation, const Vector3d& by) {
  const Vector3f turn = by.cast<float>();
  return (motion::rotation_from_vector<float>(turn) * orientation).normalized();
}

}  // namespace

TrunkFit::TrunkFit(const SourceMotion& source, const motion::Skeleton& skeleton)
    : source_rest_(source.trunk_at_rest) {
  const motion::JointFrames frames = forward_kinematics(skeleton, motion::rest_pose(skeleton));
  const Vector3f hips =
      0.5F * (frames.position[Role::left_thigh] + frames.position[Role::right_thigh]);
  const auto place = [&](Role role) -> Vector3f { return frames.position[role] - hips; };
  rest_.abdomen = place(Role::abdomen);
  rest_.chest = place(Role::chest);
  rest_.left_shoulder = place(Role::left_upper_arm);
  rest_.right_shoulder = place(Role::right_upper_arm);
  rest_.shoulders = 0.5F * (rest_.left_shoulder + rest_.right_shoulder);
  rest_.head = place(Role::head);
  neck_ = place(Role::neck);
  left_clavicle_ = place(Role::left_clavicle);
  right_clavicle_ = place(Role::right_clavicle);

  scale_ = rest_.shoulders.z() / source_rest_.shoulders.z();
  for (auto point : {&SourceTrunk::abdomen, &SourceTrunk::chest}) {
    const float share = (source_rest_.*point).z() / source_rest_.shoulders.z();
    const float below = corners_.empty() ? 0 : corners_.back().share;
    if (share > below && share < 1) corners_.push_back({point, share});
  }
  corners_.push_back({&SourceTrunk::shoulders, 1});
}

Vector3f TrunkFit::point_of(const SourceTrunk& trunk, float share) const {
  Vector3f below = Vector3f::Zero();
  float share_below = 0;
  for (const Corner& corner : corners_) {
    const Vector3f& above = trunk.*corner.point;
    if (share <= corner.share) {
      const float weight = (share - share_below) / (corner.share - share_below);
      return below + weight * (above - below);
    }
    below = above;
    share_below = corner.share;
  }
  return below;
}

// Turns a part of the spine as the source's spine turns between the same heights.
void TrunkFit::align(Role role, float from, float to, const SourceTrunk& trunk,
                     PerRole<Quaternionf>& orientation) const {
  Quaternionf& turned = orientation[role];
  const Vector3f at_rest = point_of(source_rest_, to) - point_of(source_rest_, from);
  const Vector3f now = point_of(trunk, to) - point_of(trunk, from);
  turned = (motion::rotation_between<float>(turned * at_rest, now) * turned).normalized();
}

// Returns where a point of the source is in the skeleton's proportions. Where the two differ in the
// rest pose, the difference turns with a part of the trunk.
Vector3f TrunkFit::goal(Vector3f SourceTrunk::*point, const SourceTrunk& trunk,
                        const Quaternionf& carrier) const {
  return scale_ * trunk.*point + carrier * (rest_.*point - scale_ * source_rest_.*point);
}

void TrunkFit::bend(const SourceFrame& frame, PerRole<Quaternionf>& orientation) const {
  const float abdomen_share = rest_.abdomen.z() / rest_.shoulders.z();
  const float chest_share = rest_.chest.z() / rest_.shoulders.z();
  align(Role::abdomen, abdomen_share, chest_share, frame.trunk, orientation);
  align(Role::chest, chest_share, 1, frame.trunk, orientation);

  pull_spine(frame.trunk, orientation);
  const Quaternionf& chest = orientation[Role::chest];
  const Vector3f chest_joint = orientation[Role::pelvis] * rest_.abdomen +
                               orientation[Role::abdomen] * (rest_.chest - rest_.abdomen);
  const auto pull = [&](Role role, const Vector3f& joint, Vector3f SourceTrunk::*point) {
    const Vector3f segment = orientation[role] * (rest_.*point - joint);
    const Vector3f error =
        goal(point, frame.trunk, chest) - chest_joint - chest * (joint - rest_.chest) - segment;
    const Vector3d turn =
        damped_turns<3, 3>(lever(segment), error.cast<double>(), kClavicleDamping);
    orientation[role] = turned(orientation[role], turn);
  };
  pull(Role::left_clavicle, left_clavicle_, &SourceTrunk::left_shoulder);
  pull(Role::right_clavicle, right_clavicle_, &SourceTrunk::right_shoulder);
}

// Turns abdomen, chest and neck so that shoulders and head come towards their goals, in
// Gauss-Newton steps from the present errors plus those that the turns so far have removed.
void TrunkFit::pull_spine(const SourceTrunk& trunk, PerRole<Quaternionf>& orientation) const {
  constexpr std::array<Role, 3> kSpine{Role::abdomen, Role::chest, Role::neck};
  const std::array<Quaternionf, 3> from{orientation[kSpine[0]], orientation[kSpine[1]],
                                        orientation[kSpine[2]]};
  const Vector3f near_end = orientation[Role::pelvis] * rest_.abdomen;
  const Vector3f shoulders = goal(&SourceTrunk::shoulders, trunk, from[0]) - near_end;
  const Vector3f head = goal(&SourceTrunk::head, trunk, from[2]) - near_end;
  Eigen::Vector<double, 9> turns = Eigen::Vector<double, 9>::Zero();
  for (int step = 0; step < kSteps; ++step) {
    const Vector3f abdomen = orientation[Role::abdomen] * (rest_.chest - rest_.abdomen);
    const Vector3f to_shoulders = orientation[Role::chest] * (rest_.shoulders - rest_.chest);
    const Vector3f to_neck = orientation[Role::chest] * (neck_ - rest_.chest);
    const Vector3f neck = orientation[Role::neck] * (rest_.head - neck_);
    Eigen::Vector<double, 6> error;
    error.head<3>() = (shoulders - abdomen - to_shoulders).cast<double>();
    error.tail<3>() = (head - abdomen - to_neck - neck).cast<double>();
    Eigen::Matrix<double, 6, 9> jacobian;
    jacobian << lever(abdomen), lever(to_shoulders), Matrix3d::Zero(),  //
        lever(abdomen), lever(to_neck), lever(neck);
    turns = damped_turns<6, 9>(jacobian, error + jacobian * turns, kSpineDamping);
    for (std::size_t i = 0; i < kSpine.size(); ++i) {
      orientation[kSpine[i]] = turned(from[i], turns.segment<3>(3 * static_cast<Eigen::Index>(i)));
    }
  }
}

}  // namespace flinch::database
