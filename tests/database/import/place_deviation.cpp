// SPDX-License-Identifier: MIT
#include "tests/database/import/place_deviation.h"

#include <algorithm>
#include <cmath>

#include "motion/rotation.h"

namespace flinch::tests {
namespace {

using database::FigureFrame;
using database::Source;
using Eigen::Vector3d;
using Eigen::Vector3f;
using motion::JointFrames;
using motion::Role;

// Where a source has a joint, and which joint of the skeleton stands for it.
struct Point {
  Role source;
  bool at_end = false;  // of the source's segment
  Role target;
};

// Some files have a joint named after the head where the neck begins.
Role head_joint(const Source& source, const motion::Skeleton& skeleton) {
  const motion::JointFrames rest = forward_kinematics(skeleton, motion::rest_pose(skeleton));
  const database::ReferencePose& reference = source.reference;
  const double above_hips = source.metres_per_unit * (reference.position[Role::head].z() -
                                                      reference.position[Role::left_thigh].z());
  const auto distance = [&](Role role) {
    return std::abs(above_hips -
                    double{rest.position[role].z() - rest.position[Role::left_thigh].z()});
  };
  return distance(Role::head) <= distance(Role::neck) ? Role::head : Role::neck;
}

Point wrist(const Source& source, Role forearm, Role hand) {
  if (source.figure.has(hand)) return {hand, false, hand};
  return {forearm, true, hand};
}

Vector3f middle_of_hips(const JointFrames& frames) {
  return 0.5F * (frames.position[Role::left_thigh] + frames.position[Role::right_thigh]);
}

}  // namespace

std::vector<PlaceDeviation> place_deviations(const Source& source, const motion::Skeleton& skeleton,
                                             const database::Segment& segment,
                                             const motion::Motion& clip) {
  const database::SourceMotion motion = source_motion(source);
  const Eigen::AngleAxisf yaw(placement_of(motion, skeleton, segment).yaw, Vector3f::UnitZ());
  const auto first = static_cast<int>(std::lround(segment.start_s / motion.frame_time_s));
  const Role head = head_joint(source, skeleton);
  const Point left_wrist = wrist(source, Role::left_forearm, Role::left_hand);
  const Point right_wrist = wrist(source, Role::right_forearm, Role::right_hand);

  std::vector<PlaceDeviation> deviations;
  for (std::size_t k = 0; k < clip.poses.size(); ++k) {
    const int number = std::min(first + static_cast<int>(k), source.bvh.frame_count - 1);
    const FigureFrame in_file =
        figure_frame(source.figure, forward_kinematics(source.bvh, number), source.to_world);
    const JointFrames frames = forward_kinematics(skeleton, clip.poses[k]);
    const auto deviation = [&](const Point& point) {
      const Vector3d place =
          point.at_end ? in_file.end[point.source] : in_file.position[point.source];
      const Vector3f wanted =
          yaw * (source.metres_per_unit * (place - hip_centre(in_file))).cast<float>();
      return (frames.position[point.target] - middle_of_hips(frames) - wanted).norm();
    };
    deviations.push_back(
        {deviation({Role::head, false, head}),
         std::max(deviation({Role::left_upper_arm, false, Role::left_upper_arm}),
                  deviation({Role::right_upper_arm, false, Role::right_upper_arm})),
         std::max(deviation(left_wrist), deviation(right_wrist))});
  }
  return deviations;
}

PlaceDeviation largest(const std::vector<PlaceDeviation>& deviations) {
  PlaceDeviation all;
  for (const PlaceDeviation& one : deviations) {
    all.head = std::max(all.head, one.head);
    all.shoulder = std::max(all.shoulder, one.shoulder);
    all.hand = std::max(all.hand, one.hand);
  }
  return all;
}

double angular_acceleration(const motion::Motion& clip, motion::Role role) {
  double sum = 0;
  if (clip.poses.size() < 3) return 0;
  const auto velocity = [&](std::size_t k) -> Vector3f {
    const Eigen::Quaternionf way =
        clip.poses[k].rotation[role] * clip.poses[k - 1].rotation[role].conjugate();
    return clip.rate_hz * motion::rotation_vector(way);
  };
  for (std::size_t k = 2; k < clip.poses.size(); ++k) {
    sum += double{(clip.rate_hz * (velocity(k) - velocity(k - 1))).squaredNorm()};
  }
  return std::sqrt(sum / static_cast<double>(clip.poses.size() - 2));
}

}  // namespace flinch::tests
