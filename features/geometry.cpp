// SPDX-License-Identifier: MIT
#include "features/geometry.h"

namespace flinch::features {
namespace {

/// The path near the contact: a straight line through `point`. Character's frame.
struct Path {
  Eigen::Vector3f point;
  Eigen::Vector3f direction;  ///< unit or 0
  Eigen::Vector3f side;       ///< unit, horizontal, to the left of the direction
  Eigen::Vector3f up;         ///< unit or 0, perpendicular to both
};

Path make_path(const Eigen::Vector3f& point, const Eigen::Vector3f& velocity) {
  Path path;
  path.point = point;
  path.direction = velocity.normalized();  // a zero vector stays zero
  const Eigen::Vector3f level = Eigen::Vector3f::UnitZ().cross(path.direction);
  constexpr float kSteep = 1e-4F;  // for a vertical path any side will do
  path.side = level.norm() > kSteep ? level.normalized() : Eigen::Vector3f::UnitY();
  path.up = path.direction.cross(path.side);
  return path;
}

/// Vector from `centre` to the nearest point of the path.
Eigen::Vector3f closest_approach(const Path& path, const Eigen::Vector3f& centre) {
  const Eigen::Vector3f offset = path.point - centre;
  return offset - offset.dot(path.direction) * path.direction;
}

}  // namespace

Geometry geometry_of(const Scenario& scenario, const PredictedCharacter& character) {
  const Eigen::Quaternionf to_character(
      Eigen::AngleAxisf(-scenario.state.facing, Eigen::Vector3f::UnitZ()));
  const Eigen::Vector3f origin(character.pelvis.x(), character.pelvis.y(), 0);
  const StrikingPoint then = striking_point(scenario.threat, scenario.time_to_impact_s,
                                            character.target_centres[scenario.target]);
  const Path path =
      make_path(to_character * (then.position - origin), to_character * then.velocity);
  const auto closest_approach_to = [&](motion::Target target) -> Eigen::Vector3f {
    const Eigen::Vector3f& centre = character.target_centres[target];
    return closest_approach(path, to_character * (centre - origin));
  };
  const Eigen::Vector3f aimed = to_character * (character.target_centres[scenario.target] - origin);
  const Eigen::Vector3f offset = closest_approach_to(scenario.target);
  const Eigen::Vector3f contact = aimed + offset;
  const Eigen::Vector3f head = closest_approach_to(motion::Target::head);
  const Eigen::Vector3f trunk = closest_approach_to(motion::Target::trunk);
  const Eigen::Vector3f pelvis = closest_approach_to(motion::Target::pelvis);
  const Eigen::Vector3f legs = closest_approach_to(motion::Target::legs);
  return {.contact_x = contact.x(),
          .contact_y = contact.y(),
          .contact_z = contact.z(),
          .approach_x = path.direction.x(),
          .approach_y = path.direction.y(),
          .approach_z = path.direction.z(),
          .impact_speed_mps = then.velocity.norm(),
          .offset_side = offset.dot(path.side),
          .offset_up = offset.dot(path.up),
          .miss_head_side = head.dot(path.side),
          .miss_head_up = head.dot(path.up),
          .miss_trunk_side = trunk.dot(path.side),
          .miss_trunk_up = trunk.dot(path.up),
          .miss_pelvis_side = pelvis.dot(path.side),
          .miss_pelvis_up = pelvis.dot(path.up),
          .miss_legs_side = legs.dot(path.side),
          .miss_legs_up = legs.dot(path.up)};
}

PredictedCharacter predict_character(const IdlingFigure& figure, const CharacterState& state,
                                     float time_s) {
  const motion::Pose pose = idle_pose(figure.stance, state, time_s);
  const motion::JointFrames frames = motion::forward_kinematics(*figure.skeleton, pose);
  PredictedCharacter ahead;
  ahead.pelvis = pose.root_position;
  for (const motion::Target target : motion::kTargets) {
    ahead.target_centres[target] = motion::target_centre(*figure.model, frames, target);
  }
  return ahead;
}

}  // namespace flinch::features
